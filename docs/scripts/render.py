#!/usr/bin/env python3
"""Render a coarse mesh beside the solution on its refinement.

Usage:
    render.py COARSE.vtu SOLUTION.vtu FIELD PICTURE.png

Left: the coarse mesh, coloured by region, with its edges. Right: the refined
mesh with its edges, the point array FIELD with contour lines, and a colour bar.
Both files are VTU files of tetrahedra; a mesh in another format goes through
`octruss convert` first.

Needs no display: VTK turns to EGL or OSMesa by itself (Debian: libegl1 or
libosmesa6) and warns of a missing X server, which does no harm.

Requirements, used with Python 3.11:
    pip install numpy==2.4.6 pillow==13.0.0 vtk==9.7.2
"""

import argparse
import io
import os

import numpy as np
import vtk
from PIL import Image
from vtk.util.numpy_support import vtk_to_numpy

SIZE = (1600, 700)
BACKGROUND = (0.985, 0.985, 0.98)
INK = (0.13, 0.15, 0.19)
REGION_COLOURS = [(0.62, 0.70, 0.79), (0.93, 0.72, 0.42), (0.60, 0.77, 0.60), (0.80, 0.60, 0.70)]
BANDS = 12
OVERSAMPLING = 2


def read_grid(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetNumberOfCells() == 0:
        raise SystemExit(f"{path}: no cells found; expected a VTU file of tetrahedra")
    return grid


def output_of(algorithm, data):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def surface_of(grid):
    return output_of(vtk.vtkGeometryFilter(), grid)


def with_smooth_normals(surface, feature_angle):
    """Split normals at sharp edges only, so that curved walls look curved."""
    normals = vtk.vtkPolyDataNormals()
    normals.SetFeatureAngle(feature_angle)
    normals.SplittingOn()
    normals.ConsistencyOn()
    return output_of(normals, surface)


def lit(actor):
    material = actor.GetProperty()
    material.SetAmbient(0.22)
    material.SetDiffuse(0.78)
    material.SetSpecular(0.12)
    material.SetSpecularPower(24)
    return actor


def coarse_actors(grid):
    """Flat faces coloured by region, and the edges of the tetrahedra on them."""
    table = vtk.vtkLookupTable()
    regions = grid.GetCellData().GetArray("region")
    numbers = np.unique(vtk_to_numpy(regions)) if regions else np.array([0])
    table.SetNumberOfTableValues(len(numbers))
    table.IndexedLookupOn()
    for index, number in enumerate(numbers):
        table.SetTableValue(index, *REGION_COLOURS[index % len(REGION_COLOURS)], 1.0)
        table.SetAnnotation(vtk.vtkVariant(int(number)), str(number))
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface_of(grid))
    mapper.SetLookupTable(table)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("region")
    mapper.SetScalarVisibility(regions is not None)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(*INK)
    actor.GetProperty().SetLineWidth(1.1 * OVERSAMPLING)
    return [lit(actor)]


def colours(low, high):
    """One colour between two contour lines, from deep blue through teal to warm yellow."""
    ramp = vtk.vtkColorTransferFunction()
    ramp.SetColorSpaceToLab()
    stops = [(0.23, 0.28, 0.56), (0.17, 0.46, 0.65), (0.18, 0.62, 0.60), (0.55, 0.79, 0.48), (0.97, 0.86, 0.35)]
    for index, stop in enumerate(stops):
        ramp.AddRGBPoint(low + (high - low) * index / (len(stops) - 1), *stop)
    table = vtk.vtkLookupTable()
    table.SetRange(low, high)
    table.SetNumberOfTableValues(BANDS)
    for index in range(BANDS):
        table.SetTableValue(index, *ramp.GetColor(low + (high - low) * index / (BANDS - 1)), 1.0)
    return table


def solution_actors(grid, field, table):
    """The field on the surface, its contour lines and the edges of the tetrahedra there."""
    low, high = table.GetRange()
    skin = with_smooth_normals(surface_of(grid), 30.0)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(skin)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(field)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(low, high)
    mapper.InterpolateScalarsBeforeMappingOn()
    solid = vtk.vtkActor()
    solid.SetMapper(mapper)
    solid.GetProperty().EdgeVisibilityOn()
    solid.GetProperty().SetEdgeColor(1.0, 1.0, 1.0)
    solid.GetProperty().SetEdgeOpacity(0.3)
    solid.GetProperty().SetLineWidth(0.5 * OVERSAMPLING)

    lines = vtk.vtkContourFilter()
    lines.SetInputData(skin)
    lines.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, field)
    for index in range(1, BANDS):
        lines.SetValue(index - 1, low + (high - low) * index / BANDS)
    line_mapper = vtk.vtkPolyDataMapper()
    line_mapper.SetInputConnection(lines.GetOutputPort())
    line_mapper.ScalarVisibilityOff()
    line_mapper.SetResolveCoincidentTopologyToPolygonOffset()
    line_mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -2.0)
    contours = vtk.vtkActor()
    contours.SetMapper(line_mapper)
    contours.GetProperty().SetColor(*INK)
    contours.GetProperty().SetLineWidth(1.2 * OVERSAMPLING)
    contours.GetProperty().LightingOff()
    return [lit(solid), contours]


def styled(text, size):
    text.SetFontFamilyToArial()
    text.SetFontSize(size * OVERSAMPLING)
    text.SetColor(*INK)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()


def colour_bar(field, table):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(field)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("{:.3g}")
    bar.UnconstrainedFontSizeOn()
    styled(bar.GetTitleTextProperty(), 16)
    styled(bar.GetLabelTextProperty(), 15)
    bar.SetBarRatio(0.28)
    bar.SetPosition(0.1, 0.25)
    bar.SetWidth(0.8)
    bar.SetHeight(0.5)
    return bar


def caption(text):
    label = vtk.vtkTextActor()
    label.SetInput(text)
    styled(label.GetTextProperty(), 22)
    label.GetTextProperty().SetJustificationToCentered()
    label.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    label.SetPosition(0.5, 0.05)
    return label


def panel(actors, left, right):
    """A renderer over the part of the window from `left` to `right`, fractions of its width."""
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(left, 0.0, right, 1.0)
    renderer.SetBackground(*BACKGROUND)
    for actor in actors:
        renderer.AddActor(actor)
    return renderer


def aim(renderer, bounds):
    """Frame `bounds`, seen from the front right above and lit from the camera's upper left."""
    kit = vtk.vtkLightKit()
    kit.SetKeyLightIntensity(0.95)
    kit.SetKeyLightAngle(50, -25)
    kit.SetKeyToFillRatio(2.2)
    kit.SetKeyToHeadRatio(3.0)
    kit.AddLightsToRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(0.62, -1.0, 0.78)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(20)
    renderer.ResetCamera(bounds)
    camera.Zoom(1.25)
    camera.SetWindowCenter(0.0, -0.17)


def rendered(panels):
    """The picture, drawn larger and scaled down so that thin lines stay even."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*(OVERSAMPLING * side for side in SIZE))
    for renderer in panels:
        window.AddRenderer(renderer)
    window.Render()
    capture = vtk.vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    capture.Update()
    image = capture.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    picture = Image.fromarray(np.ascontiguousarray(pixels[::-1, :, :3]))
    return picture.resize(SIZE, Image.Resampling.LANCZOS)


def save(picture, path):
    """Write a PNG of 256 colours, at once or not at all."""
    data = io.BytesIO()
    picture.quantize(256, kmeans=4, dither=Image.Dither.NONE).save(data, "PNG", optimize=True)
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    with open(path + ".part", "wb") as file:
        file.write(data.getvalue())
    os.replace(path + ".part", path)


def main():
    arguments = argparse.ArgumentParser(description="Render a coarse mesh beside a refined solution.")
    for name in ("coarse", "solution", "field", "picture"):
        arguments.add_argument(name)
    given = arguments.parse_args()

    coarse, fine = read_grid(given.coarse), read_grid(given.solution)
    values = fine.GetPointData().GetArray(given.field)
    if values is None:
        points = fine.GetPointData()
        names = [points.GetArrayName(index) for index in range(points.GetNumberOfArrays())]
        raise SystemExit(f"{given.solution}: no point array `{given.field}`; there are {names}")
    table = colours(*values.GetRange())
    before = coarse_actors(coarse) + [caption(f"{coarse.GetNumberOfCells():,} tetrahedra")]
    after = solution_actors(fine, given.field, table) + [caption(f"{fine.GetNumberOfCells():,} tetrahedra")]
    panels = [panel(before, 0.0, 0.455), panel(after, 0.455, 0.91), panel([colour_bar(given.field, table)], 0.91, 1.0)]
    for renderer in panels[:2]:
        aim(renderer, coarse.GetBounds())
    save(rendered(panels), given.picture)


if __name__ == "__main__":
    main()
