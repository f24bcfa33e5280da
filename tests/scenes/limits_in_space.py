#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Limit loads in space that are known by hand, with joints from soft to rigid: first the weight, then a growing force.

* A block on a slab topples about an edge or, pushed along its diagonal, over its corner: c W h / 2 = W a, with a the distance from the
  centre to the edge or corner along the force. Exact: 1e-9.
* The same block under weight and push that grow together stands or falls at once.
* Two cubes slide on a slab, pushed obliquely: c = f.
* Rock wedges on two planes, cut into tetrahedra. Hoek and Bray, Rock Slope Engineering (1981), chapter 8: the wedge slides along
  the line of intersection l, so that friction acts along it alone and the normal forces follow from equilibrium across
  it, N1 n1 + N2 n2 + W - (W.l) l = 0; P = f (N1 + N2) - W.l.

While directions of slip still turn, a limit is approached as slips grow without bounds and the path ends less than 1e-8 of the stage
before it (theory, section 17): tolerance 1e-8 for what slides. With stiff and rigid joints a wedge carries more at first, because friction
still points away from l, and then jumps: its equilibrium is followed at least as far as the load by hand, and the load of the jump is a
smooth function of the compliance, so that from 1e11 kPa/m to rigid it changes by about a hundredth of the change from 1e9.

Every limit load must be shown by a motion: the certificate of the mechanism in summary.json.

usage: limits_in_space.py FUGA
"""
import math
import pathlib
import sys
import tempfile

import spatial_model

FUGA = pathlib.Path(sys.argv[1]).resolve()
EXACT, APPROACHED = 1e-9, 1e-8
FRICTION, DENSITY = 0.9, 25.0
# Corners of the wedge: on the face of the slope, left and right on the crest, behind the crest.
WEDGES = [((5, 0, 3), (1, 0, 10), (9, 0, 10), (5, 6, 10)), ((5, 0, 3), (2, 0, 10), (9, 0, 10), (5, 7, 10)),
          ((4, 0, 4), (1, 0, 10), (9, 0, 10), (5, 6, 10)), ((5, 0, 5), (1, 0, 10), (8, 0, 10), (4, 6, 10)),
          ((6, 0, 3), (1, 0, 10), (9, 0, 10), (5, 8, 10)), ((5, 0, 6), (1, 0, 10), (9, 0, 10), (6, 6, 10)),
          ((3, 0, 4), (1, 0, 10), (9, 0, 10), (6, 8, 10)), ((7, 0, 4), (2, 0, 10), (9, 0, 10), (5, 7, 10))]

BLOCK = """
Point(1) = {{0, 0, -1}};
line[] = Extrude{{1, 0, 0}}{{ Point{{1}}; Layers{{{n}}}; }};
square[] = Extrude{{0, 1, 0}}{{ Line{{line[1]}}; Layers{{{n}}}; Recombine; }};
slab[] = Extrude{{0, 0, 1}}{{ Surface{{square[1]}}; Layers{{2}}; Recombine; }};
block[] = Extrude{{0, 0, 4}}{{ Surface{{slab[0]}}; Layers{{4}}; Recombine; }};
Physical Volume("rock") = {{slab[1]}};
Physical Volume("block") = {{block[1]}};
Physical Surface("base") = {{slab[0]}};
Physical Surface("bottom") = {{square[1]}};
Physical Surface("free") = {{slab[2], slab[3], slab[4], slab[5], block[0], block[2], block[3], block[4], block[5]}};
"""

CUBES = """
SetFactory("OpenCASCADE");
Box(1) = {0, 0, -1, 3, 1, 1}; Box(2) = {0, 0, 0, 1, 1, 1}; Box(3) = {2, 0, 0, 1, 1, 1};
parts() = BooleanFragments{ Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
rock() = Volume{:}; rock() -= {2, 3};
Physical Volume("one") = {2};
Physical Volume("two") = {3};
Physical Volume("rock") = {rock()};
first() = Surface In BoundingBox{-0.01, -0.01, -0.01, 1.01, 1.01, 0.01};
second() = Surface In BoundingBox{1.99, -0.01, -0.01, 3.01, 1.01, 0.01};
bottom() = Surface In BoundingBox{-0.01, -0.01, -1.01, 3.01, 1.01, -0.99};
Physical Surface("first") = {first()};
Physical Surface("second") = {second()};
Physical Surface("bottom") = {bottom()};
outer() = CombinedBoundary{ Volume{:}; };
free() = {};
For i In {0 : #outer() - 1}
  If (Abs(outer(i)) != bottom(0))
    free() += {Abs(outer(i))};
  EndIf
EndFor
Physical Surface("free") = {free()};
Mesh.CharacteristicLengthMax = 0.5;
"""

WEDGE = """
SetFactory("OpenCASCADE");
Box(1) = {{0, 0, 0, 10, 10, 10}};
Point(101) = {{{0}}}; Point(102) = {{{1}}}; Point(103) = {{{2}}}; Point(104) = {{{3}}};
Line(101) = {{101, 102}}; Line(102) = {{102, 104}}; Line(103) = {{104, 101}};
Line(104) = {{101, 103}}; Line(105) = {{103, 104}}; Line(106) = {{102, 103}};
Curve Loop(101) = {{101, 102, 103}};   Plane Surface(101) = {{101}};
Curve Loop(102) = {{104, 105, 103}};   Plane Surface(102) = {{102}};
Curve Loop(103) = {{101, 106, -104}};  Plane Surface(103) = {{103}};
Curve Loop(104) = {{102, -105, -106}}; Plane Surface(104) = {{104}};
Surface Loop(101) = {{101, 102, 103, 104}}; Volume(101) = {{101}};
parts() = BooleanFragments{{ Volume{{1}}; Delete; }}{{ Volume{{101}}; Delete; }};
rock() = Volume{{:}}; rock() -= {{101}};
Physical Volume("wedge") = {{101}};
Physical Volume("rock") = {{rock()}};
Physical Surface("left") = {{101}};
Physical Surface("right") = {{102}};
bottom() = Surface In BoundingBox{{-1, -1, -0.01, 11, 11, 0.01}};
Physical Surface("bottom") = {{bottom()}};
outer() = CombinedBoundary{{ Volume{{:}}; }};
free() = {{}};
For i In {{0 : #outer() - 1}}
  If (Abs(outer(i)) != bottom(0))
    free() += {{Abs(outer(i))}};
  EndIf
EndFor
Physical Surface("free") = {{free()}};
Mesh.CharacteristicLengthMax = 2;
Mesh.CharacteristicLengthMin = 0.5;
"""

PARAMETERS = """
set Dimension = 3
subsection Mesh
  set File = {mesh}
end
subsection Bodies
{bodies}  subsection rock
    set Young modulus = 1e7
    set Poisson ratio = 0.2
  end
end
subsection Joints
{joints}end
subsection Boundaries
  subsection bottom
    set Fixed = all
  end
  subsection free
    set Fixed = free
  end
end
subsection Loads
  subsection weight
    set Type = weight
  end
  subsection push
    set Type   = seismic
    set Horizontal coefficient = {horizontal!r}
    set Horizontal direction   = {direction}
    set Vertical coefficient   = {vertical!r}
  end
end
subsection Stages
{stages}end
subsection Output
  set Fields = never
end
"""

WEIGHT_THEN_PUSH = """  subsection weight
    set Loads = weight: t
  end
  subsection push
    set Loads = push: t
  end
"""
TOGETHER = """  subsection together
    set Loads = weight: t; push: t
  end
"""


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def limit_by_hand(corners):
    """The force per weight at which the wedge slides, and its unit vector."""
    toe, left, right, back = corners
    line = unit(minus(toe, back))
    weight = [0.0, 0.0, -1.0]
    normals = []
    for on_crest, other in ((left, right), (right, left)):
        normal = unit(cross(line, minus(on_crest, toe)))
        normals.append(normal if dot(normal, minus(other, toe)) > 0 else [-x for x in normal])
    across = minus(weight, [dot(weight, line) * x for x in line])
    c = dot(*normals)
    b = [-dot(across, normal) for normal in normals]
    pressures = [(b[0] - c * b[1]) / (1 - c * c), (b[1] - c * b[0]) / (1 - c * c)]
    assert min(pressures) > 0, "the wedge loses contact with a plane"
    return FRICTION * sum(pressures) - dot(weight, line), line


def run(mesh_file, joints, stiffness, friction, coefficients, stages=WEIGHT_THEN_PUSH, dilatancy=0):
    """@p joints: names with the body above each; @p coefficients: force per weight at the end of the second stage."""
    x, y, z = coefficients
    _, code, summary, text = spatial_model.run(FUGA, mesh_file.with_name(f"{mesh_file.stem}_{stiffness}.prm"), PARAMETERS.format(
        mesh=mesh_file.name, bodies="".join(spatial_model.body(name, 1e7, DENSITY) for name in sorted(set(joints.values()))),
        joints="".join(spatial_model.joint(name, body, "rock", friction, stiffness, dilatancy) for name, body in joints.items()),
        horizontal=math.hypot(x, y), direction=f"{x!r}; {y!r}", vertical=z, stages=stages))
    return code, summary, text


class Check:
    def __init__(self):
        self.complaints = []

    def __call__(self, name, result, limit, tolerance, may_jump=False):
        """The second stage ends at the share @p limit; where it may jump, not before."""
        code, summary, text = result
        error = (summary["t"] - 1) / limit - 1
        print(f"{name}: exit code {code}, {summary['verdict']}, error {error:.1e}, certificate {summary['certificate']['worst']:.1e}")
        if code != 3 or error < -tolerance or (error > tolerance and not may_jump) or summary["certificate"]["worst"] > EXACT:
            self.complaints.append(f"{name}: exit code {code}, error of the limit {error}\n{text[-1500:]}")
        elif summary["verdict"] == "limit load":
            proof = summary["limit_load"]["proof"]
            print(f"    resistance {proof['resistance']:.1e}, inadmissible {proof['inadmissible']:.1e}, balance {proof['balance']:.1e}, "
                  f"drive {proof['drive']:.3f}")
            # What only approaches its mechanism still meets the resistance at which the path ends (theory, section 17), some
            # times 1e-3 of the joints' stiffness.
            bound = EXACT if tolerance == EXACT else 1e-2
            if not (proof["error"] < bound and proof["inadmissible"] < EXACT and proof["drive"] > 0):
                self.complaints.append(f"{name}: the limit is not shown by a motion: {proof}")


def check_toppling(check, folder):
    for n in (2, 3, 4):
        mesh_file = spatial_model.mesh(folder, f"block_{n}", BLOCK.format(n=n))
        for stiffness in ("1e6", "1e8", "rigid"):
            for x, y in ((1.0, 0.0), (1.0, 1.0), (math.cos(math.pi / 6), 0.5)):
                arm = 0.5 * math.hypot(x, y) / max(x, y)
                limit = arm / 2 / math.hypot(x, y)
                result = run(mesh_file, {"base": "block"}, stiffness, FRICTION, (x, y, 0.0))
                check(f"block of {n} x {n} cells, stiffness {stiffness}, pushed along ({x:.2f}, {y:.2f})", result, limit, EXACT)


def check_first_load(check, folder):
    """A block pushed by c times its weight slides at once if c > f, topples at once if c > W a / (h / 2), and else stands."""
    mesh_file = spatial_model.mesh(folder, "first", BLOCK.format(n=4))
    for stiffness in ("1e6", "1e9", "rigid"):
        for friction, push, code in ((0.2, 0.21, 3), (0.2, 0.19, 0), (0.9, 0.26, 3), (0.9, 0.24, 0)):
            x, y = (math.cos(math.pi / 6), 0.5) if friction < 0.25 else (1.0, 0.0)
            found, summary, text = run(mesh_file, {"base": "block"}, stiffness, friction, (push * x, push * y, 0.0), TOGETHER)
            print(f"first load, f = {friction}, c = {push}, stiffness {stiffness}: exit code {found}, t = {summary['t']}")
            if found != code or summary["t"] != (1.0 if code == 0 else 0.0):
                check.complaints.append(f"first load, f = {friction}, c = {push}, stiffness {stiffness}: exit code {found}\n{text[-1500:]}")


def check_cubes(check, folder):
    mesh_file = spatial_model.mesh(folder, "cubes", CUBES)
    for stiffness in ("1e6", "1e10", "rigid"):
        for friction in (0.3, 0.6):
            result = run(mesh_file, {"first": "one", "second": "two"}, stiffness, friction, (1.0, 0.3, 0.0))
            check(f"two cubes, f = {friction}, stiffness {stiffness}", result, friction / math.hypot(1.0, 0.3), APPROACHED / friction)


def check_wedges(check, folder):
    for number, corners in enumerate(WEDGES):
        limit, line = limit_by_hand(corners)
        mesh_file = spatial_model.mesh(folder, f"wedge_{number}", WEDGE.format(*(", ".join(map(str, corner)) for corner in corners)))
        loads = {}
        for stiffness in ("1e6", "1e9", "1e11", "rigid"):
            # Twice the limit, so that it comes in the middle of the stage.
            result = run(mesh_file, {"left": "wedge", "right": "wedge"}, stiffness, FRICTION, [2 * limit * x for x in line])
            check(f"wedge {number}, stiffness {stiffness}", result, 0.5, 2 * APPROACHED, may_jump=stiffness != "1e6")
            loads[stiffness] = result[1]["t"]
        if not abs(loads["rigid"] - loads["1e11"]) <= 0.03 * abs(loads["1e11"] - loads["1e9"]) + APPROACHED:
            check.complaints.append(f"wedge {number}: the limit with rigid joints is not that of stiff ones: {loads}")


def main():
    check = Check()
    with tempfile.TemporaryDirectory(prefix="limits_") as name:
        folder = pathlib.Path(name)
        check_toppling(check, folder)
        check_first_load(check, folder)
        check_cubes(check, folder)
        check_wedges(check, folder)
    for text in check.complaints:
        print(text)
    return 1 if check.complaints else 0


if __name__ == "__main__":
    sys.exit(main())
