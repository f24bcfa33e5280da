#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Makes one self-contained HTML page, report.html, from the results of a run or a sweep.

usage: make_report.py RESULT_DIR      (the same as: fuga report RESULT_DIR)

Exit codes: 0 done, 1 no finished results there or Debian packages missing.
"""

import importlib.util
import json
import os
import sys

PACKAGES = {"matplotlib": "python3-matplotlib", "pandas": "python3-pandas", "vtkmodules": "python3-vtk9"}
# Detailed diagrams are drawn of so many joints.
DRAWN_JOINTS = 8


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


def run_page(directory):
    from fuga_results import Results
    from report import joint_diagrams, load_diagrams, sections
    from report.page import Page
    from report.pictures import NoPictures, pictures

    results = Results(directory)
    summary = results.summary
    page = Page(results.title or "fuga")
    if not results.levels:
        page.section("results", "Results", "<p>The run ended before its first load level: there is nothing to draw.</p>")
        page.section("certificate", "Certificate", sections.certificate_table(summary))
        page.section("parameters", "Parameters", sections.parameters(summary))
        return page, sections.verdict_box(summary), sections.footer(summary)
    levels = results.representative_levels()
    joints = results.joints[:DRAWN_JOINTS]
    more = (f"<p>The first {DRAWN_JOINTS} of {len(results.joints)} joints.</p>" if len(results.joints) > DRAWN_JOINTS else "")

    def each(draw, *arguments):
        return [more] + [draw(results, joint, *arguments) for joint in joints]

    page.section("resultants", "Resultants", sections.resultant_tables(results, levels))
    page.section("monitors", "Monitors", sections.monitor_tables(results, levels))
    page.section("certificate", "Certificate", sections.certificate_table(summary))
    page.section("remarks", "Joints and warnings", sections.remarks(summary))
    if results.in_space:
        page.section("stresses", "Contact stresses", "<p>Diagrams along a joint, of shear against pressure and of loops are for "
                     "models in the plane. The fields of surfaces are in joints.pvd, all numbers in joint_history.csv.</p>")
        joints = []
    else:
        page.section("stresses", "Contact stresses", each(joint_diagrams.pressures, levels)
                     + each(joint_diagrams.shear_and_strength, levels)[1:])
        page.section("displacements", "Relative displacements", each(joint_diagrams.displacements, levels))
    page.section("load", "Load and displacement", [load_diagrams.load_displacement(results),
                                                           load_diagrams.beyond_limit(results)])
    page.section("states", "States and events", [load_diagrams.timeline(results)])
    page.section("safety", "Safety", [load_diagrams.safety(results)])
    if not results.in_space:
        page.section("paths", "Most used elements", each(joint_diagrams.coulomb_paths))
    loops = [figure for figure in each(joint_diagrams.hysteresis)[1:] if figure]
    page.section("hysteresis", "Hysteresis", loops)
    page.section("energy", "Energy balance", [load_diagrams.energies(results)
                                              or "<p>Energies are not known: the run took implicit steps.</p>"])
    try:
        page.section("pictures", "Bodies", pictures(results))
    except NoPictures as reason:
        page.section("pictures", "Bodies", f"<p>{reason}</p>")
    page.section("sizes", "Sizes and work", sections.sizes(summary))
    page.section("parameters", "Parameters", sections.parameters(summary))
    page.section("events", "Events", sections.event_list(results))
    page.section("files", "Files", sections.files(directory))
    return page, sections.verdict_box(summary), sections.footer(summary)


def sweep_page(directory, summary):
    from fuga_results import Table
    from report import sections, sweep
    from report.page import Page

    results = Table(os.path.join(directory, "sweep.csv"))
    page = Page(summary.get("title") or f"Sweep, {os.path.basename(os.path.abspath(directory))}")
    page.section("limits", "Limit loads", list(sweep.diagrams(results)))
    page.section("variants", "Variants", sweep.variants(results))
    if summary:
        page.section("sizes", "Sizes and work", sections.sizes(summary))
        page.section("remarks", "Joints and warnings", sections.remarks(summary))
        page.section("parameters", "Parameters", sections.parameters(summary))
    page.section("files", "Files", sections.files(directory))
    return page, sweep.verdict_box(results), sections.footer(summary)


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    directory = arguments[0]
    check_packages()
    summary = finished_summary(directory)
    from report import figures
    figures.style()
    is_sweep = os.path.exists(os.path.join(directory, "sweep.csv"))
    page, head, foot = sweep_page(directory, summary) if is_sweep else run_page(directory)
    path = os.path.join(directory, "report.html")
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(page.text(head, foot))
    os.replace(path + ".part", path)
    print(path)


if __name__ == "__main__":
    main(sys.argv[1:])
