#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What is written of bodies in motion besides the tables of every run: accelerations and response spectra of monitors,
fields between the levels, which VTK's own readers read, and events of the motion as a whole.

usage: motion_results.py FUGA

Blocks are so stiff that they move as rigid ones; everything they do is known in closed form:
* A block on stiff ground moves as the ground does, here for three periods of a sin wt; an oscillator on it has the way
  a/(o^2 - w^2) (sin wt - w/o sin ot), o its own frequency.
* A block on a spring, an elastic ground without mass, under a sudden acceleration: a (1 - cos wt); the ground in the middle of
  the spring has the mean of that and of its base. The oscillator on the block is the sum of two such motions.
* A block that falls has the acceleration g, the velocity g t and the way g t^2/2.
* A block that slides beyond its limit load does not come to rest: the last field is of the moment when it is left; friction
  has taken f N s.
* Lips without mass jump where friction is beyond its critical value: a row of events.csv with what the ledger of energies has.
"""
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import vtk
from vtk.util.numpy_support import vtk_to_numpy

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


def column():
    """Two cells above each other, with sides of one metre: the bodies `lower` and `upper`."""
    nodes = [(x, y) for y in (0., 1., 2.) for x in (0., 1.)]
    cells = [(1 + 2 * j, 2 + 2 * j, 4 + 2 * j, 3 + 2 * j) for j in range(2)]
    return Mesh(nodes, [(2, "lower", cells[:1]), (2, "upper", cells[1:]), (1, "bottom", [(1, 2)]), (1, "top", [(5, 6)]),
                        (1, "sides", [(1, 3), (3, 5), (2, 4), (4, 6)])])


def pair():
    """The same beside each other."""
    nodes = [(x, y) for y in (0., 1.) for x in (0., 1., 2.)]
    return Mesh(nodes, [(2, "lower", [(1, 2, 5, 4)]), (2, "upper", [(2, 3, 6, 5)]), (1, "bottom", [(1, 2), (2, 3)]),
                        (1, "top", [(4, 5), (5, 6)]), (1, "sides", [(1, 4), (3, 6)])])


def scene(stages, **sections):
    body = {"Young modulus": 1e9, "Poisson ratio": 0., "Weight density": G}
    model = {"Mesh": {"File": "blocks.msh"}, "Bodies": {"lower": dict(body), "upper": dict(body)},
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
    def __init__(self, folder, name, model, exit_code=0, mesh=column()):
        self.folder = folder / name
        self.folder.mkdir()
        mesh.write(self.folder / "blocks.msh")
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

    def frames(self):
        """(time, arrays at the points) of the bodies; joints have the same times."""
        result = []
        for name in ("joints", "bodies"):
            entries = xml.parse(self.folder / f"{name}.pvd").getroot().findall("./Collection/DataSet")
            times = [float(entry.get("timestep")) for entry in entries]
            check(not result or times == [t for t, _ in result], f"{name}.pvd: {times}")
            result = []
            for t, entry in zip(times, entries):
                reader = vtk.vtkXMLUnstructuredGridReader()
                reader.SetFileName(str(self.folder / entry.get("file")))
                reader.Update()
                data = reader.GetOutput().GetPointData()
                result.append((t, {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}))
        return result


def largest_response(way, velocity, omega, duration, shortest):
    """Of an undamped oscillator up to this time, looked at 4000 times in the shortest period, and in free vibration after it."""
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
        Output={"Response spectra": "true", "Spectrum damping": 0., "Spectrum periods": "0.1, 0.3, 0.7, 2", "Report": "true"}))
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
    page = (run.folder / "report.html").read_text(encoding="utf-8")
    check("Response spectra of the monitors in stage \u2018shake\u2019" in page, "spectra in the report")


def block_on_a_spring(folder):
    a, period, duration = 2., 0.2, 1.
    w = 2. * math.pi / period
    (folder / "sudden.txt").write_text(f"0 {a}\n{duration} {a}\n")
    model = scene({"shake": {"Loads": "weight: 0", "Duration": duration}},
                  Earthquake={"Record y": "../sudden.txt", "Record unit": "length/s^2", "Baseline": "keep"},
                  Output={"Response spectra": "true", "Spectrum damping": 0., "Spectrum periods": "0.08, 0.13, 0.5, 2"})
    model["Bodies"]["lower"]["Young modulus"] = w * w
    model["Dynamics"]["Massless bodies"] = "lower"
    # Nodes in its middle, which have no mass.
    nodes = [(x, y) for y in (0., 0.5, 1., 2.) for x in (0., 1.)]
    cells = [(1 + 2 * j, 2 + 2 * j, 4 + 2 * j, 3 + 2 * j) for j in range(3)]
    run = Run(folder, "spring", model, mesh=Mesh(nodes, [
        (2, "lower", cells[:2]), (2, "upper", cells[2:]), (1, "bottom", [(1, 2)]), (1, "top", [(7, 8)]),
        (1, "sides", [(1, 3), (3, 5), (5, 7), (2, 4), (4, 6), (6, 8)])]))
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


def falling_block(folder):
    duration, interval = 0.5, 0.03
    model = scene({"fall": {"Loads": "weight: 1", "Duration": duration, "Levels": 2}},
                  Output={"Field interval": interval, "Fields": "levels", "Response spectra": "true"})
    model["Joints"]["base"].update({"Initial gap": 5., "Cohesion": 0., "Tensile strength": 0.})
    for body in model["Bodies"].values():  # the stress of a rigid motion over E is the rounding of its way
        body["Young modulus"] = 1e3
    run = Run(folder, "fall", model)
    known = sorted({k * interval for k in range(1, 17)} | {0.25, 0.5})
    frames = run.frames()
    check(len(frames) == len(known) and all(abs(t * duration - time) < 1e-9 for (t, _), time in zip(frames, known)),
          f"times of the fields: {[t * duration for t, _ in frames]}")
    for (_, arrays), t in zip(frames, known):
        for name, component in (("velocity", -G * t), ("displacement", -0.5 * G * t * t)):
            for vector in arrays[name]:  # single precision
                near(vector[1], component, 1e-5 * G, f"{name} of the falling block after {t} s")
                near(vector[0], 0., 1e-9, f"{name} of the falling block across")
    for _, value in run.accelerations("top", "y"):
        near(value, -G, 1e-9 * G, "acceleration of the falling block")
    periods = [period for period, _, _ in run.spectrum("top", "y")[1:]]
    check(len(periods) == 100 and abs(periods[0] - 0.02) < 1e-12 and abs(periods[-1] - 5.) < 1e-9, f"periods {periods}")
    # g at once and with 5 % of the critical damping: g (1 + exp(-pi z/sqrt(1 - z^2))), half a period later.
    known = G * (1. + math.exp(-math.pi * 0.05 / math.sqrt(1. - 0.05 ** 2)))
    for period, acceleration, _ in run.spectrum("top", "y")[1:]:
        if period < 2. * duration:
            near(acceleration, known, 1e-6 * known, f"pseudo-acceleration of {period} s of a fall")
    del model["Output"]["Field interval"], model["Output"]["Response spectra"]
    plain = Run(folder, "plain", model)
    check([round(2. * t) for t, _ in plain.frames()] == [1, 2], "fields without an interval")
    check(all("velocity" not in arrays for _, arrays in plain.frames()), "velocities that nobody asked for")
    check(not any((plain.folder / name).exists() for name in ("spectra.csv", "accelerations.csv")), "spectra nobody asked for")


def endless_slide(folder):
    interval, longest = 0.4, 1.
    model = scene({"weight": {"Loads": "weight: t"}, "pull": {"Loads": "pull: t"}},
                  Dynamics={"Longest continuation": longest, "Excess load": 0.1, "Damping ratio": 0.001, "Damping frequencies": "1; 9"},
                  Solver={"Beyond limit load": "dynamic"}, Output={"Field interval": interval, "Report": "true"})
    model["Joints"]["base"].update({"Cohesion": 0., "Tensile strength": 0., "Normal stiffness": 1e5, "Shear stiffness": 1e5})
    model["Loads"]["pull"] = {"Type": "weight", "Value": "1; 0"}
    run = Run(folder, "slide", model, 3)
    motion = json.loads((run.folder / "summary.json").read_text(encoding="utf-8"))["continuations"][0]
    steps, frames = run.rows("earthquake.csv"), run.frames()
    check(not motion["comes_to_rest"] and motion["seconds"] >= 0.999 * longest, f"{motion}")
    check(len(frames) == 3, f"times of the slide: {[t for t, _ in frames]}")
    for t, arrays in frames:
        time = float(min(steps, key=lambda row: abs(float(row["t"]) - t))["time"])
        near(time, interval if t == frames[0][0] else 2. * interval if t == frames[1][0] else longest, 1e-9, "time of a field")
        # Driven by a tenth of the weight; springs and damping are thousandths.
        for vector in arrays["velocity"]:
            near(vector[0], 0.1 * G * time, 0.02 * G * longest, f"velocity of the sliding block after {time} s")
    page = (run.folder / "report.html").read_text(encoding="utf-8")
    near(float(re.search(r"at most ([0-9.]+) m/s on the way", page).group(1)), 0.1 * G * longest, 0.02 * G * longest,
         "velocity of the slide in the report")
    begin, end = (row for row in run.rows("events.csv") if row["energy"] != "nan")
    check((begin["from"], begin["to"], float(begin["energy"])) == ("equilibrium", "motion until rest", 0.), f"{begin}")
    check(float(begin["t"]) == motion["t"] and begin["stage"] == end["stage"] == "pull" and begin["joint"] == "base", f"{begin}")
    check((end["from"], end["to"], end["t"]) == ("motion until rest", "motion", steps[-1]["t"]), f"{end}")
    # Friction of half the weight on the way; what the springs of the joint store is thousandths.
    friction = 0.5 * 2. * G * motion["largest_slip"]
    near(float(end["energy"]), friction, 0.01 * friction, "work on the joints of a slide")
    by_kind = json.loads((run.folder / "summary.json").read_text(encoding="utf-8"))["events"]
    check(by_kind["by_kind"]["motion until rest -> motion"] == 1 and by_kind["total"] == len(run.rows("events.csv")), f"{by_kind}")


def jumping_lips(folder):
    model = scene({"weight": {"Loads": "weight: t"}, "shake": {"Loads": "pull: sin(2*pi*t)", "Duration": 1.}},
                  Dynamics={"Time step": 0.02}, Solver={"Non-unique": "first"})
    del model["Monitors"]
    for body in model["Bodies"].values():
        body.update({"Young modulus": 1e3, "Poisson ratio": 0.3})
    model["Joints"]["base"] = {"Plus lip": "bottom", "Minus lip": "rigid", "Normal law": "rigid", "Shear law": "rigid",
                               "Friction coefficient": 2.}
    model["Loads"]["pull"] = {"Type": "weight", "Value": "2; 0"}
    run = Run(folder, "jumps", model, mesh=pair())
    events, steps = run.rows("events.csv"), run.rows("earthquake.csv")
    jumps = [i for i, row in enumerate(events) if row["to"] == "jump"]
    check(len(jumps) == 2, f"{len(jumps)} jumps")
    for i in jumps:
        row, t = events[i], float(events[i]["t"])
        check(row["from"] == "motion" and row["joint"] == "base" and row["stage"] == "shake", f"{row}")
        check(events[i + 1]["t"] == row["t"] and events[i + 1]["energy"] == "nan", f"after a jump: {events[i + 1]}")
        # In a rigid joint nothing but friction takes work, by the ledger the jump nearly all of that in its step.
        step = next(k for k, one in enumerate(steps) if float(one["t"]) >= t)
        work = float(steps[step]["joint_work"]) - float(steps[step - 1]["joint_work"])
        check(abs(work - float(row["energy"])) <= 1e-3 * work, f"work {row['energy']} of a jump in a step with {work}")


def main():
    with tempfile.TemporaryDirectory() as name:
        for part in (block_on_stiff_ground, block_on_a_spring, falling_block, endless_slide, jumping_lips):
            part(pathlib.Path(name))
    print("\n".join(complaints[:40]) or "bodies in motion are written as they move")
    sys.exit(1 if complaints else 0)


main()
