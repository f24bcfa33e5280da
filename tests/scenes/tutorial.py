#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""doc/tutorial.md as a newcomer would follow it: writes its files, types its commands in an empty home folder, and
compares what it prints with what comes; its table with the results; its arithmetic with arithmetic.

usage: tutorial.py FUGA
"""
import csv
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FUGA = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
TEXT = (ROOT / "doc/tutorial.md").read_text(encoding="utf-8")
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
ROUNDING = 1e-9  # certificates, as in their bound: they differ from machine to machine
complaints = []
n_checks = 0


def check(condition, text):
    global n_checks
    n_checks += 1
    if not condition:
        complaints.append(text)


def unit(text):
    """One in the last digit of a printed number; an integer is meant exactly."""
    mantissa, _, exponent = text.partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 1.01 * 10.0**(int(exponent or 0) - decimals) if decimals else 0.0


def same_line(printed, line):
    """The words are equal, and the numbers to the digits printed; time, memory and rounding may differ."""
    def words(text):
        return re.sub(r"\s+", " ", NUMBER.sub("#", re.sub(r"\(.*\)", "", text) if text.startswith("Certificate") else text)).strip()
    if words(printed) != words(line):
        return False
    return printed.startswith("Time") or all(
        abs(float(a) - float(b)) <= unit(a) or max(abs(float(a)), abs(float(b))) < ROUNDING
        for a, b in zip(NUMBER.findall(printed), NUMBER.findall(line)))


def compare(printed, output):
    """The lines printed are among those of the output, in this order; '...' stands for any."""
    lines, missing = output.splitlines(), []
    for text in printed.splitlines():
        if text != "...":
            place = next((i for i, line in enumerate(lines) if same_line(text, line)), None)
            if place is None:
                missing.append(text)
            else:
                lines = lines[place + 1:]
    check(not missing, "not, or not in this order, printed: " + "\n".join(missing) + "\n--- but\n" + output)


class Shell:
    """One shell after another, each in the folder and with the variables of the last one."""

    def __init__(self, folder):
        self.state = folder / "state"
        home, programs = folder / "home", folder / "programs"
        home.mkdir()
        programs.mkdir()
        (programs / "fuga").symlink_to(FUGA)
        (home / "fuga").symlink_to(ROOT)
        self.state.write_text(f"cd {home}\nexport HOME={home} PATH={programs}:$PATH\n", encoding="utf-8")
        self.folder = home / "mydam"

    def run(self, commands):
        script = f". {self.state}\n{commands}\ncode=$?\n{{ export -p; echo \"cd '$PWD'\"; }} >{self.state}\nexit $code\n"
        run = subprocess.run(["sh", "-c", script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONDONTWRITEBYTECODE": "1"}, check=False)
        check(run.returncode == 0, f"exit code {run.returncode} of\n{commands}{run.stdout}")
        return run.stdout


def follow(shell):
    """Every block is a file (named at the end of the line above), commands, or what the last commands print."""
    output, written = "", set()
    for block in BLOCK.finditer(TEXT):
        kind, content = block.groups()
        if kind == "sh":
            output = shell.run(content)
        elif kind == "text":
            compare(content, output)
        else:
            name = re.search(r"`([\w.]+)`(?:, continued)?:\n\n$", TEXT[:block.start()]).group(1)
            with open(shell.folder / name, "a" if name in written else "x", encoding="utf-8") as file:
                file.write(content)
            written.add(name)
    check(written == {"dam.geo", "dam.prm", "look.py"}, f"files of the tutorial: {written}")


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


def main():
    words = BLOCK.sub("", TEXT)
    check_arithmetic(words)
    with tempfile.TemporaryDirectory() as folder:
        shell = Shell(pathlib.Path(folder))
        follow(shell)
        if not complaints:
            check_table(words, shell.folder)
            check_levels(words, shell.folder)
            for file in ("tutorial.png", "results/dam/report.html", "results/dam/results.png"):
                check((shell.folder / file).stat().st_size > 10000, f"{file} is empty")
    print("\n".join(complaints) or f"{n_checks} checks")
    sys.exit(1 if complaints else 0)


main()
