// Problem S0: a structure B x H = 4 m x 12 m on a foundation, one joint under the structure.
// Uniform squares of size B/n. Variables (gmsh -setnumber):
//   n          contact faces under the structure (8)
//   split      1: the mesh is already open, with the lips structure_base and foundation_contact (0)
//   triangles  1: every square is cut into two triangles (0)
DefineConstant[ n = 8, split = 0, triangles = 0 ];
B = 4; H = 12; left = 2 * B; right = 2 * B; depth = 1.5 * B;

// The grid lines x = -8, 0, 4, 12 and y = -6, 0, 12.
Point(1) = {-left, -depth, 0};  Point(2) = {0, -depth, 0};  Point(3) = {B, -depth, 0};  Point(4) = {B + right, -depth, 0};
Point(5) = {-left, 0, 0};       Point(6) = {0, 0, 0};       Point(7) = {B, 0, 0};       Point(8) = {B + right, 0, 0};
Point(9) = {0, H, 0};           Point(10) = {B, H, 0};

Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};   // bottom
Line(4) = {5, 6};  Line(5) = {6, 7};  Line(6) = {7, 8};   // top of the foundation
Line(7) = {1, 5};  Line(8) = {2, 6};  Line(9) = {3, 7};  Line(10) = {4, 8};
base = 5; a = 6; b = 7;
If (split)
  // its own points and curve: two lips in the same place
  Point(11) = {0, 0, 0};  Point(12) = {B, 0, 0};  Line(11) = {11, 12};
  base = 11; a = 11; b = 12;
EndIf
Line(12) = {a, 9};  Line(13) = {b, 10};  Line(14) = {9, 10};

Curve Loop(1) = {1, 8, -4, -7};   Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -5, -8};   Plane Surface(2) = {2};
Curve Loop(3) = {3, 10, -6, -9};  Plane Surface(3) = {3};
Curve Loop(4) = {base, 13, -14, -12};  Plane Surface(4) = {4};

Transfinite Curve {1, 4} = left / B * n + 1;
Transfinite Curve {3, 6} = right / B * n + 1;
Transfinite Curve {2, 5, base, 14} = n + 1;
Transfinite Curve {7, 8, 9, 10} = depth / B * n + 1;
Transfinite Curve {12, 13} = H / B * n + 1;
Transfinite Surface {1, 2, 3, 4};
If (!triangles)
  Recombine Surface {1, 2, 3, 4};
EndIf

Physical Surface("structure", 1) = {4};
Physical Surface("foundation", 2) = {1, 2, 3};
If (split)
  Physical Curve("structure_base", 11) = {11};
  Physical Curve("foundation_contact", 12) = {5};
Else
  Physical Curve("base", 11) = {5};
EndIf
Physical Curve("upstream", 13) = {12};
Physical Curve("downstream", 14) = {13};
Physical Curve("crest", 15) = {14};
Physical Curve("foundation_top", 16) = {4, 6};
Physical Curve("foundation_bottom", 17) = {1, 2, 3};
Physical Curve("foundation_sides", 18) = {7, 10};
