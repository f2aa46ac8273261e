// A quarter of the plate of holed-plate.geo: 40 by 20 in x and y, 0.5 thick in z, round a hole of
// radius 2 about the z axis; x, y >= 0. The cuts are `xsym` (x = 0) and `ysym` (y = 0), the end
// x = 20 is `right`, the wall of the hole `hole`, the face z = 0 `face`, all the rest `free`.
// Made with gmsh 4.15.2 by
//
//   gmsh quarter-plate.geo -3 -format msh41 -o quarter-plate.msh
//
SetFactory("OpenCASCADE");
length = 20; width = 10; thickness = 0.5; radius = 2;
Rectangle(1) = {0, 0, 0, length, width};
Disk(2) = {0, 0, 0, radius};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Extrude {0, 0, thickness} { Surface{3}; Layers{1}; }

e = 1e-3; x = length + e; y = width + e; r = radius + e; z = thickness + e;
xsym() = Surface In BoundingBox{-e, -e, -e, e, y, z};
ysym() = Surface In BoundingBox{-e, -e, -e, x, e, z};
right() = Surface In BoundingBox{x - 2*e, -e, -e, x, y, z};
hole() = Surface In BoundingBox{-e, -e, -e, r, r, z};
face() = Surface In BoundingBox{-e, -e, -e, x, y, e};
free() = Surface{:};
free() -= xsym(); free() -= ysym(); free() -= right(); free() -= hole(); free() -= face();

Physical Volume("plate", 1) = {1};
Physical Surface("xsym", 1) = xsym();
Physical Surface("ysym", 2) = ysym();
Physical Surface("right", 3) = right();
Physical Surface("hole", 4) = hole();
Physical Surface("face", 5) = face();
Physical Surface("free", 6) = free();

// Eight segments on the quarter of the hole, from there on larger.
Field[1] = Distance;
Field[1].SurfacesList = {hole()};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = 0.4; Field[2].SizeMax = 2.5;
Field[2].DistMin = 0; Field[2].DistMax = 9;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6; // frontal Delaunay on surfaces
