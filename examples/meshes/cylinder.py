"""Writes cylinder.msh from cylinder.geo, with a density at its vertices.

Used with gmsh 4.15.2 from PyPI, in the folder of this file.
"""

import gmsh

# Of steel and aluminium, in g/cm³.
LOWER, UPPER = 7.8, 2.7
BORDER = 1.25

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.open("cylinder.geo")
gmsh.model.mesh.generate(3)
nodes, coordinates, _ = gmsh.model.mesh.getNodes()
density = [[LOWER if z < BORDER else UPPER] for z in coordinates[2::3]]
view = gmsh.view.add("density")
gmsh.view.addModelData(view, 0, gmsh.model.getCurrent(), "NodeData", nodes, density)
gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
gmsh.view.write(view, "cylinder.msh")
tets = gmsh.model.mesh.getElementsByType(4)[0]
worst = min(gmsh.model.mesh.getElementQualities(tets, "eta"))
print(f"{len(nodes)} vertices, {len(tets)} tets, worst mean ratio {worst:.4f}")
gmsh.finalize()
