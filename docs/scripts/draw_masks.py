#!/usr/bin/env python3
"""Draw what a new vertex is made of: the rows of a scheme's matrix on its regular lattice.

Usage:
    draw_masks.py SCHEME PICTURE.png

The weights come from `octruss basis`: on a lattice all rows of a kind are shifts
of each other, so that one column holds them all. The Kuhn lattice is drawn with
e1 to e4 towards the corners of a regular tetrahedron, which shows its symmetry;
the averaged scheme is drawn on the octet truss.

Requirements, used with Python 3.11:
    pip install matplotlib==3.11.2 numpy==2.4.6 pillow==13.0.0 vtk==9.7.2
"""

import argparse
import itertools
import tempfile
from pathlib import Path

import numpy as np
from program import basis, fraction, kuhn_block, octet_truss, write_mesh
from style import FAINT, INK, MARKED, PAPER, View, ball, bare, dot, new_vertex, plt, save, segment, shade

# e1, e2, e3 in the picture; e4 is minus their sum.
KUHN = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1]], float)
NEIGHBOURS = [np.array(d) for d in itertools.product((0, 1), repeat=3) if any(d)]
NEIGHBOURS += [-d for d in NEIGHBOURS]


class Column:
    """What the field that is 1 at the origin becomes in one step, by doubled offset."""

    def __init__(self, mesh, vertex, scheme, spacing, is_vertex=lambda place: True):
        places, values = basis(mesh, vertex, scheme, 1)
        points, _ = basis(mesh, vertex, "linear", 1)
        offsets = np.rint((points - points[vertex]) * 2 / spacing).astype(int)
        self.weights = {tuple(o): w for o, w in zip(offsets.tolist(), values) if abs(w) > 1e-14}
        self.is_vertex = is_vertex
        assert len(places) == len(points)

    def row(self, at):
        """The weights of a new vertex at a doubled place: (coarse vertex, weight)."""
        found = []
        for offset, weight in sorted(self.weights.items()):
            doubled = np.array(at) - offset
            if not (doubled % 2).any() and self.is_vertex(doubled // 2):
                found.append((doubled // 2, weight))
        assert abs(sum(w for _, w in found) - 1) < 1e-12, at
        return found


def kuhn_column(scheme):
    points, tets, middle = kuhn_block(6)
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder, "block.vtk")
        write_mesh(mesh, points, tets)
        return Column(mesh, middle, scheme, 1.0)


def truss_column():
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder, "truss.vtu")
        middle, spacing = octet_truss(mesh, 4)
        return Column(mesh, middle, "averaged", spacing, lambda place: sum(place) % 2 == 0)


def is_neighbour(a, b):
    return any((np.array(a) - b == d).all() for d in NEIGHBOURS)


def is_marked(a, b):
    """Whether a Kuhn edge has four tets, which all mark it: its direction is a sum of two e."""
    return abs(sum(np.abs(np.array(a) - b)) - 2) == 0


def star(at):
    """The lattice vertices of the tets at an edge's midpoint or a vertex, by doubled place."""
    if not (np.array(at) % 2).any():
        centre = np.array(at) // 2
        return [centre] + [centre + d for d in NEIGHBOURS]
    half = next(d for d in NEIGHBOURS if not ((np.array(at) - d) % 2).any())
    a, b = (np.array(at) - half) // 2, (np.array(at) + half) // 2
    return [a, b] + [v for v in (a + d for d in NEIGHBOURS) if is_neighbour(v, b)]


def is_new(column, at):
    return (np.array(at) % 2).any() or not column.is_vertex(np.array(at) // 2)


def clearest_view(places):
    """The direction from which no two of the places come close to each other."""
    pairs = np.array(list(itertools.combinations(range(len(places)), 2)))
    if len(pairs) == 0:
        return View(-24, 18)

    def gap(view):
        flat = view.flat(places)
        return np.linalg.norm(flat[pairs[:, 0]] - flat[pairs[:, 1]], axis=1).min()

    views = [View(turn, tilt) for tilt in range(8, 46, 2) for turn in range(-80, 82, 2)]
    return max(views, key=gap)


def draw_balls(axes, view, weights, size):
    largest = max(abs(w) for _, w in weights)
    for at, weight in weights:
        text = str(fraction(weight)).replace("-", "−")
        ball(axes, view, at, text, shade(weight, largest), size, 9.0 if len(text) < 5 else 7.6)


def draw_kuhn(axes, column, at, title):
    """One row with the tets that it stands among."""
    row = column.row(at)
    place = lambda v: (np.array(v, float) - np.array(at) / 2) @ KUHN
    inner = {tuple(v) for v in star(at)}
    vertices = sorted(inner | {tuple(v) for v, _ in row})
    view = clearest_view([place(v) for v in vertices])
    for a, b in itertools.combinations(vertices, 2):
        if is_neighbour(a, b):
            both = a in inner and b in inner
            colour = MARKED if is_marked(a, b) else INK
            segment(axes, view, place(a), place(b), colour, 1.4 if both else 0.8, "-" if both else ":")
    for vertex in vertices:
        dot(axes, view, place(vertex), FAINT, 5)
    draw_balls(axes, view, [(place(v), w) for v, w in row], 0.36)
    if is_new(column, at):
        new_vertex(axes, view, (0, 0, 0))
    bare(axes, title)
    axes.autoscale_view()


def draw_truss(axes, column, at, title):
    """One row on the octet truss, whose edges join points at distance √2."""
    row = column.row(at)
    place = lambda v: 1.25 * (np.array(v, float) - np.array(at) / 2)
    view = clearest_view([place(v) for v, _ in row])
    for (a, _), (b, _) in itertools.combinations(row, 2):
        if abs(sum((a - b) ** 2)) == 2:
            segment(axes, view, place(a), place(b), INK, 1.2)
    draw_balls(axes, view, [(place(v), w) for v, w in row], 0.36)
    if is_new(column, at):
        new_vertex(axes, view, (0, 0, 0))
    bare(axes, title)
    axes.autoscale_view()


def legend(figure, averaged):
    """One line below the panels."""
    lines = [plt.Line2D([], [], color=INK, lw=1.4, label="edge of the truss" if averaged else "edge of six tets")]
    if not averaged:
        lines.append(plt.Line2D([], [], color=MARKED, lw=1.4, label="edge of four tets, which mark it"))
    diamond = {"marker": "D", "mfc": PAPER, "mec": INK, "mew": 1.8, "ms": 7, "ls": ""}
    lines.append(plt.Line2D([], [], label="the new vertex", **diamond))
    figure.legend(handles=lines, loc="lower center", ncol=3, frameon=False, fontsize=9.5)


KUHN_PANELS = [
    ((0, 0, 0), "vertex"),
    ((1, 0, 0), "edge of six tets"),
    ((1, 1, 0), "edge of four tets, which all mark it"),
]
TRUSS_PANELS = [
    ((0, 0, 0), "vertex"),
    ((1, 1, 0), "edge of the truss"),
    ((2, 0, 0), "centre of an octahedron"),
]


def main():
    arguments = argparse.ArgumentParser(description="Draw the rows of a scheme on its regular lattice.")
    arguments.add_argument("scheme")
    arguments.add_argument("picture")
    given = arguments.parse_args()
    averaged = given.scheme == "averaged"
    column = truss_column() if averaged else kuhn_column(given.scheme)
    panels = TRUSS_PANELS if averaged else KUHN_PANELS
    # An interpolatory vertex stays: nothing to draw.
    panels = [panel for panel in panels if len(column.row(panel[0])) > 1]
    figure, axes = plt.subplots(1, len(panels), figsize=(4.2 * len(panels), 4.4))
    for one, (at, title) in zip(axes, panels):
        (draw_truss if averaged else draw_kuhn)(one, column, at, title)
    # The same scale in every panel.
    extents = [[np.abs(one.get_xlim()).max(), np.abs(one.get_ylim()).max()] for one in axes]
    wide, high = np.maximum(np.max(extents, axis=0), [2.6, 2.2])
    figure.set_figheight(4.2 * high / wide + 0.8)
    for one in axes:
        one.set_xlim(-wide, wide)
        one.set_ylim(-high, high)
    height = figure.get_figheight()
    figure.subplots_adjust(left=0.0, right=1.0, top=1 - 0.4 / height, bottom=0.4 / height, wspace=0.0)
    legend(figure, averaged)
    save(figure, given.picture)


if __name__ == "__main__":
    main()
