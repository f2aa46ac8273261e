// A torus about the z axis: radius 1 to the middle of the tube, 0.45 of the tube.
// A sixth of its surface, round the x axis, is `held`, the rest `free`.
// Made with gmsh 4.15.2 by
//
//   gmsh torus.geo -3 -format msh41 -o torus.msh
//
// 96 vertices, 226 tets, 44 triangles on `held` and 144 on `free`. The worst mean ratio is
// 0.41; with the usual guard subdivision keeps it above 0.20.
SetFactory("OpenCASCADE");
R = 1; r = 0.45;
Torus(1) = {0, 0, 0, R, r, Pi/3};
Torus(2) = {0, 0, 0, R, r, 5*Pi/3};
Rotate {{0, 0, 1}, {0, 0, 0}, -Pi/6} { Volume{1}; }
Rotate {{0, 0, 1}, {0, 0, 0}, Pi/6} { Volume{2}; }
BooleanFragments{ Volume{1, 2}; Delete; }{ }

// The two cuts lie between both volumes; what else bounds them is the torus.
held() = Boundary{ Volume{1}; };
free() = Boundary{ Volume{2}; };
cuts() = {};
For i In {0:#held()-1}
  For j In {0:#free()-1}
    If (Fabs(held(i)) == Fabs(free(j)))
      cuts() += Fabs(held(i));
    EndIf
  EndFor
EndFor
held() = Abs(held()); free() = Abs(free());
held() -= cuts(); free() -= cuts();

Physical Volume("torus", 1) = {1, 2};
Physical Surface("held", 1) = held();
Physical Surface("free", 2) = free();

Mesh.MeshSizeMin = 0.6;
Mesh.MeshSizeMax = 0.6;
Mesh.Algorithm3D = 10; // HXT
Mesh.OptimizeNetgen = 1;
