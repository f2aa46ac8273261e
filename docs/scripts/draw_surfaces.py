#!/usr/bin/env python3
"""Draw the rules on surfaces and curves: rows of the matrix, read from `octruss basis`.

Usage:
    draw_surfaces.py PICTURE.png

Above the rules that the approximating schemes share (Loop with Warren's weights,
cubic B-spline), below those of the interpolatory scheme (modified butterfly,
four-point). Regular rows are those of a block of Kuhn cells, extraordinary ones
those at the pole of a bipyramid.

Requirements, used with Python 3.11:
    pip install matplotlib==3.11.2 numpy==2.4.6 pillow==13.0.0 vtk==9.7.2
"""

import argparse

import numpy as np
from program import fraction, kuhn_block, refine, rows
from style import FAINT, MARKED, View, ball, bare, dot, new_vertex, plt, save, segment, shade

FLAT = View(0, 90)
RADIUS = 0.31


class Surface:
    """Some rows on a part of a mesh's surface, laid out in the plane."""

    def __init__(self, points, tets, scheme, layout, edges, *options):
        self.layout = {v: np.array([*place, 0.0]) for v, place in layout.items()}
        self.edges = edges
        self.columns = sorted(layout)
        self.points = np.array(points, float)
        self.entries, self.places = rows(points, tets, scheme, self.columns, *options)

    def row(self, *ends):
        """The weights of the vertex between the ends, or of the one vertex given."""
        place = self.points[list(ends)].mean(axis=0)
        at = int(np.argmin(np.linalg.norm(self.places - place, axis=1)))
        weights = {v: w for v, w in zip(self.columns, self.entries[at]) if abs(w) > 1e-14}
        assert abs(sum(weights.values()) - 1) < 1e-12, ends
        return weights

    def middle(self, *vertices):
        return np.mean([self.layout[v] for v in vertices], axis=0)

    def draw(self, axes, ends, title, curves=()):
        row = self.row(*ends)
        for a, b in self.edges:
            on_curve = a in curves and b in curves
            segment(axes, FLAT, self.layout[a], self.layout[b], MARKED if on_curve else FAINT, 3.0 if on_curve else 1.0)
        largest = max(abs(w) for w in row.values())
        for v, place in self.layout.items():
            if v in row:
                text = str(fraction(row[v])).replace("-", "−")
                ball(axes, FLAT, place, text, shade(row[v], largest), RADIUS, 9 if len(text) < 5 else 7.6)
            else:
                dot(axes, FLAT, place, FAINT, 4)
        if len(ends) > 1:
            new_vertex(axes, FLAT, self.middle(*ends), 7)
        bare(axes, title)


def face(scheme):
    """The face z = 0 of a block, its triangles drawn equilateral; vertices by place; those on two sharp edges."""
    points, tets, _ = kuhn_block(4)
    number = {p: v for v, p in enumerate(points)}
    flat = {number[i, j, 0]: (i - 0.5 * j, 0.866 * j) for i in range(5) for j in range(5)}
    steps = [(1, 0), (0, 1), (1, 1)]
    inside = lambda i, j: 0 <= i < 5 and 0 <= j < 5
    edges = [
        (number[i, j, 0], number[i + a, j + b, 0])
        for i in range(5) for j in range(5) for a, b in steps if inside(i + a, j + b)
    ]
    border = {v for (i, j, k), v in number.items() if k == 0 and (i == 0 or j == 0)}
    return Surface(points, tets, scheme, flat, edges), lambda i, j: number[i, j, 0], border


def pole(n, scheme):
    """A smooth surface about a vertex of valence n among vertices of valence 6, and the numbers of both.

    The cap of a bipyramid that was split once: the pole, and a ring at half its height.
    """
    turns = 2 * np.pi * np.arange(n) / n + np.pi / 2
    corners = [(0, 0, 0), (0, 0, 1), (0, 0, -1)] + [(np.cos(t), np.sin(t), 0) for t in turns]
    stars = [[0, apex, 3 + i, 3 + (i + 1) % n] for i in range(n) for apex in (1, 2)]
    points, tets = refine(corners, stars, "linear", 1, "--crease-angle", "180")
    where = lambda keep: [v for v, p in enumerate(points) if keep(p[2], np.hypot(p[0], p[1]))]
    centre = 1
    ring = where(lambda z, r: abs(z - 0.5) < 1e-9 and r > 0.1)
    layout = {v: 2.4 * points[v][:2] for v in [centre, *ring]}
    near = lambda a, b: np.linalg.norm(points[a] - points[b]) < 0.99
    edges = [(centre, v) for v in ring] + [(a, b) for a in ring for b in ring if a < b and near(a, b)]
    return Surface(points, tets, scheme, layout, edges, "--crease-angle", "180"), centre, ring[0]


def window(axes, middle, half):
    """The part of a panel about a place."""
    x, y = np.asarray(middle)[:2]
    axes.set_xlim(x - half, x + half)
    axes.set_ylim(y - half, y + half)


def approximating(axes):
    surface, at, border = face("box-spline")
    surface.draw(axes[0], [at(2, 2)], "vertex of valence 6")
    surface.draw(axes[2], [at(2, 2), at(3, 2)], "edge")
    surface.draw(axes[3], [at(2, 0)], "vertex of a curve", border)
    surface.draw(axes[4], [at(1, 0), at(2, 0)], "edge of a curve", border)
    cap, centre, _ = pole(3, "box-spline")
    cap.draw(axes[1], [centre], "vertex of valence 3")
    above = np.array([0, 1.0, 0])
    edge = surface.middle(at(2, 2), at(3, 2))
    return [surface.middle(at(2, 2)), (0, 0.3), edge, surface.middle(at(2, 0)) + above,
            surface.middle(at(1, 0), at(2, 0)) + above]


def interpolatory(axes):
    surface, at, border = face("interpolatory")
    surface.draw(axes[0], [at(2, 2), at(3, 2)], "edge, regular ends")
    for one, n in ((axes[1], 3), (axes[2], 4)):
        cap, centre, beside = pole(n, "interpolatory")
        cap.draw(one, [centre, beside], f"edge, one end of valence {n}")
    surface.draw(axes[3], [at(1, 0), at(2, 0)], "edge of a curve", border)
    surface.draw(axes[4], [at(0, 0), at(1, 0)], "edge beside a corner", border)
    above = np.array([0, 1.0, 0])
    return [surface.middle(at(2, 2), at(3, 2)), (0, 0.3), (0, 0), surface.middle(at(1, 0), at(2, 0)) + above,
            surface.middle(at(1, 0)) + above]


def main():
    arguments = argparse.ArgumentParser(description="Draw the rules on surfaces and curves.")
    arguments.add_argument("picture")
    given = arguments.parse_args()
    figure, axes = plt.subplots(2, 5, figsize=(14.4, 6.2))
    figure.subplots_adjust(left=0.005, right=0.995, top=0.9, bottom=0.01, wspace=0.04, hspace=0.3)
    for line, draw, half, name in (
        (axes[0], approximating, 1.85, "approximating schemes"),
        (axes[1], interpolatory, 1.85, "interpolatory scheme, $w = 1/16$"),
    ):
        for one, middle in zip(line, draw(line)):
            window(one, middle, half)
        top = line[0].get_position().y1
        figure.text(0.5, top + 0.06, name, ha="center", fontsize=12, weight="bold")
    save(figure, given.picture)


if __name__ == "__main__":
    main()
