// A cylindrical arch dam of five monoliths in a valley with sloping flanks, with vertical contraction joints c1 ... c4 and the
// joints b1 ... b5 on the rock, those of the outer monoliths also at the abutments. The axis of the cylinder is x = y = 0,
// the reservoir lies outside of it, at x < 0, and the middle of the dam at y = 0. The dam is a polygon of 5 n panels. Variables:
//   n            panels of a monolith (2), one hexahedron wide each
//   layers       hexahedra over the height of the dam (4)
//   across       hexahedra through its thickness (2)
//   tetrahedra   1: Gmsh's tetrahedra, of the given size in the dam
DefineConstant[ n = 2, layers = 4, across = 2, tetrahedra = 0, size = 12 ];
R = 100; T = 10; H = 40;         // downstream radius, thickness, height in the middle
rise = 16;                       // of the rock, from the middle monolith to the abutments
side = 20; depth = 20;           // of the rock around
monolith = 16; abutment = 10;    // degrees
N = 5 * n + 2;                   // panels, the first and last one of rock

// Stations are numbered from 0 to N; point p, line l, face f of station k have the numbers 100 k + p, ..., and what lies
// between the stations k and k + 1 has 100 k + 50 + that of its beginning.
//
//   11 --7-- 9 --8-- 10 --9-- 12     crest; 11 and 12 at the abutments only
//    |       |        |        |     16, 14, 15, 17; faces 5, 4, 6
//    5 --4-- 6 --5--  7 --6--  8     surface of the rock
//    |       |        |        |     10, 11, 12, 13; faces 1, 2, 3
//    1 --1-- 2 --2--  3 --3--  4     bottom
For k In {0 : N}
  degrees = (k == 0) ? -2.5 * monolith - abutment : (k == N) ? 2.5 * monolith + abutment : ((k - 1) / n - 2.5) * monolith;
  c = -Cos(degrees * Pi / 180); s = -Sin(degrees * Pi / 180); o = 100 * k;
  above = Fabs(degrees) / monolith - 0.5;
  z = rise * ((above < 0) ? 0 : (above > 2) ? 1 : above / 2);
  outer = (k <= 1 || k >= N - 1);
  radius[] = {R - side, R, R + T, R + T + side};
  For j In {0 : 3}
    Point(o + 1 + j) = {radius[j] * c, radius[j] * s, -depth, 2 * size};
    Point(o + 5 + j) = {radius[j] * c, radius[j] * s, z, (j == 1 || j == 2) ? size : 2 * size};
    Line(o + 10 + j) = {o + 1 + j, o + 5 + j};
  EndFor
  For j In {0 : 2}
    Line(o + 1 + j) = {o + 1 + j, o + 2 + j};
    Line(o + 4 + j) = {o + 5 + j, o + 6 + j};
    Curve Loop(o + 1 + j) = {o + 1 + j, o + 11 + j, -(o + 4 + j), -(o + 10 + j)};
    Plane Surface(o + 1 + j) = {o + 1 + j};
  EndFor
  Point(o + 9) = {R * c, R * s, H, size};
  Point(o + 10) = {(R + T) * c, (R + T) * s, H, size};
  Line(o + 8) = {o + 9, o + 10};
  Line(o + 14) = {o + 6, o + 9};
  Line(o + 15) = {o + 7, o + 10};
  Curve Loop(o + 4) = {o + 5, o + 15, -(o + 8), -(o + 14)};
  Plane Surface(o + 4) = {o + 4};
  across_lines[] += {o + 2, o + 5, o + 8};
  side_lines[] += {o + 1, o + 4, -(o + 3), -(o + 6)};
  depth_lines[] += {-(o + 10), -(o + 11), -(o + 12), -(o + 13)};
  height_lines[] += {o + 14, o + 15};
  If (outer)
    Point(o + 11) = {(R - side) * c, (R - side) * s, H, 2 * size};
    Point(o + 12) = {(R + T + side) * c, (R + T + side) * s, H, 2 * size};
    Line(o + 7) = {o + 11, o + 9};
    Line(o + 9) = {o + 10, o + 12};
    Line(o + 16) = {o + 5, o + 11};
    Line(o + 17) = {o + 8, o + 12};
    Curve Loop(o + 5) = {o + 4, o + 14, -(o + 7), -(o + 16)};
    Plane Surface(o + 5) = {o + 5};
    Curve Loop(o + 6) = {o + 6, o + 17, -(o + 9), -(o + 15)};
    Plane Surface(o + 6) = {o + 6};
    side_lines[] += {o + 7, -(o + 9)};
    height_lines[] += {o + 16, o + 17};
  EndIf
EndFor

from[] = {0, 1, 2, 3, 5, 6, 7, 11, 9, 10, 1, 2, 3, 4, 6, 7, 5, 8}; // points at the ends of the lines 1 ... 17
to[]   = {0, 2, 3, 4, 6, 7, 8, 9, 10, 12, 5, 6, 7, 8, 9, 10, 11, 12};
below[] = {0, 1, 2, 3, 5, 4, 6}; right[] = {0, 11, 12, 13, 15, 14, 17}; // lines around the faces 1 ... 6
over[] = {0, 4, 5, 6, 8, 7, 9};  left[] = {0, 10, 11, 12, 14, 16, 15};
For k In {0 : N - 1}
  o = 100 * k;
  outer = (k == 0 || k == N - 1);
  For p In {1 : outer ? 12 : 10}
    Line(o + 50 + p) = {o + p, o + 100 + p};
    along_lines[] += {o + 50 + p};
  EndFor
  For l In {1 : 17}
    If (outer || (l != 7 && l != 9 && l < 16))
      Curve Loop(o + 50 + l) = {o + 50 + from[l], o + 100 + l, -(o + 50 + to[l]), -(o + l)};
      Surface(o + 50 + l) = {o + 50 + l};
    EndIf
  EndFor
  For f In {1 : outer ? 6 : 4}
    Surface Loop(o + 50 + f) = {o + f, o + 100 + f, o + 50 + below[f], o + 50 + right[f], o + 50 + over[f], o + 50 + left[f]};
    Volume(o + 50 + f) = {o + 50 + f};
    If (outer || f < 4)
      rock[] += {o + 50 + f};
    EndIf
  EndFor
  bottom[] += {o + 51, o + 52, o + 53};
  sides[] += {o + 60, o + 63};
  If (outer)
    sides[] += {o + 66, o + 67};
    dry[] += {o + 57, o + 58, o + 59};
  Else
    bed[] += {o + 56};
    dry[] += {o + 54};
  EndIf
EndFor
For f In {1 : 6}
  sides[] += {f, 100 * N + f};
EndFor
dry[] += {105, 106, 100 * (N - 1) + 5, 100 * (N - 1) + 6};

If (!tetrahedra)
  Transfinite Curve {across_lines[]} = across + 1;
  Transfinite Curve {side_lines[]} = 3 Using Progression 0.6;
  Transfinite Curve {depth_lines[]} = 3 Using Progression 1.6;
  Transfinite Curve {height_lines[]} = layers + 1;
  Transfinite Curve {along_lines[]} = 2;
  Transfinite Surface "*";
  Recombine Surface "*";
  Transfinite Volume "*";
EndIf

Physical Volume("rock", 1) = {rock[]};
Physical Surface("rock_sides", 2) = {bottom[], sides[]};
Physical Surface("reservoir_bed", 3) = {bed[]};
For m In {1 : 5}
  part[] = {}; base[] = {};
  For k In {1 + (m - 1) * n : m * n}
    part[] += {100 * k + 54};
    base[] += {100 * k + 55};
    upstream[] += {100 * k + 65};
    dry[] += {100 * k + 58, 100 * k + 64};
  EndFor
  If (m == 1)
    base[] += {104};
  ElseIf (m == 5)
    base[] += {100 * (N - 1) + 4};
  EndIf
  Physical Volume(Sprintf("m%g", m), 10 + m) = {part[]};
  Physical Surface(Sprintf("b%g", m), 20 + m) = {base[]};
  If (m < 5)
    Physical Surface(Sprintf("c%g", m), 30 + m) = {100 * (1 + m * n) + 4};
  EndIf
EndFor
Physical Surface("upstream", 4) = {upstream[]};
Physical Surface("dry", 5) = {dry[]};
