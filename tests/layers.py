#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""A layer includes only itself and layers above it; laws, contact and mesh know neither deal.II nor each other's business.

usage: layers.py REPOSITORY
"""
import pathlib
import re
import sys

# What each layer may include besides itself; the order is that of CMakeLists.txt.
ALLOWED = {
    "base": [],
    "laws": ["base"],
    "contact": ["base", "laws"],
    "mesh": ["base"],
    "bodies": ["base", "laws", "contact", "mesh"],
    "io": ["base", "laws", "contact", "mesh", "bodies"],
}
# At the top, like source/*.cc: may include everything.
TOP = ["python"]
WITHOUT_DEALII = ["base", "laws", "contact", "mesh"]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def main():
    root = pathlib.Path(sys.argv[1])
    complaints, n_files = [], 0
    for folder in ("include/fuga", "source"):
        for layer in sorted(p.name for p in (root / folder).iterdir() if p.is_dir()):
            if layer in TOP:
                continue
            if layer not in ALLOWED:
                complaints.append(f"{folder}/{layer}: no layer of this name")
                continue
            for path in sorted((root / folder / layer).rglob("*.[hc]*")):
                n_files += 1
                for name in INCLUDE.findall(path.read_text()):
                    where = f"{path.relative_to(root)} includes {name}"
                    parts = name.split("/")
                    if parts[0] == "deal.II" and layer in WITHOUT_DEALII:
                        complaints.append(where + ", but this layer does not know deal.II")
                    if parts[0] != "fuga":
                        continue
                    if len(parts) < 3:
                        complaints.append(where + ", the top")
                    elif parts[1] != layer and parts[1] not in ALLOWED[layer]:
                        complaints.append(where + ", which is not above it")
                    if not (root / "include" / name).is_file():
                        # made by CMake (the version)
                        if not (root / "include" / (name + ".in")).is_file():
                            complaints.append(where + ", which does not exist")
    print("\n".join(complaints) or f"{n_files} files: every include points upwards")
    sys.exit(1 if complaints or n_files < 50 else 0)


main()
