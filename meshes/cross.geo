// Four blocks 1 m x 1 m that meet at a cross:   c d
// every pair of neighbours has its joint.       a b      n x n squares each.
DefineConstant[ n = 2 ];
For j In {0:2}
  For i In {0:2}
    Point(3 * j + i + 1) = {i, j, 0};
  EndFor
EndFor
For j In {0:2}
  For i In {1:2}
    Line(2 * j + i) = {3 * j + i, 3 * j + i + 1};
  EndFor
EndFor
For j In {0:1}
  For i In {1:3}
    Line(10 + 3 * j + i) = {3 * j + i, 3 * (j + 1) + i};
  EndFor
EndFor
For j In {0:1}
  For i In {1:2}
    s = 2 * j + i;
    Curve Loop(s) = {s, 11 + 3 * j + i, -(s + 2), -(10 + 3 * j + i)};
    Plane Surface(s) = {s};
  EndFor
EndFor
Transfinite Curve {1:6, 11:16} = n + 1;
Transfinite Surface {1:4};
Recombine Surface {1:4};

Physical Surface("a", 1) = {1};
Physical Surface("b", 2) = {2};
Physical Surface("c", 3) = {3};
Physical Surface("d", 4) = {4};
Physical Curve("j_ab", 11) = {12};
Physical Curve("j_cd", 12) = {15};
Physical Curve("j_ac", 13) = {3};
Physical Curve("j_bd", 14) = {4};
Physical Curve("bottom", 15) = {1, 2};
Physical Curve("top", 16) = {5, 6};
Physical Curve("left", 17) = {11, 14};
Physical Curve("right", 18) = {13, 16};
