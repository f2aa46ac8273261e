"""Writes the Gmsh files of this folder, with gmsh 4.15.2 from PyPI.

Prints what Gmsh itself counts in them; the tests quote these figures.
The ASCII files are written first and read again before the binary ones, since
Gmsh prints 16 digits: so all flavours hold the same coordinates bit for bit.
"""

import gmsh


def open_model(name):
    gmsh.clear()
    gmsh.open(name)


def write(name, version, binary):
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.option.setNumber("Mesh.Binary", binary)
    gmsh.write(name)


def describe(name):
    """Prints nodes, simplices of each group, and the volume of each region."""
    open_model(name)
    print(name, len(gmsh.model.mesh.getNodes()[0]), "nodes")
    for dimension, group in gmsh.model.getPhysicalGroups():
        entities = gmsh.model.getEntitiesForPhysicalGroup(dimension, group)
        tags = [gmsh.model.mesh.getElements(dimension, e)[1] for e in entities]
        count = sum(len(t) for of_entity in tags for t in of_entity)
        print(" ", dimension, group, gmsh.model.getPhysicalName(dimension, group), count)


def blocks():
    open_model("blocks.geo")
    gmsh.model.mesh.generate(3)
    write("blocks-4.1-ascii.msh", 4.1, 0)
    open_model("blocks-4.1-ascii.msh")
    write("blocks-4.1-binary.msh", 4.1, 1)
    write("blocks-2.2-ascii.msh", 2.2, 0)
    write("blocks-2.2-binary.msh", 2.2, 1)
    describe("blocks-4.1-ascii.msh")


def second_order():
    """A coarser mesh of the blocks, of ten-node tets, with a field on all nodes."""
    open_model("blocks.geo")
    gmsh.option.setNumber("Mesh.MeshSizeMin", 0.9)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.9)
    gmsh.model.mesh.generate(3)
    corners = len(gmsh.model.mesh.getNodes()[0])
    gmsh.model.mesh.setOrder(2)
    gmsh.option.setNumber("Mesh.SaveParametric", 1)
    write("second-order.msh", 4.1, 0)
    gmsh.option.setNumber("Mesh.SaveParametric", 0)
    print("second-order.msh", corners, "corners")
    describe("second-order.msh")
    write("second-order-2.2-binary.msh", 2.2, 1)


def sparse_tags():
    """A regular octahedron of four tets; node tags far apart and in no order."""
    gmsh.clear()
    gmsh.model.add("octahedron")
    gmsh.model.addDiscreteEntity(3, 1)
    tags = [900000000001, 17, 4000, 3, 123456789, 55]
    points = [0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1]
    gmsh.model.mesh.addNodes(3, 1, tags, points)
    top, east, north, west, south, bottom = tags
    ring = [east, north, west, south]
    tets = [[bottom, top, ring[i], ring[(i + 1) % 4]] for i in range(4)]
    gmsh.model.mesh.addElementsByType(1, 4, [70, 50, 60, 40], sum(tets, []))
    gmsh.model.addPhysicalGroup(3, [1], 9, "octahedron")
    write("sparse-tags.msh", 4.1, 0)


def fields(binary, name, version):
    """The octahedron with fields: T = z + 2 on nodes, a flux on all tets but one."""
    open_model("sparse-tags.msh")
    gmsh.model.mesh.renumberNodes()
    gmsh.model.mesh.renumberElements()
    model = gmsh.model.getCurrent()
    nodes, points, _ = gmsh.model.mesh.getNodes()
    tets = gmsh.model.mesh.getElementsByType(4)[0]
    view = gmsh.view.add("T")
    values = [[z + 2] for z in points[2::3]]
    gmsh.view.addModelData(view, 0, model, "NodeData", nodes, values)
    flux = gmsh.view.add("heat flux")
    values = [[float(t), 0.5, -float(t)] for t in tets[:3]]
    gmsh.view.addModelData(flux, 0, model, "ElementData", tets[:3], values)
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.option.setNumber("Mesh.Binary", binary)
    gmsh.option.setNumber("PostProcessing.Binary", binary)
    gmsh.view.write(view, name)
    gmsh.option.setNumber("PostProcessing.SaveMesh", 0)
    gmsh.view.write(flux, name, append=True)
    gmsh.option.setNumber("PostProcessing.SaveMesh", 1)


def partitioned():
    """The coarse blocks in three parts, with the entities and ghosts that parts add."""
    open_model("blocks.geo")
    gmsh.option.setNumber("Mesh.MeshSizeMin", 0.9)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.9)
    gmsh.model.mesh.generate(3)
    gmsh.option.setNumber("Mesh.PartitionCreateGhostCells", 1)
    gmsh.model.mesh.partition(3)
    write("partitioned.msh", 4.1, 0)
    write("partitioned-binary.msh", 4.1, 1)


def periodic():
    """A box whose right face repeats the left one; binary."""
    gmsh.clear()
    gmsh.model.add("periodic")
    gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
    gmsh.model.occ.synchronize()
    shift = [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    gmsh.model.mesh.setPeriodic(2, [2], [1], shift)
    gmsh.model.addPhysicalGroup(3, [1], 1, "box")
    gmsh.option.setNumber("Mesh.MeshSizeMin", 0.9)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.9)
    gmsh.model.mesh.generate(3)
    write("periodic.msh", 4.1, 1)


gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
blocks()
second_order()
sparse_tags()
fields(0, "fields-ascii.msh", 4.1)
fields(1, "fields-binary.msh", 4.1)
fields(1, "fields-2.2-binary.msh", 2.2)
partitioned()
periodic()
gmsh.finalize()
