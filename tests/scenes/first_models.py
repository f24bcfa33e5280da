#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The first models of README.md as a newcomer would make them: their files are written, their commands typed, what they print
is compared.

usage: first_models.py FUGA
"""
import pathlib
import re
import sys
import tempfile

from typed_page import BLOCK, ROOT, Shell, check, compare, follow

FUGA = pathlib.Path(sys.argv[1]).resolve()


def readme(folder):
    """Its commands stand within the text. The wall slides at 0.432 tan 30° = 1.5 t ½ 0.00981 6²."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    text = text[text.index("## First own run"):text.index("## Where to read on")]
    printed = next(content for kind, content in BLOCK.findall(text) if kind == "text")
    shell = Shell(folder, FUGA, ".")
    written = follow(BLOCK.sub(lambda block: "" if block.group(1) == "text" else block.group(), text), shell)
    check(written == {"wall.geo", "wall.prm"}, f"files of the README: {written}")
    commands = re.findall(r"`((?:gmsh|fuga) [^`]+)`", text)
    check(commands == ["gmsh -2 wall.geo", "fuga --check wall.prm", "fuga wall.prm", "fuga report results/wall"], f"commands: {commands}")
    for command in commands[:-1]:  # the report is made by the tutorial
        output = shell.run(command + (" || [ $? = 3 ]" if command == "fuga wall.prm" else ""))
    compare(printed, output)


def main():
    with tempfile.TemporaryDirectory() as folder:
        readme(pathlib.Path(folder))
    sys.exit(check.exit_code())


main()
