// An anchor bar, half of it by symmetry: 1 m long, 0.02 m (half the thickness) high, under a block 0.05 m high; the
// joint between them is y = 0.02. n x 1 elements in the bar, n x 4 in the block.
DefineConstant[ n = 40 ];
L = 1; d = 0.02; H = 0.07;
Point(1) = {0, 0, 0};  Point(2) = {L, 0, 0};
Point(3) = {0, d, 0};  Point(4) = {L, d, 0};
Point(5) = {0, H, 0};  Point(6) = {L, H, 0};
Line(1) = {1, 2};  Line(2) = {3, 4};  Line(3) = {5, 6};
Line(4) = {1, 3};  Line(5) = {2, 4};  Line(6) = {3, 5};  Line(7) = {4, 6};
Curve Loop(1) = {1, 5, -2, -4};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 7, -3, -6};  Plane Surface(2) = {2};
Transfinite Curve {1, 2, 3} = n + 1;
Transfinite Curve {4, 5} = 2;
Transfinite Curve {6, 7} = 5;
Transfinite Surface {1, 2};
Recombine Surface {1, 2};

Physical Surface("bar", 1) = {1};
Physical Surface("block", 2) = {2};
Physical Curve("bond", 11) = {2};
Physical Curve("axis", 12) = {1};
Physical Curve("far_end", 13) = {4};
Physical Curve("head", 14) = {5};
Physical Curve("block_face", 15) = {7};
Physical Curve("block_end", 16) = {6};
Physical Curve("block_top", 17) = {3};
