#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Run time, memory and error of fuga and of its peers on the same scenes, in one go.

usage: benchmark.py [--quick] [--repeats N] [--only PART]... [--full] [--tables]

All runs use one thread. The tools take turns, and the whole round is repeated, so that a slow quarter of an hour
of the machine hits all of them; the figures are medians. A run of more than a minute is not repeated. A whole run
writes results/benchmark/phases.csv and doc/benchmarks.md with its plots; with --quick or --only everything goes to
results/benchmark/partial instead. --tables writes the page again from the figures of the last whole run.
Parts: startup scaling peers stiffness reversal precision sweep.
"""
import argparse
import csv
import dataclasses
import json
import platform
import shutil
import statistics
import subprocess
import sys
import time

import calculix
import figures
import fuga_runs
import getfem_run
import meshes
import precision
import scenes
import sweep
import tables
from fuga_runs import WORK
from process import Result

PARTS = ("startup", "scaling", "peers", "stiffness", "reversal", "precision", "sweep")
SLOW = 60.  # CPU seconds beyond which a case is run once
COLUMNS = ("scene", "tool", "variant", "elements", "dofs", "phase", "seconds", "memory_MB", "error", "repeats")


@dataclasses.dataclass
class Case:
    scene: str
    tool: str
    variant: str
    run: callable
    results: list = dataclasses.field(default_factory=list)

    def is_slow(self):
        return any(result.phases["total"] > SLOW for result in self.results)


def startup_cases(options):
    def only_start(seconds):
        return lambda: Result({"total": seconds()}, 0., 0, 0)
    return [Case("none", "fuga", "version", only_start(fuga_runs.start_seconds)),
            Case("none", "calculix", "version", only_start(calculix.start_seconds)),
            Case("none", "getfem", "import", only_start(getfem_run.start_seconds)),
            fuga_case(scenes.scene_g(9, 0.6), "f0.6")]


def fuga_case(scene, variant, fields="never"):
    return Case(scene.name, "fuga", variant + " n=%d" % scene.n, lambda: fuga_runs.run_scene(scene, variant, fields))


def stage_ends(scene):
    """The scene by one certified implicit step per stage: the setting to put beside peers with one increment."""
    return scene.altered(solver={"Follow": "stage ends"})


def scaling_cases(options):
    cases = []
    for n in (9, 17, 33) if options.quick else (9, 17, 33, 65, 129, 257):
        for variant in ("linear", "law9", "rigid", "bonded"):
            cases.append(fuga_case(scenes.s0(n, variant), variant, "end" if variant == "bonded" else "never"))
    for n in sizes_of_scene_g(options):
        cases += [fuga_case(scenes.scene_g(n, f), "f%.1f" % f) for f in (0.2, 0.6)]
    return cases


def sizes_of_scene_g(options):
    return (9, 33) if options.quick else (9, 33, 129, 513)


class References:
    """Jumps at the ends of the stages, made when first wanted; who computed them is noted in `sources`."""

    def __init__(self):
        self.known, self.sources = {}, {}

    def of(self, scene):
        key = "%s n=%d f=%g kn=%r" % (scene.name, scene.n, scene.joint["f"], scene.joint["kn"])
        if key not in self.known:
            self.known[key], self.sources[key] = fuga_runs.reference_of(scene)
        return self.known[key]


REFERENCES = References()


def calculix_case(scene, variant, kind, increments, limit):
    return Case(scene.name, "calculix", "%s %s x%d n=%d" % (variant, kind, increments, scene.n),
                lambda: calculix.run_scene(scene, kind, increments, REFERENCES.of(scene), limit))


def getfem_case(scene, variant, increments, limit):
    rigid = scene.altered(joint={**scene.joint, "kn": None})
    return Case(scene.name, "getfem", "%s x%d n=%d" % (variant, increments, scene.n),
                lambda: getfem_run.run_scene(rigid, increments, REFERENCES.of(rigid), limit))


def peer_cases(options):
    cases = []
    for n in sizes_of_scene_g(options):
        for f in (0.2, 0.6):
            scene, rigid, variant = scenes.scene_g(n, f), scenes.scene_g(n, f, None), "f%.1f" % f
            cases += [fuga_case(scene, variant), fuga_case(rigid, "rigid " + variant)]
            if fuga_runs.knows("stage ends"):
                cases.append(fuga_case(stage_ends(scene), variant + " stage ends"))
            for increments in (10, 1):
                cases += [calculix_case(scene, variant, kind, increments, 600) for kind in ("nts", "sts")]
                cases.append(getfem_case(scene, variant, increments, 600))
    if not options.quick:
        scene = scenes.s0(65)
        cases += [fuga_case(scene, "linear"), fuga_case(scenes.s0(65, "rigid"), "rigid")]
        for increments in (10, 1):
            cases += [calculix_case(scene, "linear", kind, increments, 900) for kind in ("nts", "sts")]
            cases.append(getfem_case(scene, "linear", increments, 900))
    return cases


def stiffness_cases(options):
    cases = []
    for kn in (1e6, 1e8, 1e10, 1e12, None):
        variant = "rigid f0.6" if kn is None else "kn%.0e f0.6" % kn
        for n in (33,) if options.quick else (33, 129):
            cases.append(fuga_case(scenes.scene_g(n, 0.6, kn), variant))
        if kn not in (None, 1e6):
            cases += [calculix_case(scenes.scene_g(33, 0.6, kn), variant, kind, 10, 120) for kind in ("nts", "sts")]
    return cases


def reversal_cases(options):
    cases = []
    for n in (33,) if options.quick else (33, 129):
        scene = scenes.scene_g(n, 0.6, reversal=True)
        cases.append(fuga_case(scene, "f0.6"))
        for increments in (1, 10) if options.quick else (1, 10, 50, 200, 800):
            limit = 3600 if options.full else (900 if n == 33 else 180)
            if increments <= (800 if n == 33 or options.full else 200):
                kinds = ("nts", "sts") if increments <= 50 else ("nts",)
                cases += [calculix_case(scene, "f0.6", kind, increments, limit) for kind in kinds]
    return cases


def precision_cases(options):
    cases = []
    for problem in (make() for make in precision.PROBLEMS):
        if problem.finest:
            result, directory = precision.run(problem, *problem.finest)
            if result.failure:
                raise RuntimeError("%s: the finest run failed: %s" % (problem.name, result.failure))
            problem.prepare(directory)
            REFERENCES.sources[problem.name] = "finest run %s; %s" % ((problem.finest,), problem.domain)
        for level, kind, degree in problem.runs(options.quick):
            def run(problem=problem, level=level, kind=kind, degree=degree):
                result, directory = precision.run(problem, level, kind, degree)
                if not result.failure:
                    result.error = problem.error(directory)
                return result
            cases.append(Case(problem.name, "fuga", "%s Q%d level=%d" % (kind, degree, level), run))
    return cases


def sweep_cases(options):
    if not sweep.available():
        return []
    n = 33 if options.quick else 129
    scene = scenes.scene_g(n, 0.6)
    return [fuga_case(scene, "f0.6")] + [
        Case("scene_g", "fuga", "sweep of %d n=%d" % (count, n), lambda count=count: sweep.run(scene, count))
        for count in sweep.COUNTS]


MAKERS = {"startup": startup_cases, "scaling": scaling_cases, "peers": peer_cases, "stiffness": stiffness_cases,
          "reversal": reversal_cases, "precision": precision_cases, "sweep": sweep_cases}


def measure_all(cases, repeats):
    for number in range(repeats):
        for k, case in enumerate(cases, 1):
            if number and case.is_slow():
                continue
            result = case.run()
            case.results.append(result)
            print("round %d/%d, %d/%d  %s %s %s: %.3f s%s%s" % (
                number + 1, repeats, k, len(cases), case.scene, case.tool, case.variant, result.phases["total"],
                "" if result.error is None else ", error %.1e" % result.error,
                ", " + result.failure if result.failure else ""), flush=True)


def rows_of(case):
    """Medians; of the runs that came to the end, if some did."""
    good = [result for result in case.results if not result.failure] or case.results
    phases = dict.fromkeys(name for result in good for name in result.phases)
    error = "failed" if good[0].failure else ("" if good[0].error is None else "%.3e" % good[0].error)
    variant = case.variant.split(" n=")[0]
    for phase in phases:
        seconds = statistics.median(result.phases.get(phase, 0.) for result in good)
        yield (case.scene, case.tool, variant, good[0].elements, good[0].dofs, phase, "%.6f" % seconds,
               "%.1f" % statistics.median(result.memory_MB for result in good), error, len(case.results))


def notes_of(case):
    """What the CSV has no column for."""
    last = case.results[-1]
    failures = [result.failure for result in case.results if result.failure]
    return {"failures": failures, **last.info}


def machine():
    cpu = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "?")
    packages = ["calculix-ccx", "python3-getfem++", "libdeal.ii-dev", "libmumps-dev", "libopenblas0-pthread"]
    query = ["dpkg-query", "-W", "-f=${Package} ${Version}, ", *packages]
    versions = subprocess.run(query, capture_output=True, text=True)
    commit = subprocess.run(["git", "-C", str(meshes.REPOSITORY), "describe", "--always", "--dirty"],
                            capture_output=True, text=True).stdout.strip()
    return {"cpu": cpu, "cores": len(open("/proc/cpuinfo").read().split("processor\t")) - 1,
            "system": platform.platform(), "versions": versions.stdout.rstrip(", "), "commit": commit,
            "date": time.strftime("%Y-%m-%d"), "load": open("/proc/loadavg").read().split()[0]}


def save(directory, cases, facts):
    directory.mkdir(parents=True, exist_ok=True)
    with open(directory / "phases.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for case in cases:
            writer.writerows(rows_of(case))
    notes = {"%s|%s|%s" % (case.scene, case.tool, case.variant): notes_of(case) for case in cases}
    (directory / "notes.json").write_text(json.dumps({"machine": facts, "references": REFERENCES.sources,
                                                      "cases": notes}, indent=1) + "\n")


def write_page(directory, page_directory):
    import plots  # here, so that matplotlib does not load while measuring
    measured = figures.Figures(directory)
    names = plots.write(measured, page_directory)
    (page_directory / "benchmarks.md").write_text(tables.page(measured, names))
    for name in ("phases.csv", "notes.json"):  # the figures travel with the page
        shutil.copy(directory / name, page_directory / ("benchmark_" + name))
    print("Written: %s" % (page_directory / "benchmarks.md"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="small scenes, one round: does everything still run?")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--only", action="append", choices=PARTS)
    parser.add_argument("--full", action="store_true", help="also the longest runs of the peers (hours)")
    parser.add_argument("--tables", action="store_true", help="measure nothing, write the page again")
    options = parser.parse_args()
    whole = not options.quick and not options.only
    directory = WORK if whole else WORK / "partial"
    page_directory = meshes.REPOSITORY / "doc" if whole else directory
    if not options.tables:
        shutil.rmtree(WORK / "meshes", ignore_errors=True)  # of an older generator, perhaps
        facts = {**machine(), "repeats": 1 if options.quick else options.repeats, "command": " ".join(sys.argv[1:])}
        begin, cases = time.time(), {}
        for part in options.only or PARTS:
            for case in MAKERS[part](options):
                cases.setdefault((case.scene, case.tool, case.variant), case)
        cases = list(cases.values())
        try:
            measure_all(cases, facts["repeats"])
        finally:  # also after an interruption: what was measured is kept
            facts["minutes"] = round((time.time() - begin) / 60., 1)
            save(directory, [case for case in cases if case.results], facts)
    write_page(directory, page_directory)


if __name__ == "__main__":
    main()
