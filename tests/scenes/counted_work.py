#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The work of nine scenes, counted by the program itself, against the counts recorded in counted_work.csv: a change that
makes a run cost more is found whatever else the machine does.

usage: counted_work.py FUGA [--record]

What is counted, and in which phase: work.counted of summary.json (base/work_counter.h). A count may differ by a tenth
from the recorded one: decisions at the last digits, and the digits of times in what is written, differ from machine to
machine. Counts below FEW are not compared, of an operation that matters there are more. --record writes the file from
this run; commit it together with the change that is its reason.
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RECORD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "counted_work.csv")
TOLERANCE, FEW = 0.1, 50

# Name, parameter file, elements of the mesh of scene G if not its own, settings.
SCENES = [("scene G, 129 elements, f = 0.6", "scene_g_f06.prm", 129, []),
          ("scene G, 513 elements, f = 0.6", "scene_g_f06.prm", 513, ["Output/Fields=end"]),
          ("scene G, 129 elements, f = 0.2", "scene_g_f02.prm", 129, ["Output/Fields=never"]),
          ("structure on a foundation, law (9)", "paper_3_cubic_root.prm", None, ["Output/Fields=end"]),
          ("arch of seven blocks", "arch.prm", None, ["Output/Fields=end"]),
          ("two cylinders", "hertz.prm", None, ["Output/Fields=end"]),
          ("block of a dam in space", "dam_block_3d.prm", None, ["Output/Fields=end", "Solver/Bodies=direct"]),
          ("arch dam in space", "arch_dam.prm", None, ["Output/Fields=end"]),
          ("gravity dam under an earthquake", "dam_earthquake.prm", None, ["Output/Fields=never"])]


def counts_of(fuga, scene, folder):
    """{(phase, what): count}"""
    _, file, elements, settings = scene
    if elements:
        mesh = os.path.join(folder, f"scene_g_{elements}.msh")
        if not os.path.exists(mesh):
            subprocess.run([sys.executable, os.path.join(TOP, "meshes", "scene_g.py"), str(elements), mesh], check=True,
                           stdout=subprocess.DEVNULL)
        settings = settings + [f"Mesh/File={mesh}"]
    command = [fuga, os.path.join(TOP, "parameters", file), "--quiet", "--output-dir", os.path.join(folder, "out")]
    for setting in settings:
        command += ["--set", setting]
    code = subprocess.run(command, check=False, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}).returncode
    if code not in (0, 3):  # 3: a limit load
        sys.exit(f"{file}: exit code {code}")
    with open(os.path.join(folder, "out", "summary.json"), encoding="utf-8") as summary:
        phases = json.load(summary)["work"]["counted"]
    return {(phase, what): count for phase, counts in phases.items() for what, count in counts.items()
            if what != "cpu_seconds" and count > 0}


def main():
    fuga = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        found = {(scene[0], *key): count for scene in SCENES for key, count in counts_of(fuga, scene, folder).items()}
    if "--record" in sys.argv:
        with open(RECORD, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["scene", "phase", "what", "count"])
            writer.writerows([*key, count] for key, count in found.items())
        return
    with open(RECORD, encoding="utf-8", newline="") as file:
        recorded = {(row["scene"], row["phase"], row["what"]): int(row["count"]) for row in csv.DictReader(file)}
    wrong = 0
    for key in sorted(recorded.keys() | found.keys()):
        now, then = found.get(key, 0), recorded.get(key, 0)
        if max(now, then) >= FEW and abs(now - then) > TOLERANCE * then:
            wrong += 1
            print(f"{', '.join(key)}: {now}, recorded {then}" + (f", ratio {now / then:.2f}" if then else ""))
    if wrong:
        sys.exit(f"{wrong} counts differ by more than a tenth. If the change is meant (or for the better): "
                 "tests/scenes/counted_work.py FUGA --record, and commit the file.")
    print(f"{len(recorded)} counts of {len(SCENES)} scenes as recorded.")


main()
