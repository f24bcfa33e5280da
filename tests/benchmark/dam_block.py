# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The block of a gravity dam in space: meshes/dam_block_3d.geo with the data of parameters/dam_block_3d.prm.

Weight, then the pressure of the full reservoir on the upstream face times a factor. No water stands in the joint or on
the bed: the push grows in proportion, so that the limit has a closed form. Units kN, m, kPa.
"""
import functools
import itertools
import os
import subprocess

import fuga_runs
import meshes
from scenes import Scene

GEOMETRY = meshes.REPOSITORY / "meshes" / "dam_block_3d.geo"
HEIGHT, CREST, BASE, WEIGHT, WATER, FRICTION = 30., 4., 24., 24., 9.81, 0.7
# Weight times friction over the resultant of the water.
SLIDING_LIMIT = FRICTION * WEIGHT * (CREST + BASE) / 2. * HEIGHT / (WATER * HEIGHT ** 2 / 2.)
GAUSS = (-3. ** -0.5, 3. ** -0.5)
# Corners of the reference cube and square in the order of Gmsh.
CUBE = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


@functools.lru_cache(maxsize=3)
def _mesh(faces):
    path = str(fuga_runs.WORK / "meshes" / ("dam_block_gmsh_%d.msh" % faces))
    if not os.path.exists(path):
        os.makedirs(os.path.dirname(path), exist_ok=True)
        subprocess.run(["gmsh", "-3", "-v", "1", "-format", "msh22", "-setnumber", "n", str(faces), "-o", path,
                        str(GEOMETRY)], check=True, stdout=subprocess.DEVNULL)
    return meshes.read(path)


def _values(corners, point):
    """Multilinear functions of the corners at a point of the reference cell."""
    values = []
    for corner in corners:
        value = 1.
        for c, x in zip(corner, point):
            value *= (1. + c * x) / 2.
        values.append(value)
    return values


def _derivatives(corners, point, d):
    return [value * corner[d] / (1. + corner[d] * point[d])
            for corner, value in zip(corners, _values(corners, point))]


def _tangents(corners, places, point):
    """Columns of the Jacobian."""
    return [[sum(s * place[k] for s, place in zip(_derivatives(corners, point, d), places)) for k in range(3)]
            for d in range(len(point))]


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class DamBlock(Scene):
    dim = 3
    boundaries = {"rock_bottom": "all", "rock_sides": "x", "rock_ends": "y", "reservoir_bed": "free", "valley": "free",
                  "dam_ends": "free", "downstream": "free", "crest": "free"}
    beside_base = ("reservoir_bed", "valley")

    def nodal_loads(self, mesh):
        """{load: {node: (Fx, Fy, Fz)}} of trilinear elements; two Gauss points in a direction are exact here."""
        weight, push = {}, {}

        def add(target, v, d, force):
            target.setdefault(v, [0.] * 3)[d] += force

        for cell in mesh.group(self.structure):
            places = [mesh.nodes[v - 1] for v in cell]
            for point in itertools.product(GAUSS, repeat=3):
                a, b, c = _tangents(CUBE, places, point)
                volume = sum(x * y for x, y in zip(_cross(a, b), c))
                for v, value in zip(cell, _values(CUBE, point)):
                    add(weight, v, 2, -value * volume * self.bodies[self.structure][2])
        for face in mesh.group("upstream"):  # the plane x = 0; the water pushes along x
            places = [mesh.nodes[v - 1] for v in face]
            for point in itertools.product(GAUSS, repeat=2):
                area = abs(_cross(*_tangents(SQUARE, places, point))[0])
                values = _values(SQUARE, point)
                pressure = self.pressure[0] + self.pressure[1] * sum(s * p[2] for s, p in zip(values, places))
                for v, value in zip(face, values):
                    add(push, v, 0, value * pressure * area)
        return {"weight": weight, "push": push}

    def reference(self):
        return None


def to_the_limit(faces):
    scene = dam_block(faces, 1.3 * SLIDING_LIMIT)
    return scene.altered(name="dam_block_limit", limit=SLIDING_LIMIT)


def dam_block(faces, push=1.4):
    """`faces` contact faces from heel to toe; push: the pressure at the end over that of the full reservoir."""
    n = len(_mesh(faces).line_nodes("base"))
    return DamBlock("dam_block", n, lambda _: _mesh(faces),
                    {"dam": (2.5e7, 0.2, WEIGHT), "rock": (2e7, 0.25, 0.)},
                    {"kn": 2e7, "kt": 1e7, "f": FRICTION}, (WATER * HEIGHT, -WATER), [{"weight": 1.}, {"push": push}])
