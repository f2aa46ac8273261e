// Two blocks side by side: x in [0, 1] and x in [1, 1.5], both 1 × 1 in y and z.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 0.5, 1, 1};
BooleanFragments{ Volume{1, 2}; Delete; }{}

left() = Surface In BoundingBox{-0.1, -0.1, -0.1, 0.1, 1.1, 1.1};
middle() = Surface In BoundingBox{0.9, -0.1, -0.1, 1.1, 1.1, 1.1};
right() = Surface In BoundingBox{1.4, -0.1, -0.1, 1.6, 1.1, 1.1};
seam() = Curve In BoundingBox{0.9, -0.1, -0.1, 1.1, 1.1, 0.1};
tip() = Point In BoundingBox{-0.1, -0.1, -0.1, 0.1, 0.1, 0.1};

Physical Volume("left block", 1) = {1};
Physical Volume("right block", 2) = {2};
Physical Volume("heated", 12) = {2}; // the right block is in two groups
Physical Surface("inlet", 3) = {left()};
Physical Surface("outlet", 4) = {right()};
Physical Surface("walls", 5) = {left(), right()}; // both are in two groups
Physical Surface("reversed", 6) = {-middle(0)};
Physical Surface(30) = {middle()}; // no name
Physical Curve("seam", 7) = {seam()};
Physical Point("tip", 8) = {tip()};

Mesh.MeshSizeMin = 0.45;
Mesh.MeshSizeMax = 0.45;
