#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The pages of doc/ speak of what exists: messages of doc/errors.md are in the sources, entries of doc/names.md and
doc/errors.md are in doc/input.md, links lead to files and headings; the README is short, and the top of the repository tidy.

usage: documents.py SOURCE_DIR
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
TOP_LEVEL = {"CHANGELOG.md", "CMakeLists.txt", "CONTRIBUTING.md", "LICENSE.md", "README.md", "check", "doc", "include", "meshes",
             "parameters", "run", "source", "tests", "tools"}
UNTRACKED = {"build", "results"}
complaints = []


def messages():
    """All string literals of the C++ sources, neighbours joined."""
    joined = []
    for path in sorted((ROOT / "source").rglob("*.cc")):
        text = "\n".join(re.sub(r"//.*", "", line) if '"' not in line else line
                         for line in path.read_text(encoding="utf-8").splitlines())
        joined.append(LITERAL.sub(r"\1", re.sub(r'(?<!\\)"\s*\n\s*"', "", text)))
    return "\n".join(joined)


def entries():
    """(names of sections, names of entries) of doc/input.md."""
    text = (ROOT / "doc/input.md").read_text(encoding="utf-8")
    return set(re.findall(r"^## (\w+)$", text, re.M)), set(re.findall(r"^\| `([^`]+)` \|", text, re.M))


def check_messages(text):
    known = messages()
    phrases = re.findall(r"^\| `([^`]+)` \|", text[text.index("## Input errors"):text.index("## Loss of")], re.M)
    phrases += re.findall(r"^\| `([^`]+)` \|", text[text.index("## Numerical"):], re.M)
    phrases += re.findall(r"`([^`]+)`", text[text.index("**Restart.**"):text.index("## Loss of")])
    for phrase in phrases:
        is_option = phrase.startswith("-") or "/" in phrase
        if not is_option and phrase not in known:
            complaints.append(f"doc/errors.md: no source has the message '{phrase}'")
    return len(phrases)


def check_entries(name, text):
    sections, known = entries()
    found = re.findall(r"`(" + "|".join(sections) + r")/([^`]+)`", text)
    for section, path in found:
        entry = path.split("/")[-1].split(" = ")[0]
        if entry not in known:
            complaints.append(f"{name}: there is no entry {section}/{path}")
    return len(found)


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def check_links(path):
    text = path.read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`|\$[^$]*\$", "", text)):
        if "://" in target:
            continue
        file, _, anchor = target.partition("#")
        there = path if not file else path.parent / file
        if not there.exists():
            complaints.append(f"{path.relative_to(ROOT)}: the link to {target} leads nowhere")
        elif anchor and anchor not in {slug(h) for h in re.findall(r"^#+ (.*)$", there.read_text(encoding="utf-8"), re.M)}:
            complaints.append(f"{path.relative_to(ROOT)}: no heading {target}")


def check_top():
    names = {path.name for path in ROOT.iterdir()}
    for name in sorted(names - TOP_LEVEL - UNTRACKED):
        if not name.startswith((".", "build-")):
            complaints.append(f"{name} does not belong to the top of the repository")
    length = len((ROOT / "README.md").read_text(encoding="utf-8").splitlines())
    if length > 150:
        complaints.append(f"README.md has {length} lines; details belong to the pages of doc/")


def main():
    errors, names = ((ROOT / "doc" / name).read_text(encoding="utf-8") for name in ("errors.md", "names.md"))
    n_messages = check_messages(errors)
    n_entries = check_entries("doc/errors.md", errors) + check_entries("doc/names.md", names)
    check_top()
    for path in [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "meshes").glob("*.md")), *sorted((ROOT / "doc").rglob("*.md"))]:
        check_links(path)
    if n_messages < 40 or n_entries < 30:
        complaints.append(f"only {n_messages} messages and {n_entries} entries found")
    print("\n".join(complaints) or f"{n_messages} messages, {n_entries} entries")
    sys.exit(1 if complaints else 0)


main()
