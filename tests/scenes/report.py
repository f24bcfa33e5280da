#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Reports of small runs: a run with pictures, a limit load without fields, a sweep; what is refused.

usage: report.py FUGA

The page has to be HTML whose elements close, with every section, nothing from the network, SVG that an XML parser
reads, and the numbers of the CSV files and of summary.json. The limit load is the closed form: the block of 20 m x 40 m
of 24 kN/m^3 with f = 0.2 slides when the water on 40 m reaches the factor 0.2 * 19200 / (9.81 * 40^2 / 2).
"""
import csv
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

FUGA = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[2]
VOID = {"meta", "br", "hr", "img", "link", "input"}
RUN_SECTIONS = ["resultants", "certificate", "remarks", "stresses", "displacements", "load", "states", "safety", "paths",
                "energy", "pictures", "sizes", "parameters", "events", "files"]
SHOWN = 1e-5  # six digits are shown, a bit less near a power of ten
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


class Page(html.parser.HTMLParser):
    """Tables by id as rows of (text, value or None), ids, addresses; complains of elements that do not close."""

    def __init__(self, text, name):
        super().__init__()
        self.name, self.ids, self.addresses, self.tables, self.words = name, [], [], {}, ""
        self._open, self._table = [], None
        self.feed(text)
        check(not self._open, f"{name}: never closed: {self._open}")

    def handle_starttag(self, tag, attributes):
        self.handle_startendtag(tag, attributes)
        if tag not in VOID:
            self._open.append(tag)

    def handle_startendtag(self, tag, attributes):
        for key, value in attributes:
            if key == "id":
                self.ids.append(value)
            if key in ("src", "href", "xlink:href", "data", "action", "srcset", "poster"):
                self.addresses.append(value)
            self.addresses += re.findall(r"url\(([^)]*)\)", value or "") if key in ("style", "clip-path", "fill") else []
        if tag == "table":
            self._table = self.tables.setdefault(dict(attributes).get("id", ""), [])
        elif tag == "tr" and self._table is not None:
            self._table.append([])
        elif tag in ("td", "th") and self._table is not None:
            self._table[-1].append(["", None])
        elif tag == "data" and self._open and self._open[-1] in ("td", "th"):
            self._table[-1][-1][1] = float(dict(attributes)["value"])

    def handle_endtag(self, tag):
        check(bool(self._open) and self._open[-1] == tag, f"{self.name}: </{tag}> closes {self._open[-1:]}")
        if self._open:
            self._open.pop()
        if tag == "table":
            self._table = None

    def handle_data(self, data):
        if "style" in self._open or "script" in self._open:
            return
        if self._table is not None and ("td" in self._open or "th" in self._open):
            self._table[-1][-1][0] += data
        self.words += data


def number_of(text):
    return float(text.replace("\u2212", "-").replace("\u221e", "inf"))


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]


def same(cell, expected, what, shown_to=SHOWN, rounding=0.0):
    """All digits in the attribute, the first in the text; 0 for what is rounding. Infinity has no attribute."""
    text, value = cell
    shown = number_of(text)
    value = shown if value is None else value
    check(value == expected, f"{what}: {value!r} instead of {expected!r}")
    check(shown == expected or abs(shown - expected) <= shown_to * abs(expected) or (shown == 0.0 and abs(expected) < rounding),
          f"{what}: shows {text} for {expected!r}")


def read_page(directory, sections):
    text = (directory / "report.html").read_text(encoding="utf-8")
    page = Page(text, directory.name)
    check(len(page.ids) == len(set(page.ids)), f"{directory.name}: an id stands twice")
    for name in sections:
        check(name in page.ids, f"{directory.name}: no section {name}")
    for address in page.addresses:
        check(address.startswith(("data:", "#")), f"{directory.name}: address {address[:60]}")
        check(not address.startswith("#") or address[1:] in page.ids, f"{directory.name}: nothing has the id of {address}")
    outside = re.sub(r'xmlns(:\w+)?="[^"]*"', "", re.sub(r"base64,[\sA-Za-z0-9+/=]*", "", text))
    check("http" not in outside and "@import" not in outside, f"{directory.name}: an address of the network")
    drawings = re.findall(r"<svg.*?</svg>", text, flags=re.DOTALL)
    for drawing in drawings:
        try:
            xml.fromstring(drawing)
        except xml.ParseError as error:
            complaints.append(f"{directory.name}: SVG: {error}")
    check(len(drawings) == text.count("<figcaption>") > 0, f"{directory.name}: {len(drawings)} drawings")
    check(text.count("data:image/png;base64,") > 0 or not (directory / "bodies.pvd").exists(),
          f"{directory.name}: no picture of the bodies")
    return page


def check_tables(page, directory):
    summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
    resultants, events = rows_of(directory / "resultants.csv"), rows_of(directory / "events.csv")
    joints = list(dict.fromkeys(row["joint"] for row in resultants))
    for k, joint in enumerate(joints):
        head, *body = page.tables[f"resultants-{k}"]
        levels = [number_of(cell[0].removeprefix("t = ")) for cell in head[2:]]
        check(1 <= len(levels) <= 6, f"{len(levels)} levels")
        check(abs(levels[-1] - float(resultants[-1]["t"])) <= SHOWN, "the last level is not among those shown")
        names = [name for name in resultants[0] if name not in ("t", "joint")]
        check([row[0][0] for row in body] == [name.replace("_", " ") for name in names], "rows of the resultants")
        for name, row in zip(names, body):
            # Two digits of a certificate tell enough.
            digits = 0.06 if name == "certificate" else SHOWN
            rounding = 1e-12 * max((abs(cell[1]) for cell in row[2:] if cell[1] is not None), default=0.0)
            for t, cell in zip(levels, row[2:]):
                source = next(r for r in resultants if r["joint"] == joint and abs(float(r["t"]) - t) <= SHOWN)
                same(cell, float(source[name]), f"{joint}, {name} at {t}", digits, rounding)
    for (name, _, value, within), (key, expected) in zip(page.tables["certificate-table"][1:],
                                                         summary["certificate"]["entries"].items()):
        check(name[0] == key and value[1] == expected and within[0] == "yes", f"certificate: {name[0]}")
    check(len(page.tables["certificate-table"]) == 1 + len(summary["certificate"]["entries"]), "entries of the certificate")
    listed = page.tables["event-table"][1:]
    check(len(listed) == len(events) == summary["events"]["total"], f"{len(listed)} events listed")
    for row, event in zip(listed, events):
        same(row[1], float(event["t"]), f"t of event {event['event']}")
        check(row[-2][0] == event["from"] and row[-1][0] == event["to"], f"states of event {event['event']}")
    sizes = {row[0][0]: row[1][1] for row in page.tables["sizes-table"]}
    for name, value in summary["sizes"].items():
        check(sizes[name.replace("_", " ")] == value, f"size: {name}")
    check(f"Exit code {summary['exit_code']}." in page.words, "the exit code")
    check(summary["title"] in page.words, "the title")


def fuga(*arguments):
    return subprocess.run([FUGA, *map(str, arguments)], capture_output=True, text=True)


def with_monitors(folder):
    """A copy of a parameter file with two points, one of them with stress."""
    text = (ROOT / "parameters/paper_2_linear.prm").read_text(encoding="utf-8").replace("../meshes", str(ROOT / "meshes"))
    copy = folder / "monitored.prm"
    copy.write_text(text + "\nsubsection Monitors\nsubsection crest\nset Point = 0, 12\nend\n"
                    "subsection heel\nset Point = 0.5, 0.5\nset Stress = true\nend\nend\n", encoding="utf-8")
    return copy


def check_monitors(page, directory):
    rows = rows_of(directory / "monitors.csv")
    for k, (monitor, n_rows) in enumerate((("crest", 2), ("heel", 6))):
        head, *body = page.tables[f"monitor-{k}"]
        check(len(body) == n_rows, f"{monitor}: {len(body)} rows")
        for row in body:
            rounding = 1e-12 * max(abs(cell[1]) for cell in row[2:])
            for title, cell in zip(head[2:], row[2:]):
                t = number_of(title[0].removeprefix("t = "))
                source = next(r for r in rows if r["monitor"] == monitor and abs(float(r["t"]) - t) <= SHOWN)
                same(cell, float(source[row[0][0].replace(" ", "_")]), f"{monitor}, {row[0][0]} at {t}", rounding=rounding)
    check("displacements of the monitors" in page.words, "the diagram of the monitors")


def run_with_pictures(directory):
    run = fuga(with_monitors(directory.parent), "--quiet", "--output-dir", directory,
               "--set", "Output/Report=true", "--set", "Output/Fields=end", "--set", "Title=a < b & \"c\"")
    check(run.returncode == 0 and run.stdout == "", f"the run: {run.returncode} {run.stdout} {run.stderr}")
    page = read_page(directory, RUN_SECTIONS + ["monitors"])
    check_tables(page, directory)
    check_monitors(page, directory)
    check("Done" in page.words and "3060" in page.words, "verdict and parameters of a run that is done")


def limit_load(directory):
    run = fuga(ROOT / "parameters/scene_g_f02.prm", "--quiet", "--output-dir", directory, "--set", "Output/Fields=never",
               "--set", "Mesh/File=../meshes/scene_g_9.msh", "--set", "Stages/water/Loads=water: 0.6*t",
               "--set", "Solver/Beyond limit load=arc length")
    check(run.returncode == 3, f"the run to the limit load: {run.returncode} {run.stderr}")
    report = fuga("report", directory)
    check(report.returncode == 0 and report.stdout.strip() == f"{directory}/report.html", f"report: {report}")
    page = read_page(directory, RUN_SECTIONS)
    check_tables(page, directory)
    factor = re.search(r"water (0\.\d{9})", page.words)
    expected = 0.2 * 24. * 20. * 40. / (9.81 * 40. ** 2 / 2.)
    check(factor is not None and abs(float(factor.group(1)) - expected) < 1e-9, "the limit load in the verdict")
    check("limit load, mechanism sliding" in page.words, "the mechanism in the verdict")
    check("Beyond the limit load" in page.words, "the path beyond the limit load")
    check("wrote no fields" in page.words, "that there are no fields is not said")


def sweep(directory):
    run = fuga(ROOT / "parameters/scene_g_f02.prm", "--quiet", "--output-dir", directory,
               "--set", "Mesh/File=../meshes/scene_g_9.msh", "--set", "Stages/water/Loads=water: 0.6*t",
               "--set", "Sweep/Friction coefficient=0.1, 0.2, 0.3", "--set", "Sweep/Cohesion=0, 20",
               "--set", "Output/Report=true")
    check(run.returncode == 0, f"the sweep: {run.returncode} {run.stderr}")
    page = read_page(directory, ["limits", "variants", "files"])
    variants = rows_of(directory / "sweep.csv")
    table = page.tables["variants-table"][1:]
    check(len(table) == len(variants) == 6, f"{len(table)} variants")
    names = list(variants[0])
    for row, variant in zip(table, variants):
        same(row[names.index("t")], float(variant["t"]), f"t of variant {variant['variant']}")
        check(row[names.index("verdict")][0] == variant["verdict"], f"verdict of variant {variant['variant']}")


def refused(directory):
    directory.mkdir()
    for name, content, words in (("nothing", None, "no summary.json"), ("unfinished", '{"verdict": "unfinished"}', "not finished"),
                                 ("cut", '{"verdict"', "cannot be read")):
        folder = directory / name
        folder.mkdir()
        if content:
            (folder / "summary.json").write_text(content)
        report = fuga("report", folder)
        check(report.returncode == 1 and words in report.stderr and "Traceback" not in report.stderr, f"{name}: {report}")
        check(not (folder / "report.html").exists(), f"{name}: a report was written")
    check(fuga("report", directory / "absent").returncode == 1, "a directory that is not there")


def later_run_removes_the_report(directory):
    fuga(ROOT / "parameters/paper_2_linear.prm", "--quiet", "--output-dir", directory, "--set", "Output/Fields=never")
    check(not (directory / "report.html").exists(), "the report of an earlier run is still there")
    check(not (directory / "view_in_paraview.py").exists(), "view_in_paraview.py without fields")


def scripts(directory):
    """read_results.py reads what is there."""
    script = ROOT / "source/python/read_results.py"
    run = subprocess.run(["/usr/bin/python3", script, directory, "-o", directory / "picture.png"], capture_output=True, text=True)
    summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
    check(run.returncode == 0 and (directory / "picture.png").exists(), f"read_results.py: {run.stderr}")
    check(f"{summary['sizes']['cells']} cells" in run.stdout, "read_results.py: cells of the fields")
    check(f"{summary['events']['total']} events" in run.stdout, "read_results.py: events")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run_with_pictures(folder / "run")
        scripts(folder / "run")
        limit_load(folder / "limit")
        sweep(folder / "sweep")
        refused(folder / "refused")
        later_run_removes_the_report(folder / "run")
    print("\n".join(complaints[:40]) or "all reports are as they should be")
    sys.exit(1 if complaints else 0)


main()
