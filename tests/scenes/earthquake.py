#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""A dam under an earthquake (parameters/dam_earthquake.prm): against Newmark's block, and against itself with other steps.

* With a dam and a joint that are nearly rigid it slides as Newmark's block (N. M. Newmark, Effects of earthquakes on dams and
  embankments, Geotechnique 15, 1965), which is integrated here with steps of its own: M a = shaking + thrust - friction while
  it slides, one way or back. M is that of the dam and of the water that moves with it, 7/12 (unit weight/g) H^2 in closed
  form; N and T are those of the statics before.
* Half the step changes the slip that remains by less than a hundredth; the ledger of energies closes.
* Levels of resultants.csv have the energy of the bodies that the step has which ends there.
* Afterwards the slip is what the last step of the earthquake left.

usage: earthquake.py FUGA
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

FUGA = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[2]
GRAVITY, LEVEL, UNIT_WEIGHT, FRICTION, WEIGHT = 9.81, 24., 9.81, 0.7, 7920.


def run(folder, *settings):
    """earthquake.csv, resultants.csv and summary.json of a run."""
    words = [word for setting in ("Output/Fields=never", *settings) for word in ("--set", setting)]
    done = subprocess.run([FUGA, ROOT / "parameters/dam_earthquake.prm", "--quiet", "--output-dir", folder, *words],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{settings}: exit code {done.returncode}: {done.stdout[-500:]}{done.stderr[-500:]}")
    tables = []
    for name in ("earthquake.csv", "resultants.csv"):
        with open(folder / name, newline="", encoding="utf-8") as file:
            tables.append([{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)])
    return *tables, json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def slip_of_block(times, accelerations, mass, normal_force, thrust):
    """Of a block on a plane that moves with these accelerations, linear in between, in 20 steps per sample: friction holds it as
    long as it can, and opposes its motion else."""
    strength, slip, velocity = FRICTION * normal_force, 0., 0.
    for i in range(len(times) - 1):
        n, width = 20, times[i + 1] - times[i]
        for k in range(n):
            ground = accelerations[i] + (k + 0.5) / n * (accelerations[i + 1] - accelerations[i])
            push, h = thrust - mass * ground, width / n
            if velocity == 0. and abs(push) <= strength:
                continue
            way = math.copysign(1., velocity if velocity != 0. else push)
            change = (push - way * strength) / mass * h
            stops = velocity != 0. and (velocity + change) * way < 0.
            slip += velocity * velocity / (2. * abs(change) / h) * way if stops else (velocity + 0.5 * change) * h
            velocity = 0. if stops else velocity + change
    return slip


def expect(complaints, what, value, known, tolerance):
    print(f"{what}: {value:.6g}, expected {known:.6g}")
    if not abs(value - known) <= tolerance:
        complaints.append(f"{what} is {value:.6g}, not {known:.6g} within {tolerance:.2g}")


def main():
    complaints = []
    record = [line.split() for line in (ROOT / "parameters/records/noise.txt").read_text(encoding="utf-8").splitlines()
              if line and not line.startswith("#")]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shaken, resultants, summary = run(folder / "dam", "Dynamics/Event tolerance=1e-5")
        halved, _, _ = run(folder / "halved", "Dynamics/Event tolerance=1e-5", "Dynamics/Time step=0.0025")
        stiff, statics, _ = run(folder / "stiff", "Bodies/dam/Young modulus=2.5e10", "Bodies/rock/Young modulus=2e10",
                                "Joints/base/Normal stiffness=2e10", "Joints/base/Shear stiffness=1e10", "Dynamics/Damping ratio=0")
    duration = float(shaken[-1]["time"])
    before = [row for row in statics if float(row["t"]) == 2.][0]
    mass = WEIGHT / GRAVITY + 7. / 12. * UNIT_WEIGHT / GRAVITY * LEVEL ** 2
    slip = slip_of_block([float(t) for t, _ in record if float(t) <= duration], [GRAVITY * float(a) for _, a in record],
                         mass, -float(before["N"]), float(before["T"]))
    # What is left of elasticity, and steps that sample the record as the block does, make hundredths of a difference.
    expect(complaints, "slip of the nearly rigid dam [m]", float(stiff[-1]["mean_slip"]), slip, 0.02 * slip)
    remaining = float(shaken[-1]["mean_slip"])
    expect(complaints, "slip with half the step [m]", float(halved[-1]["mean_slip"]), remaining, 0.01 * remaining)
    motion = summary["motion"]
    expect(complaints, "energy of the integration in time", motion["numerical"] / motion["largest_energy"], 0., 1e-4)
    expect(complaints, "energy that is not accounted for", motion["not_accounted_for"] / motion["largest_energy"], 0., 1e-9)
    grown = {row["t"]: float(row["energy_bodies"]) for row in shaken}
    for row in resultants:
        if row["t"] in grown:  # the reservoir has left the rest; rounding of 1e-9 of the largest
            level = [r for r in resultants if float(r["t"]) == 2.][0]
            difference = float(row["energy_bodies"]) - float(level["energy_bodies"]) - grown[row["t"]]
            if not abs(difference) <= 1e-9 * max(grown.values()):
                complaints.append(f"energy of the bodies at t = {row['t']} differs by {difference:.3g} from that of the step")
    after = [row for row in resultants if float(row["t"]) == 4.][0]
    expect(complaints, "largest slip afterwards [m]", float(after["largest_slip"]), float(shaken[-1]["largest_slip"]), 1e-3 * remaining)
    print("\n".join(complaints) or "the dam slides as it should")
    sys.exit(1 if complaints else 0)


main()
