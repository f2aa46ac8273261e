// The unit cube in four layers along z, in turn of the regions `soft` and `hard`, for
// coefficients that jump. Its six sides together are `sides`.
// Made with gmsh 4.15.2 by
//
//   gmsh layers.geo -3 -format msh41 -o layers.msh
//
// 148 vertices, 488 tets, half of them in each region; the worst mean ratio is 0.58.
SetFactory("OpenCASCADE");
For k In {0:3}
  Box(k + 1) = {0, 0, k/4, 1, 1, 1/4};
EndFor
BooleanFragments{ Volume{1:4}; Delete; }{ }

e = 1e-3;
sides() = Surface In BoundingBox{-e, -e, -e, e, 1 + e, 1 + e};
sides() += Surface In BoundingBox{1 - e, -e, -e, 1 + e, 1 + e, 1 + e};
sides() += Surface In BoundingBox{-e, -e, -e, 1 + e, e, 1 + e};
sides() += Surface In BoundingBox{-e, 1 - e, -e, 1 + e, 1 + e, 1 + e};
sides() += Surface In BoundingBox{-e, -e, -e, 1 + e, 1 + e, e};
sides() += Surface In BoundingBox{-e, -e, 1 - e, 1 + e, 1 + e, 1 + e};

Physical Volume("soft", 1) = {1, 3};
Physical Volume("hard", 2) = {2, 4};
Physical Surface("sides", 1) = sides();

Mesh.MeshSizeMin = 0.35;
Mesh.MeshSizeMax = 0.35;
Mesh.Algorithm3D = 10; // HXT
Mesh.OptimizeNetgen = 1;
