// The right half of a block of width 254 and height 127, on whose bottom a punch of half-width 1 acts (line contact). Very coarse:
// seven by seven cells that double away from the contact; the program refines them where it matters.
n = 7; size = 2^n - 1;
Point(1) = {0, 0, 0};     Point(2) = {1, 0, 0};     Point(3) = {size, 0, 0};
Point(4) = {size, size, 0};  Point(5) = {1, size, 0};  Point(6) = {0, size, 0};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {5, 4};  Line(5) = {6, 5};  Line(6) = {1, 6};
Line(7) = {2, 5};
Curve Loop(1) = {1, 7, -5, -6};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, -4, -7};  Plane Surface(2) = {2};
Transfinite Curve {1, 5} = 2;
Transfinite Curve {2, 4} = n Using Progression 2;
Transfinite Curve {3, 6, 7} = n + 1 Using Progression 2;
Transfinite Surface {1, 2};
Recombine Surface {1, 2};

Physical Surface("block", 1) = {1, 2};
Physical Curve("contact", 11) = {1};
Physical Curve("free", 12) = {2};
Physical Curve("right", 13) = {3};
Physical Curve("top", 14) = {4, 5};
Physical Curve("axis", 15) = {6};
