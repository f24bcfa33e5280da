#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What is written of bodies in motion besides the tables of every run: accelerations and response spectra of monitors.

usage: motion_results.py FUGA

Blocks are so stiff that they move as rigid ones; everything they do is known in closed form:
* A block on stiff ground moves as the ground does, here for three periods of a sin wt; an oscillator on it has the way
  a/(o^2 - w^2) (sin wt - w/o sin ot), o its own frequency.
* A block on a spring, an elastic ground without mass, under a sudden acceleration: a (1 - cos wt); the ground in the middle of
  the spring has the mean of that and of its base. The oscillator on the block is the sum of two such motions.
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
sys.path.insert(0, str(ROOT / "tests" / "benchmark"))
from meshes import Mesh  # noqa: E402

G, STEP = 10., 0.002
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def near(value, known, tolerance, what):
    check(abs(value - known) <= tolerance, f"{what}: {value!r} instead of {known!r}")


def column(heights):
    """Two cells above each other, one metre wide: the bodies `lower` and `upper`."""
    nodes = [(x, y) for y in heights for x in (0., 1.)]
    cells = [(1 + 2 * j, 2 + 2 * j, 4 + 2 * j, 3 + 2 * j) for j in range(2)]
    return Mesh(nodes, [(2, "lower", cells[:1]), (2, "upper", cells[1:]), (1, "bottom", [(1, 2)]), (1, "top", [(5, 6)]),
                        (1, "sides", [(1, 3), (3, 5), (2, 4), (4, 6)])])


def scene(stages, **sections):
    body = {"Young modulus": 1e9, "Poisson ratio": 0., "Weight density": G}
    model = {"Mesh": {"File": "column.msh"}, "Bodies": {"lower": dict(body), "upper": dict(body)},
             "Joints": {"base": {"Plus lip": "bottom", "Minus lip": "rigid", "Normal stiffness": 1e10, "Shear stiffness": 1e10,
                                 "Friction coefficient": 0.5, "Cohesion": 1e6, "Tensile strength": 1e6}},
             "Boundaries": {"top": {"Fixed": "free"}, "sides": {"Fixed": "free"}},
             "Loads": {"weight": {"Type": "weight"}}, "Stages": stages,
             "Dynamics": {"Time step": STEP, "Gravity": G},
             "Monitors": {"top": {"Point": "0.5, 2"}, "middle": {"Point": "0.5, 0.5"}}, "Output": {"Fields": "never"}}
    for name, entries in sections.items():
        model.setdefault(name.replace("_", " "), {}).update(entries)
    return model


class Run:
    def __init__(self, folder, name, model, exit_code=0):
        self.folder = folder / name
        self.folder.mkdir()
        column([0., 1., 2.]).write(self.folder / "column.msh")
        (self.folder / "scene.json").write_text(json.dumps(model), encoding="utf-8")
        done = subprocess.run([FUGA, "scene.json", "--quiet", "--output-dir", "."], cwd=self.folder, capture_output=True,
                              text=True, check=False)
        if done.returncode != exit_code:
            sys.exit(f"{name}: exit code {done.returncode}: {done.stdout}{done.stderr}")

    def rows(self, name, **wanted):
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            rows = [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]
        return [row for row in rows if all(row[key] == value for key, value in wanted.items())]

    def spectrum(self, monitor, axis):
        """(period, pseudo-acceleration, displacement); the period 0 has the largest acceleration."""
        return [tuple(float(row[key]) for key in ("period", "pseudo_acceleration", "displacement"))
                for row in self.rows("spectra.csv", monitor=monitor, axis=axis)]

    def accelerations(self, monitor, axis):
        return [(float(row["time"]), float(row["a" + axis])) for row in self.rows("accelerations.csv", monitor=monitor)]


def largest_response(way, velocity, omega, duration, shortest):
    """Of an undamped oscillator up to this time, looked at 4000 times in the shortest period, and in free vibration behind it."""
    dt = shortest / 4000.
    within = max(abs(way(i * dt)) for i in range(int(duration / dt)))
    return max(within, math.hypot(way(duration), velocity(duration) / omega))


def block_on_stiff_ground(folder):
    a, period, n_periods = 3., 0.5, 3
    w, duration = 2. * math.pi / period, n_periods * period
    (folder / "harmonic.txt").write_text("".join(f"{i * STEP:.6f} {a * math.sin(w * i * STEP):.15g}\n"
                                                 for i in range(round(duration / STEP) + 1)))
    run = Run(folder, "stiff", scene({"shake": {"Loads": "weight: 0", "Duration": 2.}}, Earthquake={
        "Record x": "../harmonic.txt", "Record unit": "length/s^2", "Baseline": "keep"},
        Output={"Response spectra": "true", "Spectrum damping": 0., "Spectrum periods": "0.1, 0.3, 0.7, 2"}))
    # Lines between the samples lack (w h)^2/8 of the sine; what steps do not resolve of the block swings about it from step to
    # step by a part of what the acceleration changes in one, w h.
    tolerance, of_history = 1e-4, 0.1 * w * STEP
    for monitor in ("top", "middle"):
        (zero, largest, way), *spectrum = run.spectrum(monitor, "x")
        near(largest, a, of_history * a, f"{monitor}: largest acceleration")
        check(zero == way == 0. and len(spectrum) == 4, f"{monitor}: {run.spectrum(monitor, 'x')}")
        for own_period, acceleration, displacement in spectrum:
            o = 2. * math.pi / own_period
            share = a / (o * o - w * w)
            known = largest_response(lambda t: share * (math.sin(w * t) - w / o * math.sin(o * t)),
                                     lambda t: share * w * (math.cos(w * t) - math.cos(o * t)), o, duration,
                                     min(period, own_period))
            near(displacement, known, tolerance * known, f"{monitor}: way of {own_period} s")
            near(acceleration, o * o * known, tolerance * o * o * known, f"{monitor}: pseudo-acceleration of {own_period} s")
        history = run.accelerations(monitor, "x")
        check([round(t / STEP) for t, _ in history] == list(range(1001)), f"{monitor}: {len(history)} samples")
        for t, value in history:
            near(value, a * math.sin(w * t) if t < duration else 0., of_history * a, f"{monitor}: acceleration after {t} s")
    check(not (run.folder / "bodies.pvd").exists(), "fields that nobody asked for")


def block_on_a_spring(folder):
    a, period, duration = 2., 0.2, 1.
    w = 2. * math.pi / period
    (folder / "sudden.txt").write_text(f"0 {a}\n{duration} {a}\n")
    model = scene({"shake": {"Loads": "weight: 0", "Duration": duration}},
                  Earthquake={"Record y": "../sudden.txt", "Record unit": "length/s^2", "Baseline": "keep"},
                  Output={"Response spectra": "true", "Spectrum damping": 0., "Spectrum periods": "0.08, 0.13, 0.5, 2"})
    model["Bodies"]["lower"]["Young modulus"] = w * w
    model["Dynamics"]["Massless bodies"] = "lower"
    run = Run(folder, "spring", model)
    # (wh)^2/12 of the phase, which grows with time; second differences lack (wh)^2/12 as well.
    tolerance = 0.02 * a
    for t, value in run.accelerations("top", "y"):
        near(value, a * (1. - math.cos(w * t)), tolerance, f"block on a spring after {t} s")
    for t, value in run.accelerations("middle", "y"):
        if STEP < t < duration - STEP:  # before, at rest
            near(value, a * (1. - 0.5 * math.cos(w * t)), tolerance, f"middle of the spring after {t} s")
    for own_period, acceleration, _ in run.spectrum("top", "y")[1:]:
        o = 2. * math.pi / own_period
        share = a / (o * o - w * w)
        known = o * o * largest_response(
            lambda t: a / o ** 2 * (1. - math.cos(o * t)) - share * (math.cos(w * t) - math.cos(o * t)),
            lambda t: a / o * math.sin(o * t) + share * (w * math.sin(w * t) - o * math.sin(o * t)), o, duration,
            min(period, own_period))
        near(acceleration, known, 0.01 * known, f"pseudo-acceleration of {own_period} s on a block on a spring")


def main():
    with tempfile.TemporaryDirectory() as name:
        for part in (block_on_stiff_ground, block_on_a_spring):
            part(pathlib.Path(name))
    print("\n".join(complaints[:40]) or "bodies in motion are written as they move")
    sys.exit(1 if complaints else 0)


main()
