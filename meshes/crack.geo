// A plate 4 m x 4 m with a crack 2 m long in its middle: both tips lie inside the body.
// The crack is drawn from left to right: its plus side is above. Squares of size 1/n.
DefineConstant[ n = 2 ];
For j In {0:2}
  Point(4 * j + 1) = {0, 2 * j, 0};  Point(4 * j + 2) = {1, 2 * j, 0};
  Point(4 * j + 3) = {3, 2 * j, 0};  Point(4 * j + 4) = {4, 2 * j, 0};
  For i In {1:3}
    Line(3 * j + i) = {4 * j + i, 4 * j + i + 1};
  EndFor
EndFor
For j In {0:1}
  For i In {1:4}
    Line(10 + 4 * j + i) = {4 * j + i, 4 * (j + 1) + i};
  EndFor
EndFor
For j In {0:1}
  For i In {1:3}
    s = 3 * j + i;
    Curve Loop(s) = {s, 11 + 4 * j + i, -(s + 3), -(10 + 4 * j + i)};
    Plane Surface(s) = {s};
  EndFor
EndFor
Transfinite Curve {1, 3, 4, 6, 7, 9} = n + 1;
Transfinite Curve {2, 5, 8} = 2 * n + 1;
Transfinite Curve {11:18} = 2 * n + 1;
Transfinite Surface {1:6};
Recombine Surface {1:6};

Physical Surface("plate", 1) = {1:6};
Physical Curve("crack", 11) = {5};
Physical Curve("bottom", 12) = {1:3};
Physical Curve("top", 13) = {7:9};
Physical Curve("left", 14) = {11, 15};
Physical Curve("right", 15) = {14, 18};
