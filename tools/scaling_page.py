#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Measures how time and memory grow with degrees of freedom and contact elements, directly and iteratively, on one
process and on two, and estimates from this what large machines need; writes doc/scaling.md.

usage: scaling_page.py [--fuga BIN] [--output DIR] [--missing | --again | --from-measurements]

Measuring takes about half an hour and 10 GB; measurements are kept in doc/scaling.json, from which the page can be
written again. Whatever else a machine does makes runs slower, never faster: --again measures all once more.
"""
import argparse
import json
import math
import os
import platform
import resource
import shutil
import subprocess
import sys
import tempfile

from remarks import remarks

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(TOP, "tests", "benchmark"))
from fuga_runs import commit  # noqa: E402
from process import processor  # noqa: E402

COMMAND = "/usr/bin/python3 tools/scaling_page.py"

SPACE = "Dam block in space"
PLANE = "Scene G in the plane"
# A coarse file that the program refines, so that p4est divides the mesh.
REFINED = "Dam block in space, refined twice"
DIRECT, ITERATIVE, FREE = "direct", "iterative", "iterative matrix-free"
# Event by event with all levels, then with more and more water until nothing holds it.
LIMIT = "direct, to the limit load"

# Problem, solver, contact faces (elements) across the joint, processes.
RUNS = sorted([(SPACE, DIRECT, n, 1) for n in (8, 12, 16, 24, 32, 40)] + [(SPACE, ITERATIVE, n, 1) for n in (8, 12, 16)] +
              [(SPACE, FREE, n, 1) for n in (8, 12, 16, 24, 32, 40, 56)] + [(SPACE, LIMIT, 40, 1)] +
              [(PLANE, DIRECT, n, 1) for n in (33, 129, 513)] + [(PLANE, ITERATIVE, n, 1) for n in (33, 65, 129)] +
              [(PLANE, FREE, n, 1) for n in (33, 129, 513)] +
              [(SPACE, DIRECT, n, 2) for n in (16, 24)] + [(SPACE, FREE, n, 2) for n in (16, 24)] +
              [(PLANE, DIRECT, n, 2) for n in (129, 513)] + [(REFINED, FREE, 12, n) for n in (1, 2)],
              key=lambda run: (run[3], run[0] == SPACE and run[2] >= 32, run[2]))

# Assumed, not measured: operations per second of a dense inversion on one core.
DENSE_FLOPS = 1e10

# Phases of summary.json under the name of the page.
PHASES = {"mesh": ("start", "mesh", "mesh and degrees of freedom", "joints and supports"),
          "assembly": ("assembly", "nodal blocks", "elements and loads", "loads"),
          "elimination": ("ordering", "start of MPI and MUMPS", "analysis", "factorisation", "rigid motions",
                          "layered system"),
          "loads": ("condensation of loads",),
          "path": ("path",),
          "fields": ("recovery of displacements", "equilibrium check", "fields", "tables")}


def make_mesh(problem, n, folder):
    path = os.path.join(folder, f"{problem == PLANE:d}_{n}.msh")
    if not os.path.exists(path):
        if problem != PLANE:
            command = ["gmsh", "-3", "-v", "1", "-format", "msh41", "-setnumber", "n", str(n), "-o", path,
                       os.path.join(TOP, "meshes/dam_block_3d.geo")]
        else:
            command = ["/usr/bin/python3", os.path.join(TOP, "meshes/scene_g.py"), str(n), path]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return path


def safety_by_hand():
    """f (weight - uplift) / thrust of the block when the reservoir is full, from its dimensions alone (doc/examples/dam_block_3d.md):
    only the thrust grows. kN, m."""
    friction, gamma, level, width, drains = 0.7, 9.81, 27., 15., 3.
    base, crest, height = 24., 4., 30.
    weight = 24. * 0.5 * (base + crest) * height * width
    at_drains = 0.5 * (1. - drains / base)  # share of the full head
    uplift = gamma * level * width * (0.5 * (1. + at_drains) * drains + 0.5 * at_drains * (base - drains))
    return friction * (weight - uplift) / (0.5 * gamma * level**2 * width)


def measure(fuga, problem, solver, n, processes, folder):
    """The summary of a run, reduced to what the page needs."""
    output = os.path.join(folder, "out")
    shutil.rmtree(output, ignore_errors=True)
    name = "scene_g_f06.prm" if problem == PLANE else "dam_block_3d.prm"
    settings = ["Output/Fields=end", "Output/Checkpoint=never", f"Mesh/File={make_mesh(problem, n, folder)}"]
    if solver == LIMIT:
        settings += ["Solver/Bodies=direct", "Safety/Load factor=water"]
    else:
        settings += ["Solver/Load knots=1", f"Solver/Bodies={solver}",
                     ("Stages/water" if problem == PLANE else "Stages/reservoir") + "/Levels=1"]
    if solver == FREE:
        settings.append("Solver/Follow=stage ends")
    if problem == REFINED:
        settings.append("Mesh/Refinements=2")
    command = ["mpirun", "--allow-run-as-root", "-np", str(processes)] if processes > 1 else []
    command += [fuga, os.path.join(TOP, "parameters", name), "--quiet", "--output-dir", output]
    for setting in settings:
        command += ["--set", setting]
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")
    with open(os.path.join(output, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    seconds, peaks = summary["seconds"], summary["work"]["peak_memory_MB_after_phase"]
    row = {"problem": problem, "solver": solver, "n": n, "processes": processes,
           "unknowns": summary["sizes"]["degrees_of_freedom"], "elements": summary["sizes"]["contact_elements"],
           "bars": summary["sizes"]["bars"], "events": summary["events"]["total"],
           "schemes": summary["iterations"]["iterations"], "iterations": summary["work"]["iterations_of_bodies"],
           "load": os.getloadavg()[0], "solutions": summary["work"]["solutions_of_bodies"], "certificate": summary["certificate"]["worst"],
           "megabytes": summary["memory_MB"], "wall": sum(seconds.values()), "peak behind start": peaks.get("start", 0.),
           "seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}
    if solver == LIMIT:
        row["safety"] = summary["safety"]["load_factor"]
    # What the run had of a processor while others worked too; several processes have their own.
    share = row["seconds"] / row["wall"] if processes == 1 else 1.
    for phase, names in PHASES.items():
        row[f"seconds of {phase}"] = share * sum(seconds.get(name, 0.) for name in names)
        row[f"peak behind {phase}"] = max(peaks.get(name, 0.) for name in names)
    return row


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def number(value, digits=3):
    """A figure of so many digits, with blanks between thousands."""
    if value == 0:
        return "0"
    if value < 1e-3:
        return "< 0.001"
    if value >= 1000:
        digits_kept = max(0, int(math.log10(value)) + 1 - digits)
        return f"{round(value, -digits_kept):,.0f}".replace(",", " ")
    return f"{value:.{digits}g}"


def growth(rows, key, variable):
    """(c, q) of key = c variable^q by least squares in logarithms, over the larger half of the runs."""
    rows = sorted(rows, key=lambda row: row[variable])
    rows = rows[-max(2, (len(rows) + 1) // 2):]
    x = [math.log(row[variable]) for row in rows]
    y = [math.log(max(row[key], 1e-9)) for row in rows]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    q = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)
    return math.exp(mean_y - q * mean_x), q


class Page:
    def __init__(self, data):
        self.machine, self.commit, self.rows = data["machine"], data["commit"], data["rows"]
        self.runs = "once" if data["runs"] == 1 else f"{data['runs']} times, of which the fastest counts"
        loads = [row["load"] for row in self.rows]
        self.load = f"{min(loads):.0f} to {max(loads):.0f}"
        self.text = []

    def select(self, problem, solver, processes=1):
        rows = [row for row in self.rows
                if (row["problem"], row["solver"], row["processes"]) == (problem, solver, processes)]
        return sorted(rows, key=lambda row: row["unknowns"])

    def write_runs(self):
        for problem in (PLANE, SPACE):
            self.text.append(f"## {problem}: growth\n")
            for solver in (DIRECT, ITERATIVE, FREE):
                rows = self.select(problem, solver)
                if not rows:
                    continue
                self.text.append(f"**{solver}**\n")
                self.text.append(table(
                    ["dofs", "contact elements", "events", "schemes", "CG and GMRES iterations", "CPU [s]", "wall [s]"] +
                    list(PHASES) + ["peak [MB]", "certificate"],
                    [[number(row["unknowns"], 7), row["elements"], row["events"] or "-",
                      row["schemes"] if solver == FREE else "-",
                      number(row["iterations"], 7) if row["iterations"] else "-", number(row["seconds"]),
                      number(row["wall"])] +
                     [number(row[f"seconds of {phase}"]) for phase in PHASES] +
                     [number(row["megabytes"], 4), f"{row['certificate']:.0e}"] for row in rows]))

    def write_limit(self):
        for row in self.select(SPACE, LIMIT):
            factor, by_hand = row["safety"]["factor"], safety_by_hand()
            self.text.append(
                f"**To the limit load.** {number(row['unknowns'], 7)} dofs, {row['elements']} contact elements, weight, "
                f"reservoir, uplift, event by event ({row['events']} of them), then the water grows until the block slides: "
                f"{number(row['seconds'])} s of a processor ({number(row['seconds of elimination'])} elimination, "
                f"{number(row['seconds of path'])} path), {number(row['megabytes'] / 1e3)} GB, certificate "
                f"{row['certificate']:.0e}. Load factor {factor:.9g} ({row['safety']['verdict']}); by hand, "
                f"f (weight − uplift) / thrust of the full reservoir from the dimensions of the block ([example](examples/dam_block_3d.md)): {by_hand:.9g}, a difference of {abs(factor / by_hand - 1.):.0e}.\n")

    def write_memory(self):
        self.text.append("## Memory by phase\n")
        self.text.append("Peak resident size [MB] of the process up to the end of each phase, largest run of each kind.\n")
        phases = {"mesh": "mesh", "loads": "bodies eliminated, loads condensed", "elimination": "small system",
                  "path": "path", "fields": "fields"}
        rows = []
        for problem in (PLANE, SPACE):
            for solver in (DIRECT, ITERATIVE, FREE):
                runs = self.select(problem, solver)
                if runs:
                    rows.append([problem, solver, number(runs[-1]["unknowns"], 7)] +
                                [number(runs[-1][f"peak behind {phase}"], 4) for phase in phases])
        self.text.append(table(["problem", "bodies", "dofs"] + list(phases.values()), rows))

    def write_processes(self):
        pairs = [(one, two) for two in self.rows if two["processes"] == 2 for one in self.rows
                 if one["processes"] == 1 and all(one[key] == two[key] for key in ("problem", "solver", "n"))]
        if not pairs:
            return
        self.text.append("## One process and two\n")
        self.text.append("Memory is that of the first process. The mesh of the block that is refined is divided by p4est; the others "
                         "are used as they are in their files, and every process keeps them ([parallel](parallel.md)).\n")
        self.text.append(table(
            ["problem", "bodies", "dofs", "wall time 1 [s]", "wall time 2 [s]", "elimination 1 [s]", "elimination 2 [s]",
             "memory behind *mesh* 1 [MB]", "2 [MB]", "memory 1 [MB]", "memory 2 [MB]"],
            [[one["problem"], one["solver"], number(one["unknowns"], 7), number(one["wall"]),
              number(two["wall"]), number(one["seconds of elimination"]), number(two["seconds of elimination"]),
              number(one["peak behind mesh"], 4), number(two["peak behind mesh"], 4),
              number(one["megabytes"], 4), number(two["megabytes"], 4)] for one, two in pairs]))

    def write_fits(self):
        self.text.append("## Exponents\n")
        self.text.append("Fitted to the larger half of the runs: time and memory grow as dofs to the power of\n")
        rows = []
        for problem in (PLANE, SPACE):
            for solver in (DIRECT, ITERATIVE, FREE):
                runs = self.select(problem, solver)
                if len(runs) > 2:
                    rows.append([problem, solver] + [f"{growth(runs, key, 'unknowns')[1]:.2f}" for key in
                                                     ("seconds", "seconds of elimination", "seconds of path",
                                                      "megabytes")])
        self.text.append(table(["problem", "bodies", "time", "elimination", "path", "memory"], rows))

    def memory_of_mesh(self, unknowns):
        """What of it every process has, from a refined mesh on one process and on two."""
        one, two = ((row["peak behind mesh"] - row["peak behind start"]) / row["unknowns"] * 1e6
                    for n in (1, 2) for row in self.select(REFINED, FREE, n))
        whole, divided = 2. * two - one, 2. * (one - two)
        return (f"{number(one)} bytes per unknown on one process, {number(two)} on each of two where p4est divides a refined "
                f"mesh; hence {number(whole)} that every process has and {number(divided)} that are divided: "
                f"{number((whole + divided / 64.) * unknowns / 1e9)} GB on each of 64 processes "
                f"({number(one * unknowns / 1e9)} GB if the file is the mesh).")

    def write_estimate(self):
        unknowns, elements = 1e8, 1e5
        bars = 3 * elements
        free = self.select(SPACE, FREE)
        largest = max(free, key=lambda row: row["unknowns"])
        direct = self.select(SPACE, DIRECT)
        c_direct, q_direct = growth(direct, "megabytes", "unknowns")
        t_direct, p_direct = growth(direct, "seconds of elimination", "unknowns")
        per_unknown = largest["megabytes"] / largest["unknowns"] * 1e6  # bytes
        iteration = (largest["seconds of path"] + largest["seconds of loads"]) / largest["iterations"]
        iteration *= unknowns / largest["unknowns"]
        levels = math.log(unknowns / largest["unknowns"]) / math.log(27.)
        per_solution = largest["iterations"] / (largest["solutions"])
        grown = per_solution * (1. + 0.1 * levels)
        schemes = largest["schemes"]
        dense = 2. * 8. * bars ** 2 / 1e9
        dense_time = 2. * bars ** 3 / DENSE_FLOPS
        column_time = bars * grown * iteration
        self.text.append("## Estimate: 1e8 dofs and 1e5 contact elements in space\n")
        self.text.append(
            "Assumptions: the fits above hold; multigrid needs a tenth more iterations with every level more (27 times "
            "the unknowns); work on the bodies divides by the number of processes (communication is left out, as are "
            "the gains of more caches); a process has a core of this machine for itself; nothing of the interface "
            f"is distributed; the inversion in eq. 4 takes 2 n³ operations for n bars, at an assumed rate of {DENSE_FLOPS:.0e} per second "
            "(one core, double precision, not measured). Computed by the script from the measurements:\n")
        rows = []
        for processes in (64, 1024):
            rows.append([
                processes,
                number(c_direct * unknowns ** q_direct / 1e3 / processes),
                number(t_direct * unknowns ** p_direct / 3600. / processes),
                number(per_unknown * unknowns / 1e9 / processes),
                number(grown * largest["solutions"] * iteration / 3600. / processes),
                number(dense),
                number(column_time / 3600. / processes),
                number(dense_time / 3600.)])
        self.text.append(table(
            ["processes", "factor: memory per process [GB]", "factor: time [h]", "matrix-free: memory per process [GB]",
             f"matrix-free: time of a run with {schemes} schemes [h]", "S and W, on every process [GB]",
             "S by columns: time [h]", "eq. 4 on one process [h]"], rows))
        self.text.append(
            f"The interface of {number(bars)} bars: S and W are {number(dense)} GB on every process, the inversion in eq. 4 takes "
            f"{number(dense_time / 3600.)} h on one. Mesh, degrees of freedom and tables of nodes: "
            f"{self.memory_of_mesh(unknowns)}\n")

    def write(self, path):
        self.text = [f"<!-- Generated by `{COMMAND}`. Do not edit: run it again. -->\n# Growth of time and memory\n",
                     f"Written by `{COMMAND}` from runs of {self.commit} on {self.machine}. Bodies `direct` (MUMPS) and `iterative` "
                     "(conjugate gradients with algebraic multigrid, [theory](theory.md), section 1) follow every event; "
                     "`iterative matrix-free` finds stage ends without the stiffness of the interface (section 18). "
                     "Problems: `parameters/dam_block_3d.prm` with meshes of `meshes/dam_block_3d.geo`, "
                     "`parameters/scene_g_f06.prm` with meshes of `meshes/scene_g.py`; loads interpolated between stage "
                     f"ends. One BLAS thread. Every case was run {self.runs}. Load average of the machine while measuring: {self.load}. Times are CPU "
                     "seconds, so that other work does not count; those of the phases are wall seconds times "
                     "the share of a processor that the run got.\n"]
        self.write_runs()
        self.write_limit()
        self.write_memory()
        self.write_processes()
        self.write_fits()
        self.write_estimate()
        self.text.append(remarks("scaling"))
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(self.text))


def measure_all(data, fuga, again, store):
    rows = {(row["problem"], row["solver"], row["n"], row["processes"]): row for row in data["rows"]}
    with tempfile.TemporaryDirectory() as folder:
        for run in RUNS:
            if run in rows and not again:
                continue
            row = measure(fuga, *run, folder)
            print(f"{run}: {row['seconds']:.1f} s, {row['megabytes']:.0f} MB", flush=True)
            if run not in rows or row["seconds"] < rows[run]["seconds"]:
                rows[run] = row
            data["rows"] = list(rows.values())
            with open(store, "w", encoding="utf-8") as file:
                json.dump(data, file, indent=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--fuga", default=os.path.join(TOP, "build", "release", "fuga"))
    parser.add_argument("--output", default=os.path.join(TOP, "doc"))
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--from-measurements", action="store_true", help="write the page from scaling.json")
    how.add_argument("--missing", action="store_true", help="measure what scaling.json lacks, then write the page")
    how.add_argument("--again", action="store_true", help="measure all once more, keep of every case the faster run")
    options = parser.parse_args()
    store = os.path.join(options.output, "scaling.json")
    here = {"machine": f"{os.cpu_count()} cores of an {processor()}, Linux {platform.release().split('-')[0]}",
            "commit": commit()}
    data = {**here, "runs": 0, "rows": []}
    if options.from_measurements or options.missing or options.again:
        with open(store, encoding="utf-8") as file:
            data = json.load(file)
    if not options.from_measurements:
        for what, ours in here.items():
            if data[what] != ours:
                sys.exit(f"{store} is of another {what}, {data[what]}, not {ours}: measure without --missing and --again.")
        data["runs"] += not options.missing
        measure_all(data, os.path.abspath(options.fuga), options.again, store)
    Page(data).write(os.path.join(options.output, "scaling.md"))


if __name__ == "__main__":
    main()
