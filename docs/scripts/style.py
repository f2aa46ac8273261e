"""What the pictures have in common: colours, projection, balls with weights, files."""

import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import render
from matplotlib.colors import LinearSegmentedColormap
from PIL import Image

INK = "#21262f"
FAINT = "#aab2bd"
PAPER = "#fbfbfa"
POSITIVE = "#2b5f9e"
NEGATIVE = "#c4572e"
MARKED = "#d08a1d"
SECOND = "#2c8f86"
THIRD = "#7c5aa6"
VALENCE = {4: MARKED, 5: "#a4467f", 6: POSITIVE}
HEAT = LinearSegmentedColormap.from_list(
    "heat", ["#fbfbfa", "#cfe3ea", "#8cc3cd", "#469dae", "#2b6f9e", "#2c4583", "#231f4f"]
)
BELOW = LinearSegmentedColormap.from_list("below", ["#a33f1b", "#e58a5f", "#fbe3d6"])

plt.rcParams.update({
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "mathtext.fontset": "dejavusans",
    "text.color": INK,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.facecolor": PAPER,
    "figure.facecolor": PAPER,
    "xtick.color": INK,
    "ytick.color": INK,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
})


def save(figure, path, dpi=150):
    """A PNG of 256 colours, written at once or not at all."""
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=dpi, format="png")
    plt.close(figure)
    render.save(Image.open(drawn).convert("RGB"), path)


class View:
    """An orthographic projection: turned about z, then tilted towards the reader."""

    def __init__(self, turn, tilt):
        a, b = np.radians([turn, tilt])
        right = [np.cos(a), np.sin(a), 0.0]
        up = [-np.sin(a) * np.sin(b), np.cos(a) * np.sin(b), np.cos(b)]
        self.axes = np.array([right, up])
        self.towards = np.cross(right, up)

    def flat(self, points):
        return np.asarray(points, float) @ self.axes.T

    def depth(self, points):
        """Larger is nearer."""
        return np.asarray(points, float) @ self.towards


def bare(axes, title=None):
    axes.set_aspect("equal")
    axes.axis("off")
    if title:
        axes.set_title(title, fontsize=11, color=INK)


def segment(axes, view, a, b, colour=FAINT, width=1.0, style="-", near=0.0):
    """A line between two points; `near` lifts it before what is as deep."""
    (xa, ya), (xb, yb) = view.flat([a, b])
    depth = float(view.depth([(np.asarray(a, float) + np.asarray(b, float)) / 2])[0])
    axes.plot([xa, xb], [ya, yb], style, color=colour, lw=width, zorder=10 + depth + near, solid_capstyle="round")


def ball(axes, view, place, text, colour, radius, size=9.0):
    """A ball with its weight written on it."""
    (x, y), = view.flat([place])
    depth = float(view.depth([place])[0])
    disc = plt.Circle((x, y), radius, facecolor=colour, edgecolor=PAPER, lw=1.4, zorder=20 + depth)
    axes.add_patch(disc)
    axes.text(x, y, text, ha="center", va="center_baseline", color="white", fontsize=size, zorder=20.01 + depth)


def dot(axes, view, place, colour=FAINT, size=4.0):
    (x, y), = view.flat([place])
    axes.plot([x], [y], "o", color=colour, ms=size, zorder=19 + float(view.depth([place])[0]))


def new_vertex(axes, view, place, size=9.0):
    """Where the new vertex lies: a diamond."""
    (x, y), = view.flat([place])
    axes.plot([x], [y], "D", mfc=PAPER, mec=INK, mew=1.8, ms=size, zorder=60)


def shade(weight, largest):
    """The colour of a weight: hue by sign, strength by size."""
    base = np.array(matplotlib.colors.to_rgb(POSITIVE if weight > 0 else NEGATIVE))
    share = 0.45 + 0.55 * min(1.0, abs(weight) / largest) ** 0.5
    return tuple(1.0 - share * (1.0 - base))
