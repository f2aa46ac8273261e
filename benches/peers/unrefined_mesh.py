"""Mesh examples/meshes/l-bracket.geo finely, by Gmsh alone: nothing in it comes from refining.

Usage: python3 unrefined_mesh.py GEO FACTOR MSH

FACTOR multiplies the mesh sizes that GEO asks for; 0.055 gives 104,008 vertices. Used with
gmsh 4.15.2 from PyPI; on one thread, so that the mesh is always the same.
"""

import sys

import gmsh


def main():
    geometry, factor, mesh = sys.argv[1:]
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("Mesh.MeshSizeFactor", float(factor))
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.open(geometry)
    gmsh.model.mesh.generate(3)
    gmsh.write(mesh)
    tets = gmsh.model.mesh.getElementsByType(4)[0]
    worst = min(gmsh.model.mesh.getElementQualities(tets, "eta"))
    print(f"{len(gmsh.model.mesh.getNodes()[0]):,} vertices, {len(tets):,} tets, worst mean ratio {worst:.2f}")
    gmsh.finalize()


if __name__ == "__main__":
    main()
