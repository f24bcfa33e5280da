// The lower half of a cylinder, half of it by symmetry: a quarter of a disc of radius 100 mm, cut flat by 0.02 mm along
// s = 2 mm where it touches y = 0 (the roundness there is the initial gap of the joint). Elements of size h along this
// line and above it, growing to 6 mm (unit: mm).
DefineConstant[ h = 0.05 ];
R = 100; s = 2;
y0 = Sqrt(R * R - s * s);
b = s / 2;  // height of the regular part
Point(1) = {0, y0, 0};  Point(2) = {0, 0, 0};  Point(3) = {s, 0, 0};  Point(4) = {R, y0, 0};
Point(5) = {s, b, 0};   Point(6) = {0, b, 0};
Line(1) = {2, 3};  Circle(2) = {3, 1, 4};  Line(3) = {4, 1};  Line(4) = {1, 6};  Line(5) = {6, 2};
Line(6) = {3, 5};  Line(7) = {5, 6};
Curve Loop(1) = {1, 6, 7, 5};      Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7, -6};  Plane Surface(2) = {2};
Transfinite Curve {1, 7} = s / (2 * h) + 1;
Transfinite Curve {5, 6} = b / (2 * h) + 1;
Transfinite Surface {1};
// everything is cut into quadrilaterals, which halves the sizes
Recombine Surface {1, 2};
Mesh.SubdivisionAlgorithm = 1;  Mesh.RecombineAll = 1;

Field[1] = Distance;  Field[1].CurvesList = {6, 7};  Field[1].NumPointsPerCurve = 50;
Field[2] = MathEval;  Field[2].F = Sprintf("Min(12, %g + 0.25 * F1)", 2 * h);
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;  Mesh.MeshSizeExtendFromBoundary = 0;  Mesh.MeshSizeFromCurvature = 0;

Physical Surface("cylinder", 1) = {1, 2};
Physical Curve("contact", 11) = {1};
Physical Curve("round", 12) = {2};
Physical Curve("middle", 13) = {3};
Physical Curve("axis", 14) = {4, 5};
