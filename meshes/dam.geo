// A gravity dam, 30 m high, 18 m wide at its base and 4 m at its crest, on rock; its upstream face is
// x = 0, its base y = 0. Variable (gmsh -setnumber):
//   n     contact faces under the dam (18)
//   rows  cells from its base to its crest (1.2 n)
DefineConstant[ n = 18, rows = Round(1.2 * n) ];
B = 18; H = 30; crest = 4; left = 36; right = 36; depth = 36;
m = 10;  // faces along the far parts, which grow with the distance

Point(1) = {-left, -depth, 0};  Point(2) = {0, -depth, 0};  Point(3) = {B, -depth, 0};  Point(4) = {B + right, -depth, 0};
Point(5) = {-left, 0, 0};       Point(6) = {0, 0, 0};       Point(7) = {B, 0, 0};       Point(8) = {B + right, 0, 0};
Point(9) = {0, H, 0};           Point(10) = {crest, H, 0};

Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};
Line(4) = {5, 6};  Line(5) = {6, 7};  Line(6) = {7, 8};
Line(7) = {1, 5};  Line(8) = {2, 6};  Line(9) = {3, 7};  Line(10) = {4, 8};
Line(11) = {6, 9};  Line(12) = {7, 10};  Line(13) = {9, 10};

Curve Loop(1) = {1, 8, -4, -7};     Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -5, -8};     Plane Surface(2) = {2};
Curve Loop(3) = {3, 10, -6, -9};    Plane Surface(3) = {3};
Curve Loop(4) = {5, 12, -13, -11};  Plane Surface(4) = {4};

Transfinite Curve {2, 5, 13} = n + 1;
Transfinite Curve {11, 12} = rows + 1;
Transfinite Curve {1, 4} = m + 1 Using Progression 1 / 1.25;
Transfinite Curve {3, 6} = m + 1 Using Progression 1.25;
Transfinite Curve {7, 8, 9, 10} = m + 1 Using Progression 1 / 1.25;
Transfinite Surface {1, 2, 3, 4};
Recombine Surface {1, 2, 3, 4};

Physical Surface("dam", 1) = {4};
Physical Surface("rock", 2) = {1, 2, 3};
Physical Curve("base", 11) = {5};
Physical Curve("upstream", 12) = {11};
Physical Curve("downstream", 13) = {12};
Physical Curve("crest", 14) = {13};
Physical Curve("reservoir_bed", 15) = {4};
Physical Curve("valley", 16) = {6};
Physical Curve("rock_bottom", 17) = {1, 2, 3};
Physical Curve("rock_sides", 18) = {7, 10};
