// A pier of six blocks, each 0.6 m x 0.5 m, on a base 2.6 m x 0.5 m; joint i is under block i. Squares of 0.6/n, nearly.
DefineConstant[ n = 6 ];
b = 0.6; h = 0.5; count = 6; side = 1; depth = 0.5;
Point(1) = {-side, -depth, 0};  Point(2) = {0, -depth, 0};  Point(3) = {b, -depth, 0};  Point(4) = {b + side, -depth, 0};
Point(5) = {-side, 0, 0};  Point(8) = {b + side, 0, 0};
For i In {0:count}
  Point(10 + i) = {0, i * h, 0};  Point(20 + i) = {b, i * h, 0};
  Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {0:count - 1}
  Line(40 + i) = {10 + i, 11 + i};  Line(50 + i) = {20 + i, 21 + i};
  Curve Loop(i + 1) = {30 + i, 50 + i, -(31 + i), -(40 + i)};  Plane Surface(i + 1) = {i + 1};
EndFor
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {5, 10};  Line(5) = {20, 8};
Line(6) = {1, 5};  Line(7) = {2, 10};  Line(8) = {3, 20};  Line(9) = {4, 8};
Curve Loop(11) = {1, 7, -4, -6};   Plane Surface(11) = {11};
Curve Loop(12) = {2, 8, -30, -7};  Plane Surface(12) = {12};
Curve Loop(13) = {3, 9, -5, -8};   Plane Surface(13) = {13};
Transfinite Curve {30:36, 2} = n + 1;
Transfinite Curve {40:45, 50:55, 6:9} = 6;
Transfinite Curve {1, 3, 4, 5} = 9;
Transfinite Surface {1:6, 11:13};
Recombine Surface {1:6, 11:13};

For i In {1:count}
  Physical Surface(Sprintf("block_%g", i)) = {i};
  Physical Curve(Sprintf("joint_%g", i)) = {29 + i};
EndFor
Physical Surface("base") = {11:13};
Physical Curve("left") = {40:45};
Physical Curve("free") = {50:55, 36, 4, 5};
Physical Curve("bottom") = {1:3};
Physical Curve("sides") = {6, 9};
