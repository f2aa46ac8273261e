// A whole plate of 40 by 20 in x and y, 0.5 thick in z, round a hole of radius 2 about the z
// axis: the diameter is a fifth of the width. The ends are `left` and `right` (x = -20 and
// 20), the wall of the hole is `hole`, the face z = 0 `face`, all the rest `free`.
// Made with gmsh 4.15.2 by
//
//   gmsh holed-plate.geo -3 -format msh41 -o holed-plate.msh
//
// 1286 vertices, 3525 tets in one layer; surfaces `left` and `right` 16 triangles each, `hole`
// 122, `face` 1175, `free` 1243. The worst mean ratio is 0.39; after two interpolatory levels it
// is 0.20.
SetFactory("OpenCASCADE");
length = 40; width = 20; thickness = 0.5; radius = 2;
Rectangle(1) = {-length/2, -width/2, 0, length, width};
Disk(2) = {0, 0, 0, radius};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Extrude {0, 0, thickness} { Surface{3}; Layers{1}; }

e = 1e-3; x = length/2 + e; y = width/2 + e; r = radius + e; z = thickness + e;
left() = Surface In BoundingBox{-x, -y, -e, -x + 2*e, y, z};
right() = Surface In BoundingBox{x - 2*e, -y, -e, x, y, z};
hole() = Surface In BoundingBox{-r, -r, -e, r, r, z};
face() = Surface In BoundingBox{-x, -y, -e, x, y, e};
free() = Surface{:};
free() -= left(); free() -= right(); free() -= hole(); free() -= face();

Physical Volume("plate", 1) = {1};
Physical Surface("left", 1) = left();
Physical Surface("right", 2) = right();
Physical Surface("hole", 3) = hole();
Physical Surface("face", 4) = face();
Physical Surface("free", 5) = free();

// 61 segments round the hole, from there on larger.
Field[1] = Distance;
Field[1].SurfacesList = {hole()};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = 0.2; Field[2].SizeMax = 2.5;
Field[2].DistMin = 0; Field[2].DistMax = 9;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.Algorithm = 6; // frontal Delaunay on surfaces
