// A quarter of a slice of a thick pipe: radii 1 and 2, 0.1 long, in x, y >= 0. The walls
// are `bore` and `outside`, the cuts x = 0 and y = 0 `cuts`, both ends `ends`.
// Made with gmsh 4.15.2 by
//
//   gmsh pipe.geo -3 -format msh41 -o pipe.msh
//
// 956 vertices, 2616 tets in one layer; surfaces `bore` and `outside` 64 triangles each, `cuts`
// 36, `ends` 1744. The worst mean ratio is 0.41; after two interpolatory levels it is 0.20.
SetFactory("OpenCASCADE");
inner = 1; outer = 2; length = 0.1;
Disk(1) = {0, 0, 0, outer};
Disk(2) = {0, 0, 0, inner};
Rectangle(3) = {0, 0, 0, outer, outer};
BooleanIntersection(4) = { Surface{1}; Delete; }{ Surface{3}; Delete; };
BooleanDifference(5) = { Surface{4}; Delete; }{ Surface{2}; Delete; };
Extrude {0, 0, length} { Surface{5}; Layers{1}; }

e = 1e-3;
bore() = Surface In BoundingBox{-e, -e, -e, inner + e, inner + e, length + e};
cuts() = Surface In BoundingBox{-e, -e, -e, e, outer + e, length + e};
cuts() += Surface In BoundingBox{-e, -e, -e, outer + e, e, length + e};
ends() = Surface In BoundingBox{-e, -e, -e, outer + e, outer + e, e};
ends() += Surface In BoundingBox{-e, -e, length - e, outer + e, outer + e, length + e};
outside() = Surface{:};
outside() -= bore(); outside() -= cuts(); outside() -= ends();

Physical Volume("pipe", 1) = {1};
Physical Surface("bore", 1) = bore();
Physical Surface("outside", 2) = outside();
Physical Surface("cuts", 3) = cuts();
Physical Surface("ends", 4) = ends();

// 32 segments on a quarter of each wall.
Mesh.MeshSizeMin = 0.04;
Mesh.MeshSizeMax = 0.15;
Mesh.MeshSizeFromCurvature = 128;
Mesh.Algorithm = 6; // frontal Delaunay on surfaces
