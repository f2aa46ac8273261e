// A bracket: a base plate with four bolt holes and two crossing ribs. Millimetres.
// Made with gmsh 4.15.2 by
//
//   gmsh bracket.geo -3 -format msh41 -o bracket.msh
//
// 1117 vertices, 3098 tets: 2557 in `plate`, 541 in `ribs`, joined by a
// conforming interface. Surfaces: `bolts` (the hole walls) 192 triangles, `base`
// 784, `load` (the top of the ribs) 42, `free` (all the rest) 1138; their borders
// are all sharp edges. Every bolt hole has 12 segments, every rounded corner 12
// in its quarter circle. Mean ratio at least 0.486, dihedral angles from 18 to 135
// degrees. Three box-spline levels with edges kept above 40 degrees give 1586176
// tets of mean ratio at least 0.270.
SetFactory("OpenCASCADE");

// Plate, in the plane z = 0 to thickness, with four rounded corners.
length = 120; width = 80; thickness = 8; corner = 30;
// Bolt holes, one in each quadrant.
hole = 8; hole_x = 37; hole_y = 20;
// Ribs: two upright trapezia that cross, given by half their lengths at the
// foot and at the top.
rib = 9; height = 34; top = 14; foot_x = 45; foot_y = 30;

Rectangle(1) = {-length/2, -width/2, 0, length, width, corner};
plate() = Extrude {0, 0, thickness} { Surface{1}; };
holes() = {};
For i In {0:3}
  v = newv;
  Cylinder(v) = {(2*(i%2) - 1)*hole_x, (i > 1 ? 1 : -1)*hole_y, -1, 0, 0, thickness + 2, hole};
  holes() += v;
EndFor
drilled() = BooleanDifference{ Volume{plate(1)}; Delete; }{ Volume{holes()}; Delete; };

// A trapezium in the plane of the direction (ux, uy), thickened both ways.
Macro Trapezium
  p = newp; l = newl; c = newll; s = news;
  Point(p) = {-foot*ux, -foot*uy, thickness};
  Point(p + 1) = {foot*ux, foot*uy, thickness};
  Point(p + 2) = {top*ux, top*uy, thickness + height};
  Point(p + 3) = {-top*ux, -top*uy, thickness + height};
  Line(l) = {p, p + 1};
  Line(l + 1) = {p + 1, p + 2};
  Line(l + 2) = {p + 2, p + 3};
  Line(l + 3) = {p + 3, p};
  Curve Loop(c) = {l, l + 1, l + 2, l + 3};
  Plane Surface(s) = {c};
  Translate {-rib/2*uy, -rib/2*ux, 0} { Surface{s}; }
  body() = Extrude {rib*uy, rib*ux, 0} { Surface{s}; };
Return
ux = 1; uy = 0; foot = foot_x;
Call Trapezium;
along = body(1);
ux = 0; uy = 1; foot = foot_y;
Call Trapezium;
across = body(1);
cross() = BooleanUnion{ Volume{along}; Delete; }{ Volume{across}; Delete; };

// One conforming interface between plate and ribs.
BooleanFragments{ Volume{drilled(), cross()}; Delete; }{ }

e = 1e-3;
x = length/2 + e; y = width/2 + e; z = thickness + height;
plate_volume() = Volume In BoundingBox{-x, -y, -e, x, y, thickness + e};
rib_volume() = Volume In BoundingBox{-x, -y, thickness - e, x, y, z + e};
base() = Surface In BoundingBox{-x, -y, -e, x, y, e};
load() = Surface In BoundingBox{-x, -y, z - e, x, y, z + e};
interface() = Surface In BoundingBox{-foot_x - e, -foot_y - e, thickness - e, foot_x + e, foot_y + e, thickness + e};

bolts() = {};
arcs() = {};
For i In {0:3}
  sx = 2*(i%2) - 1; sy = (i > 1 ? 1 : -1);
  x = sx*hole_x; y = sy*hole_y; r = hole + e;
  bolts() += Surface In BoundingBox{x - r, y - r, -e, x + r, y + r, thickness + e};
  For k In {0:1}
    x = sx*hole_x; y = sy*hole_y; r = hole + e; z = k*thickness;
    arcs() += Curve In BoundingBox{x - r, y - r, z - e, x + r, y + r, z + e};
    x = sx*(length - corner)/2; y = sy*(width - corner)/2; r = corner/2 + e;
    arcs() += Curve In BoundingBox{x - r, y - r, z - e, x + r, y + r, z + e};
  EndFor
EndFor

free() = Surface{:};
free() -= base();
free() -= load();
free() -= bolts();
free() -= interface();

Physical Volume("plate", 1) = plate_volume();
Physical Volume("ribs", 2) = rib_volume();
Physical Surface("bolts", 1) = bolts();
Physical Surface("base", 2) = base();
Physical Surface("load", 3) = load();
Physical Surface("free", 4) = free();

// Twelve segments on every hole and on every quarter circle of a corner.
MeshSize{ PointsOf{ Volume{plate_volume()}; } } = 13;
MeshSize{ PointsOf{ Volume{rib_volume()}; } } = 9;
Transfinite Curve{arcs()} = 13;

Mesh.Algorithm = 6;    // frontal Delaunay on surfaces
Mesh.Algorithm3D = 10; // HXT
Mesh.Smoothing = 3;
Mesh.OptimizeThreshold = 0.6;
Mesh.OptimizeNetgen = 1;
