// A footing B x H = 2 m x 1 m on ground 8 m x 3 m, with a joint under it; the middle of the top, b wide, is
// the column. Squares of size 1/n; x = 0 is the middle.
DefineConstant[ n = 8 ];
B = 2; H = 1; b = 0.5; W = 4; D = 3;
Point(1) = {-W, -D, 0};  Point(2) = {-B/2, -D, 0};  Point(3) = {B/2, -D, 0};  Point(4) = {W, -D, 0};
Point(5) = {-W, 0, 0};   Point(6) = {-B/2, 0, 0};   Point(7) = {B/2, 0, 0};   Point(8) = {W, 0, 0};
Point(9) = {-B/2, H, 0}; Point(10) = {-b/2, H, 0};  Point(11) = {b/2, H, 0};  Point(12) = {B/2, H, 0};
For i In {1:3}
  Line(i) = {i, i + 1};           // bottom
  Line(3 + i) = {4 + i, 5 + i};   // top of the ground
  Line(6 + i) = {8 + i, 9 + i};   // top of the footing
EndFor
For i In {1:4}
  Line(10 + i) = {i, 4 + i};
EndFor
Line(15) = {6, 9};  Line(16) = {7, 12};
For i In {1:3}
  Curve Loop(i) = {i, 11 + i, -(3 + i), -(10 + i)};  Plane Surface(i) = {i};
EndFor
Curve Loop(4) = {5, 16, -9, -8, -7, -15};  Plane Surface(4) = {4};

// the ground grows coarser away from the footing
Transfinite Curve {2, 5} = B * n + 1;
Transfinite Curve {7, 9} = (B - b) / 2 * n + 1;
Transfinite Curve {8} = b * n + 1;
Transfinite Curve {15, 16} = H * n + 1;
Transfinite Curve {-1, -4, 3, 6, -11, -12, -13, -14} = 13 Using Progression 1.12;
Transfinite Surface {1, 2, 3};
Transfinite Surface {4} = {6, 7, 12, 9};
Recombine Surface {1:4};

Physical Surface("footing", 1) = {4};
Physical Surface("ground", 2) = {1:3};
Physical Curve("base", 11) = {5};
Physical Curve("column", 12) = {8};
Physical Curve("footing_free", 13) = {7, 9, 15, 16};
Physical Curve("ground_top", 14) = {4, 6};
Physical Curve("ground_bottom", 15) = {1:3};
Physical Curve("ground_sides", 16) = {11, 14};
