#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The program is a house of layers, a layer one of rooms: a file includes only its own room and rooms before it.

What stands at the door of a layer (folder without a room) is common to all its rooms. Laws, contact and mesh do not know
deal.II. A room has at most a dozen sources and a dozen headers. The rooms of the report are likewise, of scripts; what stands at
its door puts together what they make.

usage: layers.py REPOSITORY
"""
import pathlib
import re
import sys

# Which layers a layer may include besides itself; the order is that of CMakeLists.txt.
ALLOWED = {
    "base": [],
    "laws": ["base"],
    "contact": ["base", "laws"],
    "mesh": ["base"],
    "bodies": ["base", "laws", "contact", "mesh"],
    "input": ["base", "laws", "contact", "mesh", "bodies"],
    "output": ["base", "laws", "contact", "mesh", "bodies", "input"],
    "run": ["base", "laws", "contact", "mesh", "bodies", "input", "output"],
    "study": ["base", "laws", "contact", "mesh", "bodies", "input", "output", "run"],
}
# The rooms of each layer, in the order in which they may include each other.
ROOMS = {
    "base": ["", "numerics"],
    "laws": [""],
    "contact": ["", "system", "element", "scheme", "cones", "rates", "segments", "path", "dynamics", "judge"],
    "mesh": [""],
    "bodies": ["", "space", "joints", "solvers", "elasticity", "loads", "condensed", "dynamics", "motion", "program"],
    "input": ["", "syntax", "entries", "values", "joints", "loads", "dynamics", "read"],
    "output": ["files", "results", "tables", "fields", "warnings", "restart"],
    "run": ["model", "journal", "simulation"],
    "study": [""],
}
WITHOUT_DEALII = ["base", "laws", "contact", "mesh"]
MOST_FILES = 12
# The rooms of the report, in the order in which they may import each other.
SCRIPTS = ["text", "drawings", ""]
IMPORT = re.compile(r"^\s*(?:from|import) report\.?(\w*)", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def complaint(root, layer, room, name):
    """Why a file of this room must not include this header; None if it may."""
    if name.startswith("deal.II/"):
        return "but this layer does not know deal.II" if layer in WITHOUT_DEALII else None
    if not name.startswith("fuga/"):
        return None
    if not any((root / "include" / (name + end)).is_file() for end in ("", ".in")):
        return "which does not exist"
    other, *inner = name.split("/")[1:-1]
    if other != layer:
        return None if other in ALLOWED[layer] else "a layer that is not before it"
    rooms = ROOMS[layer]
    return None if rooms.index("/".join(inner)) <= rooms.index(room) else "a room that is not before it"


def complaints_of_scripts(root):
    """Imports that lead up, and rooms with too many scripts."""
    scripts = root / "source/python"
    for path in sorted((scripts / "report").rglob("*.py")):
        room = "/".join(path.relative_to(scripts / "report").parts[:-1])
        for name in IMPORT.findall(path.read_text()):
            if SCRIPTS.index(name if name in SCRIPTS else "") > SCRIPTS.index(room):
                yield f"{path.relative_to(root)} imports report.{name}, a room that is not before it"
    for folder in {path.parent for path in scripts.rglob("*.py")}:
        if (n := len(list(folder.glob("*.py")))) > MOST_FILES:
            yield f"{folder.relative_to(root)}: {n} files in one room"


def main():
    root = pathlib.Path(sys.argv[1])
    complaints, n_files = list(complaints_of_scripts(root)), 0
    for folder in ("include/fuga", "source"):
        count = {}
        for path in sorted((root / folder).rglob("*.[hc]*")):
            layer, *inner = path.relative_to(root / folder).parts[:-1] or ["main"]
            room = "/".join(inner)
            if layer in ("python", "main"):
                continue
            if room not in ROOMS.get(layer, []):
                complaints.append(f"{path.relative_to(root)}: no such room")
                continue
            n_files += 1
            count[layer, room] = count.get((layer, room), 0) + 1
            for name in INCLUDE.findall(path.read_text()):
                why = complaint(root, layer, room, name)
                if why:
                    complaints.append(f"{path.relative_to(root)} includes {name}, {why}")
        complaints += [f"{folder}/{'/'.join(filter(None, key))}: {n} files in one room"
                       for key, n in count.items() if n > MOST_FILES]
    print("\n".join(complaints) or f"{n_files} files: every include leads to the same room or one before it")
    sys.exit(1 if complaints or n_files < 50 else 0)


main()
