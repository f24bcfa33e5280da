#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Bodies of few modes (Dynamics/Bodies = modes) against the finite elements and against closed forms.

* With all modes a wall on a block, two joints above each other, moves as with finite elements to rounding: under a record in two directions, with Rayleigh
  damping, sliding and rocking; also with a spectral radius below 1, from an initial velocity, and with quadratic elements.
* With few modes the error falls as modes are added, and the mass is all there.
* D3: a pad on a spring and a frictional base under a sudden force (Code_Aster, SDNV104B): x(T/2) = 2 (F - friction)/k, x(T) = 3.5.
* D7: Newmark's block under a rectangular pulse A for T slides by (AT)^2/(2N) (1 - N/A).
* The ledger closes and the certificate holds.
* What modes cannot do is refused.

usage: modes.py FUGA
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

FUGA = str(pathlib.Path(sys.argv[1]).resolve())
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests" / "benchmark")]
from dynamics_scenes import Pad, column_of_cells  # noqa: E402
from meshes import uniform  # noqa: E402

G = 9.81
ALL = 1e9  # Hz
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]


class Run:
    def __init__(self, folder, model, *settings, exit_code=0):
        (folder / "scene.json").write_text(json.dumps(model))
        words = [word for setting in settings for word in ("--set", setting)]
        done = subprocess.run([FUGA, "scene.json", "--output-dir", "out", *words], cwd=folder, capture_output=True, text=True, check=False)
        self.text = done.stdout + done.stderr
        check(done.returncode == exit_code, f"{settings}: exit code {done.returncode}: {self.text[-800:]}")
        if exit_code == 0 and done.returncode == 0:
            self.steps = table(folder / "out" / "earthquake.csv")
            if "Monitors" in model:
                self.moved = [row for row in table(folder / "out" / "monitors.csv") if row["occasion"] == "step"]
            summary = json.loads((folder / "out" / "summary.json").read_text())
            motion = summary["motion"]
            check(motion["not_accounted_for"] <= 1e-9 * motion["largest_energy"], f"{settings}: the ledger lacks {motion}")
            check(summary["certificate"]["worst"] <= 1e-9, f"{settings}: certificate {summary['certificate']}")

    def column(self, name):
        return [float(row[name]) for row in (self.moved if name in ("ux", "uy") else self.steps)]


def wall(folder):
    """A wall on a block on the ground, [m, MN]."""
    mesh = column_of_cells(uniform(0., 2., 2), uniform(0., 6., 6), {"all": lambda x, y: True}, {
        "foot": lambda x, y: y == 0., "left": lambda x, y: x == 0.})
    cells = mesh.bodies()[0][1]
    mesh.groups = [g for g in mesh.groups if g[1] != "all"] + [(2, "block", cells[:4]), (2, "wall", cells[4:]),
                                                              (1, "seam", [(7, 8), (8, 9)])]
    mesh.write(folder / "scene.msh")
    with open(folder / "shaking.txt", "w", encoding="utf-8") as file:
        for i in range(101):
            file.write(f"{0.005 * i} {8. * math.sin(0.4 * i)} {3. * math.sin(0.7 * i)}\n")
    layer = {"Normal stiffness": 2e3, "Shear stiffness": 1e3, "Friction coefficient": 0.4}
    return {"Mesh": {"File": "scene.msh"},
            "Bodies": {name: {"Young modulus": 1e3, "Poisson ratio": 0.2, "Weight density": 0.024} for name in ("block", "wall")},
            "Joints": {"ground": {"Plus lip": "foot", "Minus lip": "rigid", **layer},
                       "seam": {"Line": "seam", "Plus body": "wall", "Minus body": "block", **layer}},
            "Boundaries": {name: {"Fixed": "free"} for name in ("left", "rest")},
            "Loads": {"weight": {"Type": "weight"}},
            "Stages": {"weight": {"Loads": "weight: t"}, "quake": {"Loads": "weight: 1", "Duration": 0.5, "Levels": 4}},
            "Dynamics": {"Time step": 0.005, "Gravity": G, "Damping ratio": 0.02, "Damping frequencies": "5; 50"},
            "Earthquake": {"Record x": "shaking.txt", "Record y": "shaking.txt", "Record unit": "length/s^2", "Baseline": "keep"},
            "Monitors": {"top": {"Point": "0.3, 5.7", "Stress": "true"}},
            "Output": {"Fields": "never"}}


def difference(one, other, names=("ux", "uy", "largest_slip", "N", "kinetic_energy", "energy_bodies", "damping")):
    """The largest over all steps, of every column relative to its largest value."""
    result = 0.
    for name in names:
        a, b = one.column(name), other.column(name)
        if len(a) != len(b):
            return math.inf
        result = max(result, max(abs(x - y) for x, y in zip(a, b)) / max(map(abs, b)))
    return result


def against_finite_elements(folder):
    model = wall(folder)
    modes = lambda highest: ("Dynamics/Bodies=modes", f"Dynamics/Highest frequency={highest}")
    for settings in ((), ("Dynamics/Spectral radius=0.8",), ("Bodies/wall/Initial velocity=0.3; 0",), ("Mesh/Polynomial degree=2",)):
        exact = Run(folder, model, *settings)
        error = difference(Run(folder, model, *settings, *modes(ALL)), exact)
        print(f"all modes, {settings}: {error:.1e}")
        check(error <= 1e-8, f"{settings}: with all modes the motion differs by {error:.2e}")
    # Slips in shocks are sensitive to everything: of joints that hold, whose layers stretch.
    hold = [f"Joints/{joint}/{entry}" for joint in ("ground", "seam") for entry in ("Cohesion=100", "Tensile strength=10")]
    exact, errors = Run(folder, model, *hold), []
    for highest in (20., 50., 100., 200.):
        few = Run(folder, model, *hold, *modes(highest))
        check(" normal mode" in few.text, "the log does not tell of modes")
        errors.append(difference(few, exact, ("ux", "uy")))
    print("modes up to 20, 50, 100, 200 Hz:", *(f"{error:.1e}" for error in errors))
    check(errors == sorted(errors, reverse=True) and errors[-1] < 1e-4, f"errors do not fall: {errors}")
    return model


def refusals(folder, model):
    modes = "Dynamics/Bodies=modes"
    seam = model["Joints"]["seam"]
    rigid = {key: value for key, value in seam.items() if key != "Normal stiffness"}
    model["Joints"]["seam"] = {**rigid, "Normal law": "rigid"}
    said = " ".join(Run(folder, model, modes, exit_code=1).text.split())
    check("joint 'seam' is rigid" in said, said[-600:])
    model["Joints"]["seam"] = seam
    for settings, text in (((modes, "Dynamics/Absorbing boundaries=left"), "'Absorbing boundaries' needs finite elements"),
                           ((modes, "Dynamics/Second order=weight"), "'Second order' needs finite elements"),
                           (("Dynamics/Highest frequency=50",), "finite elements have no limit of frequency")):
        said = " ".join(Run(folder, model, *settings, exit_code=1).text.split())
        check(text in said, f"{settings}: {said[-600:]}")


def pad(folder):
    """T/2 lies within a step; layer and pad are worth 5e-7."""
    scene = Pad()
    scene.mesh.write(folder / "scene.msh")
    model = scene.fuga()
    model.update({"Mesh": {"File": "scene.msh"}, "Output": {"Fields": "never"}, "Boundaries": {
        "wall": {"Fixed": "x, y"}, "rest": {"Fixed": "free"}}})
    model["Dynamics"].update({"Time step": scene.span / 101, "Halvings": 12, "Event tolerance": 1e-8, "Bodies": "modes"})
    ways = Run(folder, model).column("ux")
    print(f"D3: {max(ways):.6f}, {ways[-1]:.6f}")
    check(abs(max(ways) - 14.916667) <= 1e-4 * 14.9 and abs(ways[-1] - 3.5) <= 1e-5 * 14.9, f"D3: {max(ways)}, {ways[-1]}")


def newmark(folder):
    """A stiff block on a stiff frictional layer; the ground pushes it for T = 0.5 s with A = 0.5 g, friction is 0.2."""
    A, N, T = 0.5 * G, 0.2 * G, 0.5
    mesh = column_of_cells(uniform(0., 2., 2), uniform(0., 1., 1), {"block": lambda x, y: True}, {"foot": lambda x, y: y == 0.})
    mesh.write(folder / "scene.msh")
    n = 1000
    (folder / "pulse.txt").write_text("".join(f"{2. * i / n} {-A if 2. * i / n < T - 1e-9 else 0.}\n" for i in range(n + 1)))
    stiff = {"Normal stiffness": 1e5, "Shear stiffness": 1e5, "Friction coefficient": 0.2}
    model = {"Mesh": {"File": "scene.msh"}, "Bodies": {"block": {"Young modulus": 1e5, "Poisson ratio": 0., "Weight density": 0.024}},
             "Joints": {"ground": {"Plus lip": "foot", "Minus lip": "rigid", **stiff}}, "Boundaries": {"rest": {"Fixed": "free"}},
             "Loads": {"weight": {"Type": "weight"}},
             "Stages": {"weight": {"Loads": "weight: t"}, "pulse": {"Loads": "weight: 1", "Duration": 1.5}},
             "Dynamics": {"Time step": 0.002, "Gravity": G, "Bodies": "modes"},
             "Earthquake": {"Record x": "pulse.txt", "Record unit": "length/s^2", "Baseline": "keep"}, "Output": {"Fields": "never"}}
    # Linear between samples, the pulse is half a sample shorter.
    length = T - 0.5 * 2. / n
    slip, known = Run(folder, model).column("mean_slip")[-1], (A * length) ** 2 / (2. * N) * (1. - N / A)
    print(f"D7: {slip:.6f}, {known:.6f}")
    check(abs(abs(slip) - known) <= 1e-3 * known, f"D7: {slip} instead of {known}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        model = against_finite_elements(folder)
        refusals(folder, model)
        pad(folder)
        newmark(folder)
    print("\n".join(complaints) or "modes move as they should")
    sys.exit(1 if complaints else 0)


main()
