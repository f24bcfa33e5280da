# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""doc/benchmarks.md from the measured figures."""
import sys

import meshes
from page import requirements
from page.figures import TOTALS, exponent

sys.path.insert(0, str(meshes.REPOSITORY / "tools"))
from remarks import remarks  # noqa: E402

# The phases of summary.json in the words of the tables.
GROUPS = {"start": ("start", "start of MPI and MUMPS"),
          "mesh": ("mesh", "mesh and degrees of freedom", "joints and supports", "elements and loads"),
          "assembly": ("assembly", "loads", "rigid motions"),
          "factorisation": ("ordering", "analysis", "factorisation"),
          "condensation": ("condensation of loads", "layered system"), "path": ("path",),
          "recovery": ("recovery of displacements",), "output": ("fields", "tables")}
KNOWN = {phase for phases in GROUPS.values() for phase in phases} | set(TOTALS)
PROBLEMS = ("V2 patch", "V5 pull-out", "V7 Hertz", "V8 punch", "V8 stick zone", "V9 Raous")


def table(header, rows):
    if not rows:
        return "Not measured in this run.\n"
    lines = [header, ["---"] * len(header)] + [list(map(str, row)) for row in rows]
    return "\n".join("| %s |" % " | ".join(line) for line in lines) + "\n"


def seconds(value):
    return "" if value is None else ("%.4f" if value < 1. else "%.3f" if value < 10. else "%.1f") % value


def scientific(value):
    return "" if value is None else "%.1e" % value


def error_of(one):
    return one.failure() if one.failed else scientific(one.error)


def grouped(one):
    """Seconds by group; phases that no group knows are shown as 'other'."""
    groups = {name: sum(one.phases.get(phase, 0.) for phase in phases) for name, phases in GROUPS.items()}
    return {**groups, "other": sum(value for name, value in one.phases.items() if name not in KNOWN)}


def requirement_tables(figures):
    parts, count = [], {"yes": 0, "no": 0, "in part": 0, "-": 0}
    for title, rows in requirements.by_title(figures):
        parts += ["### %s\n" % title, table(["figure", "required", "measured", "reached"], rows)]
        for row in rows:
            count[row[3]] += 1
    return "\n".join(["%d rows reached, %d not, %d in part, %d not measured.\n" % tuple(count.values())] + parts)


def work_precision(figures, problem):
    rows = []
    for variant in figures.variants(problem):
        one = figures.fuga(problem, variant)
        rows.append([variant, one.dofs, one.n, error_of(one), seconds(one.seconds),
                     *map(seconds, grouped(one).values())])
    reference = figures.references.get(problem)
    return "### %s\n\n%s" % (problem, "Reference: %s.\n\n" % reference if reference else "") + table(
        ["mesh, degree", "dofs", "contact elements", "error", "CPU after start", *GROUPS, "other"], rows)


def _growth(series):
    """Rows of exponents over the last four sizes."""
    last = series[-4:]
    values = {name: [grouped(one)[name] for one in last] for name in GROUPS if name != "start"}
    values.update({"all": [one.without_fields() for one in last], "memory MB": [one.memory for one in last]})
    for name, ys in values.items():
        in_dofs, in_n = (exponent(list(zip(xs, ys))) for xs in ([one.dofs for one in last], [one.n for one in last]))
        if in_dofs is not None:
            yield [last[-1].variant, name, seconds(ys[-1]), "%.2f" % in_dofs, "%.2f" % in_n]


def scaling(figures, scene, variants):
    rows, growth = [], []
    for variant in variants:
        series = figures.series(scene, variant)
        for one in series:
            path, events = one.phase("path"), one.note.get("events", 0)
            phases = grouped(one)
            del phases["start"]
            rows.append([variant, one.n, one.dofs, one.failure() if one.failed else seconds(one.without_fields())]
                        + list(map(seconds, phases.values()))
                        + ["%.0f" % one.memory, events, "%.0f" % (events / path) if path and events else "",
                           scientific(one.note.get("certificate"))])
        if len(series) >= 3:
            growth += _growth([one for one in series if not one.failed])
    header = ["variant", "n", "dofs", "CPU after start, no fields", *list(GROUPS)[1:], "other", "memory MB", "events",
              "events/s", "certificate"]
    return table(header, rows) + "\nExponents over the last four sizes:\n\n" + table(
        ["variant", "phase", "at the largest", "in dofs", "in contact elements"], growth)


def _end(one):
    counted = [name for name in ("events", "increments", "iterations", "solutions") if name in one.note]
    work = ", ".join("%d %s" % (one.note[name], name) for name in counted)
    return [seconds(one.total), seconds(one.seconds), "%.0f" % one.memory, error_of(one), work]


def peers(figures, scene, sizes=None):
    shown = [one for one in figures.all_of(scene) if (sizes is None or one.n in sizes) and
             " threads " not in one.variant and not one.variant.startswith(("kn", "sweep", "law9"))]
    shown.sort(key=lambda one: (one.n, one.variant.replace("rigid ", "").split()[0], one.tool != "fuga", one.tool))
    return table(["n", "dofs", "tool", "variant", "CPU", "CPU after start", "memory MB", "error", "work"],
                 [[one.n, one.dofs, one.tool, one.variant] + _end(one) for one in shown])


def stiffness(figures):
    shown = [one for one in figures.all_of("scene_g") if one.n in (33, 129) and
             (one.variant.startswith("kn") or (one.tool, one.variant) == ("fuga", "rigid f0.6"))]
    shown.sort(key=lambda one: (one.tool != "fuga", one.n))
    return table(["n", "tool", "variant", "CPU", "CPU after start", "memory MB", "error", "work"],
                 [[one.n, one.tool, one.variant] + _end(one) for one in shown])


def threads(figures):
    """By the clock: threads share work, they do not save it."""
    rows = []
    for scene in ("scene_g", "s0", "dam_block"):
        for variant in figures.variants(scene):
            if " threads " in variant:
                rows += [[scene, one.n, one.dofs, *variant.split(" threads "), seconds(one.phase("wall")),
                          seconds(one.total), *map(seconds, grouped(one).values())]
                         for one in figures.series(scene, variant)]
    return table(["scene", "n", "dofs", "variant", "threads", "whole process", "CPU", *GROUPS, "other"], rows)


def failures(figures):
    """Every run of fuga that did not end as it should, also where a repetition of it did."""
    found = [[one.scene, one.variant, one.n, message] for scene in dict.fromkeys(key[0] for key in figures.rows)
             for one in figures.all_of(scene) if one.tool == "fuga" for message in one.note.get("failures", [])]
    return table(["scene", "variant", "n", "message"], found) if found else "None.\n"


HEAD = """<!-- Generated by `./check benchmark`. Do not edit: run it again. -->
# Benchmarks

This page and its plots are written by `./check benchmark` (options: `%(command)s`) from one run, in which the tools
took turns. All raw figures of that run: [benchmark_phases.csv](benchmark_phases.csv) and
[benchmark_notes.json](benchmark_notes.json).

| | |
| --- | --- |
| machine | %(cpu)s, %(cores)d cores, %(system)s |
| run | %(date)s, %(minutes)s minutes, load at the beginning %(load)s |
| versions | fuga %(commit)s, %(versions)s |
| threads | 1 for every tool, save in the table of threads |
| repeats | medians of %(repeats)d rounds, of fewer where a case had taken 10 s or twice the same within 2 %% |

"CPU" is user and system time of the whole process [s]. "After start" is this less the CPU time of the same program that
only says its version (fuga: median of the last five; CalculiX) or only loads its library (GetFEM), measured just before. Phases
are those of fuga's `summary.json`, by the clock; where two runs of fuga are compared, it is by the sums of their
phases, since the start of a process varies by more than a small scene takes. No VTU files are written, save by the bonded control, where the time
for them is subtracted. An error is the relative Euclidean norm of all jumps at the end of the history.

n: contact elements. x10, x1: ten, one increment per stage. nts, sts: node-to-surface, surface-to-surface contact of
CalculiX. "Stage ends": fuga without events, by one certified implicit step per stage.
"""
ERRORS = """Errors: fuga's against the independent solutions in `tests/scenes/reference` (none is shown where there
is none); the peers' against these, or else against fuga. GetFEM's joint is rigid; its error is taken
against the rigid solution.
"""
SPACE = """`meshes/dam_block_3d.geo`, trilinear hexahedra, data of `parameters/dam_block_3d.prm`: weight, then 1.4 times the
pressure of the full reservoir on the upstream face; no water in the joint. The same nodes, elements and nodal forces
for both. Errors: CalculiX's against fuga's path. Bonded: the bodies grown together. GetFEM was not tried in space; what
is missing at n = 400 is in `./check benchmark --full`.
"""
LIMIT = """The push goes on to 1.3 times what the block bears, f weight / (resultant of the water). Error: of the load at
which the run stops. CalculiX begins with ten increments per stage and cuts them.
"""
THREADS = """Seconds by the clock; the CPU time is that of all threads together.\n"""


def page(figures, plots):
    def plot(name, words):
        return "![%s](%s.png)\n" % (words, name) if name in plots else ""

    text = [HEAD % {**figures.machine, "command": figures.machine["command"] or "none"},
            "## What was to be reached\n", requirement_tables(figures),
            "## Work and precision\n", plot("benchmark_precision", "error against time")]
    text += [work_precision(figures, problem) for problem in PROBLEMS if figures.variants(problem)]
    text += ["## Scaling\n", plot("benchmark_scaling", "time over size"),
             "### S0\n", scaling(figures, "s0", ("linear", "law9", "rigid", "bonded")),
             "### Scene G\n", scaling(figures, "scene_g", ("f0.2", "f0.6", "bonded")),
             "## Peers\n", plot("benchmark_peers", "fuga and its peers"), ERRORS,
             "### Scene G\n", peers(figures, "scene_g", (9, 33, 129, 513)),
             "### S0, 65 contact elements\n", peers(figures, "s0", (65,)),
             "## Scene G with reversal\n", plot("benchmark_reversal", "error of CalculiX against its time"),
             "Load +L, −L, +L, f = 0.6. Error: the largest at the ends of all stages, against fuga's path.\n",
             peers(figures, "scene_g_reversal"), "## Stiff and rigid joints\n", stiffness(figures),
             "## In space: the block of a dam\n", SPACE, peers(figures, "dam_block"),
             "### To the limit of sliding\n", LIMIT, peers(figures, "dam_block_limit"),
             "## Threads\n", THREADS, threads(figures),
             "## Failed runs of fuga\n", failures(figures), remarks("benchmarks")]
    return "\n".join(part for part in text if part)
