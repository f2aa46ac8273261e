#!/usr/bin/env python3
"""Render what the boundary rules make of a tet and of a hexagonal prism.

Usage:
    draw_shapes.py PICTURE.png

Left to right, each in the edges of the mesh that it came from: a regular tet
without creases, box-spline (it keeps a twenty-fifth of its volume); the same,
interpolatory; a prism without creases, box-spline; the same with a crease angle
of 70°, which keeps the rims of its ends sharp and lets its sides become round.

Needs no display; see render.py. Requirements, used with Python 3.11:
    pip install matplotlib==3.11.2 numpy==2.4.6 pillow==13.0.0 vtk==9.7.2
"""

import argparse
from collections import Counter
from itertools import combinations

import numpy as np
import render
import vtk
from program import refine
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

LEVELS = 4
FEATURE_ANGLE = 50.0
SHAPE = (0.42, 0.62, 0.74)
TET = ([(0, 0, 0), (1, 0, 0), (0.5, 0.866, 0), (0.5, 0.289, 0.816)], [(0, 1, 2, 3)])


def prism():
    """Six triangles about an axis, in two layers, three tets to each prism."""
    turns = np.pi * np.arange(6) / 3
    points = [(x, y, z) for z in (0.0, 0.9, 1.8) for x, y in [(0, 0), *zip(np.cos(turns), np.sin(turns))]]
    tets = []
    for layer in range(2):
        for i in range(6):
            below = sorted([7 * layer, 7 * layer + 1 + i, 7 * layer + 1 + (i + 1) % 6])
            a, b, c = below
            d, e, f = (v + 7 for v in below)
            tets += [(a, b, c, f), (a, b, e, f), (a, d, e, f)]
    return points, tets


def skin(points, tets):
    """The boundary triangles, outward."""
    sides = Counter()
    outward = {}
    for tet in np.asarray(tets).tolist():
        for left_out in range(4):
            side = [tet[i] for i in range(4) if i != left_out]
            p, q, r = points[side]
            if np.dot(np.cross(q - p, r - p), points[tet[left_out]] - p) > 0:
                side[1], side[2] = side[2], side[1]
            sides[tuple(sorted(side))] += 1
            outward[tuple(sorted(side))] = side
    return [outward[side] for side, tets in sorted(sides.items()) if tets == 1]


def poly_data(points, cells, size):
    data = vtk.vtkPolyData()
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    data.SetPoints(places)
    array = vtk.vtkCellArray()
    array.SetData(size, numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells, np.int64).ravel(), deep=True))
    data.SetPolys(array) if size == 3 else data.SetLines(array)
    return data


def shape_actor(points, tets, opacity):
    smooth = render.with_smooth_normals(poly_data(points, skin(points, tets), 3), FEATURE_ANGLE)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(smooth)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    material = actor.GetProperty()
    material.SetColor(*SHAPE)
    material.SetOpacity(opacity)
    material.EdgeVisibilityOn()
    material.SetEdgeColor(1, 1, 1)
    material.SetEdgeOpacity(0.35)
    material.SetLineWidth(0.6 * render.OVERSAMPLING)
    return render.lit(actor)


def frame_actor(points, tets):
    """The boundary edges of the mesh that it came from, as thin rods."""
    points = np.asarray(points, float)
    edges = sorted({tuple(sorted(pair)) for side in skin(points, tets) for pair in combinations(side, 2)})
    rods = vtk.vtkTubeFilter()
    rods.SetInputData(poly_data(points, edges, 2))
    rods.SetRadius(0.006 * np.ptp(points, axis=0).max())
    rods.SetNumberOfSides(12)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(rods.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*render.INK)
    return actor


def volume(points, tets):
    corners = points[np.asarray(tets)]
    return np.linalg.det(corners[:, 1:] - corners[:, :1]).sum() / 6


def main():
    arguments = argparse.ArgumentParser(description="Render a tet and a prism under the boundary rules.")
    arguments.add_argument("picture")
    given = arguments.parse_args()
    panels = []
    rows = [
        (TET, "box-spline", "180", "no creases, box-spline"),
        (TET, "interpolatory", "180", "no creases, interpolatory"),
        (prism(), "box-spline", "180", "no creases, box-spline"),
        (prism(), "box-spline", "70", "crease angle 70°, box-spline"),
    ]
    for number, ((points, tets), scheme, angle, text) in enumerate(rows):
        # A floor of 0 refuses inverted tets only, so that the shapes are those of the rules.
        fine = refine(points, tets, scheme, LEVELS, "--crease-angle", angle, "--min-quality", "0")
        start = np.array(points, float)
        if len(tets) == 1:
            text += f"\n{100 * volume(*fine) / abs(volume(start, tets)):.1f} % of the volume"
        # The interpolatory shape hides its frame: it is drawn as glass.
        actors = [shape_actor(*fine, 0.5 if scheme == "interpolatory" else 1.0), frame_actor(points, tets)]
        panel = render.panel(actors, number / len(rows), (number + 1) / len(rows))
        caption = render.caption(text)
        caption.GetTextProperty().SetLineSpacing(1.25)
        caption.GetTextProperty().SetVerticalJustificationToTop()
        caption.GetPositionCoordinate().SetValue(0.5, 0.16)
        panel.AddActor(caption)
        render.aim(panel, [v for pair in zip(start.min(axis=0), start.max(axis=0)) for v in pair])
        panel.GetActiveCamera().Zoom(0.52)
        panel.GetActiveCamera().SetWindowCenter(0.0, -0.12)
        panels.append(panel)
    render.save(render.rendered(panels).crop((0, 80, 1600, 650)), given.picture)


if __name__ == "__main__":
    main()
