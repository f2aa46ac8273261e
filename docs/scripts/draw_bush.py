#!/usr/bin/env python3
"""Draw the end of a bush of twelve segments, refined in three ways, over its exact circles.

Usage:
    draw_bush.py PICTURE.png

Each panel has the rims of the bore (radius 3.5) and of the sleeve (radius 5.5) after two levels, the
vertices of the input as dots and the exact circles. Mesh by benches/bodies/bodies.py, refined by
`octruss refine`.

Requirements, used with Python 3.11:
    pip install matplotlib==3.11.2 numpy==2.4.6 pillow==13.0.0 vtk==9.7.2 gmsh==4.15.2
"""

import argparse
import sys
import tempfile
from pathlib import Path

import numpy as np
from program import octruss
from style import FAINT, INK, POSITIVE, plt, save

sys.path.append(str(Path(__file__).resolve().parents[2] / "benches" / "bodies"))
from bodies import make  # noqa: E402

END, RADII = 12.0, (3.5, 5.5)
WAYS = {
    "linear": ["--scheme", "linear"],
    "box-spline, published": ["--scheme", "box-spline", "--interpolate=false"],
    "box-spline, through the input": ["--scheme", "box-spline"],
}


def table(words, keyword, kind, width):
    at = words.index(keyword)
    count = int(words[at + 1])
    return np.array(words[at + 2 : at + 2 + width * count], kind).reshape(-1, width)


def rims(path):
    """The edges of the end, as pairs of points: those of one triangle of it alone."""
    words = path.read_text().split()
    points = table(words, "Vertices", float, 4)[:, :3]
    tets = table(words, "Tetrahedra", int, 5)[:, :4] - 1
    faces = np.vstack([np.delete(tets, k, axis=1) for k in range(4)])
    faces = faces[(abs(points[faces][:, :, 2] - END) < 1e-6).all(axis=1)]
    edges = np.sort(np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [0, 2]]]), axis=1)
    edges, count = np.unique(edges, axis=0, return_counts=True)
    return points[edges[count == 1]][:, :, :2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("picture")
    arguments = parser.parse_args()
    figure, panels = plt.subplots(1, 3, figsize=(10.5, 3.8), sharex=True, sharey=True)
    turn = np.linspace(0, 2 * np.pi, 400)
    with tempfile.TemporaryDirectory() as scratch:
        mesh, coarse, fine = (Path(scratch) / name for name in ("bush.msh", "coarse.mesh", "fine.mesh"))
        make("bush, 12 segments", mesh)
        octruss("refine", mesh, coarse, "--quiet", "--scheme", "linear", "--levels", "0")
        for panel, (name, options) in zip(panels, WAYS.items()):
            octruss("refine", mesh, fine, "--quiet", *options, "--levels", "2")
            for radius in RADII:
                panel.plot(radius * np.cos(turn), radius * np.sin(turn), color=FAINT, lw=3)
            panel.plot(*rims(fine).transpose(2, 1, 0), color=POSITIVE, lw=1.2, marker=".", ms=3)
            panel.plot(*rims(coarse).reshape(-1, 2).T, ".", color=INK, ms=5)
            panel.set_title(name, fontsize=10)
            panel.set_aspect("equal")
            panel.axis("off")
    figure.tight_layout()
    save(figure, arguments.picture)


if __name__ == "__main__":
    main()
