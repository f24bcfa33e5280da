#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The tables of meshes on one process and on several: the same text, line by line.

usage: compare_tables.py TABLES_OF_MESHES MESH_DIR

Expected: deal.II's serial mesh is the reference; p4est and parallel::shared have to lead to the same numbers of cells
and nodes, places to 1e-12, faces, pieces, hanging nodes. 5 processes are more than some of the meshes have cells.
"""
import sys

from launcher import run


def tables(program, meshes, n):
    done = run(program, n, meshes)
    if done.returncode != 0:
        sys.exit(f"{n} processes: exit code {done.returncode}\n{done.stderr}")
    return done.stdout.splitlines()


def main():
    program, meshes = sys.argv[1:]
    one = tables(program, meshes, 1)
    if sum("hangs on" in line for line in one) < 100:
        sys.exit("hardly a node hangs: the meshes test nothing")
    for n in (2, 3, 5):
        other = tables(program, meshes, n)
        for i, (a, b) in enumerate(zip(one, other)):
            if a != b:
                sys.exit(f"{n} processes: line {i + 1}: '{b}' instead of '{a}'")
        if len(other) != len(one):
            sys.exit(f"{n} processes: {len(other)} lines instead of {len(one)}")
    print(f"the same {len(one)} lines on 1, 2, 3 and 5 processes")


main()
