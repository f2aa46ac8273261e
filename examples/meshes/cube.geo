// The unit cube as an unstructured mesh: 141 vertices, 360 tets, 44 triangles on
// each of the six named faces. Made with gmsh 4.15.2 by
//
//   gmsh cube.geo -3 -format msh41 -o cube.msh
//
// The worst mean ratio is 0.54; after three box-spline levels it is 0.33.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Physical Volume("cube", 1) = {1};

e = 1e-3;
Physical Surface("x0", 1) = Surface In BoundingBox{-e, -e, -e, e, 1 + e, 1 + e};
Physical Surface("x1", 2) = Surface In BoundingBox{1 - e, -e, -e, 1 + e, 1 + e, 1 + e};
Physical Surface("y0", 3) = Surface In BoundingBox{-e, -e, -e, 1 + e, e, 1 + e};
Physical Surface("y1", 4) = Surface In BoundingBox{-e, 1 - e, -e, 1 + e, 1 + e, 1 + e};
Physical Surface("z0", 5) = Surface In BoundingBox{-e, -e, -e, 1 + e, 1 + e, e};
Physical Surface("z1", 6) = Surface In BoundingBox{-e, -e, 1 - e, 1 + e, 1 + e, 1 + e};

Mesh.MeshSizeMin = 0.28;
Mesh.MeshSizeMax = 0.28;
Mesh.Algorithm3D = 10; // HXT
Mesh.OptimizeNetgen = 1;
