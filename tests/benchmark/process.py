# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""One measured child process, and the shape of what a measurement gives.

The child is started by a small process of its own (this file as a program): Linux counts the memory of the process
that forks as memory of the child, and the benchmark holds large meshes.
"""
import dataclasses
import json
import os
import resource
import subprocess
import sys
import time

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "CCX_NPROC_EQUATION_SOLVER",
           "CCX_NPROC_RESULTS")


@dataclasses.dataclass
class Process:
    cpu: float        # user + system seconds of the child
    wall: float
    memory_MB: float  # largest resident size
    code: int         # exit code; negative: ended by this signal
    output: str       # stdout and stderr

    @property
    def timed_out(self):
        return self.code in (-24, -9)  # SIGXCPU, and SIGKILL at the hard limit


@dataclasses.dataclass
class Result:
    """What one run of one tool on one scene gave."""
    phases: dict                  # seconds, 'total' and 'total_after_start' among them
    memory_MB: float
    elements: int
    dofs: int
    error: float = None           # None: not compared
    failure: str = None           # the message of a run that did not reach its end
    info: dict = dataclasses.field(default_factory=dict)  # events, iterations, verdict ...


def measure(command, directory=".", cpu_limit=600, threads=1):
    """Runs the command on so many threads; CPU seconds beyond the limit end it."""
    launcher = [sys.executable, os.path.abspath(__file__), str(int(cpu_limit)), *command]
    answer = subprocess.run(launcher, cwd=directory, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=True,
                            env={**os.environ, **dict.fromkeys(THREADS, str(threads))})
    with open(os.path.join(directory, "process_output.txt"), errors="replace") as log:
        return Process(*json.loads(answer.stdout), log.read())


def launch(cpu_limit, command):
    """CPU seconds, wall seconds, MB and exit code of the command."""
    with open("process_output.txt", "w") as log:
        begin = time.monotonic()
        child = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_CPU, (cpu_limit, cpu_limit + 5)))
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        wall = time.monotonic() - begin
    return usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss / 1024., child.returncode


def processor():
    """Its name, as the kernel gives it."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), "?")


def relative_error(values, reference):
    """Of two flat lists, in the Euclidean norm; the absolute one where the reference is zero."""
    difference = sum((a - b) ** 2 for a, b in zip(values, reference, strict=True))
    return (difference / (sum(b * b for b in reference) or 1.)) ** 0.5


if __name__ == "__main__":
    print(json.dumps(launch(int(sys.argv[1]), sys.argv[2:])))
