// The plate of NAFEMS' test T4: 0.6 by 1 m, A at the origin, AB along x, DA along y,
// extruded by 0.05 m. BC and CD (x = 0.6 and y = 1) are `convection`, AB (y = 0) is `hot`,
// DA (x = 0) and both faces of the plate are `insulated`. Metres.
// Made with gmsh 4.15.2 by
//
//   gmsh convective-plate.geo -3 -format msh41 -o convective-plate.msh
//
// 182 vertices, 444 tets in one layer; surfaces `hot` 12 triangles, `convection` 32,
// `insulated` 316. E of the test, 0.2 m above B, is a vertex. The worst mean ratio is 0.66.
SetFactory("OpenCASCADE");
width = 0.6; height = 1; thickness = 0.05;
// E, at 0.2 m above B, becomes a vertex.
Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Point(3) = {width, 0.2, 0};
Point(4) = {width, height, 0};
Point(5) = {0, height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Extrude {0, 0, thickness} { Surface{1}; Layers{1}; }

e = 1e-6;
hot() = Surface In BoundingBox{-e, -e, -e, width + e, e, thickness + e};
convection() = Surface In BoundingBox{width - e, -e, -e, width + e, height + e, thickness + e};
convection() += Surface In BoundingBox{-e, height - e, -e, width + e, height + e, thickness + e};
insulated() = Surface{:};
insulated() -= hot(); insulated() -= convection();

Physical Volume("plate", 1) = {1};
Physical Surface("hot", 1) = hot();
Physical Surface("convection", 2) = convection();
Physical Surface("insulated", 3) = insulated();

Mesh.MeshSizeMin = 0.1;
Mesh.MeshSizeMax = 0.1;
Mesh.Algorithm = 6; // frontal Delaunay on surfaces
