#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What drives a stage stands beside the load time in tables, log and summary: the weight's factor, the level of the reservoir, the
factor of a strength reduction, in a run and in a sweep of the dam in parameters/.

Expected: the histories of dam.prm by hand (weight t; level 28 (t - 1)); at the end of the strength reduction the dam slides as a
whole, so that F = f |N| / T with T = 9.81 28² / 2 of the water. Tolerance: rounding, 1e-9, as all is statics.

usage: drive.py FUGA
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

FUGA = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "source/python"))
from fuga_results import Results  # noqa: E402
from report.text.words import describe  # noqa: E402

FRICTION, LEVEL = 0.7, 28.0
SHEAR = 9.81 * LEVEL ** 2 / 2
ROUNDING = 1e-9
TABLES = ("events", "joint_history", "resultants")
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def close(value, expected, text):
    check(abs(float(value) - expected) <= ROUNDING * max(1.0, abs(expected)), f"{text}: {value} instead of {expected}")


def run(folder, *settings):
    words = [word for setting in (*settings, "Output/Fields=never") for word in ("--set", setting)]
    done = subprocess.run([FUGA, ROOT / "parameters/dam.prm", "--output-dir", folder, *words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"exit code {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{name.split("[")[0]: value for name, value in row.items()} for row in csv.DictReader(file)]


def check_row(row, name):
    t = float(row["t"])
    if row.get("stage", "") == "strength reduction" or t > 2.0:
        check(row["driven_by"] == "F", f"{name} at t = {t}: driven by {row['driven_by']}")
        # 1/F falls linearly to that of the largest factor, 10.
        close(1.0 / float(row["drive"]), 1.0 - 0.9 * (t - 2.0), f"{name} at t = {t}, 1/F")
    elif t > 1.0:
        check(row["driven_by"] == "level of water", f"{name} at t = {t}: driven by {row['driven_by']}")
        close(row["drive"], LEVEL * (t - 1.0), f"{name} at t = {t}, level")
    elif t < 1.0 or row.get("stage") != "reservoir":
        check(row["driven_by"] == "factor of weight", f"{name} at t = {t}: driven by {row['driven_by']}")
        close(row["drive"], t, f"{name} at t = {t}, factor")


def check_safety(folder):
    screen = run(folder, "Safety/Strength reduction=yes", "Safety/Largest factor=10")
    for name in TABLES:
        for row in rows(folder / f"{name}.csv"):
            check_row(row, name)
    last = rows(folder / "resultants.csv")[-1]
    safety = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["safety"]["strength_reduction"]
    close(last["drive"], safety["factor"], "F of the last state and of the summary")
    check(math.isclose(safety["factor"], FRICTION * abs(float(last["N"])) / SHEAR, rel_tol=ROUNDING), f"F by hand: {safety['factor']}")
    check(safety["motion"].startswith("slides on 'base'"), f"motion {safety['motion']}")
    check(safety["motion"] in screen, "the motion in the log")
    check(f"F = {safety['factor']:.6g}" in screen, "F in the log")
    check("level of water = 28 " in screen, "the level in the log")
    results = Results(folder)
    check(results.describe_time(float(last["t"])) == f"F = {safety['factor']:.4g}", "F in the words of the scripts")
    check(describe(results, 1.5) == "50 % of 'reservoir', level of water 14.00 m", f"words of the report: {describe(results, 1.5)}")
    check(describe(results, 1.0) == "end of 'weight'", f"words of the report: {describe(results, 1.0)}")
    check(describe(results, float(last["t"])) == f"F = {safety['factor']:.3f}", "F in the words of the report")
    check(results.describe_state(1.5) == "50 % of stage 'reservoir', level of water = 14", f"words: {results.describe_state(1.5)}")


def check_sweep(folder):
    """Twice the level: the dam slides on the way, at the level that the table and the log say."""
    levels = [f"Loads/{load}/Level=1: 0; 2: {2 * LEVEL}" for load in ("water", "uplift")]
    run(folder, *levels, "Sweep/Cohesion=0, 10")
    table = rows(folder / "sweep.csv")
    log = (folder / "log.txt").read_text(encoding="utf-8")
    check(len(table) == 2, f"{len(table)} variants")
    for row in table:
        check(row["verdict"] == "limit load" and row["motion"].startswith("slides on 'base'"), f"{row['verdict']}, {row['motion']}")
        check(row["driven_by"] == "level of water", f"sweep driven by {row['driven_by']}")
        level = 2 * LEVEL * (float(row["t"]) - 1.0)
        close(row["drive"], level, "level at the limit")
        # Loads are interpolated between 28 knots, 2 m apart: a parabola lies below its chord by a (2 - a).
        above = level % 2.0
        close(abs(float(row["base T"])), 9.81 * (level ** 2 + above * (2.0 - above)) / 2, "shear at the limit by hand")
        check(f"level of water = {level:.6g}" in log, "the level in the log of the sweep")


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_safety(pathlib.Path(folder) / "safety")
        check_sweep(pathlib.Path(folder) / "sweep")
    print("\n".join(complaints[:20]) or "what drives the stages stands everywhere")
    sys.exit(1 if complaints else 0)


main()
