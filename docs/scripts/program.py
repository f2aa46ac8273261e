"""Ask the program itself: small meshes go in, basis functions and spectra come out.

A script finds `octruss` on the PATH, or under the name in the variable OCTRUSS.
"""

import itertools
import json
import os
import subprocess
import tempfile
from fractions import Fraction
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

PROGRAM = os.environ.get("OCTRUSS", "octruss")


def octruss(*arguments):
    """The standard output of one run; a run that fails ends the script with its message."""
    try:
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    except FileNotFoundError:
        raise SystemExit(f"`{PROGRAM}` is not on the PATH; build it, or name it in OCTRUSS") from None
    if done.returncode != 0:
        raise SystemExit(f"{PROGRAM} {' '.join(map(str, arguments))}\n{done.stderr}")
    return done.stdout


def write_mesh(path, points, tets):
    """A legacy VTK file of tets, each turned to positive volume without losing its marked pair."""
    points = np.asarray(points, float)
    tets = np.array(tets)
    corners = points[tets]
    sides = corners[:, 1:] - corners[:, :1]
    turned = np.linalg.det(sides) < 0
    tets[turned] = tets[turned][:, [0, 3, 2, 1]]
    lines = ["# vtk DataFile Version 3.0", "mesh", "ASCII", "DATASET UNSTRUCTURED_GRID"]
    lines += [f"POINTS {len(points)} double", *(" ".join(map(repr, p)) for p in points.tolist())]
    lines += [f"CELLS {len(tets)} {5 * len(tets)}", *("4 " + " ".join(map(str, t)) for t in tets.tolist())]
    lines += [f"CELL_TYPES {len(tets)}", *["10"] * len(tets), ""]
    Path(path).write_text("\n".join(lines))


def read_mesh(path):
    """Points, tets, and the point array `basis` if there is one."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    values = grid.GetPointData().GetArray("basis")
    return points, tets, None if values is None else vtk_to_numpy(values)


def refine(points, tets, scheme, levels, *options):
    """Points and tets after some levels."""
    with tempfile.TemporaryDirectory() as folder:
        start, end = Path(folder, "start.vtk"), Path(folder, "end.vtu")
        write_mesh(start, points, tets)
        octruss("refine", start, end, "--scheme", scheme, "--levels", levels, "--quiet", *options)
        return read_mesh(end)[:2]


def basis(mesh, vertex, scheme, levels, *options):
    """Points and values of the basis function of a vertex of a mesh file."""
    with tempfile.TemporaryDirectory() as folder:
        end = Path(folder, "basis.vtu")
        octruss("basis", mesh, end, "--vertex", vertex, "--levels", levels, "--scheme", scheme, *options)
        points, _, values = read_mesh(end)
        return points, values


def along_line(mesh, vertex, scheme, levels, direction):
    """Distances, in lengths of the direction, and values along a line through a vertex."""
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder, "line.csv")
        text = ",".join(map(str, direction))
        arguments = ["--levels", levels, "--scheme", scheme, "--line", table, "--direction", text]
        octruss("basis", mesh, Path(folder, "basis.vtu"), "--vertex", vertex, *arguments)
        rows = np.loadtxt(table, delimiter=",", skiprows=1)
    return rows[:, 0] / np.linalg.norm(direction), rows[:, 4]


def rows(points, tets, scheme, columns, *options):
    """The entries of one step's matrix in some columns, and where its rows lie under the linear rule."""
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder, "mesh.vtk")
        write_mesh(mesh, points, tets)
        entries = [basis(mesh, v, scheme, 1, *options)[1] for v in columns]
        places, _ = basis(mesh, columns[0], "linear", 1, *options)
    return np.stack(entries, axis=1), places


def spectrum(scheme, *place):
    """What `octruss spectrum --json` says of a place."""
    return json.loads(octruss("spectrum", "--scheme", scheme, "--json", *place))


def kuhn_block(n):
    """A block of n³ unit cells of six tets each, and its middle vertex."""
    points = [(i, j, k) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    number = {p: v for v, p in enumerate(points)}
    tets = []
    for cell in itertools.product(range(n), repeat=3):
        for axes in itertools.permutations(range(3)):
            path = [np.array(cell)]
            for axis in axes:
                path.append(path[-1] + np.eye(3, dtype=int)[axis])
            tets.append([number[tuple(map(int, p))] for p in path])
    return points, tets, number[(n // 2,) * 3]


def octet_truss(path, levels):
    """Writes the truss of a regular tet split `levels` times; returns its middle vertex and spacing.

    Its vertices are the points with an even sum of coordinates, in units of the spacing.
    """
    corners = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
    with tempfile.TemporaryDirectory() as folder:
        start = Path(folder, "start.vtk")
        write_mesh(start, corners, [[0, 1, 2, 3]])
        octruss("refine", start, path, "--scheme", "linear", "--levels", levels, "--quiet")
    points, _, _ = read_mesh(path)
    return int(np.flatnonzero((np.abs(points) < 1e-12).all(axis=1))[0]), 2.0 / 2**levels


def fraction(weight):
    """A weight as a fraction, as in the formulas; weights that are none of small denominator fail."""
    exact = Fraction(float(weight)).limit_denominator(1000)
    assert abs(float(exact) - weight) < 1e-12, weight
    return exact
