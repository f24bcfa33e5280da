#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Has anything become slower? A few scenes, three rounds in turns, medians; every part of a run over the elimination of
the bodies in the same process, and the whole over the same bodies without a joint, beside the recorded ratio
(doc/benchmark_record.csv).

usage: sentinel.py [--record | --against PROGRAM]

Parts whose ratio is above 1.25 times the recorded one in every round, so that noise of the machine is none, are
marked, and the exit code is 1. --record writes the record from this run; commit it together with the change that is its
reason. The record knows processors, as the path may have to wait for a smaller cache on another one; it has rows of every
one that it was written on, with the commit. Where it has none, --against compares with another fuga, built from the
commit of a record, in the same rounds.
"""
import argparse
import csv
import json
import pathlib
import shutil
import statistics
import subprocess
import sys

import fuga_runs
import meshes
import scenes
from peers import calculix
from process import processor

RECORD = meshes.REPOSITORY / "doc" / "benchmark_record.csv"
COLUMNS = ("scene", "part", "cpu_seconds", "ratio", "processor", "commit")
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


def dam_block(n):
    path = fuga_runs.WORK / "meshes" / ("dam_block_%d.msh" % n)
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        subprocess.run(["gmsh", "-3", "-v", "1", "-format", "msh41", "-setnumber", "n", str(n), "-o", str(path),
                        str(meshes.REPOSITORY / "meshes" / "dam_block_3d.geo")], check=True, stdout=subprocess.DEVNULL)
    return str(path)


CASES = {**{"scene G, %d, f = %g" % (n, f): scenes.scene_g(n, f) for n in (129, 513) for f in (0.2, 0.6)},
         **{"S0, %d" % n: scenes.s0(n) for n in (129, 257)},
         "S0, 129, law (9)": scenes.s0(129, "law9"),
         "dam block in space, 12": OfFile("dam_block_3d.prm", lambda: dam_block(12), ["Solver/Bodies=direct", "Output/Fields=end"]),
         "dam block, 16, to limit": OfFile("dam_block_3d.prm", lambda: dam_block(16),
                                           ["Solver/Bodies=direct", "Output/Fields=never", "Safety/Load factor=water"]),
         "dam under an earthquake": OfFile("dam_earthquake.prm", lambda: str(meshes.REPOSITORY / "meshes" / "dam.msh"),
                                           ["Output/Fields=never"])}
# Contact elements of the scene with most degrees of freedom, S0.
LARGEST = 257
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
        # Fields of the last level only: what a level costs shows, eleven of them would hide the rest. Those of the largest
        # scene would take a fifth of the time of all.
        fields = "never" if case.n == LARGEST else "end"
        fuga_runs.write_parameters(directory / "run.prm", case.sections(fuga_runs.scene_mesh(case)), fields)
        command = [fuga_runs.PROGRAM, "run.prm", "--output-dir", "out", "--quiet"]
    process = fuga_runs.measure(command, str(directory))
    if process.code != 0:
        sys.exit("%s: exit code %d\n%s" % (name, process.code, process.output))
    with open(directory / "out" / "summary.json", encoding="utf-8") as file:
        phases = json.load(file)["work"]["counted"]
    result = {phase: counts["cpu_seconds"] for phase, counts in phases.items()}
    result["whole process"] = process.cpu
    return result


def figures_of(samples, units):
    """(median of the seconds, median of the ratios, smallest ratio)"""
    ratios = [seconds / unit for seconds, unit in zip(samples, units, strict=True)]
    return statistics.median(samples), statistics.median(ratios), min(ratios)


class Program:
    """What one fuga needed, round by round."""

    def __init__(self, path):
        self.path = path
        self.samples, self.controls = {name: [] for name in CASES}, {key: [] for key in CONTROLS}

    def measure(self):
        fuga_runs.PROGRAM = self.path
        fuga_runs.STARTS.clear()
        start = fuga_runs.start_seconds()  # in every round: it changes with what else the machine does
        for key, control in CONTROLS.items():
            self.controls[key].append(seconds_of("bonded_%s_%d" % key, control)["whole process"] - start)
        for name, case in CASES.items():
            seconds = seconds_of(name, case)
            seconds["model"] -= start  # loading the libraries is not the mesh
            seconds["total after start"] = seconds["whole process"] - start
            self.samples[name].append(seconds)

    def figures(self, peers):
        """{(scene, part): figures}; @p peers: seconds of CalculiX."""
        result = {}
        for name, of_scene in self.samples.items():
            def add(title, part, units, name=name, of_scene=of_scene):
                result[name, title] = figures_of([seconds[part] for seconds in of_scene], units)

            for part in PARTS:
                add(part, part, [seconds["elimination"] for seconds in of_scene])
            if name in peers:
                add("over CalculiX", "whole process", [peers[name]] * ROUNDS)
            if isinstance(CASES[name], scenes.Scene):
                add("over bonded control", "total after start", self.controls[CASES[name].name, CASES[name].n])
        return result


def seconds_of_peers():
    """Once: tens of seconds, and always the same program."""
    if shutil.which(calculix.PROGRAM) is None:
        return {}
    return {name: calculix.run_scene(CASES[name], "nts", 10, None, 120).phases["total"] for name in PEERS}


def read_record():
    """The rows of all processors."""
    with open(RECORD, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def write_record(figures):
    """Replaces the rows of this processor."""
    origin = {"processor": processor(), "commit": fuga_runs.commit()}
    rows = [row for row in read_record() if row["processor"] != origin["processor"]]
    rows += [{"scene": scene, "part": part, "cpu_seconds": "%.4f" % seconds, "ratio": "%.4f" % ratio, **origin}
             for (scene, part), (seconds, ratio, _) in figures.items()]
    with open(RECORD, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print("Recorded in %s." % RECORD.relative_to(meshes.REPOSITORY))


def compare(figures, before, name_before):
    """Prints the table; how many parts are worse."""
    n_worse = 0
    print("%-26s %-20s %9s %9s %9s" % ("scene", "part", "CPU s", "ratio", name_before))
    for (name, part), (seconds, ratio, smallest) in figures.items():
        expected = before.get((name, part))
        worse = expected is not None and seconds > SHORTEST and smallest > WORSE * expected
        n_worse += worse
        print("%-26s %-20s %9.3f %9.3f %9s%s" % (name, part, seconds, ratio, "" if expected is None else "%.3f" % expected,
                                                  "  << worse than %.2f times" % WORSE if worse else ""))
    return n_worse


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    choice = parser.add_mutually_exclusive_group()
    choice.add_argument("--record", action="store_true", help="write doc/benchmark_record.csv from this run")
    choice.add_argument("--against", metavar="PROGRAM", help="compare with this fuga in the same rounds, not with the record")
    options = parser.parse_args()
    present = Program(fuga_runs.PROGRAM)
    other = Program(str(pathlib.Path(options.against).resolve())) if options.against else None
    peers = seconds_of_peers()
    for _ in range(ROUNDS):
        for program in filter(None, (other, present)):
            program.measure()
    figures = present.figures(peers)
    if other:
        return 1 if compare(figures, {key: ratio for key, (_, ratio, _) in other.figures(peers).items()}, "other") else 0
    record, here = read_record(), processor()
    known = here if any(row["processor"] == here for row in record) else record[-1]["processor"]
    rows = [row for row in record if row["processor"] == known]
    n_worse = compare(figures, {(row["scene"], row["part"]): float(row["ratio"]) for row in rows}, "recorded")
    print("Recorded: %s on %s." % (rows[0]["commit"], known))
    if known != here:
        print("This processor is another one, %s: see --against." % here)
    if options.record:
        write_record(figures)
        return 0
    return 1 if n_worse else 0


sys.exit(main())
