#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The columns that the pages describe are those that the program writes: doc/results.md (events, joint_history, resultants,
monitors, boundaries, laws), doc/sweeps.md, doc/accuracy.md against the headers of runs in the plane and in space, with water, monitors with stress,
a sweep and an adapted mesh.

usage: result_columns.py FUGA
"""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

FUGA = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
MONITOR = "\nsubsection Monitors\n  subsection crest\n    set Point = {}\n    set Stress = true\n  end\nend\n"
# Parameter file, point of the monitor, further settings.
RUNS = (("dam", "1, 10", ()), ("dam_block_3d", "1, 1, 5", ()),
        ("dam_block_3d", "1, 1, 5", ("Sweep/Friction coefficient=0.7", "Stages/reservoir/Duration=0.2", "Dynamics/Time step=0.05")),
        ("footing", "0, 1", ("Sweep/Cohesion=0, 0.1",)),
        ("dam", "1, 10", ("Sweep/Joints/base/Cohesion=0, 10", "Safety/Strength reduction=yes", "Safety/Load factor=water")),
        ("dam_earthquake", "1, 10", ("Stages/earthquake/Duration=0.1", "Output/Response spectra=true", f"Earthquake/Record x={ROOT}/parameters/records/noise.txt")),
        ("dam_block_3d", "1, 1, 5", ("Stages/reservoir/Duration=1", "Dynamics/Time step=0.05", "Output/Response spectra=true")),
        ("punch_adaptive", "0, 1", ("Target accuracy/Largest number of rounds=1",)))
PAGES = {"results.md": ("events", "joint_history", "resultants", "monitors", "earthquake", "accelerations", "spectra",
                         "boundaries", "law_JOINT"), "sweeps.md": ("sweep",), "accuracy.md": ("refinement",)}
FILE = re.compile(r"`(\w+)\.csv`")


def described(page):
    """The names in the first columns of the page's tables, by the file that was named last before the table; the words of a
    first cell without code are left out."""
    names, table, file = {}, None, None
    for line in (ROOT / "doc" / page).read_text(encoding="utf-8").splitlines():
        if line.startswith("| column |"):
            table = names.setdefault(file, set())
        elif table is not None and line.startswith("|"):
            table.update(re.findall(r"`([^`]+)`", re.split(r"(?<!\\)\|", line)[1]))
        else:
            table = None
            file = (FILE.findall(line) or [file])[-1]
    return names


def written(folder):
    """The headers of all tables of all runs, without units."""
    headers = {}
    for number, (name, point, settings) in enumerate(RUNS):
        parameters = folder / f"{number}.prm"
        parameters.write_text((ROOT / "parameters" / f"{name}.prm").read_text(encoding="utf-8") + MONITOR.format(point),
                              encoding="utf-8")
        text = parameters.read_text(encoding="utf-8")
        mesh = re.search(r"^\s*set File\s*=\s*(\S+)", text, re.M).group(1)
        arguments = [item for setting in (*settings, f"Mesh/File={(ROOT / 'parameters' / mesh).resolve()}", "Output/Fields=never")
                     for item in ("--set", setting)]
        for option in ("--plot-law", "--quiet"):
            run = subprocess.run([FUGA, parameters, option, "--output-dir", folder / str(number), *arguments],
                                 capture_output=True, text=True, check=False)
            if run.returncode not in (0, 3):
                sys.exit(f"{name}: exit code {run.returncode}: {run.stdout}{run.stderr}")
        for path in (folder / str(number)).glob("*.csv"):
            with open(path, newline="", encoding="utf-8") as file:
                header, *rows = csv.reader(file)
            headers.setdefault(re.sub("^law_.*", "law_JOINT", path.stem), set()).update(column.split("[")[0] for column in header)
            if any(len(row) != len(header) for row in rows):
                sys.exit(f"{name}: rows of {path.name} are not as long as its header")
    return headers


def main():
    complaints, n_columns = [], 0
    with tempfile.TemporaryDirectory() as folder:
        headers = written(pathlib.Path(folder))
    # What was varied is a column of its own.
    headers["sweep"] = {name for name in headers["sweep"] if name not in ("Cohesion", "Friction coefficient", "Joints/base/Cohesion")}
    if missing := headers.keys() - {name for names in PAGES.values() for name in names}:
        complaints.append(f"no page describes {missing}")
    for page, files in PAGES.items():
        pages = described(page)
        for file in files:
            told, there = pages.get(file, set()), headers.get(file, set())
            n_columns += len(there)
            complaints += [f"doc/{page}: {file}.csv has a column '{name}' that is not described" for name in sorted(there - told)]
            complaints += [f"doc/{page}: {file}.csv has no column '{name}'" for name in sorted(told - there)]
    print("\n".join(complaints) or f"{n_columns} columns")
    sys.exit(1 if complaints or n_columns < 80 else 0)


main()
