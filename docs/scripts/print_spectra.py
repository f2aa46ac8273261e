#!/usr/bin/env python3
"""Print the tables of eigenvalues of the pages of docs/schemes, from `octruss spectrum`.

Usage:
    print_spectra.py SCHEME

The last table is of a vertex on a face between two tets that were split twice,
marked alike and differently. A row has the place, the size of the local matrix, the first six eigenvalues and
the verdict. "λ3 > λ4" is there only if three eigenvectors dominate; "map" tells
whether the sampled characteristic map is regular, and injective.

Requirements, used with Python 3.11:
    pip install numpy==2.4.6 vtk==9.7.2
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np
from program import kuhn_block, octruss, read_mesh, spectrum, write_mesh

VERTICES = [
    "bipyramid:3", "octahedron", "bipyramid:5", "bipyramid:6", "bipyramid:7", "bipyramid:8", "bipyramid:9",
    "bipyramid:11", "bipyramid:13", "stack:3,2", "stack:4,2", "icosahedron", "stack:6,2", "stack:7,2", "stack:8,2",
    "stack:9,2", "stack:10,2", "stack:4,3", "stack:5,3", "stack:6,3", "stack:4,4", "stack:5,4",
]
SHOWN = 6
RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def written(values):
    """Eigenvalues in six digits, equal neighbours joined by an exponent."""
    texts = []
    for re, im in values:
        if im < -5e-7:
            continue
        text = f"{re:.6f}".rstrip("0").rstrip(".").replace("-", "−")
        texts.append(f"{text} ± {im:.6f}i" if im > 5e-7 else text)
    out, start = [], 0
    for i in range(1, len(texts) + 1):
        if i == len(texts) or texts[i] != texts[start]:
            count = i - start
            out.append(texts[start] + (str(count).translate(RAISED) if count > 1 else ""))
            start = i
    return ", ".join(out)


def row(scheme, name, *place):
    found = spectrum(scheme, *place)
    verdict = found["verdict"]
    said = verdict["characteristic-map"]
    names = {(True, True): "sound", (True, False): "overlaps", (False, True): "folds", (False, False): "folds, overlaps"}
    kind = "–" if "not-applicable" in said else names[said["regular"], said["injective"]]
    values = written(found["eigenvalues"][:SHOWN])
    yes = {True: "yes", False: "no"}
    print(f"| {name} | {found['rows']} | {values} | {yes[verdict['separated']]} | {kind} |")
    if not verdict["convergent"]:
        print(f"| {name} does not converge | | | | |")


def face(scheme, name, second):
    """A vertex inside the common face of two tets, off its edges."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1)]
    with tempfile.TemporaryDirectory() as folder:
        start, split = Path(folder, "two.vtk"), Path(folder, "split.vtu")
        write_mesh(start, points, [[0, 1, 2, 3], second])
        options = ["--marking", "as-ordered", "--crease-angle", "180", "--quiet"]
        octruss("refine", start, split, "--scheme", "linear", "--levels", 2, *options)
        vertex = int(np.argmin(np.linalg.norm(read_mesh(split)[0] - [0.25, 0.25, 0], axis=1)))
        row(scheme, name, "--vertex", f"{split}:{vertex}")


def main():
    arguments = argparse.ArgumentParser(description="Print the eigenvalues of a scheme as Markdown.")
    arguments.add_argument("scheme")
    scheme = arguments.parse_args().scheme
    head = "| rows | eigenvalues | λ3 > λ4 | map |\n| --- | --- | --- | --- | --- |"
    print("| vertex", head)
    with tempfile.TemporaryDirectory() as folder:
        points, tets, middle = kuhn_block(2)
        mesh = Path(folder, "block.vtk")
        write_mesh(mesh, points, tets)
        row(scheme, "regular", "--vertex", f"{mesh}:{middle}")
    for place in VERTICES:
        row(scheme, f"`{place}`", "--vertex", place)
    for marks, valences in (("all", range(3, 11)), ("alternate", range(4, 11, 2)), ("twist", range(3, 11))):
        print(f"\n| edge, marks `{marks}`", head)
        for valence in valences:
            row(scheme, valence, "--edge", valence, "--marks", marks)
    print("\n| face, its two tets", head)
    face(scheme, "agree", [0, 1, 2, 4])
    face(scheme, "conflict", [0, 2, 1, 4])


if __name__ == "__main__":
    main()
