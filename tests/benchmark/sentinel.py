#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Has anything become slower? A few scenes, three rounds in turns, medians; every part of a run over the elimination of
the bodies in the same process, and the whole over the same bodies without a joint, beside the recorded ratio
(doc/benchmark_record.csv).

usage: sentinel.py [--record]

Parts whose ratio is above 1.25 times the recorded one in every round, so that noise of the machine is none, are
marked, and the exit code is 1. --record writes the
record from this run; commit it together with the change that is its reason.
"""
import argparse
import csv
import json
import shutil
import statistics
import subprocess
import sys

import fuga_runs
import meshes
import scenes
from peers import calculix

RECORD = meshes.REPOSITORY / "doc" / "benchmark_record.csv"
ROUNDS, WORSE = 3, 1.25
# Parts shorter than this are the clock's and the kernel's rather than the program's [s of the processor].
SHORTEST = 0.03
PARTS = ("model", "loads", "layered system", "path", "judge", "results", "total after start")


class OfFile:
    """A shipped parameter file with another mesh."""

    def __init__(self, file, mesh, settings):
        self.file, self.mesh, self.settings = file, mesh, settings

    def command(self):
        parts = [fuga_runs.PROGRAM, str(meshes.REPOSITORY / "parameters" / self.file), "--output-dir", "out", "--quiet"]
        for setting in ["Mesh/File=" + self.mesh(), *self.settings]:
            parts += ["--set", setting]
        return parts


def dam_mesh():
    path = fuga_runs.WORK / "meshes" / "dam_block_12.msh"
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        subprocess.run(["gmsh", "-3", "-v", "1", "-format", "msh41", "-setnumber", "n", "12", "-o", str(path),
                        str(meshes.REPOSITORY / "meshes" / "dam_block_3d.geo")], check=True, stdout=subprocess.DEVNULL)
    return str(path)


CASES = {**{"scene G, %d, f = %g" % (n, f): scenes.scene_g(n, f) for n in (129, 513) for f in (0.2, 0.6)},
         **{"S0, %d" % n: scenes.s0(n) for n in (129, 257)},
         "S0, 129, law (9)": scenes.s0(129, "law9"),
         "dam block in space, 12": OfFile("dam_block_3d.prm", dam_mesh, ["Solver/Bodies=direct", "Output/Fields=end"])}
# The same bodies, grown together, under the loads of the end: one linear solution, by the same program.
CONTROLS = {(case.name, case.n): case.altered(bonded=True) for case in CASES.values() if isinstance(case, scenes.Scene)}
# Scenes that CalculiX solves as well, ten increments a stage.
PEERS = ("scene G, 129, f = 0.2", "scene G, 129, f = 0.6")


def seconds_of(name, case):
    """{part: seconds of the processor}, elimination and the whole process among them."""
    directory = fuga_runs.WORK / "runs" / ("sentinel_" + "".join(c if c.isalnum() else "_" for c in name))
    directory.mkdir(parents=True, exist_ok=True)
    if isinstance(case, OfFile):
        command = case.command()
    else:
        # Fields of the last level only: what a level costs shows, eleven of them would hide the rest.
        fuga_runs.write_parameters(directory / "run.prm", case.sections(fuga_runs.scene_mesh(case)), "end")
        command = [fuga_runs.PROGRAM, "run.prm", "--output-dir", "out", "--quiet"]
    process = fuga_runs.measure(command, str(directory))
    if process.code != 0:
        sys.exit("%s: exit code %d\n%s" % (name, process.code, process.output))
    with open(directory / "out" / "summary.json", encoding="utf-8") as file:
        phases = json.load(file)["work"]["counted"]
    result = {phase: counts["cpu_seconds"] for phase, counts in phases.items()}
    result["whole process"] = process.cpu
    return result


def measure_all():
    """{(scene, part): (median of the seconds, median of the ratios, smallest ratio)}"""
    samples, peers = {name: [] for name in CASES}, {name: [] for name in PEERS}
    controls = {key: [] for key in CONTROLS}
    with_peer = shutil.which(calculix.PROGRAM) is not None
    for number in range(ROUNDS):
        start = fuga_runs.start_seconds()  # in every round: it changes with what else the machine does
        for key, control in CONTROLS.items():
            controls[key].append(seconds_of("bonded_%s_%d" % key, control)["whole process"] - start)
        for name, case in CASES.items():
            seconds = seconds_of(name, case)
            seconds["model"] -= start  # loading the libraries is not the mesh
            seconds["total after start"] = seconds["whole process"] - start
            samples[name].append(seconds)
        if with_peer and number == 0:  # tens of seconds, and always the same program
            for name in PEERS:
                scene = CASES[name]
                peers[name].append(calculix.run_scene(scene, "nts", 10, None, 120).phases["total"])
    figures = {}
    for name, of_scene in samples.items():
        units = [("whole process", "over CalculiX", [peers[name][0]] * ROUNDS)] if peers.get(name) else []
        if isinstance(CASES[name], scenes.Scene):
            units.append(("total after start", "over bonded control", controls[CASES[name].name, CASES[name].n]))
        for part, title, unit in [(part, part, [s["elimination"] for s in of_scene]) for part in PARTS] + units:
            ratios = [seconds[part] / u for seconds, u in zip(of_scene, unit, strict=True)]
            figures[name, title] = (statistics.median(s[part] for s in of_scene), statistics.median(ratios), min(ratios))
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--record", action="store_true", help="write doc/benchmark_record.csv from this run")
    record_it = parser.parse_args().record
    recorded = {}
    if RECORD.exists():
        with open(RECORD, encoding="utf-8", newline="") as file:
            recorded = {(row["scene"], row["part"]): float(row["ratio"]) for row in csv.DictReader(file)}
    figures, n_worse = measure_all(), 0
    print("%-26s %-18s %9s %9s %9s" % ("scene", "part", "CPU s", "ratio", "recorded"))
    for (name, part), (seconds, ratio, smallest) in figures.items():
        before = recorded.get((name, part))
        worse = before is not None and seconds > SHORTEST and smallest > WORSE * before
        n_worse += worse
        print("%-26s %-18s %9.3f %9.3f %9s%s" % (name, part, seconds, ratio, "" if before is None else "%.3f" % before,
                                                  "  << worse than %.2f times" % WORSE if worse else ""))
    if record_it:
        with open(RECORD, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["scene", "part", "cpu_seconds", "ratio"])
            writer.writerows([*key, "%.4f" % seconds, "%.4f" % ratio] for key, (seconds, ratio, _) in figures.items())
        print("Recorded in %s." % RECORD.relative_to(meshes.REPOSITORY))
        return 0
    return 1 if n_worse else 0


sys.exit(main())
