// Patch test: two blocks, 3 m wide and together 4 m high, with an oblique joint and an unstructured mesh.
// Variables: angle of the joint against the horizontal in degrees (20), triangles: 1 or 0, size.
DefineConstant[ angle = 20, triangles = 0, size = 0.5 ];
W = 3; H = 4;
rise = W / 2 * Tan(angle * Pi / 180);

// the size differs from corner to corner, so that the elements do
Point(1) = {0, 0, 0, size};            Point(2) = {W, 0, 0, 1.4 * size};
Point(3) = {0, H / 2 - rise, 0, size}; Point(4) = {W, H / 2 + rise, 0, 0.6 * size};
Point(5) = {0, H, 0, 1.3 * size};      Point(6) = {W, H, 0, 0.8 * size};
Line(1) = {1, 2};  Line(2) = {2, 4};  Line(3) = {3, 4};  Line(4) = {1, 3};
Line(5) = {4, 6};  Line(6) = {5, 6};  Line(7) = {3, 5};
Curve Loop(1) = {1, 2, -3, -4};  Plane Surface(1) = {1};
Curve Loop(2) = {3, 5, -6, -7};  Plane Surface(2) = {2};
If (!triangles)
  // recombination may leave triangles; the subdivision turns everything into quadrilaterals
  Recombine Surface {1, 2};
  Mesh.SubdivisionAlgorithm = 1;
  Mesh.RecombineAll = 1;
EndIf

Physical Surface("lower", 1) = {1};
Physical Surface("upper", 2) = {2};
Physical Curve("joint", 11) = {3};
Physical Curve("bottom", 12) = {1};
Physical Curve("top", 13) = {6};
Physical Curve("left_lower", 14) = {4};
Physical Curve("left_upper", 15) = {7};
Physical Curve("right_lower", 16) = {2};
Physical Curve("right_upper", 17) = {5};
