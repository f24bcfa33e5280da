// Patch test in space: two blocks, 3 x 2 m wide and together 4 m high, with a joint oblique to all axes.
// Variables: dip in x and in y of the joint (rise per length), tetrahedra: 1 or 0, size, ratio of
// neighbouring cells of the hexahedral mesh.
DefineConstant[ dip_x = 0.3, dip_y = 0.2, tetrahedra = 0, size = 1, ratio = 1.3 ];
W = 3; D = 2; H = 4;

Macro Column // a bottom, two joint and a top point at the corner (x, y); n = 10, 20, 30, 40
  z = H / 2 + dip_x * (x - W / 2) + dip_y * (y - D / 2);
  Point(n + 1) = {x, y, 0, size};
  Point(n + 2) = {x, y, z, 0.8 * size};
  Point(n + 3) = {x, y, H, 1.2 * size};
  Line(n + 1) = {n + 1, n + 2};
  Line(n + 2) = {n + 2, n + 3};
Return
n = 10; x = 0; y = 0; Call Column;
n = 20; x = W; y = 0; Call Column;
n = 30; x = W; y = D; Call Column;
n = 40; x = 0; y = D; Call Column;

For k In {1 : 3}
  Line(100 + k) = {10 + k, 20 + k};
  Line(200 + k) = {20 + k, 30 + k};
  Line(300 + k) = {40 + k, 30 + k};
  Line(400 + k) = {10 + k, 40 + k};
  Curve Loop(k) = {100 + k, 200 + k, -(300 + k), -(400 + k)};
  Plane Surface(k) = {k};
EndFor
For k In {1 : 2}
  Curve Loop(10 + k) = {100 + k, 20 + k, -(101 + k), -(10 + k)};
  Curve Loop(20 + k) = {200 + k, 30 + k, -(201 + k), -(20 + k)};
  Curve Loop(30 + k) = {300 + k, 30 + k, -(301 + k), -(40 + k)};
  Curve Loop(40 + k) = {400 + k, 40 + k, -(401 + k), -(10 + k)};
  For side In {10 : 40 : 10}
    Plane Surface(side + k) = {side + k};
  EndFor
  Surface Loop(k) = {k, k + 1, 10 + k, 20 + k, 30 + k, 40 + k};
  Volume(k) = {k};
EndFor

If (!tetrahedra)
  Transfinite Curve {101, 102, 103, 301, 302, 303} = Ceil(W / size) + 1 Using Progression ratio;
  Transfinite Curve {201, 202, 203, 401, 402, 403} = Ceil(D / size) + 1 Using Progression 1 / ratio;
  Transfinite Curve {11, 12, 21, 22, 31, 32, 41, 42} = Ceil(H / 2 / size) + 1;
  Transfinite Surface "*";
  Recombine Surface "*";
  Transfinite Volume "*";
EndIf

Physical Volume("lower", 1) = {1};
Physical Volume("upper", 2) = {2};
Physical Surface("joint", 11) = {2};
Physical Surface("bottom", 12) = {1};
Physical Surface("top", 13) = {3};
Physical Surface("front", 14) = {11, 12};
Physical Surface("right", 15) = {21, 22};
Physical Surface("back", 16) = {31, 32};
Physical Surface("left", 17) = {41, 42};
Physical Point("lower_1", 21) = {11};
Physical Point("lower_2", 22) = {21};
Physical Point("lower_3", 23) = {41};
Physical Point("upper_1", 24) = {13};
Physical Point("upper_2", 25) = {23};
