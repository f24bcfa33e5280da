# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Motions with known answers, as scenes for fuga and for CalculiX, with their errors; for dynamics_page.py."""
import csv
import json
import math
import os
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TOP / "tests" / "benchmark"))
from meshes import Mesh, uniform  # noqa: E402
from process import measure  # noqa: E402

PEER = "ccx"


def column_of_cells(xs, ys, bodies, groups):
    """Rectangles between the lines; bodies {name: test of the middle of a cell}, groups {name: test of the middle of a
    side}; the other sides at the edge are the group `rest`."""
    number = lambda i, j: 1 + i + len(xs) * j
    middle = lambda a, b: (a + b) / 2
    cells = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1))
             for j in range(len(ys) - 1) for i in range(len(xs) - 1)]
    sides = [(number(i, j), number(i + 1, j)) for j in range(len(ys)) for i in range(len(xs) - 1)]
    sides += [(number(i, j), number(i, j + 1)) for i in (0, len(xs) - 1) for j in range(len(ys) - 1)]
    nodes = [(x, y) for y in ys for x in xs]
    centre = lambda of: tuple(middle(nodes[of[0] - 1][c], nodes[of[len(of) // 2] - 1][c]) for c in (0, 1))
    inside = lambda x, y: xs[0] < x < xs[-1] and ys[0] < y < ys[-1]
    named = {**groups, "rest": lambda x, y: not inside(x, y) and not any(test(x, y) for test in groups.values())}
    return Mesh(nodes, [(2, name, [cell for cell in cells if test(*centre(cell))]) for name, test in bodies.items()]
                + [(1, name, [side for side in sides if test(*centre(side))]) for name, test in named.items()])


def above_obstacle(mesh, low, high):
    """(mesh, nodes of the lip, nodes of the other one): for CalculiX, the group `bottom` above a rectangle of one cell,
    whose nodes are the group `ground`."""
    (x0, y0), (x1, y1) = low, high
    first = len(mesh.nodes) + 1
    cell = tuple(range(first, first + 4))
    groups = [*mesh.groups, (2, "obstacle", [cell]), (1, "ground", [cell[:2], cell[2:]])]
    return Mesh(mesh.nodes + [(x0, y0), (x1, y0), (x1, y1), (x0, y1)], groups), _nodes(mesh.group("bottom")), set(cell[2:])


def _nodes(elements):
    return {v for element in elements for v in element}


class Bar:
    """D5: an elastic bar (E = 900, density 1, length 10, c = 30) falls 5 under g = 10 onto a rigid plane (Doyen, Ern and Piperno 2011).
    It touches down at t = 1, is pressed by (E/c)(v0 + g tau) for 2L/c = 2/3, and after 16/3 it is where it was."""
    name, span, point, friction = "D5, a bar that bounces once", 16. / 3., 1, None
    supports = {"left": "x", "right": "x"}
    velocities = {}

    def __init__(self, n_cells):
        self.mesh = column_of_cells([0., 0.1], uniform(0., 10., n_cells), {"bar": lambda x, y: True}, {
            "bottom": lambda x, y: y == 0., "left": lambda x, y: x == 0., "right": lambda x, y: x == 0.1})
        self.materials = {"bar": (900., 1.)}
        cell = 10. / n_cells
        self.crossing, self.stiffness = cell / 30., 900. / cell

    def fuga(self):
        return {"Bodies": {"bar": {"Young modulus": 900., "Poisson ratio": 0., "Weight density": 10.}},
                "Joints": {"ground": {"Plus lip": "bottom", "Minus lip": "rigid", "Normal law": "rigid", "Initial gap": 5.}},
                "Loads": {"weight": {"Type": "weight"}},
                "Stages": {"fall": {"Loads": "weight: 1", "Duration": self.span}},
                "Dynamics": {"Gravity": 10.},
                "Monitors": {"point": {"Point": "0, 0"}}}

    def peer_contact(self):
        return above_obstacle(self.mesh, (-0.1, -5.5), (0.2, -5.))

    def peer_loads(self):
        return [], ["*DLOAD", "BAR, GRAV, 10., 0., -1., 0."]

    @staticmethod
    def pressure(t):
        return 300. + 300. * (t - 1.) if 1. < t < 5. / 3. else 500. - 300. * (t - 11. / 3.) if 11. / 3. < t < 13. / 3. else 0.

    def errors(self, times, forces, ways):
        """Mean difference of the force from the known one relative to its mean, and where the bar is after the period, over 5."""
        known = [0.1 * self.pressure(t) for t in times]
        lengths = [t - before for before, t in zip([0.] + times, times)]
        wrong = sum(h * abs(abs(force) - right) for h, force, right in zip(lengths, forces, known))
        return {"force": wrong / sum(h * right for h, right in zip(lengths, known)), "way": abs(ways[-1][1]) / 5.}


class TwoBars:
    """D10: a bar (E = 2e11, density 7800, length 1, c = 5064) hits an equal one, whose other end is held, with the velocity 1
    (Code_Aster, SDNL111). The waves of contact come back from both ends after 2L/c, and after 4L/c the bar leaves with the velocity
    with which it came: its end is at -1e-4, -2e-4, -1e-4, 0, 2e-4 after 0.2 ... 1 ms, to the digits that are given there."""
    name, span, point, friction = "D10, a bar that hits another one", 1e-3, 1, None
    modulus, density, side = 2e11, 7800., 0.02
    supports = {"left": "x", "right": "x", "ground": "xy"}
    velocities = {"upper": (0., -1.)}

    def __init__(self, n_cells):
        ys = uniform(-1., 0., n_cells) + uniform(0., 1., n_cells)[1:]
        self.mesh = column_of_cells([0., self.side], ys, {"lower": lambda x, y: y < 0., "upper": lambda x, y: y > 0.}, {
            "joint": lambda x, y: y == 0., "ground": lambda x, y: y == -1., "left": lambda x, y: x == 0., "right": lambda x, y: x == self.side})
        self.materials = dict.fromkeys(("lower", "upper"), (self.modulus, self.density))
        self.crossing_of_bar = math.sqrt(self.density / self.modulus)
        # A hundredth longer than a wave takes, so that steps end at the times for which answers are given.
        self.crossing, self.stiffness = self.span / (5. * n_cells), self.modulus * n_cells

    def fuga(self):
        bodies = {name: {"Young modulus": E, "Poisson ratio": 0., "Weight density": 10. * density} for name, (E, density) in self.materials.items()}
        return {"Bodies": bodies,
                "Joints": {"contact": {"Line": "joint", "Plus body": "upper", "Minus body": "lower", "Normal law": "rigid"}},
                "Loads": {"none": {"Type": "weight"}},
                "Stages": {"impact": {"Loads": "none: 0", "Duration": self.span}},
                "Dynamics": {"Gravity": 10.},
                "Monitors": {"point": {"Point": "0, 0", "Body": "upper"}}}

    def peer_contact(self):
        mesh, double = self.mesh.opened("joint", "upper")
        self.point = min(double.values())
        return mesh, set(double.values()), set(double)

    def peer_loads(self):
        return [], []

    def way(self, t):
        back = self.crossing_of_bar
        return -0.5 * t if t < 2. * back else -back + 0.5 * (t - 2. * back) if t < 4. * back else t - 4. * back

    def errors(self, times, forces, ways):
        """Largest difference from the known way at the five times, and the mean one at all times, over 2e-4."""
        del forces
        wrong = [abs(way[1] - self.way(t)) / 2e-4 for t, way in zip(times, ways)]
        at = lambda time: min(zip(times, wrong), key=lambda pair: abs(pair[0] - time))[1]
        lengths = [t - before for before, t in zip([0.] + times, times)]
        return {"five times": max(at(0.2e-3 * k) for k in range(1, 6)), "mean": sum(h * e for h, e in zip(lengths, wrong)) / self.span}


class Pad:
    """D3: a stiff pad of the mass 1000 on a spring k = 1.2e4 and a base with the friction 1.05e4, under a sudden force of 1e5
    (Code_Aster, SDNV104B): x(T/2) = 2 (F - friction)/k = 14.91667, x(T) = 3.5, after a change of direction at T/2."""
    name = "D3, a pad that rubs"
    mass, k, force, friction_force, height = 1000., 1.2e4, 1e5, 1.05e4, 0.2
    friction, supports, velocities = 0.3, {"wall": "xy"}, {}

    def __init__(self):
        self.span = 2. * math.pi * math.sqrt(self.mass / self.k)
        h = self.height
        self.mesh = column_of_cells([0., 1., 1.5, 2.], [0., h], {"spring": lambda x, y: x < 1., "pad": lambda x, y: x > 1.}, {
            "bottom": lambda x, y: y == 0. and x > 1., "top": lambda x, y: y == h and x > 1., "wall": lambda x, y: x == 0.,
            "right": lambda x, y: x == 2.})
        self.materials = {"spring": (self.k / h, 1e-9), "pad": (1e10, self.mass / h)}
        self.point = len(self.mesh.nodes)
        self.press, self.pull = self.friction_force / 0.3, self.force / h

    def fuga(self):
        bodies = {name: {"Young modulus": E, "Poisson ratio": 0.} for name, (E, _) in self.materials.items()}
        bodies["pad"]["Weight density"] = 9.81 * self.mass / self.height
        return {"Bodies": bodies,
                "Joints": {"base": {"Plus lip": "bottom", "Minus lip": "rigid", "Normal stiffness": 1e9, "Shear stiffness": 1e9,
                                    "Friction coefficient": 0.3}},
                "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": str(self.press)},
                          "pull": {"Type": "traction", "Boundaries": "right", "Value": f"{self.pull}; 0"}},
                "Stages": {"press": {"Loads": "press: t"}, "pull": {"Loads": "pull: 1", "Duration": self.span}},
                "Dynamics": {},
                "Monitors": {"point": {"Point": f"2, {self.height}"}}}

    def peer_contact(self):
        return above_obstacle(self.mesh, (-5., -0.5), (30., 0.))

    def peer_loads(self):
        """Nodal forces on both sides of the slice: static, then sudden."""
        n = len(self.peer_contact()[0].nodes)
        nodal = lambda group, component, total: [
            f"{v + n * z}, {component}, {total * share / 2.:.12e}" for z in (0, 1) for v, share in _shares(self.mesh, group).items()]
        return ["*CLOAD", *nodal("top", 2, -self.press)], ["*CLOAD", *nodal("right", 1, self.force)]

    def errors(self, times, forces, ways):
        del times, forces
        return {"way": abs(ways[-1][0] - 3.5) / 14.91667}


def _shares(mesh, group):
    """By node of a line, the part of its length."""
    result = {}
    total = 0.
    for a, b in mesh.group(group):
        length = math.dist(mesh.nodes[a - 1], mesh.nodes[b - 1])
        total += length
        for v in (a, b):
            result[v] = result.get(v, 0.) + length / 2.
    return {v: part / total for v, part in result.items()}


def run_fuga(program, scene, step, folder, **dynamics):
    """(errors, CPU seconds, certificate, energy that the integration in time takes, over the largest, the same as it is)."""
    folder = pathlib.Path(folder)
    scene.mesh.write(folder / "scene.msh")
    model = scene.fuga()
    model["Mesh"] = {"File": "scene.msh"}
    model["Boundaries"] = {name: {"Fixed": ", ".join(components) if name in scene.supports else components}
                           for name, components in {**scene.supports, "rest": "free"}.items()}
    for name, velocity in scene.velocities.items():
        model["Bodies"][name]["Initial velocity"] = "; ".join(map(str, velocity))
    model["Dynamics"].update({"Time step": step, **dynamics})
    model["Output"] = {"Fields": "never", "Checkpoint": "never"}
    (folder / "scene.json").write_text(json.dumps(model))
    process = measure([program, "scene.json", "--quiet", "--output-dir", "out"], str(folder), 3600)
    if process.code not in (0, 4):
        sys.exit(f"{scene.name}: {process.output}")
    summary = json.loads((folder / "out" / "summary.json").read_text())
    times, forces, ways = [], [], []
    with open(folder / "out" / "earthquake.csv", newline="", encoding="utf-8") as file:
        rows = [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]
    with open(folder / "out" / "monitors.csv", newline="", encoding="utf-8") as file:
        moved = [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]
    way_at = {row["t"]: (float(row["ux"]), float(row["uy"])) for row in moved}
    for row in rows:
        times.append(float(row["time"]))
        forces.append(float(row["N"]))
        ways.append(way_at[row["t"]])
    motion = summary["motion"]
    return (scene.errors(times, forces, ways), process.cpu, summary["certificate"]["worst"],
            abs(motion["numerical"]) / motion["largest_energy"], motion["numerical"])


def peer_deck(scene, step, stiffness, damping):
    """For CalculiX: its implicit scheme (Hilber, Hughes and Taylor, alpha = -`damping`) with fixed increments, node to surface,
    penalty `stiffness`, a slice of the thickness 1, for velocities of its plane elements do not count. It reads no more than
    20 characters of a number."""
    mesh, lip, other_lip = scene.peer_contact()
    n = len(mesh.nodes)
    lines = ["*NODE, NSET=ALL", *("%d, %.12e, %.12e, %d." % (k + n * z, *node, z) for z in (0, 1) for k, node in enumerate(mesh.nodes, 1))]
    node_list = lambda of: ",\n".join(str(v + n * z) for z in (0, 1) for v in sorted(of))
    number, faces = 0, {"SLAVE": [], "MASTER": []}
    for name, cells in mesh.bodies():
        E, density = scene.materials.get(name, (1., 1.))
        lines.append(f"*ELEMENT, TYPE=C3D8, ELSET={name.upper()}")
        for cell in cells:
            number += 1
            lines.append(", ".join(str(v) for v in (number, *cell, *(v + n for v in cell))))
            for surface, side, face, nodes in (("SLAVE", cell[:2], "S3", lip), ("MASTER", cell[2:], "S5", other_lip)):
                if set(side) <= nodes:
                    faces[surface].append(f"{number}, {face}")
        lines += [f"*MATERIAL, NAME=M_{name.upper()}", "*ELASTIC", f"{E:.9e}, 0.", "*DENSITY", f"{density:.9e}",
                  f"*SOLID SECTION, ELSET={name.upper()}, MATERIAL=M_{name.upper()}"]
        if name in scene.velocities:
            lines += [f"*NSET, NSET=N_{name.upper()}", node_list(_nodes(cells)), "*INITIAL CONDITIONS, TYPE=VELOCITY"]
            lines += [f"N_{name.upper()}, {component}, {v:.9e}" for component, v in enumerate(scene.velocities[name], 1) if v != 0.]
    lines += ["*NSET, NSET=POINT", str(scene.point), "*BOUNDARY", "ALL, 3"]
    for group, components in {**scene.supports, "ground": "xy"}.items():
        lines += [f"*NSET, NSET={group.upper()}", node_list(_nodes(mesh.group(group))), "*BOUNDARY"]
        lines += [f"{group.upper()}, {'xy'.index(c) + 1}" for c in components]
    for surface, sides in faces.items():
        lines += [f"*SURFACE, NAME={surface}, TYPE=ELEMENT", *sides]
    lines += ["*SURFACE INTERACTION, NAME=CONTACT", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{stiffness:.9e}, {1e-10 * stiffness:.9e}, 1e-2"]
    if scene.friction:
        lines += ["*FRICTION", f"{scene.friction!r}, {stiffness:.9e}"]
    lines += ["*CONTACT PAIR, INTERACTION=CONTACT, TYPE=NODE TO SURFACE", "SLAVE, MASTER"]
    still, sudden = scene.peer_loads()
    if still:
        lines += ["*STEP, INC=1000", "*STATIC", "1., 1.", *still, "*EL FILE", "ENER", "*END STEP"]  # it asks for energies in the first step
    lines += ["*STEP, INC=10000000", f"*DYNAMIC, DIRECT, ALPHA={-damping:.9e}", f"{step:.12e}, {scene.span:.12e}", *sudden, "*NODE PRINT, NSET=POINT",
              "U", "*NODE PRINT, NSET=GROUND, TOTALS=ONLY", "RF", "*END STEP"]
    return "\n".join(lines) + "\n"


def run_peer(scene, step, stiffness, folder, damping=0.05, limit=600):
    """(errors, CPU seconds), or (what CalculiX says, CPU seconds). Its own default of `damping` is 0.05."""
    folder = pathlib.Path(folder)
    (folder / "run.dat").unlink(missing_ok=True)
    (folder / "run.inp").write_text(peer_deck(scene, step, stiffness, damping))
    process = measure([PEER, "run"], str(folder), limit)
    if process.code != 0 or "*ERROR" in process.output:
        said = re.findall(r"\*ERROR:?([^\n;]*)", process.output)
        return " ".join(said[0].split()) if said else f"exit code {process.code}", process.cpu
    text = (folder / "run.dat").read_text()
    blocks = re.split(r"(displacements|total force) [^\n]* and time +(\S+)\n", text)
    times, forces, ways = [], [], []
    before = 1. if scene.peer_loads()[0] else 0.
    for kind, time, block in zip(blocks[1::3], blocks[2::3], blocks[3::3]):
        values = [float(re.sub(r"(\d)([+-]\d{3})$", r"\1E\2", word)) for word in block.split()]  # Fortran leaves out the E of 1E-100
        if kind == "displacements":
            times.append(float(time) - before)
            ways.append((values[1], values[2]))
        else:
            forces.append(values[1])
    return scene.errors(times, forces, ways), process.cpu


def start_of_peer(folder):
    return measure([PEER, "-v"], str(folder)).cpu


def start_of_fuga(program, folder):
    return measure([os.path.abspath(program), "--version"], str(folder)).cpu
