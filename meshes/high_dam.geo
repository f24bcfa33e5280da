// A gravity dam, 45 m high, 34 m wide at its base and 6 m at its crest, with a gallery and a key, on rock with a crack below the heel
// and a weak seam, which runs under the dam and comes out in a slope downstream. The upstream face is x = 0, the base y = 0.
// Variable (gmsh -setnumber):
//   h   size of the cells along the joints (1.4)
DefineConstant[ h = 1.4 ];
far = 60;

// dam: heel, key, toe, crest; gallery
Point(1) = {0, 0, 0, 0.7*h};     Point(2) = {12, 0, 0, h};       Point(3) = {13, -2, 0, h};      Point(4) = {18, -2, 0, h};
Point(5) = {19, 0, 0, h};        Point(6) = {34, 0, 0, h};       Point(7) = {6, 38, 0, 2*h};     Point(8) = {6, 45, 0, 2*h};
Point(9) = {0, 45, 0, 2*h};
Point(11) = {3, 3, 0, 0.7*h};    Point(12) = {5, 3, 0, 0.7*h};   Point(13) = {5, 6, 0, 0.7*h};   Point(14) = {3, 6, 0, 0.7*h};
// rock: seam from the end of the crack to the slope, slope, far lines
Point(21) = {0, -7, 0, h};       Point(22) = {62, -6, 0, h};     Point(23) = {58, 0, 0, 1.5*h};  Point(24) = {66, -12, 0, 3*h};
Point(25) = {-far, 0, 0, 8*h};   Point(26) = {-far, -far, 0, 8*h};
Point(27) = {60 + far, -far, 0, 8*h};                            Point(28) = {60 + far, -12, 0, 8*h};

Line(1) = {1, 2};    Line(2) = {2, 3};    Line(3) = {3, 4};    Line(4) = {4, 5};    Line(5) = {5, 6};  // base
Line(6) = {6, 7};    Line(7) = {7, 8};    Line(8) = {8, 9};    Line(9) = {9, 1};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 11};
Line(20) = {1, 21};  Line(21) = {21, 22};                                                             // crack, seam
Line(22) = {6, 23};  Line(23) = {23, 22}; Line(24) = {22, 24}; Line(25) = {24, 28};
Line(26) = {25, 1};  Line(27) = {26, 25}; Line(28) = {26, 27}; Line(29) = {27, 28};

Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8, 9};
Curve Loop(2) = {11, 12, 13, 14};
Curve Loop(3) = {20, 21, -23, -22, -5, -4, -3, -2, -1};
Curve Loop(4) = {28, 29, -25, -24, -21, -20, -26, -27};
Plane Surface(1) = {1, 2};  Plane Surface(2) = {3};  Plane Surface(3) = {4};

Recombine Surface {1, 2, 3};

Physical Surface("dam", 1) = {1};
Physical Surface("block", 2) = {2};
Physical Surface("rock", 3) = {3};
Physical Curve("base", 11) = {1, 2, 3, 4, 5};
Physical Curve("crack", 12) = {20};
Physical Curve("seam", 13) = {21};
Physical Curve("upstream", 14) = {9};
Physical Curve("reservoir_bed", 15) = {26};
Physical Curve("dry", 16) = {6, 7, 8, 11, 12, 13, 14, 22, 23, 24, 25};
Physical Curve("rock_bottom", 17) = {28};
Physical Curve("rock_sides", 18) = {27, 29};
