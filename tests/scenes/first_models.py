#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The first models of README.md and doc/ru.md as a newcomer would make them: their files are written, their commands typed, what
they print is compared.

usage: first_models.py FUGA
"""
import math
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


def russian(folder):
    """By hand: N = 840 kN, T = 405 kN, so K = 0.7 840/405; with f = 0.4 it slides where 5 h² = 0.4 (1200 - 40 h)."""
    text = (ROOT / "doc/ru.md").read_text(encoding="utf-8")
    text = text[text.index("## 3. "):text.index("## 4. ")]
    shell = Shell(folder, FUGA, "plotina")
    written = follow(text, shell)
    check(written == {"plotina.geo", "plotina.prm"}, f"files of ru.md: {written}")
    height = -1.6 + math.sqrt(1.6**2 + 96)
    check(f"{0.7 * 840 / 405:.4f}".replace(".", ",") in text, "the safety by hand is another one")
    check(f"h = {height:.4f} м".replace(".", ",") in text, f"the level by hand is {height}")


def main():
    for page in (readme, russian):
        with tempfile.TemporaryDirectory() as folder:
            page(pathlib.Path(folder))
    sys.exit(check.exit_code())


main()
