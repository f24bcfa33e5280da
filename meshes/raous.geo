// Half of the block of Raous, Chabrand and Lebon, 40 mm x 40 mm, n x n squares (unit: mm).
DefineConstant[ n = 32 ];
L = 40;
Point(1) = {0, 0, 0};  Point(2) = {L, 0, 0};  Point(3) = {L, L, 0};  Point(4) = {0, L, 0};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 2, 3, 4} = n + 1;
Transfinite Surface {1};
Recombine Surface {1};

Physical Surface("block", 1) = {1};
Physical Curve("contact", 11) = {1};
Physical Curve("right", 12) = {2};
Physical Curve("top", 13) = {3};
Physical Curve("left", 14) = {4};
Physical Point("corner", 21) = {2};
