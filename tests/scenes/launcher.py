# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Programs on several processes."""
import os
import subprocess

SECONDS = 300  # until a run counts as hanging


def run(program, n, *arguments):
    """Runs the program on n processes; without mpirun on one."""
    launcher = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(n)] if n > 1 else []
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return subprocess.run(launcher + [program, *map(str, arguments)], env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=SECONDS)
