// A square beam, 10 by 1 by 1 along x, from y, z = -1/2 to 1/2; the end x = 0 is `clamp`,
// x = 10 `tip`, the sides are `sides`.
// Made with gmsh 4.15.2 by
//
//   gmsh cantilever.geo -3 -format msh41 -o cantilever.msh
//
// 253 vertices, 784 tets; surfaces `clamp` and `tip` 14 triangles each, `sides` 344. The worst
// mean ratio is 0.63; after three linear levels it is 0.57.
SetFactory("OpenCASCADE");
length = 10;
Box(1) = {0, -1/2, -1/2, length, 1, 1};
e = 1e-3;
clamp() = Surface In BoundingBox{-e, -1, -1, e, 1, 1};
tip() = Surface In BoundingBox{length - e, -1, -1, length + e, 1, 1};
sides() = Surface{:};
sides() -= clamp(); sides() -= tip();

Physical Volume("beam", 1) = {1};
Physical Surface("clamp", 1) = clamp();
Physical Surface("tip", 2) = tip();
Physical Surface("sides", 3) = sides();

Mesh.MeshSizeMin = 0.5;
Mesh.MeshSizeMax = 0.5;
Mesh.OptimizeNetgen = 1;
