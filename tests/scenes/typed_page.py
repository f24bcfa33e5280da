#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""A page as a newcomer would follow it: its files are written, its commands typed in an empty home folder, and what it prints
is compared with what comes. Used by tutorial.py and first_models.py.
"""
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
ROUNDING = 1e-9  # certificates, as in their bound: they differ from machine to machine


class Checks:
    """Counts what was compared and keeps what differs."""

    def __init__(self):
        self.complaints, self.number = [], 0

    def __call__(self, condition, text):
        self.number += 1
        if not condition:
            self.complaints.append(text)

    def exit_code(self):
        print("\n".join(self.complaints) or f"{self.number} checks")
        return 1 if self.complaints else 0


check = Checks()


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
        if text.strip() != "...":
            place = next((i for i, line in enumerate(lines) if same_line(text, line)), None)
            if place is None:
                missing.append(text)
            else:
                lines = lines[place + 1:]
    check(not missing, "not, or not in this order, printed: " + "\n".join(missing) + "\n--- but\n" + output)


class Shell:
    """One shell after another, each in the folder and with the variables of the last one."""

    def __init__(self, folder, program, models):
        self.state = folder / "state"
        home, programs = folder / "home", folder / "programs"
        home.mkdir()
        programs.mkdir()
        (programs / "fuga").symlink_to(program)
        (home / "fuga").symlink_to(ROOT)
        self.state.write_text(f"cd {home}\nexport HOME={home} PATH={programs}:$PATH\n", encoding="utf-8")
        self.folder = home / models

    def run(self, commands):
        script = f". {self.state}\n{commands}\ncode=$?\n{{ export -p; echo \"cd '$PWD'\"; }} >{self.state}\nexit $code\n"
        run = subprocess.run(["sh", "-c", script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "PYTHONDONTWRITEBYTECODE": "1"}, check=False)
        check(run.returncode == 0, f"exit code {run.returncode} of\n{commands}{run.stdout}")
        return run.stdout


def follow(text, shell):
    """Every block is a file (named at the end of the line above), commands, or what the last commands print. Returns the files."""
    output, written = "", set()
    for block in BLOCK.finditer(text):
        kind, content = block.groups()
        if kind == "sh":
            output = shell.run(content)
        elif kind == "text":
            compare(content, output)
        else:
            name = re.search(r"`([\w.]+)`(?:, continued)?:\n\n$", text[:block.start()]).group(1)
            with open(shell.folder / name, "a" if name in written else "x", encoding="utf-8") as file:
                file.write(content)
            written.add(name)
    return written
