// The Fichera corner: the cube from -1 to 1 without the part where x, y and z are
// all positive. Everything on the outside is `outer`, the three re-entrant faces
// `inner`.
// Made with gmsh 4.15.2 by
//
//   gmsh fichera.geo -3 -format msh41 -o fichera.msh
//
// 104 vertices, 250 tets; the worst mean ratio is 0.48.
SetFactory("OpenCASCADE");
Box(1) = {-1, -1, -1, 2, 2, 2};
Box(2) = {0, 0, 0, 1, 1, 1};
body() = BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; };

e = 1e-3;
inner() = Surface In BoundingBox{-e, -e, -e, 1 + e, 1 + e, e};
inner() += Surface In BoundingBox{-e, -e, -e, 1 + e, e, 1 + e};
inner() += Surface In BoundingBox{-e, -e, -e, e, 1 + e, 1 + e};
outer() = Surface{:};
outer() -= inner();

Physical Volume("corner", 1) = body();
Physical Surface("outer", 1) = outer();
Physical Surface("inner", 2) = inner();

Mesh.MeshSizeMin = 0.75;
Mesh.MeshSizeMax = 0.75;
Mesh.Algorithm3D = 10; // HXT
Mesh.OptimizeNetgen = 1;
