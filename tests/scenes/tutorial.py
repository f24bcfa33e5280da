#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""doc/tutorial.md as a newcomer would follow it: writes its files, types its commands in an empty home folder, and
compares what it prints with what comes; its table with the results; its arithmetic with arithmetic.

usage: tutorial.py FUGA
"""
import csv
import json
import math
import pathlib
import re
import sys
import tempfile

from typed_page import BLOCK, ROOT, Shell, check, follow, unit

FUGA = pathlib.Path(sys.argv[1]).resolve()
TEXT = (ROOT / "doc/tutorial.md").read_text(encoding="utf-8")


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{key.split("[")[0]: cell for key, cell in row.items()} for row in csv.DictReader(file)]


def plain(text):
    for sign, meaning in (("−", "-"), ("·", "*"), ("½", "0.5"), ("²", "**2")):
        text = text.replace(sign, meaning)
    return text


def check_arithmetic(text):
    """All 'terms = number' of the text, to the digits printed."""
    sums = re.findall(r"([-+*/(). \d]*\d[-+*/(). \d]*[-+*/][-+*/(). \d]*) = (-?\d+(?:\.\d+)?)", plain(text))
    for terms, result in sums:
        value = eval(terms.strip(), {"__builtins__": {}})  # digits and operators only
        check(abs(value - float(result)) <= (unit(result) or 1e-9), f"{terms} = {value}, not {result}")
    check(len(sums) >= 14, f"only {len(sums)} sums found")


def check_table(text, folder):
    """The third column of the table in section 6."""
    rows = rows_of(folder / "results/dam/resultants.csv")
    values = re.findall(r"(\w+) = (-?\d+(?:\.\d+)?)( at t = 1)? \|$", plain(text), re.M)
    for name, printed, at_one in values:
        value = float(rows[0 if at_one else -1][name])
        check(abs(value - float(printed)) <= max(unit(printed), 1e-9 * abs(value)), f"{name} is {value}, not {printed}")
    check(len(values) >= 8 and float(rows[0]["t"]) == 1.0, f"only {len(values)} values found")


def excess(level):
    """Moment beyond that of a resultant at the end of the middle third, of the closed base."""
    h, water = level, 5 * level**2
    n = 3840 + 0.1 * water - 65 * h
    return -4560 + water * h / 3 - 0.1 * water * (6.5 - h / 30) + 65 * h * (6.5 - 13 / 3) - n * 13 / 6


def check_levels(text, folder):
    """The levels that the text names: first slip, first opening, opening on the way to the crest, rigid base."""
    def level(run, state, height):
        first = next(row for row in rows_of(folder / "results" / run / "events.csv") if row["to"] == state)
        return height * float(first["stage_fraction"])
    low, high = 10.0, 20.0
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    crest = level("crest", "open", 20)
    named = [level("dam", "slip", 18), level("dam", "open", 18), crest, low]
    for value in named:
        check(f"{value:.2f} m" in text, f"the text does not name the level {value:.4f} m")
    without_crack = rows_of(folder / "results/crest/resultants.csv")[-1]
    thrust = float(without_crack["T"])
    h = math.sqrt(thrust / 5)
    safety = 0.75 * (3840 + 0.1 * thrust - 65 * h) / thrust
    check(f"from {safety:.2f} to 1" in text.replace("\n", " "), f"sliding safety without crack {safety}")


def limit_of_beam_theory(from_tip):
    """Level and crack at which a no-tension base slides: a straight pressure diagram over three times the distance of
    the resultant from the toe, and full pressure in the crack over the rest."""
    def base(h):
        head, crack = 10 * h, 0.0
        for _ in range(5000):
            closed = 13 - crack
            end = head if from_tip else head * closed / 13  # of the pressure at the tip, in the closed part
            uplift = head * crack + end * closed / 2
            about_heel = head * crack**2 / 2 + end * closed / 2 * (crack + closed / 3)
            force = 3840 + 0.5 * h**2 - uplift
            moment = 24 * (20 * 4 / 3 + 60 * 3.5 + 80 * 23 / 3) + 0.5 * h**2 * h / 30 + 5 * h**3 / 3 - about_heel
            if moment / force >= 13:
                return None
            crack, last = max(0.0, 13 - 3 * (13 - moment / force)), crack
            if abs(crack - last) < 1e-12:
                break
        return force, crack
    low, high = 10.0, 20.0
    while high - low > 1e-9:
        middle = 0.5 * (low + high)
        state = base(middle)
        low, high = (middle, high) if state and 0.75 * state[0] > 5 * middle**2 else (low, middle)
    return low, base(low)[1]


def check_rules(text, shell):
    """The table of both rules of uplift against beam theory, and the lengths of the cracks."""
    rows = re.findall(r"^\| .*\| (\d+\.\d\d) m \| (\d+\.\d\d) m \|$", text, re.M)
    check(len(rows) == 2, f"{len(rows)} rows of rules")
    level = '"Loads/{}/Level=1: 0; 2: 20"'
    shell.run(f"fuga dam.prm --quiet --output-dir results/joint --set {level.format('water')} "
              f"--set {level.format('uplift')} --set \"Loads/uplift/Profile from=joint\" || true")
    for (beam, program), run, from_tip in zip(rows, ("crest", "joint"), (True, False)):
        expected, crack = limit_of_beam_theory(from_tip)
        check(f"{expected:.2f}" == beam, f"beam theory slides at {expected}, not {beam}")
        summary = json.loads((shell.folder / "results" / run / "summary.json").read_text(encoding="utf-8"))
        slides = 20 * (summary["limit_load"]["t"] - 1)
        check(f"{slides:.2f}" == program, f"the program slides at {slides}, not {program}")
        if from_tip:
            own = float(rows_of(shell.folder / "results" / run / "resultants.csv")[-1]["cracked_length"])
            check(f"({own:.2f} m at its limit, against {crack:.2f} m)" in text, f"cracks {own}, {crack}")


def check_earthquake(text, folder):
    """The slip that remains, and that the safety is that of before."""
    slip = 1000 * float(rows_of(folder / "results/quake/earthquake.csv")[-1]["mean_slip"])
    check(f"slid by {slip:.0f} mm" in text, f"the dam has slid by {slip} mm")
    before, after = (rows_of(folder / "results" / run / "resultants.csv")[-1] for run in ("dam", "quake"))
    safety = [float(row["sliding_safety"]) for row in (before, after)]
    check(abs(safety[1] / safety[0] - 1) < 0.02, f"sliding safety {safety[0]} before, {safety[1]} after the earthquake")


def main():
    words = BLOCK.sub("", TEXT)
    check_arithmetic(words)
    with tempfile.TemporaryDirectory() as folder:
        shell = Shell(pathlib.Path(folder), FUGA, "mydam")
        written = follow(TEXT, shell)
        check(written == {"dam.geo", "dam.prm", "look.py", "shake.prm"}, f"files of the tutorial: {written}")
        if not check.complaints:
            check_table(words, shell.folder)
            check_levels(words, shell.folder)
            check_rules(words, shell)
            check_earthquake(words, shell.folder)
            for file in ("tutorial.png", "results/dam/report.html", "results/dam/results.png"):
                check((shell.folder / file).stat().st_size > 10000, f"{file} is empty")
    sys.exit(check.exit_code())


main()
