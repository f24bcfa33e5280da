// A wall of two blocks, 1 m x 2 m each, on a foundation 6 m x 2 m: the joint between the blocks meets
// the base joint in a T. Squares of size 1/n.
DefineConstant[ n = 2 ];
Point(1) = {-2, -2, 0};  Point(2) = {0, -2, 0};  Point(3) = {1, -2, 0};  Point(4) = {2, -2, 0};  Point(5) = {4, -2, 0};
Point(6) = {-2, 0, 0};   Point(7) = {0, 0, 0};   Point(8) = {1, 0, 0};   Point(9) = {2, 0, 0};   Point(10) = {4, 0, 0};
Point(11) = {0, 2, 0};   Point(12) = {1, 2, 0};  Point(13) = {2, 2, 0};
For i In {1:4}
  Line(i) = {i, i + 1};          // bottom
  Line(4 + i) = {5 + i, 6 + i};  // top of the foundation
EndFor
For i In {1:5}
  Line(10 + i) = {i, 5 + i};
EndFor
Line(21) = {7, 11};  Line(22) = {8, 12};  Line(23) = {9, 13};  Line(24) = {11, 12};  Line(25) = {12, 13};
For i In {1:4}
  Curve Loop(i) = {i, 11 + i, -(4 + i), -(10 + i)};
  Plane Surface(i) = {i};
EndFor
Curve Loop(5) = {6, 22, -24, -21};  Plane Surface(5) = {5};
Curve Loop(6) = {7, 23, -25, -22};  Plane Surface(6) = {6};
Transfinite Curve {1, 4, 5, 8, 11:15, 21:23} = 2 * n + 1;
Transfinite Curve {2, 3, 6, 7, 24, 25} = n + 1;
Transfinite Surface {1:6};
Recombine Surface {1:6};

Physical Surface("foundation", 1) = {1:4};
Physical Surface("left_block", 2) = {5};
Physical Surface("right_block", 3) = {6};
Physical Curve("left_base", 11) = {6};
Physical Curve("right_base", 12) = {7};
Physical Curve("between", 13) = {22};
Physical Curve("left_face", 14) = {21};
Physical Curve("right_face", 15) = {23};
Physical Curve("crest", 16) = {24, 25};
Physical Curve("foundation_top", 17) = {5, 8};
Physical Curve("foundation_bottom", 18) = {1:4};
Physical Curve("foundation_sides", 19) = {11, 15};
