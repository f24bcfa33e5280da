#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Run time, memory and error of fuga and of its peers on the same scenes, in one go.

usage: benchmark.py [--quick] [--repeats N] [--only PART]... [--full] [--tables]

The tools take turns in every part, round after round (rounds.py); the figures are medians. What has taken 10 s, or
twice the same time, is not repeated. A whole run writes results/benchmark/phases.csv and doc/benchmarks.md with its
plots; with --quick or --only everything goes to results/benchmark/partial instead. --tables writes the page again from
the figures of the last whole run.
"""
import argparse
import csv
import json
import platform
import shutil
import subprocess
import sys
import time

import meshes
from fuga_runs import WORK, commit
from page import figures, tables
from parts import MAKERS, REFERENCES, all_cases
from process import processor
from rounds import expect, measure_all

COLUMNS = ("scene", "tool", "variant", "elements", "dofs", "phase", "seconds", "memory_MB", "error", "repeats")


def machine():
    packages = ["calculix-ccx", "python3-getfem++", "libdeal.ii-dev", "libmumps-dev", "libopenblas0-pthread"]
    query = ["dpkg-query", "-W", "-f=${Package} ${Version}, ", *packages]
    versions = subprocess.run(query, capture_output=True, text=True)
    return {"cpu": processor(), "cores": len(open("/proc/cpuinfo").read().split("processor\t")) - 1,
            "system": platform.platform(), "versions": versions.stdout.rstrip(", "), "commit": commit(),
            "date": time.strftime("%Y-%m-%d"), "load": open("/proc/loadavg").read().split()[0]}


def save(directory, cases, facts):
    directory.mkdir(parents=True, exist_ok=True)
    with open(directory / "phases.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for case in cases:
            writer.writerows(case.rows())
    notes = {"|".join(case.key): case.notes() for case in cases}
    (directory / "notes.json").write_text(json.dumps({"machine": facts, "references": REFERENCES.sources,
                                                      "cases": notes}, indent=1) + "\n")


def write_page(directory, page_directory):
    from page import plots  # here, so that matplotlib does not load while measuring
    measured = figures.Figures(directory)
    names = plots.write(measured, page_directory)
    (page_directory / "benchmarks.md").write_text(tables.page(measured, names))
    for name in ("phases.csv", "notes.json"):  # the figures travel with the page
        shutil.copy(directory / name, page_directory / ("benchmark_" + name))
    print("Written: %s" % (page_directory / "benchmarks.md"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="small scenes, one round: does everything still run?")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--only", action="append", choices=tuple(MAKERS))
    parser.add_argument("--full", action="store_true", help="also the longest runs of the peers (hours)")
    parser.add_argument("--tables", action="store_true", help="measure nothing, write the page again")
    options = parser.parse_args()
    whole = not options.quick and not options.only
    directory = WORK if whole else WORK / "partial"
    page_directory = meshes.REPOSITORY / "doc" if whole else directory
    if not options.tables:
        shutil.rmtree(WORK / "meshes", ignore_errors=True)  # of an older generator, perhaps
        facts = {**machine(), "repeats": 1 if options.quick else options.repeats, "command": " ".join(sys.argv[1:])}
        begin, cases = time.time(), all_cases(options.only or MAKERS, options)
        expect(cases, meshes.REPOSITORY / "doc" / "benchmark_phases.csv")
        try:
            measure_all(cases, facts["repeats"])
        finally:  # also after an interruption: what was measured is kept
            facts["minutes"] = round((time.time() - begin) / 60., 1)
            save(directory, [case for case in cases if case.results], facts)
    write_page(directory, page_directory)


if __name__ == "__main__":
    main()
