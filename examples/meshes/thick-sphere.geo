// An eighth of a thick sphere: radii 1 and 2, in x, y, z >= 0. Its walls are `inside` and
// `outside`, the three cuts through the centre `cuts`.
// Made with gmsh 4.15.2 by
//
//   gmsh thick-sphere.geo -3 -format msh41 -o thick-sphere.msh
//
// 1316 vertices, 5255 tets; surfaces `inside` and `outside` 402 triangles each, `cuts` 780. The
// worst mean ratio is 0.57; after two interpolatory levels it is 0.28.
SetFactory("OpenCASCADE");
inner = 1; outer = 2;
Sphere(1) = {0, 0, 0, outer, 0, Pi/2, Pi/2};
Sphere(2) = {0, 0, 0, inner, 0, Pi/2, Pi/2};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };

e = 1e-3; all = outer + e;
inside() = Surface In BoundingBox{-e, -e, -e, inner + e, inner + e, inner + e};
cuts() = Surface In BoundingBox{-e, -e, -e, e, all, all};
cuts() += Surface In BoundingBox{-e, -e, -e, all, e, all};
cuts() += Surface In BoundingBox{-e, -e, -e, all, all, e};
outside() = Surface{:};
outside() -= inside(); outside() -= cuts();

Physical Volume("sphere", 1) = {3};
Physical Surface("inside", 1) = inside();
Physical Surface("outside", 2) = outside();
Physical Surface("cuts", 3) = cuts();

// 16 segments on a quarter of a great circle.
Mesh.MeshSizeMin = 0.05;
Mesh.MeshSizeMax = 0.2;
Mesh.MeshSizeFromCurvature = 64;
Mesh.OptimizeNetgen = 1;
