#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Makes two self-contained HTML pages from the results of a run: report.html with everything, and report_short.html, of
at most six printed pages. Of a sweep report.html only. Of the tables that fuga --plot-law has written, laws.html.

usage: make_report.py RESULT_DIR      (the same as: fuga report RESULT_DIR)

Exit codes: 0 done, 1 no finished results there or Debian packages missing.
"""

import glob
import importlib.util
import json
import os
import sys

PACKAGES = {"matplotlib": "python3-matplotlib", "pandas": "python3-pandas", "vtkmodules": "python3-vtk9",
            "jinja2": "python3-jinja2"}


def fail(text):
    sys.exit(f"Error: {text}")


def check_packages():
    missing = [package for module, package in PACKAGES.items() if importlib.util.find_spec(module) is None]
    if missing:
        fail(f"The report needs {' and '.join(missing)}. Type: sudo apt install {' '.join(missing)}")


def finished_summary(directory):
    """The summary of a finished run or sweep; a sweep of an earlier version has none: an empty one."""
    path, sweep = (os.path.join(directory, name) for name in ("summary.json", "sweep.csv"))
    if not os.path.isdir(directory):
        fail(f"There is no directory '{directory}'. Give the output directory of a finished run.")
    if not os.path.exists(path):
        if os.path.exists(sweep):
            return {}
        fail(f"There are no results in '{directory}': it has no summary.json. Run first: fuga RUN.prm "
             f"--output-dir {directory}")
    try:
        with open(path, encoding="utf-8") as file:
            summary = json.load(file)
    except ValueError as error:
        fail(f"'{path}' cannot be read: {error}. Run again.")
    if summary.get("verdict") == "unfinished":
        fail(f"The run in '{directory}' is not finished (verdict 'unfinished' in summary.json): it still runs or was "
             "stopped. Wait for it or run again.")
    return summary


def progress(word):
    """Says on a screen what is being done, in one line."""
    if sys.stdout.isatty():
        print(f"\r\033[K{word}", end="", flush=True)


def run_pages(directory):
    """By file name the pages of a run."""
    progress("Report: reading the tables ...")
    from fuga_results import Results
    from report.run_report import long_page, short_page, RunParts

    parts = RunParts(Results(directory), progress)
    return {"report.html": long_page(parts).html("Short version: report_short.html"),
            "report_short.html": short_page(parts).html("Long version: report.html")}


def sweep_pages(directory, summary):
    from fuga_results import Table
    from report import sweep
    from report.text import sections
    from report.text.page import Page

    progress("Report: drawing the sweep ...")
    results = Table(os.path.join(directory, "sweep.csv"))
    page = Page(summary.get("title") or f"Sweep, {os.path.basename(os.path.abspath(directory))}", sweep.verdict(results),
                sections.footer(summary))
    page.section("limits", "Limit loads", sweep.diagrams(results))
    page.section("variants", "Variants", [sweep.variants(results)])
    if summary:
        page.section("sizes", "Sizes and work", sections.sizes(summary))
        page.section("remarks", "Joints and warnings", sections.remarks(summary))
        page.section("parameters", "Parameters", sections.parameters(summary))
    page.section("files", "Files", sections.files(directory))
    return {"report.html": page.html()}


def law_pages(paths):
    """A page of the laws of joints. It is one of its own: a later run does not take away the tables of --plot-law, which
    may be of other data."""
    from fuga_results import Table
    from report.drawings import law_diagram
    from report.text import sections
    from report.text.page import Page, Verdict

    page = Page("Laws of joints", Verdict("", "Laws of joints", ["Drawn from the tables of fuga --plot-law."]), sections.footer({}))
    for number, path in enumerate(paths):
        joint = os.path.basename(path)[len("law_"):-len(".csv")]
        page.section(f"law-{number}", joint, [law_diagram.diagram(joint, Table(path))])
    return {"laws.html": page.html()}


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    directory = arguments[0]
    check_packages()
    laws = sorted(glob.glob(os.path.join(glob.escape(directory), "law_*.csv")))
    only_laws = laws and not os.path.exists(os.path.join(directory, "summary.json"))
    summary = {} if only_laws else finished_summary(directory)
    progress("Report: starting ...")
    from report.drawings import figures
    figures.style()
    pages = law_pages(laws) if laws else {}
    if os.path.exists(os.path.join(directory, "sweep.csv")):
        pages.update(sweep_pages(directory, summary))
    elif not only_laws:
        pages.update(run_pages(directory))
    progress("")
    for name, text in pages.items():
        path = os.path.join(directory, name)
        with open(path + ".part", "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(path + ".part", path)
        print(path)


if __name__ == "__main__":
    main(sys.argv[1:])
