#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Runs the paper's test (problem S0) for every compliance and law and writes doc/paper_trends.md.

usage: paper_trends.py [--fuga PROGRAM] [--directory DIR] [--output FILE]

DIR keeps the results of the runs (default: a temporary directory). Takes about a minute.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# The reader of results is installed with the program.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "source/python"))

from fuga_results import Results
from paper_quantities import PaperQuantities, law_9_stiffening, percent
from remarks import remarks

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
COMMAND = "/usr/bin/python3 tools/paper_trends.py"
THICKNESS = 0.002  # m
AS_PRINTED, READING = "1.25e-7", "1.25e-4"  # m/MPa: the printed number as m^3/MN and as m^3/kN
SOFTER = "1.25e-3"
FINE = 4  # refinements: 129 contact elements instead of nine
COARSE = 0
DONE, NUMERICAL_FAILURE, CERTIFICATE_ABOVE_BOUND = 0, 2, 4  # exit codes
REPORTED_GROWTH = 1.2  # of the horizontal relative displacement, as the paper states it

RIGID, LINEAR, LAW_9 = "paper_1_rigid", "paper_2_linear", "paper_3_cubic_root"
ROWS = [("rigid", RIGID, None)]
ROWS += [(f"linear, \u03c1 = {rho}", LINEAR, rho) for rho in (AS_PRINTED, READING, SOFTER)]
ROWS += [(f"law (9), \u03c10 = {rho}", LAW_9, rho) for rho in (AS_PRINTED, READING, SOFTER)]


class Runner:
    """Runs the program with overrides; one result directory per run."""

    def __init__(self, program, directory):
        self.program, self.directory, self.count = program, directory, 0

    def run(self, variant, rho, refinements=COARSE, overrides=()):
        """Exit code and result directory."""
        self.count += 1
        target = os.path.join(self.directory, f"{self.count:03d}_{variant}")
        sets = [f"Mesh/Refinements={refinements}", "Output/Fields=never", *overrides]
        if rho is not None:
            sets += [f"Joints/base/Normal compliance={rho}", f"Joints/base/Shear compliance={rho}"]
        command = [self.program, os.path.join(TOP, "parameters", variant + ".prm"), "--quiet", "--output-dir", target]
        for entry in sets:
            command += ["--set", entry]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode == 1 or not os.path.exists(os.path.join(target, "summary.json")):
            sys.exit(f"{' '.join(command)}\n{done.stderr}")
        return done.returncode, target

    def quantities(self, variant, rho, refinements=COARSE):
        code, target = self.run(variant, rho, refinements)
        if code not in (DONE, CERTIFICATE_ABOVE_BOUND):
            sys.exit(f"The run in {target} ended with exit code {code}.")
        quantities = PaperQuantities(Results(target))
        if code == CERTIFICATE_ABOVE_BOUND:
            print(f"Warning: certificate {quantities.certificate:.1e} of {target} is above its bound.")
        return quantities


def table(rows):
    lines = ["| joint, compliance [m/MPa] | open/stick/slip | zone of opening m | p_max MPa | largest gap mm "
             "| largest closure mm | largest jump mm | mean jump added by stage 2, mm | certificate |",
             "|---|---|---|---|---|---|---|---|---|"]
    for name, q in rows:
        lines.append(f"| {name} | {'/'.join(map(str, q.counts))} | {q.open_length:.3f} "
                     f"| {q.largest_pressure:.4f} | {q.largest_gap:.4f} | {q.largest_closure:.4f} "
                     f"| {q.largest_jump:.4f} | {q.mean_jump_added:.4f} | {q.certificate:.0e} |")
    return "\n".join(lines)


def compliance_of_growth(runner, growth, reference):
    """The linear compliance at which the largest jump is `growth` times that of the rigid joint."""
    low, high = float(AS_PRINTED), float(SOFTER)
    while high / low > 1.01:
        middle = (low * high) ** 0.5
        jump = runner.quantities(LINEAR, repr(middle)).largest_jump
        low, high = (middle, high) if jump < growth * reference else (low, middle)
    return (low * high) ** 0.5


def paper_iteration(runner):
    """How the paper's own iteration with a constant matrix fares on law (9)."""
    lines = ["| \u03c10 [m/MPa] | largest closure / \u03b60 | Newton: iterations in solutions (most in one) | constant "
             "stiffness, iteration (3), (7), (8) |", "|---|---|---|---|"]
    for rho in (AS_PRINTED, READING, SOFTER):
        _, newton = runner.run(LAW_9, rho)
        code, constant = runner.run(LAW_9, rho, overrides=("Solver/Iteration=constant stiffness",))
        results, other = Results(newton), Results(constant)
        work = results.summary["iterations"]
        closure = PaperQuantities(results).largest_closure / (1e3 * THICKNESS)
        if code == NUMERICAL_FAILURE:
            fate = "diverges at load time " + re.search(r"after load time ([0-9.]+)", other.summary["message"])[1]
        else:
            mine = other.summary["iterations"]
            fate = f"{mine['iterations']} in {mine['solutions']} ({mine['largest_in_one_solution']}); " \
                   f"pressures differ from Newton's by {largest_difference(results, other):.0e} MPa at most"
        lines.append(f"| {rho} | {closure:.4f} | {work['iterations']} in {work['solutions']} "
                     f"({work['largest_in_one_solution']}) | {fate} |")
    return "\n".join(lines)


def largest_difference(one, other):
    return max(abs(a - b) for a, b in zip(one.profile()["pressure"], other.profile()["pressure"]))


def trends(coarse, fine, growth_compliance):
    """(what the paper reports, what we find) with the numbers of the runs."""
    def pair(name, rho):
        return coarse[name, rho], fine[name, rho]
    rigid, printed, linear, law = (pair(RIGID, None), pair(LINEAR, AS_PRINTED), pair(LINEAR, READING),
                                   pair(LAW_9, READING))
    stiffer = [law_9_stiffening(p, float(READING), THICKNESS) for p in (0.5, 2.0)]
    in_run = law[0].stiffening(float(READING))
    return [
        ("The zone of opening is longest for the rigid joint; with compliance it shrinks a little.",
         f"Nine elements: {rigid[0].open_length:.2f}, {linear[0].open_length:.2f}, "
         f"{law[0].open_length:.2f} m for variants 1, 2, 3. 129 elements: {rigid[1].open_length:.3f}, "
         f"{linear[1].open_length:.3f} ({percent(linear[1].open_length, rigid[1].open_length)}), "
         f"{law[1].open_length:.3f} m ({percent(law[1].open_length, rigid[1].open_length)}). "
         f"As printed: {printed[1].open_length:.3f} m ({percent(printed[1].open_length, rigid[1].open_length)})."),
        ("The horizontal relative displacement of the lips grows by 20 %.",
         f"Largest jump, nine elements: {rigid[0].largest_jump:.4f} \u2192 {linear[0].largest_jump:.4f} mm "
         f"({percent(linear[0].largest_jump, rigid[0].largest_jump)}). As printed: "
         f"{printed[0].largest_jump:.4f} mm ({percent(printed[0].largest_jump, rigid[0].largest_jump)}). "
         f"+20 % belongs to \u03c1 = {growth_compliance:.2g} m/MPa, "
         f"{growth_compliance / float(READING):.2f} times the m\u00b3/kN reading and "
         f"{growth_compliance / float(AS_PRINTED):.0f} times the printed value."),
        ("The contact stresses are slightly lower than with the rigid joint.",
         f"Largest pressure, nine elements: {rigid[0].largest_pressure:.4f} \u2192 {linear[0].largest_pressure:.4f} MPa "
         f"({percent(linear[0].largest_pressure, rigid[0].largest_pressure)}), law (9) {law[0].largest_pressure:.4f} MPa "
         f"({percent(law[0].largest_pressure, rigid[0].largest_pressure)}). As printed: "
         f"{printed[0].largest_pressure:.4f} MPa ({percent(printed[0].largest_pressure, rigid[0].largest_pressure)})."),
        ("Law (9) redistributes the closure of the layer.",
         f"Largest closure {linear[0].largest_closure:.4f} \u2192 {law[0].largest_closure:.4f} mm "
         f"({percent(law[0].largest_closure, linear[0].largest_closure)}) against variant 2; largest over mean "
         f"closure {linear[0].closure_unevenness:.2f} \u2192 {law[0].closure_unevenness:.2f}. The bars are "
         f"{in_run[0]:.2f} to {in_run[1]:.2f} times stiffer in this run; law (9) itself says {stiffer[0]:.2f} at "
         f"0.5 MPa and {stiffer[1]:.2f} at 2 MPa."),
        ("Variants 1 and 2 agree with iterative solutions of the same discrete problem.",
         f"Certificates of both runs: {rigid[0].certificate:.0e} and {linear[0].certificate:.0e} on nine elements. "
         "Other solutions of these runs: `tests/scenes/judge_test.cc`, and S0 in [verification](verification.md)."),
        ("Compliance also regularises the contact problem with friction.",
         "Not a number of these runs: [theory](theory.md), section 4.")]


TEXT = """<!-- Generated by `{command}`. Do not edit: run it again. -->
# The trends of the paper, with our numbers

This page is written by `{command}`,
which runs the program for every row below.

The paper gives neither geometry nor loads of its test. The stand-in is problem S0: a structure 4 m wide and
12 m high (E = 3060 MPa) on a foundation (E = 30600 MPa), pressed by its weight (0.024 MN/m\u00b3) and then pushed by
0.0144 MPa on its left face; f = 0.2, \u03b60 = 2 mm, nine contact elements (`parameters/paper_*.prm`). The numbers
are therefore not those of the paper; the trends must be.

The compliance is run as it is printed, 1.25\u00b710\u207b\u2077 m\u00b3/MN, and read as m\u00b3/kN, 1.25\u00b710\u207b\u2074 m/MPa.

## Nine contact elements, as in the paper

{coarse}

Largest jump: largest tangential jump of an element at the end. Mean jump added: mean over the elements of the
growth of the tangential jump in stage 2. Certificate: the worst entry of the run, bound 1e-9.

## 129 contact elements (`Mesh/Refinements = {refinements}`)

{fine}

## Trends

| the paper reports | fuga finds |
|---|---|
{trends}

## The paper's iteration on law (9)

Nine elements. `Solver/Iteration = constant stiffness` is the iteration (3), (7), (8) of the paper with A/\u03c10 kept in
the matrix.

{iteration}

{remarks}"""


def main(arguments):
    parser = argparse.ArgumentParser(description="Writes doc/paper_trends.md.")
    parser.add_argument("--fuga", default=os.path.join(TOP, "build", "release", "fuga"))
    parser.add_argument("--directory")
    parser.add_argument("--output", default=os.path.join(TOP, "doc", "paper_trends.md"))
    options = parser.parse_args(arguments)

    with tempfile.TemporaryDirectory() as temporary:
        runner = Runner(options.fuga, options.directory or temporary)
        coarse = {(variant, rho): runner.quantities(variant, rho) for _, variant, rho in ROWS}
        fine = {(variant, rho): runner.quantities(variant, rho, FINE) for _, variant, rho in ROWS}
        growth = compliance_of_growth(runner, REPORTED_GROWTH, coarse[RIGID, None].largest_jump)
        text = TEXT.format(
            command=COMMAND, refinements=FINE,
            coarse=table([(name, coarse[variant, rho]) for name, variant, rho in ROWS]),
            fine=table([(name, fine[variant, rho]) for name, variant, rho in ROWS]),
            trends="\n".join(f"| {said} | {found} |" for said, found in trends(coarse, fine, growth)),
            iteration=paper_iteration(runner), remarks=remarks("paper_trends"))
    with open(options.output, "w", encoding="utf-8") as file:
        file.write(text)
    print(options.output)


if __name__ == "__main__":
    main(sys.argv[1:])
