"""What VTK and meshio make of our files, and files of theirs for us to read.

    interop_vtk.py dump FILE OUT         every array of FILE, as VTK reads it
    interop_vtk.py dump-meshio FILE OUT  the same as meshio reads it
    interop_vtk.py convert FILE FOLDER   FILE as VTK and meshio write it, in every encoding
    interop_vtk.py threshold FILE OUT    the cells of FILE in region 5, by VTK's filter

A dump lists one array a line: where, name, components, then its values, whole
numbers as such and others as the hexadecimal digits of their 64 bits.
"""

import struct
import sys

import meshio
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def line(where, name, values):
    values = numpy.asarray(values)
    components = values.shape[1] if values.ndim > 1 else 1
    if values.dtype.kind == "f":
        words = [struct.pack(">d", v).hex() for v in values.ravel().astype(numpy.float64)]
    else:
        words = [str(int(v)) for v in values.ravel()]
    return "\t".join([where, name, str(components), " ".join(words)])


def read(path):
    """The grid in a file; VTK only prints what it dislikes, so watch for that."""
    complaints = []
    reader = vtk.vtkXMLUnstructuredGridReader() if path.endswith(".vtu") else vtk.vtkUnstructuredGridReader()
    if path.endswith(".vtk"):
        reader.ReadAllFieldsOn()
        reader.ReadAllScalarsOn()
    reader.SetFileName(path)
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: complaints.append(event))
    watch = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(watch)
    reader.Update()
    if complaints or watch.GetOutput():
        sys.exit(f"VTK complains about {path}: {complaints} {watch.GetOutput()}")
    return reader.GetOutput()


def dump(path):
    grid = read(path)
    yield line("mesh", "points", vtk_to_numpy(grid.GetPoints().GetData()))
    cells = grid.GetCells()
    yield line("mesh", "connectivity", vtk_to_numpy(cells.GetConnectivityArray()))
    yield line("mesh", "offsets", vtk_to_numpy(cells.GetOffsetsArray()))
    types = [grid.GetCellType(c) for c in range(grid.GetNumberOfCells())]
    yield line("mesh", "types", numpy.array(types, dtype=int))
    for where, data in [("point", grid.GetPointData()), ("cell", grid.GetCellData()), ("file", grid.GetFieldData())]:
        for index in range(data.GetNumberOfArrays()):
            array = data.GetArray(index)
            values = vtk_to_numpy(array) if array.GetNumberOfValues() else numpy.zeros(0, dtype=int)
            yield line(where, array.GetName(), values)


def dump_meshio(path):
    mesh = meshio.read(path)
    yield line("mesh", "points", mesh.points)
    for number, block in enumerate(mesh.cells):
        yield line("mesh", block.type, block.data)
        for name, blocks in mesh.cell_data.items():
            yield line("cell", name, blocks[number])
    for name, values in mesh.point_data.items():
        yield line("point", name, values)


def convert(path, folder):
    grid = read(path)
    encodings = {
        "appended-raw": ("Appended", False),
        "appended-base64": ("Appended", True),
        "base64": ("Binary", False),
        "ascii": ("Ascii", False),
    }
    for name, (mode, encode) in encodings.items():
        for compressor in ("None", "ZLib"):
            for width in ("UInt32", "UInt64"):
                for order in ("Little", "Big"):
                    writer = vtk.vtkXMLUnstructuredGridWriter()
                    getattr(writer, f"SetDataModeTo{mode}")()
                    getattr(writer, f"SetCompressorTypeTo{compressor}")()
                    getattr(writer, f"SetHeaderTypeTo{width}")()
                    getattr(writer, f"SetByteOrderTo{order}Endian")()
                    writer.SetEncodeAppendedData(encode)
                    writer.SetInputData(grid)
                    writer.SetFileName(f"{folder}/vtk-{name}-{compressor}-{width}-{order}.vtu")
                    writer.Write()
    for version in (42, 51):
        for file_type, mode in ((1, "ascii"), (2, "binary")):
            bare = vtk.vtkUnstructuredGrid()
            bare.DeepCopy(grid)
            # vtkio cannot read what belongs to the file as a whole.
            bare.GetFieldData().Initialize()
            writer = vtk.vtkUnstructuredGridWriter()
            writer.SetFileVersion(version)
            writer.SetFileType(file_type)
            writer.SetInputData(bare)
            writer.SetFileName(f"{folder}/vtk-{version}-{mode}.vtk")
            writer.Write()
    mesh = meshio.read(path)
    mesh.write(f"{folder}/meshio-zlib.vtu")
    mesh.write(f"{folder}/meshio-none.vtu", compression=None)
    mesh.write(f"{folder}/meshio-ascii.vtu", binary=False)
    # meshio gives vertices without a reference the reference 1.
    none = numpy.zeros(len(mesh.points), dtype=int)
    regions = [block.ravel() for block in mesh.cell_data["region"]]
    bare = meshio.Mesh(mesh.points, mesh.cells, {"medit:ref": none}, {"medit:ref": regions})
    bare.write(f"{folder}/meshio.mesh")


def threshold(path, target):
    keep = vtk.vtkThreshold()
    keep.SetInputData(read(path))
    keep.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "region")
    keep.SetLowerThreshold(5)
    keep.SetUpperThreshold(5)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(keep.GetOutputPort())
    writer.SetFileName(target)
    writer.Write()


if __name__ == "__main__":
    task, path, target = sys.argv[1:]
    if task == "convert":
        convert(path, target)
    elif task == "threshold":
        threshold(path, target)
    else:
        lines = dump(path) if task == "dump" else dump_meshio(path)
        with open(target, "w", encoding="utf-8", newline="\n") as out:
            out.writelines(text + "\n" for text in lines)
