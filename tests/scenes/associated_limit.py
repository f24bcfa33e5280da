#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Limit loads with associated flow (angle of dilatancy = angle of friction) against a second-order cone program.

With associated flow the theorems of limit analysis hold: whatever the stiffness of bodies and joints and the way to it, the limit
load is the smallest that drives a motion of the wedge, as a rigid body, in which every node of its planes rises by the angle of friction
or more. That is a second-order cone program of six unknowns, the velocity v and the spin w of the wedge about its centroid:

    lambda = min -W.v   with   P.v = 1,   u_i = v + w x (x_i - x_0),   n_i.u_i >= f |u_i - (n_i.u_i) n_i|

over the nodes x_i of the planes. It is solved by linear programs (HiGHS) whose tangent planes close in on the cones; the nodes come from
Gmsh's file, normals and loads from the corners of the wedge: nothing comes from the program that is tested.

usage: associated_limit.py FUGA
"""
import math
import pathlib
import sys
import tempfile

import meshio
import numpy
from scipy.optimize import linprog

import limits_in_space
import spatial_model

# Friction, wedge and its push out of the slope. With 0.9 no motion is admitted, and any push is carried.
CASES = [(0.6, 1, (0.3, -1.0, 0.0)), (0.6, 4, (0.0, -1.0, 0.0)), (0.6, 7, (0.0, -0.5, 0.5)), (0.9, 1, (0.3, -0.2, 1.0)),
         (0.9, 4, (0.2, -1.0, -0.1))]
LARGE = 1000.0  # a push, in weights of the wedge


def nodes_of_planes(mesh_file, names):
    """{plane: nodes of its triangles, an array of points}"""
    mesh = meshio.read(mesh_file)
    result = {}
    for name in names:
        number = mesh.field_data[name][0]
        nodes = set()
        for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"], strict=True):
            if block.type == "triangle":
                nodes.update(block.data[tags == number].ravel())
        result[name] = mesh.points[sorted(nodes)]
    return result


def geometry(corners):
    """Normals into the wedge of its planes {left, right}, and its centroid."""
    toe, left, right, back = (numpy.array(corner, float) for corner in corners)
    centroid = (toe + left + right + back) / 4
    normals = {}
    for name, on_crest in (("left", left), ("right", right)):
        normal = numpy.cross(back - toe, on_crest - toe)
        normals[name] = math.copysign(1.0, normal @ (centroid - toe)) * normal / numpy.linalg.norm(normal)
    return normals, centroid


def limit_load(mesh_file, corners, push, friction):
    """The smallest push per weight that drives a motion which friction admits; infinite if it admits none."""
    normals, centroid = geometry(corners)
    nodes = []  # of each the matrices that take (v, w) to its normal and its tangential velocity
    for name, points in nodes_of_planes(mesh_file, normals).items():
        n = normals[name]
        t1 = numpy.cross(n, [0.0, 0.0, 1.0])
        t1 /= numpy.linalg.norm(t1)
        for arm in points - centroid:
            rows = [numpy.concatenate([axis, numpy.cross(arm, axis)]) for axis in (n, t1, numpy.cross(n, t1))]
            nodes.append((rows[0], numpy.array(rows[1:])))
    # A spin of 10 per length of the mesh is far beyond what a motion with P.v = 1 needs.
    bounds = [(-10.0, 10.0)] * 6
    planes = [friction * numpy.array([math.cos(a), math.sin(a)]) @ slip - rise for rise, slip in nodes
              for a in numpy.arange(8) * math.pi / 4]
    for _ in range(100):
        found = linprog([0.0, 0.0, 1.0, 0.0, 0.0, 0.0], planes, numpy.zeros(len(planes)), [[*push, 0.0, 0.0, 0.0]], [1.0], bounds,
                        method="highs", options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
        if found.status == 2:  # infeasible
            return math.inf
        assert found.status == 0, found.message
        cuts = []
        for rise, slip in nodes:
            velocity = slip @ found.x
            size = numpy.linalg.norm(velocity)
            if friction * size > rise @ found.x + 1e-9:
                cuts.append(friction * velocity / size @ slip - rise)
        if not cuts:
            return found.fun
        planes += cuts
    raise RuntimeError("the tangent planes do not close in on the cones")


def main():
    check = limits_in_space.Check()
    with tempfile.TemporaryDirectory() as name:
        for friction, number, push in CASES:
            corners = limits_in_space.WEDGES[number]
            mesh_file = spatial_model.mesh(pathlib.Path(name), f"wedge_{number}", limits_in_space.WEDGE.format(
                *(", ".join(map(str, corner)) for corner in corners)))
            limit = limit_load(mesh_file, corners, push, friction)
            print(f"wedge {number}, f = {friction}, pushed along {push}: {limit:.10f}")
            # Where there is a limit, it is found at 0.8 of the second stage: not at its end.
            largest = min(limit / 0.8, LARGE)
            for stiffness in ("1e6", "1e7"):
                result = limits_in_space.run(mesh_file, {"left": "wedge", "right": "wedge"}, stiffness, friction,
                                             [largest * x for x in push], dilatancy=math.degrees(math.atan(friction)))
                title = f"wedge {number}, f = {friction}, along {push}, stiffness {stiffness}"
                if largest < LARGE:
                    check(title, result, 0.8, limits_in_space.APPROACHED)
                elif result[0] != 0:
                    check.complaints.append(f"{title}: exit code {result[0]}\n{result[2][-1500:]}")
    print("\n".join(check.complaints) or "the limit loads are those of the cone program")
    sys.exit(1 if check.complaints else 0)


main()
