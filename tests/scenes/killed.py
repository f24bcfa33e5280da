#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Kills runs with SIGKILL at random moments: whatever can be seen then must be complete, and
--restart ends in the files of a run that was not killed.

usage: killed.py FUGA
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from result_files import check_directory, results

ROOT = pathlib.Path(__file__).resolve().parents[2]
N_RUNS = 8
complaints = []


def restart(command, directory, expected, chance):
    """Restarts, is killed again with some chance, and compares; True if there was something to restart."""
    there = (directory / "checkpoint.cbor").is_file()
    if there and random.random() < chance:
        process = subprocess.Popen(command + ["--restart"])
        time.sleep(0.3 * random.random())
        process.kill()
        process.wait()
        check_directory(directory, complaints)
    run = subprocess.run(command + ["--restart"], capture_output=True, text=True)
    if not there:
        if run.returncode != 1 or "no checkpoint" not in run.stderr:
            complaints.append(f"restart without checkpoint: {run.returncode}, {run.stderr}")
        return False
    if run.returncode != 0:
        complaints.append(f"restart: {run.returncode}, {run.stderr}")
    check_directory(directory, complaints)
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
        n_all = check_directory(pathlib.Path(name), complaints)
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
            n_seen.append(check_directory(pathlib.Path(name), complaints))
            verdict = json.loads((pathlib.Path(name) / "summary.json").read_text())["verdict"]
            # A new run removes the checkpoint of the earlier one before it says that it is unfinished.
            n_kept = n_all - (not (pathlib.Path(name) / "checkpoint.cbor").is_file())
            if process.returncode != 0 and n_seen[-1] != n_kept and verdict == "done":
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
