# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Coarse meshes and parameter files of the problems of adaptivity_page.py, and their errors."""
import csv
import json
import math
import os
import subprocess

NU = 0.3


def doubling(n):
    """0, 1, 3, 7, ...: n intervals, each twice as long as the one before."""
    return [2.0**i - 1.0 for i in range(n + 1)]


def write_mesh(path, xs, bodies, groups):
    """A Gmsh file (2.2). bodies: (name, ys) one above the other with common lines; groups of sides: (name, test of the
    middle x, y of an edge); of points: (name, (x, y))."""
    ys = sorted({y for _, lines in bodies for y in lines})
    number = {}
    for y in ys:
        for x in xs:
            number[x, y] = len(number) + 1
    names, elements = [], []

    def add(dimension, name, kind, found):
        names.append(f'{dimension} {len(names) + 1} "{name}"')
        for nodes in found:
            elements.append(f"{len(elements) + 1} {kind} 2 {len(names)} {len(names)} "
                            + " ".join(str(number[node]) for node in nodes))

    for name, lines in bodies:
        add(2, name, 3, [((a, c), (b, c), (b, d), (a, d)) for c, d in zip(lines, lines[1:]) for a, b in zip(xs, xs[1:])])
    edges = [((a, y), (b, y)) for y in ys for a, b in zip(xs, xs[1:])]
    edges += [((x, c), (x, d)) for x in xs for c, d in zip(ys, ys[1:])]
    for name, where in groups:
        if callable(where):
            add(1, name, 1, [e for e in edges if where((e[0][0] + e[1][0]) / 2, (e[0][1] + e[1][1]) / 2)])
        else:
            add(0, name, 15, [(where,)])
    with open(path, "w", encoding="ascii") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        file.write(f"$PhysicalNames\n{len(names)}\n" + "\n".join(names) + "\n$EndPhysicalNames\n")
        file.write(f"$Nodes\n{len(number)}\n" + "\n".join(f"{i} {x!r} {y!r} 0" for (x, y), i in number.items()))
        file.write(f"\n$EndNodes\n$Elements\n{len(elements)}\n" + "\n".join(elements) + "\n$EndElements\n")


def write_cube(path, lines):
    """A Gmsh file (2.2) of a cube with grid lines at the same coordinates in x, y, z: body `block`, sides `contact` (smallest
    z), `top`, `left` (smallest x), `right`, `front` (smallest y), `back`."""
    n = len(lines)
    number = lambda i, j, k: 1 + i + n * (j + n * k)
    ring = ((0, 0), (1, 0), (1, 1), (0, 1))
    cells = [[number(i + a, j + b, k + c) for c in (0, 1) for a, b in ring]
             for k in range(n - 1) for j in range(n - 1) for i in range(n - 1)]
    groups = [("block", 3, 5, cells)]
    for axis, names in ((2, ("contact", "top")), (0, ("left", "right")), (1, ("front", "back"))):
        for name, fixed in zip(names, (0, n - 1)):
            faces = []
            for j in range(n - 1):
                for i in range(n - 1):
                    corners = []
                    for a, b in ring:
                        place = [fixed, fixed, fixed]
                        place[(axis + 1) % 3], place[(axis + 2) % 3] = i + a, j + b
                        corners.append(number(*place))
                    faces.append(corners)
            groups.append((name, 2, 3, faces))
    elements = []
    for tag, (_, _, kind, found) in enumerate(groups, 1):
        for nodes in found:
            elements.append(f"{len(elements) + 1} {kind} 2 {tag} {tag} " + " ".join(map(str, nodes)))
    with open(path, "w", encoding="ascii") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        file.write(f"$PhysicalNames\n{len(groups)}\n" + "\n".join(
            f'{dimension} {tag} "{name}"' for tag, (name, dimension, _, _) in enumerate(groups, 1)) + "\n$EndPhysicalNames\n")
        file.write(f"$Nodes\n{n**3}\n" + "\n".join(
            f"{number(i, j, k)} {lines[i]!r} {lines[j]!r} {lines[k]!r}" for k in range(n) for j in range(n) for i in range(n)))
        file.write(f"\n$EndNodes\n$Elements\n{len(elements)}\n" + "\n".join(elements) + "\n$EndElements\n")


class Sphere:
    """V7 in space: a quarter of a block on a rigid plane, with the roundness of a sphere as initial gap."""
    name = "V7 sphere"
    what = "a block of 16 by 16 by 16 between planes of symmetry, 4 by 4 by 4 cubes, radius of the contact 1"
    settings = {"Quantity": "contact pressure"}
    modulus, radius, contact = 1000.0 / (1 - NU**2), 50.0, 1.0

    def exact(self, r):
        return 2 * self.modulus * self.contact / (math.pi * self.radius) * math.sqrt(max(0, 1 - (r / self.contact)**2))

    def scene(self, folder):
        lines = [0.0, 4.0, 8.0, 12.0, 16.0]
        write_cube(f"{folder}/mesh.msh", lines)
        quarter_load = self.modulus * self.contact**3 / (3 * self.radius)
        return {
            "Dimension": 3,
            "Bodies": {"block": {"Young modulus": 1000, "Poisson ratio": NU}},
            "Joints": {"sphere": {"Plus lip": "contact", "Minus lip": "rigid", "Normal law": "rigid",
                                  "Initial gap": f"(x^2 + y^2)/(2*{self.radius})"}},
            "Boundaries": {"left": {"Fixed": "x"}, "front": {"Fixed": "y"}, "right": {"Fixed": "free"}, "back": {"Fixed": "free"}},
            "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": quarter_load / lines[-1]**2}},
            "Stages": {"press": {"Loads": "press: t"}}}


class Hertz:
    """V7: two blocks with the roundness of a cylinder as initial gap."""
    name = "V7 line contact"
    what = "two blocks of 32 by 32, each 4 by 4 squares, half-width of the contact 0.85"
    settings = {"Quantity": "contact pressure"}
    half_width, radius, moduli = 0.85, 100.0, (1000.0, 3000.0)

    def exact(self, x):
        modulus = 1 / sum((1 - NU**2) / E for E in self.moduli)
        return modulus * self.half_width / (2 * self.radius) * math.sqrt(max(0, 1 - (x / self.half_width)**2))

    def scene(self, folder):
        xs = [0.0, 8.0, 16.0, 24.0, 32.0]
        size = xs[-1]
        write_mesh(f"{folder}/mesh.msh", xs, [("lower", [-x for x in reversed(xs)]), ("upper", xs)],
                   [("joint", lambda x, y: y == 0), ("left", lambda x, y: x == 0), ("right", lambda x, y: x == size),
                    ("bottom", lambda x, y: y == -size), ("top", lambda x, y: y == size)])
        half_load = self.exact(0) * math.pi * self.half_width / 4
        return {
            "Bodies": {"upper": {"Young modulus": self.moduli[0], "Poisson ratio": NU},
                       "lower": {"Young modulus": self.moduli[1], "Poisson ratio": NU}},
            "Joints": {"joint": {"Line": "joint", "Plus body": "upper", "Minus body": "lower", "Normal law": "rigid",
                                 "Initial gap": f"x^2/(2*{self.radius})"}},
            "Boundaries": {"left": {"Fixed": "x"}, "right": {"Fixed": "free"}, "bottom": {"Fixed": "all"}},
            "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": half_load / size}},
            "Stages": {"press": {"Loads": "press: t"}}}


class Punch:
    """V8: a flat rigid punch of half-width 1 without friction; the pressure counts up to 0.9."""
    name = "V8 flat punch"
    what = "half-width 1, a block of 127 by 127, 7 by 7 cells that double; the pressure counts for |x| ≤ 0.9"
    settings = {"Quantity": "contact pressure", "Where": "x <= 0.9"}

    def exact(self, x):
        return 2 / (math.pi * math.sqrt(1 - x**2))

    def scene(self, folder):
        xs = doubling(7)
        size = xs[-1]
        write_mesh(f"{folder}/mesh.msh", xs, [("block", xs)],
                   [("contact", lambda x, y: y == 0 and x < 1), ("free", lambda x, y: y == 0 and x > 1),
                    ("left", lambda x, y: x == 0), ("right", lambda x, y: x == size), ("top", lambda x, y: y == size)])
        return {
            "Bodies": {"block": {"Young modulus": 1000, "Poisson ratio": NU}},
            "Joints": {"punch": {"Plus lip": "contact", "Minus lip": "rigid", "Normal law": "rigid"}},
            "Boundaries": {"left": {"Fixed": "x"}, "right": {"Fixed": "free"}, "free": {"Fixed": "free"}},
            "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": 1 / size}},
            "Stages": {"press": {"Loads": "press: t"}}}


class Block:
    """V9: the block of Raous, Chabrand and Lebon on a rigid plane with friction 1."""
    name = "V9 Raous block"
    what = "40 by 40, 4 by 4 squares, friction 1"
    settings = {"Quantity": "contact pressure"}

    def scene(self, folder):
        xs = [0.0, 10.0, 20.0, 30.0, 40.0]
        write_mesh(f"{folder}/mesh.msh", xs, [("block", xs)],
                   [("contact", lambda x, y: y == 0), ("right", lambda x, y: x == 40), ("left", lambda x, y: x == 0),
                    ("top", lambda x, y: y == 40), ("corner", (40.0, 0.0))])
        return {
            "Bodies": {"block": {"Young modulus": 130000, "Poisson ratio": 0.2}},
            "Joints": {"base": {"Plus lip": "contact", "Minus lip": "rigid", "Normal law": "rigid", "Shear law": "rigid",
                                "Friction coefficient": 1}},
            "Boundaries": {"right": {"Fixed": "x"}, "corner": {"Fixed": "all"}},
            "Loads": {"side": {"Type": "pressure", "Boundaries": "left", "Value": 150},
                      "top": {"Type": "pressure", "Boundaries": "top", "Value": 50}},
            "Stages": {"press": {"Loads": "side: t; top: t"}},
            "Monitors": {"edge": {"Point": "0, 0"}}}


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]


class Run:
    """One run of a problem: on the mesh of a round, or with uniform refinements (and one round of estimating)."""

    def __init__(self, fuga, problem, folder, rounds, refinements=0, target=1e-6, unknowns=None, fields="never"):
        os.makedirs(folder, exist_ok=True)
        # A direct solution in space costs more.
        in_space = problem.scene(folder).get("Dimension") == 3
        unknowns = unknowns or (2e5 if in_space else 1.2e6)
        scene = {"Mesh": {"File": "mesh.msh", "Refinements": refinements}, **problem.scene(folder),
                 "Target accuracy": {**problem.settings, "Relative error": target, "Largest number of rounds": rounds,
                                     "Largest number of unknowns": unknowns},
                 "Output": {"Fields": fields, "Log": "levels"}}
        with open(f"{folder}/run.json", "w", encoding="utf-8") as file:
            json.dump(scene, file)
        done = subprocess.run([fuga, "run.json", "--output-dir", "results"], cwd=folder, capture_output=True, text=True,
                              check=False, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        if done.returncode != 0:
            raise RuntimeError(f"{problem.name}: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        self.folder = folder
        self.log = done.stdout
        with open(f"{folder}/results/summary.json", encoding="utf-8") as file:
            self.summary = json.load(file)
        self.rounds = table(f"{folder}/results/refinement.csv")
        self.unknowns = int(self.rounds[-1]["degrees_of_freedom"])
        self.elements = int(self.rounds[-1]["contact_elements"])
        self.estimate = float(self.rounds[-1]["estimated_error"])
        rows = [row for row in table(f"{folder}/results/joint_history.csv") if float(row["t"]) == 1]
        self.x, self.area, self.pressure = ([float(row[name]) for row in rows] for name in ("x", "area", "pressure"))
        if in_space: # the distance from the axis
            self.x = [math.hypot(x, float(row["y"])) for x, row in zip(self.x, rows)]
        self.shear_force = float([row for row in table(f"{folder}/results/resultants.csv") if float(row["t"]) == 1][-1]["T"])
        self.monitor = None
        if os.path.exists(f"{folder}/results/monitors.csv"):
            row = table(f"{folder}/results/monitors.csv")[-1]
            self.monitor = (float(row["ux"]), float(row["uy"]))

    def pressure_error(self, exact, end):
        """Relative error of the pressure up to x = end, root of the mean square over the area."""
        square = size = 0.0
        for x, area, pressure in zip(self.x, self.area, self.pressure):
            if x <= end:
                square += area * (pressure - exact(x))**2
                size += area * exact(x)**2
        return math.sqrt(square / size)
