// A ball of radius 1 round the origin: 92 vertices, 251 tets, 154 boundary
// triangles. Made with gmsh 4.15.2 by
//
//   gmsh ball.geo -3 -format msh41 -o ball.msh
//
// No two boundary triangles meet at more than 23 degrees, so the default crease
// angle leaves the sphere smooth. The worst mean ratio is 0.63; after four
// box-spline levels it is 0.26.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 1};
Physical Volume("ball", 1) = {1};
Physical Surface("surface", 1) = {1};

Mesh.MeshSizeMin = 0.5;
Mesh.MeshSizeMax = 0.5;
Mesh.OptimizeNetgen = 1;
