#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Runs that meet another run, Ctrl-C, or a full disk.

usage: early_ends.py FUGA

Expected: of two runs in one directory the second one ends with exit code 1, names the first one and changes nothing; a
run that was killed hinders nobody. SIGINT and SIGTERM end a run with one line and exit code 130 or 143 (128 + signal, as
of shells), a second signal at once. A file that cannot be written gives exit code 5 and the name of the file. In all
cases what is there is complete, and --restart ends in the files of a run that nothing disturbed, byte by byte.
"""
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from result_files import check_directory, results

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECONDS = 300  # until something counts as hanging
ENVIRONMENT = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


class Scene:
    """One problem, a directory for its results, and what they are without disturbance."""

    def __init__(self, fuga, where, processes=1):
        launcher = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(processes)] if processes > 1 else []
        # mpirun passes a signal on after a second or two: the run must last longer.
        levels = 300 if processes > 1 else 60
        self.command = launcher + [fuga, str(ROOT / "parameters" / "scene_g_f06.prm"), "--quiet",
                                   "--set", f"Mesh/File={ROOT}/meshes/scene_g_33.msh",
                                   "--set", f"Stages/water/Levels={levels}"]
        self.directory = where / f"results_{processes}"
        self.run()
        self.expected = results(self.directory)
        self.size = sum(path.stat().st_size for path in self.directory.iterdir())

    def begin(self, *options, **settings):
        return subprocess.Popen(self.command + ["--output-dir", str(self.directory), *options], env=ENVIRONMENT,
                                text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **settings)

    def run(self, *options, code=0, **settings):
        """Returns what it complained of."""
        process = self.begin(*options, **settings)
        _, errors = process.communicate(timeout=SECONDS)
        check(process.returncode == code, f"exit code {process.returncode} instead of {code}: {errors}")
        return errors

    def begin_and_wait_for(self, name):
        """A run that has just written the file."""
        old = self.directory / name
        if old.exists():
            old.unlink()
        process, end = self.begin(), time.monotonic() + SECONDS
        while not (old.exists() and old.stat().st_size) and process.poll() is None and time.monotonic() < end:
            time.sleep(0.002)
        check(process.poll() is None and old.exists(), f"no run that writes {name} to disturb")
        return process

    def restart(self, text):
        check_directory(self.directory, complaints)
        check(not list(self.directory.glob("*.part")), f"{text}: a temporary file is left")
        self.run("--restart")
        found = results(self.directory)
        differing = [name for name in sorted(set(found) | set(self.expected))
                     if found.get(name) != self.expected.get(name)]
        check(not differing, f"{text}: after a restart other than without: {differing}")


def snapshot(directory):
    return {path.name: (path.stat().st_mtime_ns, path.read_bytes()) for path in directory.iterdir()}


def two_in_one_directory(scene):
    first = scene.begin_and_wait_for("run.lock")
    first.send_signal(signal.SIGSTOP)
    before = snapshot(scene.directory)
    for options in ([], ["--restart"]):
        complaint = scene.run(*options, code=1)
        check("Another run" in complaint and f"process {first.pid} " in complaint and str(scene.directory) in complaint,
              f"the second run says {complaint}")
    check(snapshot(scene.directory) == before, "the second run changed something")
    scene.run("--check")
    first.send_signal(signal.SIGCONT)
    _, errors = first.communicate(timeout=SECONDS)
    check(first.returncode == 0, f"the first run: {first.returncode}, {errors}")
    check(results(scene.directory) == scene.expected, "the first run was disturbed")

    killed = scene.begin_and_wait_for("run.lock")
    killed.kill()
    killed.communicate()
    check((scene.directory / "run.lock").exists(), "a killed run took its lock file along")
    scene.run()
    check(results(scene.directory) == scene.expected, "after a killed run: other results")

    there, scene.directory = scene.directory, scene.directory.with_name("not_there") / "deeper"
    scene.run("--restart", code=1)
    check(not scene.directory.parent.exists(), "a run that did nothing left a directory")
    scene.directory = there


def signals(scene):
    for number in (signal.SIGINT, signal.SIGTERM):
        process = scene.begin_and_wait_for("checkpoint.cbor")
        process.send_signal(number)
        _, errors = process.communicate(timeout=SECONDS)
        check(process.returncode == 128 + number, f"{number!r}: exit code {process.returncode}")
        check(errors.count("\n") == 1 and "Interrupted at " in errors and " of stage '" in errors and
              "--restart" in errors, f"{number!r}: {errors}")
        check('"verdict": "interrupted"' in (scene.directory / "summary.json").read_text(), "the summary does not say so")
        scene.restart(f"{number!r}")

    # Of two signals that wait, both handlers run.
    process = scene.begin_and_wait_for("checkpoint.cbor")
    for number in (signal.SIGSTOP, signal.SIGINT, signal.SIGTERM, signal.SIGCONT):
        process.send_signal(number)
    _, errors = process.communicate(timeout=SECONDS)
    check(process.returncode in (-signal.SIGINT, -signal.SIGTERM) and not errors,
          f"a second signal: {process.returncode}, {errors}")
    scene.restart("a second signal")


def signal_to_several_processes(scene):
    process = scene.begin_and_wait_for("checkpoint.cbor")
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=SECONDS)
    check(process.returncode != 0, "mpirun interrupted: exit code 0")
    # mpirun may have closed the screen already.
    check('"verdict": "interrupted"' in (scene.directory / "summary.json").read_text(), "mpirun interrupted: no summary")
    check(errors.count("Interrupted at ") <= 1, f"mpirun interrupted: {errors}")
    check_directory(scene.directory, complaints)
    scene.run("--restart")
    # Solvers of several processes add in any order: not byte by byte.
    found = results(scene.directory)
    check(sorted(found) == sorted(scene.expected), "several processes: other files after a restart")
    for name in ("events.csv", "resultants.csv"):
        check(found[name].count(b"\n") == scene.expected[name].count(b"\n"), f"several processes: other {name}")


def no_room(scene):
    limit = 60000  # bytes of one file; those of the scene are larger

    def limit_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    check(any(path.stat().st_size > limit for path in scene.directory.iterdir()), "no file above the limit")
    message = scene.run(code=5, preexec_fn=limit_files)
    check("The result file " in message and "File too large" in message and " free in " in message,
          f"limit of files: {message}")
    if "--restart" in message:
        scene.restart("limit of files")
    else:
        check(not (scene.directory / "checkpoint.cbor").exists(), f"no word of the checkpoint: {message}")

    # A disk with room for half of the files, if this user may make one.
    whole, disk = scene.directory, scene.directory.with_name("disk")
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={scene.size // 2}", "none", str(disk)], capture_output=True).returncode:
        print("no small disk can be mounted: only the limit of the size of files was tried")
        return
    try:
        scene.directory = disk
        message = scene.run(code=5)
        check("No space left on device" in message and "are free in " in message and "--restart" in message,
              f"full disk: {message}")
        check_directory(disk, complaints)
        shutil.rmtree(whole)
        shutil.copytree(disk, whole)
    finally:
        subprocess.run(["umount", str(disk)], check=True)
        scene.directory = whole
    scene.restart("full disk")


def main():
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # the runs would ignore it if this shell does, as one in the background
    with tempfile.TemporaryDirectory() as name:
        scene = Scene(sys.argv[1], pathlib.Path(name))
        two_in_one_directory(scene)
        signals(scene)
        no_room(scene)
        signal_to_several_processes(Scene(sys.argv[1], pathlib.Path(name), processes=2))
    print("\n".join(complaints))
    sys.exit(1 if complaints else 0)


main()
