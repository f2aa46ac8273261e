#!/usr/bin/env python3
"""Draw the basis function of a scheme on its regular lattice: a cut, lines, and how differences decay.

Usage:
    draw_basis.py SCHEME PICTURE.png

Left: the function on a plane of the lattice through its vertex, with the coarse
lattice. Middle: its values along lines through the vertex, by
`octruss basis --line`. Right: the largest second and third differences along
lattice edges, scaled so that a curve that falls to zero stands for a continuous
first or second derivative. The mask comes from one step of `octruss basis`; the
further levels are its repeated application, compared with `octruss basis` at the
third level.

Requirements, used with Python 3.11:
    pip install matplotlib==3.11.2 numpy==2.4.6 pillow==13.0.0 vtk==9.7.2
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np
from program import along_line, basis, kuhn_block, octet_truss, write_mesh
from style import BELOW, HEAT, INK, MARKED, POSITIVE, SECOND, THIRD, plt, save

LEVELS = 6


class Lattice:
    """Where a scheme is regular: a mesh file, a vertex of it, and the plane and lines to show."""

    def __init__(self, folder, scheme):
        self.averaged = scheme == "averaged"
        # Lattice steps that the function may reach to either side.
        self.reach = 4 if self.averaged else 3
        if self.averaged:
            self.mesh = Path(folder, "truss.vtu")
            self.vertex, self.spacing = octet_truss(self.mesh, 4)
            self.lines = [((1, 1, 0), "edge of the truss"), ((2, 0, 0), "across an octahedron")]
            self.differences = [(1, 1, 0), (1, 0, 1), (0, 1, 1), (1, -1, 0), (1, 0, -1), (0, 1, -1)]
        else:
            self.mesh = Path(folder, "block.vtk")
            points, tets, self.vertex = kuhn_block(2 * self.reach)
            write_mesh(self.mesh, points, tets)
            self.spacing = 1.0
            self.lines = [((1, 0, 0), "edge of six tets"), ((1, 1, 0), "edge of four tets")]
            self.differences = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1)]

    def sampled(self, scheme, levels):
        """The values of `octruss basis` on a cube of lattice points; NaN where the lattice has none."""
        points, values = basis(self.mesh, self.vertex, scheme, levels)
        steps = 2**levels
        offsets = np.rint((points - points[self.vertex]) * steps / self.spacing).astype(int)
        half = self.reach * steps
        inside = (np.abs(offsets) <= half).all(axis=1)
        cube = np.full((2 * half + 1,) * 3, np.nan)
        cube[tuple((offsets[inside] + half).T)] = values[inside]
        return cube


def cascade(mask, levels):
    """The basis function on finer and finer lattices: each is the mask applied to the last."""
    fields = [np.ones((1, 1, 1))]
    for _ in range(levels):
        coarse = fields[-1]
        side = 2 * (coarse.shape[0] - 1) + mask.shape[0]
        fine = np.zeros((side,) * 3)
        for offset in np.argwhere(mask != 0):
            window = tuple(slice(o, o + 2 * coarse.shape[0] - 1, 2) for o in offset)
            fine[window] += mask[tuple(offset)] * coarse
        fields.append(fine)
    return fields


def trimmed(cube):
    """The smallest cube about the middle with all that is not zero."""
    middle = cube.shape[0] // 2
    reach = np.abs(np.argwhere(np.nan_to_num(cube) != 0) - middle).max()
    inner = slice(middle - reach, middle + reach + 1)
    return np.nan_to_num(cube[inner, inner, inner])


def largest_difference(field, direction, order):
    """Max |difference of an order| along a lattice direction, zeros beyond the support included."""
    pad = 2 * order
    padded = np.pad(field, pad)
    for _ in range(order):
        padded = padded - np.roll(padded, direction, axis=(0, 1, 2))
    return np.abs(padded).max()


def plane(lattice, field, levels):
    """A cut: where its points are drawn, their values, and two edges of the coarse lattice.

    The plane e1, e2 of the Kuhn lattice, drawn with its symmetry; a coordinate plane of the truss.
    """
    middle = field.shape[0] // 2
    values = field[:, :, middle]
    steps = np.arange(-middle, middle + 1)
    a, b = np.meshgrid(steps, steps, indexing="ij")
    if lattice.averaged:
        # Every other point of the plane is on the truss: a square grid, turned by 45 degrees.
        rows, columns = a + b, a - b
        inside = (np.abs(rows) <= middle) & (np.abs(columns) <= middle)
        places = [np.clip(index + middle, 0, 2 * middle) for index in (rows, columns)]
        values = np.where(inside, values[tuple(places)], 0)
        return rows / 2**levels, columns / 2**levels, values, np.array([[1, 1], [1, -1]])
    # e1 = (1, √2), e2 = (1, −√2): e1 + e2, an edge of four tets, lies level.
    edges = np.array([[1, np.sqrt(2)], [1, -np.sqrt(2)]])
    return (a + b) / 2**levels, np.sqrt(2) * (a - b) / 2**levels, values, edges


def show_cut(axes, lattice, field, levels):
    x, y, values, (u, v) = plane(lattice, field, levels)
    top, low = values.max(), values.min()
    if low < -1e-12:
        axes.contourf(x, y, values, np.linspace(low, -0.004, 5), cmap=BELOW)
    bands = np.linspace(0.01 * top, top, 15)
    shown = axes.contourf(x, y, values, bands, cmap=HEAT)
    axes.contour(x, y, values, bands[::2], colors=[INK], linewidths=0.5)
    for i in range(-4, 5):
        for step, other in ((u, v), (v, u)):
            ends = np.array([i * other - 4 * step, i * other + 4 * step])
            axes.plot(*ends.T, color=INK, lw=0.5, alpha=0.35)
        if not lattice.averaged:
            ends = np.array([i * u - 4 * (u + v), i * u + 4 * (u + v)])
            axes.plot(*ends.T, color=MARKED, lw=0.8, alpha=0.55)
    support = np.abs(values) > 1e-6
    wide = max(np.abs(x[support]).max(), np.abs(y[support]).max()) * 1.08
    axes.set_xlim(-wide, wide)
    axes.set_ylim(-wide, wide)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    for side in axes.spines.values():
        side.set_visible(False)
    axes.set_title("on a plane of the lattice" + (", red below zero" if low < -1e-12 else ""), fontsize=11)
    bar = plt.colorbar(shown, ax=axes, shrink=0.8, pad=0.03, ticks=np.linspace(0, top, 5)[1:], format="%.2f")
    bar.outline.set_visible(False)


def show_lines(axes, lattice, scheme, levels):
    for (direction, name), colour, dashes in zip(lattice.lines, (POSITIVE, MARKED), ("-", "--")):
        distance, value = along_line(lattice.mesh, lattice.vertex, scheme, levels, direction)
        axes.plot(distance / lattice.spacing, value, dashes, color=colour, lw=2.0, label=name)
    axes.axhline(0, color=INK, lw=0.6)
    axes.set_xlim(-2.4, 2.4)
    axes.set_ylim(top=1.2 * axes.get_ylim()[1])
    axes.set_xlabel("edges from the vertex")
    axes.set_title("along lines through the vertex", fontsize=11)
    axes.legend(frameon=False, fontsize=9, loc="upper center", ncol=2)


def show_decay(axes, lattice, fields):
    rows = {}
    for order, scale in ((2, 2.0), (3, 4.0)):
        rows[order] = [
            scale**level * max(largest_difference(fields[level], d, order) for d in lattice.differences)
            for level in range(1, LEVELS + 1)
        ]
    levels = range(1, LEVELS + 1)
    axes.semilogy(levels, rows[2], "o-", color=SECOND, lw=1.8, label=r"$2^L \max|\Delta^2|$: to zero if $C^1$")
    axes.semilogy(levels, rows[3], "s--", color=THIRD, lw=1.8, label=r"$4^L \max|\Delta^3|$: to zero if $C^2$")
    axes.set_xlabel("level $L$")
    axes.set_title("differences along lattice edges", fontsize=11)
    axes.grid(axis="y", color=INK, alpha=0.12)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high * (high / low) ** 0.35)
    axes.legend(frameon=False, fontsize=9, loc="upper left")
    return rows


def main():
    arguments = argparse.ArgumentParser(description="Draw the basis function of a scheme.")
    arguments.add_argument("scheme")
    arguments.add_argument("picture")
    given = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        lattice = Lattice(folder, given.scheme)
        fields = cascade(trimmed(lattice.sampled(given.scheme, 1)), LEVELS)
        third = trimmed(lattice.sampled(given.scheme, 3))
        assert np.abs(third - trimmed(fields[3])).max() < 1e-12, "the program and its mask differ"
        figure, axes = plt.subplots(1, 3, figsize=(13.8, 4.1), width_ratios=[1.1, 1, 1])
        show_cut(axes[0], lattice, fields[5], 5)
        show_lines(axes[1], lattice, given.scheme, 3)
        rows = show_decay(axes[2], lattice, fields)
    for order, values in rows.items():
        print(given.scheme, f"order {order}:", " ".join(f"{value:.5f}" for value in values))
    figure.subplots_adjust(left=0.02, right=0.985, top=0.9, bottom=0.13, wspace=0.2)
    save(figure, given.picture)


if __name__ == "__main__":
    main()
