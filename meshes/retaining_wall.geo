// A gravity wall in two lifts on rock; the ground is to the left. Units: m.
DefineConstant[ n = 8 ]; // cells across the wall

Point(1) = {-6, -5, 0}; Point(2) = {0, -5, 0}; Point(3) = {3, -5, 0}; Point(4) = {9, -5, 0};
Point(5) = {-6, 0, 0};  Point(6) = {0, 0, 0};  Point(7) = {3, 0, 0};  Point(8) = {9, 0, 0};
Point(9) = {0, 3, 0};   Point(10) = {2, 3, 0};
Point(11) = {0, 6, 0};  Point(12) = {1, 6, 0};

Line(1) = {1, 2};   Line(2) = {2, 3};   Line(3) = {3, 4};
Line(4) = {5, 6};   Line(5) = {6, 7};   Line(6) = {7, 8};
Line(7) = {1, 5};   Line(8) = {2, 6};   Line(9) = {3, 7};   Line(10) = {4, 8};
Line(11) = {6, 9};  Line(12) = {7, 10}; Line(13) = {9, 10};
Line(14) = {9, 11}; Line(15) = {10, 12}; Line(16) = {11, 12};

Curve Loop(1) = {1, 8, -4, -7};     Plane Surface(1) = {1};
Curve Loop(2) = {2, 9, -5, -8};     Plane Surface(2) = {2};
Curve Loop(3) = {3, 10, -6, -9};    Plane Surface(3) = {3};
Curve Loop(4) = {5, 12, -13, -11};  Plane Surface(4) = {4};
Curve Loop(5) = {13, 15, -16, -14}; Plane Surface(5) = {5};

Transfinite Curve {2, 5, 13, 16} = n + 1;
Transfinite Curve {1, 4} = n + 1 Using Progression 0.8;
Transfinite Curve {3, 6} = n + 1 Using Progression 1.25;
Transfinite Curve {7, 8, 9, 10} = n + 1 Using Progression 0.8;
Transfinite Curve {11, 12, 14, 15} = n + 1;
Transfinite Surface {1:5};
Recombine Surface {1:5};

Physical Surface("rock")  = {1, 2, 3};
Physical Surface("lower") = {4};
Physical Surface("upper") = {5};
Physical Curve("base")    = {5};
Physical Curve("lift")    = {13};
Physical Curve("bottom")  = {1, 2, 3};
Physical Curve("sides")   = {7, 10};
Physical Curve("ground")  = {4, 6};
Physical Curve("back")    = {11, 14};
Physical Curve("face")    = {12, 15, 16};
