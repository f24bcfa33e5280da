#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The pages of doc/ speak of what exists: messages of doc/errors.md are in the sources, entries of doc/names.md and
doc/errors.md are in doc/input.md, the sources name an entry once, links lead to files and headings; pages, sections and equations that any file mentions
are there, and so are the sources and folders that a page mentions; generated pages have the remarks that are written by hand; the
README is short, and the top of the repository tidy.

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


def check_names():
    """An entry of the input is named by the table of its section; whatever else in the program needs the name takes it
    from there."""
    rows = re.findall(r"^\| `([^`]+)` \|", (ROOT / "doc/input.md").read_text(encoding="utf-8"), re.M)
    code = "\n".join(re.sub(r"^\s*(//|/?\*).*", "", path.read_text(encoding="utf-8"), flags=re.M)
                     for folder in ("source", "include") for path in sorted((ROOT / folder).rglob("*.[ch]*")))
    names = [literal.split("/")[-1] for literal in LITERAL.findall(code)]
    for name in sorted(set(rows)):
        # A single word may be the title of something else.
        if " " in name and names.count(name) > rows.count(name):
            complaints.append(f"the sources name the entry '{name}' {names.count(name)} times; doc/input.md has {rows.count(name)}")
    return len(set(rows))


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


def check_mentions():
    """Every page that any file names is a path from the file's folder, from the root, or, in a page or its generator, from doc/; with the
    section or equation that follows it. Every `NAME.cc`, `NAME.h` in a page is a source."""
    theory = (ROOT / "doc/theory.md").read_text(encoding="utf-8")
    places = {"section": set(re.findall(r"^## (\d+)\.", theory, re.M)), "eq.": set(re.findall(r"\\tag\{(\w+)\}", theory))}
    sources = {path.name for folder in ("include", "source", "tests") for path in (ROOT / folder).rglob("*.*")}
    n_mentions = 0
    for path in mentioning():
        text = path.read_text(encoding="utf-8")
        name = path.relative_to(ROOT)
        folders = [path.parent, ROOT] + ([ROOT / "doc"] if path.suffix in (".md", ".py") else [])
        for page in re.finditer(r"[\w./-]*\w\.md\b", text):
            n_mentions += 1
            if not any((folder / page.group()).is_file() for folder in folders):
                complaints.append(f"{name}: there is no page {page.group()}")
        # Comments break lines; the markers of the next line do not count.
        words = re.sub(r"\n\s*(?://|\*|#)?\s*", " ", text)
        for kind, number in re.findall(r"theory(?:\.md\)?|\]\(theory\.md\))?,? (section|eq\.) (\w+)", words):
            if number not in places[kind]:
                complaints.append(f"{name}: the theory has no {kind} {number}")
        if path.suffix == ".md":
            for source in re.findall(r"`(?:[\w.]+/)*(\w+\.(?:cc|h))`", text):
                if source not in sources:
                    complaints.append(f"{name}: there is no source {source}")
    return n_mentions


def check_rooms():
    """A path in a page that begins with a folder of source/ is a source or a folder; in a list in brackets a name without a
    folder is a source beside the one before it."""
    tops = {path.name for path in (ROOT / "source").iterdir()}
    known = {path.relative_to(top).with_suffix("") for top in (ROOT / "source", ROOT / "include/fuga") for path in top.rglob("*")}
    n_paths = 0
    for page in sorted((ROOT / "doc").rglob("*.md")) + [ROOT / "CONTRIBUTING.md"]:
        text = page.read_text(encoding="utf-8")
        in_brackets = r"\(((?:`[a-z_0-9/]+`(?:,\s+|(?=\))))+)\)"
        alone = re.findall(r"`[a-z_]+/[a-z_0-9/]+`", re.sub(in_brackets, "", text))
        for words in re.findall(in_brackets, text) + alone:
            room = None
            for name in re.findall(r"`([^`]+)`", words):
                path = pathlib.Path(name)
                if "/" in name:
                    room = path.parent if path.parts[0] in tops else None
                elif room:
                    path = room / name
                if room:
                    n_paths += 1
                    if path not in known:
                        complaints.append(f"{page.relative_to(ROOT)}: source/ and include/fuga/ have no {path}")
    return n_paths


def check_remarks():
    """A generated page has the hand-written remarks as they are now."""
    for path in sorted((ROOT / "doc/remarks").glob("*.md")):
        pages = [page for page in (ROOT / "doc").glob("*.md") if f"remarks/{path.name}" in page.read_text(encoding="utf-8")]
        if not pages:
            complaints.append(f"no page has doc/remarks/{path.name}")
        for page in pages:
            if path.read_text(encoding="utf-8") not in page.read_text(encoding="utf-8"):
                complaints.append(f"{page.relative_to(ROOT)} has other remarks than {path.name}: write the page again")


def mentioning():
    """The hand-written and generated texts of the repository."""
    kinds = {".cc", ".h", ".in", ".py", ".md", ".prm", ".geo", ".sh", ".txt"}
    files = [path for folder in ("include", "source", "tests", "doc", "meshes", "parameters")
             for path in sorted((ROOT / folder).rglob("*")) if path.suffix in kinds]
    return [*files, *sorted(ROOT.glob("*.md")), ROOT / "CMakeLists.txt", ROOT / "check", ROOT / "run", *sorted((ROOT / ".ci").iterdir())]


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
    n_names = check_names()
    check_top()
    check_remarks()
    n_mentions = check_mentions() + check_rooms()
    for path in [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "meshes").glob("*.md")), *sorted((ROOT / "doc").rglob("*.md"))]:
        check_links(path)
    if n_names < 100 or n_messages < 40 or n_entries < 30 or n_mentions < 200:
        complaints.append(f"only {n_messages} messages, {n_entries} entries and {n_mentions} pages found")
    print("\n".join(complaints) or f"{n_messages} messages, {n_entries} entries, {n_mentions} pages")
    sys.exit(1 if complaints else 0)


main()
