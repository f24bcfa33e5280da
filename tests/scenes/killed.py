#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Kills runs with SIGKILL at random moments: whatever can be seen then must be complete (design.md, section 4), and
--restart ends in the files of a run that was not killed.

usage: killed.py FUGA

Every .csv is RFC 4180 with CR LF after the last row and as many fields in every row, every .json can be parsed, every
.vtu and .pvd is well-formed XML, every file that a .pvd names is there. Temporary files end in .part and do not count.
"""
import csv
import io
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(__file__).resolve().parents[2]
N_RUNS = 15
complaints = []


def check_csv(path):
    text = path.read_bytes().decode()
    if not text.endswith("\r\n"):
        return "the last row is cut off"
    if "\n" in text.replace("\r\n", ""):
        return "bare line feed"
    lengths = {len(row) for row in csv.reader(io.StringIO(text, newline=""), strict=True)}
    return None if len(lengths) == 1 else f"rows of {sorted(lengths)} fields"


def check_pvd(path):
    for entry in xml.parse(path).getroot().findall("./Collection/DataSet"):
        if not (path.parent / entry.get("file")).is_file():
            return f"names {entry.get('file')}, which is not there"
    return None


CHECKS = {".csv": check_csv, ".pvd": check_pvd,
          ".json": lambda path: json.loads(path.read_text()) and None,
          ".vtu": lambda path: xml.parse(path) and None}


def check_directory(directory):
    n_files = 0
    for path in sorted(directory.iterdir()):
        if path.suffix == ".part":
            continue
        n_files += 1
        try:
            complaint = CHECKS.get(path.suffix, lambda path: None)(path)
        except Exception as error:  # any failure to read is what is looked for
            complaint = repr(error)
        if complaint:
            complaints.append(f"{path.name}: {complaint}")
    return n_files


def results(directory):
    """Files by name, without times, memory, and what tells of restarts."""
    files = {}
    for path in directory.iterdir():
        content = path.read_bytes()
        if path.name == "summary.json":
            summary = json.loads(content)
            del summary["seconds"], summary["memory_MB"], summary["work"]
            content = json.dumps(summary)
        elif path.name == "log.txt":
            content = [line for line in content.splitlines() if not line.startswith((b"Time ", b"Restarted "))]
        if path.name != "checkpoint.cbor":
            files[path.name] = content
    return files


def restart(command, directory, expected, chance):
    """Restarts, is killed again with some chance, and compares; True if there was something to restart."""
    there = (directory / "checkpoint.cbor").is_file()
    if there and random.random() < chance:
        process = subprocess.Popen(command + ["--restart"])
        time.sleep(0.3 * random.random())
        process.kill()
        process.wait()
        check_directory(directory)
    run = subprocess.run(command + ["--restart"], capture_output=True, text=True)
    if not there:
        if run.returncode != 1 or "no checkpoint" not in run.stderr:
            complaints.append(f"restart without checkpoint: {run.returncode}, {run.stderr}")
        return False
    if run.returncode != 0:
        complaints.append(f"restart: {run.returncode}, {run.stderr}")
    check_directory(directory)
    found = results(directory)
    differing = [name for name in sorted(set(found) | set(expected)) if found.get(name) != expected.get(name)]
    if differing:
        complaints.append(f"after a restart other than without: {differing}")
    return True


def main():
    fuga = sys.argv[1]
    random.seed(11)
    command = [fuga, str(ROOT / "parameters" / "scene_g_f06.prm"), "--quiet",
               "--set", f"Mesh/File={ROOT}/meshes/scene_g_33.msh", "--set", "Stages/water/Levels=100"]
    with tempfile.TemporaryDirectory() as name:
        begin = time.monotonic()
        subprocess.run(command + ["--output-dir", name], check=True)
        duration = time.monotonic() - begin
        n_all = check_directory(pathlib.Path(name))
        expected = results(pathlib.Path(name))
        n_restarts = 0
        # The earlier results lie there still: they go, or are replaced, but never mix.
        n_seen = []
        for run in range(N_RUNS):
            process = subprocess.Popen(command + ["--output-dir", name])
            # evenly spread, with a random part: from the very start until it would have ended
            time.sleep(duration * (run + random.random()) / N_RUNS)
            process.kill()
            process.wait()
            n_seen.append(check_directory(pathlib.Path(name)))
            verdict = json.loads((pathlib.Path(name) / "summary.json").read_text())["verdict"]
            if process.returncode != 0 and n_seen[-1] != n_all and verdict == "done":
                complaints.append(f"killed with {n_seen[-1]} files, but summary.json says done")
            n_restarts += restart(command + ["--output-dir", name], pathlib.Path(name), expected, 0.5)
    print(f"{n_all} files of a whole run, {duration:.2f} s; after kills: {n_seen}; {n_restarts} restarts")
    if n_restarts == 0:
        complaints.append("no kill left a checkpoint")
    if not any(0 < n < n_all for n in n_seen):
        complaints.append("no kill hit the writing of results")
    print("\n".join(complaints))
    sys.exit(1 if complaints else 0)


main()
