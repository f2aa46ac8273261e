#!/usr/bin/env python3
"""Draw a tet's marked pair, its red split, and what agreeing and conflicting neighbours make of a face.

Usage:
    draw_split.py PICTURE.png

Left to right: a tet and its marked pair; its eight parts, pulled apart, with the
inner diagonal; a face between two tets that mark the same edge of it, refined
twice by `octruss refine`, each edge coloured by how many tets surround it; the
same for two tets that mark different edges.

Requirements, used with Python 3.11:
    pip install matplotlib==3.11.2 numpy==2.4.6 pillow==13.0.0 vtk==9.7.2
"""

import argparse
import itertools
from collections import Counter

import numpy as np
from matplotlib.colors import to_rgb
from program import refine
from style import FAINT, INK, MARKED, PAPER, POSITIVE, SECOND, VALENCE, View, bare, plt, save, segment

TET = np.array([[0, 0, 0], [1, 0, 0], [0.5, 0.866, 0], [0.5, 0.289, 0.816]])
TET = TET - TET.mean(axis=0)
ENDS = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
# The children of the red split: nodes 0 to 3 are the corners, 4 + e the midpoint of edge e.
CORNERS = [(0, 4, 5, 6), (4, 1, 7, 8), (5, 7, 2, 9), (6, 8, 9, 3)]
DIAGONAL = (5, 8)
VIEW = View(-42, 22)


def solid(axes, corners, colour, lift):
    """A convex body by its corners' hull: the faces towards the reader, shaded."""
    centre = corners.mean(axis=0)
    base = np.array(to_rgb(colour))
    for three in itertools.combinations(range(len(corners)), 3):
        triangle = corners[list(three)]
        normal = np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
        normal *= np.sign(normal @ (triangle.mean(axis=0) - centre)) / np.linalg.norm(normal)
        if VIEW.depth([normal])[0] > 0 and ((corners - triangle[0]) @ normal).max() < 1e-9:
            light = 0.60 + 0.40 * max(0.0, float(normal @ np.array([-0.45, -0.55, 0.70])))
            flat = VIEW.flat(triangle)
            axes.add_patch(plt.Polygon(flat, facecolor=base * light, edgecolor="white", lw=1.2, zorder=lift))


def whole(axes):
    """A tet's edges, the marked pair strong, and the diagonal between its midpoints."""
    for a, b in ENDS:
        marked = (a, b) in ((0, 2), (1, 3))
        segment(axes, VIEW, TET[a], TET[b], MARKED if marked else INK, 4.2 if marked else 1.5)
    middles = [(TET[0] + TET[2]) / 2, (TET[1] + TET[3]) / 2]
    segment(axes, VIEW, *middles, MARKED, 2.0, ":")
    for number, corner in enumerate(TET):
        x, y = VIEW.flat([corner * 1.2])[0]
        axes.text(x, y, f"$x_{number}$", ha="center", va="center", fontsize=13)
    bare(axes)
    axes.margins(0.16)


def parts(axes):
    """The four children at the corners, moved out, and the four round the diagonal as glass."""
    nodes = np.vstack([TET, [(TET[a] + TET[b]) / 2 for a, b in ENDS]])
    for child in CORNERS:
        corners = nodes[list(child)] + 1.15 * nodes[list(child)].mean(axis=0)
        middle = float(VIEW.depth([corners.mean(axis=0)])[0])
        solid(axes, corners, POSITIVE, 5 if middle < 0 else 40)
    for a, b in itertools.combinations(range(4, 10), 2):
        if np.linalg.norm(nodes[a] - nodes[b]) < 0.6:
            segment(axes, VIEW, nodes[a], nodes[b], SECOND, 1.8)
    for pole in DIAGONAL:
        for vertex in set(range(4, 10)) - set(DIAGONAL):
            triangle = [nodes[pole], nodes[vertex], nodes[DIAGONAL[0] + DIAGONAL[1] - pole]]
            axes.add_patch(plt.Polygon(VIEW.flat(triangle), facecolor=SECOND, alpha=0.07, zorder=8))
    segment(axes, VIEW, nodes[DIAGONAL[0]], nodes[DIAGONAL[1]], MARKED, 4.2, near=5)
    bare(axes)


def valences(second):
    """The edges inside the common face of two tets after two splits: ends and how many tets surround them."""
    points = [(0, 0, 0), (1, 0, 0), (0.5, 0.866, 0), (0.5, 0.289, 0.8), (0.5, 0.289, -0.8)]
    options = ("--marking", "as-ordered", "--crease-angle", "180")
    fine, tets = refine(points, [[0, 1, 2, 3], second], "linear", 2, *options)
    counts = Counter(tuple(sorted(pair)) for tet in tets.tolist() for pair in itertools.combinations(tet, 2))
    return fine, {pair: n for pair, n in counts.items() if all(abs(fine[v][2]) < 1e-9 for v in pair)}


def is_border(p, q):
    middle = (p + q) / 2
    sides = [middle[1], 0.866 * 2 * middle[0] - middle[1], 0.866 * 2 * (1 - middle[0]) - middle[1]]
    return min(abs(s) for s in sides) < 1e-6


def face(axes, second):
    """The edges in the face, and outside it those that the two tets mark."""
    fine, edges = valences(second)
    for (a, b), tets in sorted(edges.items()):
        p, q = fine[a][:2], fine[b][:2]
        border = is_border(fine[a], fine[b])
        axes.plot(*np.transpose([p, q]), color=FAINT if border else VALENCE[tets], lw=3.0, solid_capstyle="round")
        if not border:
            x, y = (p + q) / 2
            box = {"boxstyle": "circle,pad=0.16", "fc": PAPER, "ec": "none"}
            axes.text(x, y, str(tets), color=VALENCE[tets], ha="center", va="center", bbox=box, zorder=5)
    agree = second[1] == 1
    corners = np.array([(0, 0), (1, 0), (0.5, 0.866)])
    for pair, distance in (((0, 2), 0.06), ((0, 2) if agree else (0, 1), 0.10 if agree else 0.06)):
        ends = corners[list(pair)]
        middle = ends.mean(axis=0)
        away = middle - corners.mean(axis=0)
        away *= distance / np.linalg.norm(away)
        axes.plot(*(0.9 * ends + 0.1 * middle + away).T, color=MARKED, lw=3.4, solid_capstyle="round")
    bare(axes)


PANELS = [
    (whole, "a tet and its marked pair"),
    (parts, "its eight parts: four at the corners,\nfour round the inner diagonal"),
    (lambda axes: face(axes, [0, 1, 2, 4]), "a face whose two tets agree:\nedges of 4 and 6 tets, as in the lattice"),
    (lambda axes: face(axes, [0, 2, 1, 4]), "a face whose two tets conflict:\nedges of 5 and 6 tets, at every level"),
]


def main():
    arguments = argparse.ArgumentParser(description="Draw the red split and the marks.")
    arguments.add_argument("picture")
    given = arguments.parse_args()
    figure, axes = plt.subplots(1, len(PANELS), figsize=(14.4, 4.0))
    figure.subplots_adjust(left=0.01, right=0.99, top=0.84, bottom=0.03, wspace=0.08)
    for one, (draw, title) in zip(axes, PANELS):
        draw(one)
        box = one.get_subplotspec().get_position(figure)
        figure.text((box.x0 + box.x1) / 2, 0.97, title, ha="center", va="top", fontsize=11)
    save(figure, given.picture)


if __name__ == "__main__":
    main()
