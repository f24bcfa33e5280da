// One block of a gravity dam on rock: 30 m high, 24 m wide at its base, 4 m at its crest, 15 m long
// from one contraction joint (y = 0) to the next; upstream face x = 0, base z = 0. Variable:
//   n   contact faces from the upstream to the downstream face (8)
DefineConstant[ n = 8 ];
B = 24; H = 30; crest = 4; L = 15; left = 36; right = 36; depth = 36;
m = Round(0.75 * n);   // faces along the far parts, which grow with the distance
layers = Round(0.625 * n);
growth = 1 + 1.2 / m;

Point(1) = {-left, 0, -depth};  Point(2) = {0, 0, -depth};  Point(3) = {B, 0, -depth};  Point(4) = {B + right, 0, -depth};
Point(5) = {-left, 0, 0};       Point(6) = {0, 0, 0};       Point(7) = {B, 0, 0};       Point(8) = {B + right, 0, 0};
Point(9) = {0, 0, H};           Point(10) = {crest, 0, H};

Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};
Line(4) = {5, 6};  Line(5) = {6, 7};  Line(6) = {7, 8};
Line(7) = {1, 5};  Line(8) = {2, 6};  Line(9) = {3, 7};  Line(10) = {4, 8};
Line(11) = {6, 9};  Line(12) = {7, 10};  Line(13) = {9, 10};

Curve Loop(1) = {1, 8, -4, -7};     Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -5, -8};     Plane Surface(2) = {2};
Curve Loop(3) = {3, 10, -6, -9};    Plane Surface(3) = {3};
Curve Loop(4) = {5, 12, -13, -11};  Plane Surface(4) = {4};

Transfinite Curve {2, 5, 13} = n + 1;
Transfinite Curve {11, 12} = Round(1.25 * n) + 1;
Transfinite Curve {1, 4} = m + 1 Using Progression 1 / growth;
Transfinite Curve {3, 6} = m + 1 Using Progression growth;
Transfinite Curve {7, 8, 9, 10} = m + 1 Using Progression 1 / growth;
Transfinite Surface {1, 2, 3, 4};
Recombine Surface {1, 2, 3, 4};

// out[0]: the end at y = L, out[1]: the volume, then the sides in the order of the curve loop
rock1[] = Extrude {0, L, 0} { Surface{1}; Layers{layers}; Recombine; };
rock2[] = Extrude {0, L, 0} { Surface{2}; Layers{layers}; Recombine; };
rock3[] = Extrude {0, L, 0} { Surface{3}; Layers{layers}; Recombine; };
dam[]   = Extrude {0, L, 0} { Surface{4}; Layers{layers}; Recombine; };

Physical Volume("dam", 1) = {dam[1]};
Physical Volume("rock", 2) = {rock1[1], rock2[1], rock3[1]};
Physical Surface("base", 11) = {dam[2]};
Physical Surface("upstream", 12) = {dam[5]};
Physical Surface("downstream", 13) = {dam[3]};
Physical Surface("crest", 14) = {dam[4]};
Physical Surface("reservoir_bed", 15) = {rock1[4]};
Physical Surface("valley", 16) = {rock3[4]};
Physical Surface("rock_bottom", 17) = {rock1[2], rock2[2], rock3[2]};
Physical Surface("rock_sides", 18) = {rock1[5], rock3[3]};
Physical Surface("rock_ends", 19) = {1, 2, 3, rock1[0], rock2[0], rock3[0]};
Physical Surface("dam_ends", 20) = {4, dam[0]};
