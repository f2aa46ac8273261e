// A round bar of radius 1/2 and height 3, in six layers, with vertices along its
// axis. The mesh carries a field `density` at its vertices, 7.8 in the lower three
// layers of vertices and 2.7 in the others, so it comes from a script beside this
// file, with gmsh 4.15.2:
//
//   python cylinder.py
//
// 133 vertices, 432 tets, 12 segments round the rim; surfaces `bottom` and `top`.
// The worst mean ratio is 0.53; after three box-spline levels it is 0.25.
SetFactory("OpenCASCADE");
radius = 0.5; height = 3; layers = 6;
Disk(1) = {0, 0, 0, radius};
Point(100) = {0, 0, 0};
Point{100} In Surface{1};
// Flat enough that the wall is smooth: 30 degrees from segment to segment.
Transfinite Curve{1} = 13;
Extrude {0, 0, height} { Surface{1}; Layers{layers}; }

Physical Volume("bar", 1) = {1};
e = 1e-3;
Physical Surface("bottom", 1) = Surface In BoundingBox{-1, -1, -e, 1, 1, e};
Physical Surface("top", 2) = Surface In BoundingBox{-1, -1, height - e, 1, 1, height + e};

Mesh.MeshSizeMin = 0.4;
Mesh.MeshSizeMax = 0.4;
Mesh.MeshSizeFromCurvature = 0;
