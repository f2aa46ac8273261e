#!/usr/bin/env python3
"""Draw a field on a coarse mesh and on two refinements, with its course along the z axis.

Usage:
    blend.py COARSE.vtu LINEAR.vtu SMOOTH.vtu FIELD PICTURE.png

Left: the three meshes, coloured by the point array FIELD with contour lines.
Right: FIELD and its slope along a line near the z axis, on the two refinements.
For docs/pictures/blended-cylinder.png:

    octruss run configs/blended-cylinder.toml --out smooth
    octruss run configs/blended-cylinder.toml --out linear \\
        --set stage.subdivide.scheme=linear --set expect={}
    octruss run configs/blended-cylinder.toml --out coarse \\
        --set stage.subdivide.levels=0 --set expect={}
    blend.py coarse/solution.vtu linear/solution.vtu smooth/solution.vtu density \\
        docs/pictures/blended-cylinder.png

Requirements and display as for render.py beside this file, and matplotlib==3.11.2.
"""

import argparse
import io

import matplotlib
import numpy as np
import vtk
from PIL import Image
from vtk.util.numpy_support import vtk_to_numpy

import render

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402 (after the choice of backend)

STYLES = {"linear": ("#b4532a", 1.6), "box-spline": ("#2b5b8a", 2.0)}
# A little off the axis, so that the line runs through tets and not along edges.
LINE = (0.0103, 0.0061)
SAMPLES = 1200
PICTURES = 0.55


def profile(grid, field):
    """The field at points along the line, as heights and values."""
    low, high = grid.GetBounds()[4:6]
    line = vtk.vtkLineSource()
    line.SetPoint1(*LINE, low + 1e-6)
    line.SetPoint2(*LINE, high - 1e-6)
    line.SetResolution(SAMPLES)
    probe = vtk.vtkProbeFilter()
    probe.SetInputConnection(line.GetOutputPort())
    probe.SetSourceData(grid)
    probe.Update()
    found = probe.GetOutput()
    heights = vtk_to_numpy(found.GetPoints().GetData())[:, 2].astype(float)
    return heights, vtk_to_numpy(found.GetPointData().GetArray(field)).astype(float)


def bars(grids, field):
    """The meshes side by side, each drawn by its surface."""
    table = render.colours(*grids[0][1].GetPointData().GetArray(field).GetRange())
    panels = []
    for index, (name, grid) in enumerate(grids):
        actors = render.solution_actors(grid, field, table)
        actors.append(render.caption(name))
        left, right = (PICTURES * at / len(grids) for at in (index, index + 1))
        panel = render.panel(actors, left, right)
        camera = panel.GetActiveCamera()
        camera.SetPosition(0.5, -1.0, 0.45)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(20)
        panel.ResetCamera(grids[0][1].GetBounds())
        camera.Zoom(0.94)
        camera.SetWindowCenter(0.0, -0.06)
        panels.append(panel)
    panels.append(render.panel([], PICTURES, 1.0))
    return render.rendered(panels)


def curves(grids, field, size):
    """The field and its slope along the axis."""
    figure, axes = pyplot.subplots(
        2, 1, sharex=True, figsize=(size[0] / 100, size[1] / 100), dpi=100, layout="constrained"
    )
    figure.set_facecolor(render.BACKGROUND)
    for name, grid in grids:
        heights, values = profile(grid, field)
        colour, width = STYLES[name]
        axes[0].plot(heights, values, color=colour, linewidth=width, label=name)
        middles = 0.5 * (heights[1:] + heights[:-1])
        axes[1].plot(middles, np.diff(values) / np.diff(heights), color=colour, linewidth=width)
    axes[0].set_ylabel(field)
    axes[0].legend(frameon=False)
    axes[1].set_ylabel(f"slope of {field}")
    axes[1].set_xlabel("height along the axis")
    for axis in axes:
        axis.set_facecolor(render.BACKGROUND)
        axis.grid(color="0.88", linewidth=0.8)
        axis.spines[["top", "right"]].set_visible(False)
    picture = io.BytesIO()
    figure.savefig(picture, format="png", facecolor=figure.get_facecolor())
    return Image.open(picture).convert("RGB")


def main():
    arguments = argparse.ArgumentParser(description="Draw a field on a coarse mesh and two refinements.")
    for name in ("coarse", "linear", "smooth", "field", "picture"):
        arguments.add_argument(name)
    given = arguments.parse_args()
    coarse, linear, smooth = map(render.read_grid, (given.coarse, given.linear, given.smooth))
    refined = [("linear", linear), ("box-spline", smooth)]
    picture = bars([("coarse", coarse), *refined], given.field)
    width, height = picture.size
    left = int(PICTURES * width)
    plots = curves(refined, given.field, (width - left - 30, height - 60))
    picture.paste(plots, (left + 10, 30))
    render.save(picture, given.picture)


if __name__ == "__main__":
    main()
