// A round arch of 7 voussoirs on two abutments: 150 degrees of a ring, radii 2.2 m and 2.55 m, centre in (0, 0).
// Joints are radial. n elements across the ring, m along each voussoir.
DefineConstant[ n = 4, m = 5 ];
inside = 2.2; outside = 2.55; opening = 150 * Pi / 180; count = 7; foot = 0.5;
Point(1) = {0, 0, 0};
// joint i = 0 ... 7, from the left springing to the right one
For i In {0:count}
  angle = Pi / 2 + opening / 2 - i * opening / count;
  Point(10 + i) = {inside * Cos(angle), inside * Sin(angle), 0};
  Point(30 + i) = {outside * Cos(angle), outside * Sin(angle), 0};
  Line(50 + i) = {10 + i, 30 + i};
EndFor
For i In {0:count - 1}
  Circle(70 + i) = {10 + i, 1, 11 + i};
  Circle(90 + i) = {30 + i, 1, 31 + i};
  Curve Loop(i + 1) = {70 + i, 51 + i, -(90 + i), -(50 + i)};  Plane Surface(i + 1) = {i + 1};
EndFor
// abutments: the ring goes on along its tangents
For k In {0:1}
  i = k * count;  direction = 2 * k - 1;
  angle = Pi / 2 - direction * opening / 2;
  tx = direction * foot * Sin(angle);  ty = -direction * foot * Cos(angle);
  a[] = Point{10 + i};  b[] = Point{30 + i};
  Point(130 + k) = {a[0] + tx, a[1] + ty, 0};  Point(140 + k) = {b[0] + tx, b[1] + ty, 0};
  Line(150 + k) = {10 + i, 130 + k};  Line(160 + k) = {130 + k, 140 + k};  Line(170 + k) = {30 + i, 140 + k};
  Curve Loop(100 + k) = {150 + k, 160 + k, -(170 + k), -(50 + i)};  Plane Surface(100 + k) = {100 + k};
EndFor
Transfinite Curve {50:57, 160, 161} = n + 1;
Transfinite Curve {70:76, 90:96, 150, 151, 170, 171} = m + 1;
Transfinite Surface {1:7, 100, 101};
Recombine Surface {1:7, 100, 101};

For i In {1:count}
  Physical Surface(Sprintf("voussoir_%g", i)) = {i};
  Physical Curve(Sprintf("extrados_%g", i)) = {89 + i};
EndFor
For i In {0:count}
  Physical Curve(Sprintf("joint_%g", i)) = {50 + i};
EndFor
Physical Surface("abutments") = {100, 101};
Physical Curve("feet") = {160, 161};
Physical Curve("free") = {70:76, 150, 151, 170, 171};
