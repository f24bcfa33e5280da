#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Reports of small runs: a run with pictures, a limit load without fields, many joints, a block in space, a strength reduction, a
sweep; what is refused.

usage: report.py FUGA

The pages have to be HTML whose elements close, with every section in its order, nothing from the network, SVG that an XML
parser reads, and the numbers of the CSV files and of summary.json, rounded to four digits. The limit load is the closed form: the block of 20 m x 40 m
of 24 kN/m^3 with f = 0.2 slides when the water on 40 m reaches the factor 0.2 * 19200 / (9.81 * 40^2 / 2).
"""
import csv
import html.parser
import json
import math
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

FUGA = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[2]
VOID = {"meta", "br", "hr", "img", "link", "input"}
RUN_SECTIONS = ["stresses", "model", "joints", "resultants", "safety", "load", "shear", "levels", "displacements", "pictures",
                "states", "paths", "energy", "certificate", "remarks", "sizes", "parameters", "events", "files"]
SHORT_SECTIONS = ["stresses", "model", "joints", "safety", "load", "pictures"]
SPACE_SECTIONS = [name for name in RUN_SECTIONS if name not in ("shear", "levels", "displacements", "paths")]
SHOWN = 0.5e-3  # half a unit of the fourth digit, at worst that of 1.000
SUPERSCRIPTS = str.maketrans("\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079", "-0123456789")
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


class Page(html.parser.HTMLParser):
    """Tables by id as rows of texts, ids, addresses; complains of elements that do not close."""

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
            self._table[-1].append("")

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
            self._table[-1][-1] += data
        self.words += data


def number_of(text):
    """A number as the report writes it: minus signs, powers of ten."""
    mantissa, _, exponent = text.replace("\u2212", "-").replace("\u221e", "inf").replace("\u2013", "nan").partition("\u00b710")
    return float(f"{mantissa}e{exponent.translate(SUPERSCRIPTS)}" if exponent else mantissa)


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(file)]


def same(text, expected, what, shown_to=SHOWN, rounding=0.0):
    """Rounded, with no more digits than an engineer reads; 0 for what is rounding."""
    shown = number_of(text)
    check(shown == expected or abs(shown - expected) <= shown_to * abs(expected) or (shown == 0.0 and abs(expected) < rounding)
          or (math.isnan(shown) and math.isnan(expected)), f"{what}: shows {text} for {expected!r}")
    digits = re.sub(r"^\u2212?0\.0*|\u00b710.*|[^0-9]", "", text)
    check(len(digits.rstrip("0")) <= 4, f"{what}: {text} has too many digits")


def read_page(directory, sections, file="report.html"):
    text = (directory / file).read_text(encoding="utf-8")
    page = Page(text, directory.name)
    order = [name for name in page.ids if name in sections]
    check(order == sections, f"{directory.name}: sections {order}")
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
        head, words, *body = page.tables[f"resultants-{k}"]
        shown = [number_of(cell.removeprefix("t = ")) for cell in head[2:]]
        check(1 <= len(shown) <= 6, f"{len(shown)} levels")
        check(abs(shown[-1] - float(resultants[-1]["t"])) <= SHOWN, "the last level is not among those shown")
        check(all(words[2:]), "levels without a name")
        for name in ("N", "T", "M", "share open", "largest gap", "sliding safety", "certificate"):
            check(name in [row[0] for row in body], f"no row {name}")
        rows = [min((r for r in resultants if r["joint"] == joint), key=lambda r: abs(float(r["t"]) - t)) for t in shown]
        for name, unit, *cells in body:
            factor = 1e3 if unit == "mm" else 1.0
            # Two digits of a certificate tell enough.
            digits = 0.06 if name == "certificate" else SHOWN
            rounding = 1e-12 * max(abs(float(row["N"])) + abs(float(row["M"])) for row in rows)
            for row, cell in zip(rows, cells):
                same(cell, factor * float(row[name.replace(" ", "_")]), f"{joint}, {name}", digits, rounding)
    overview = {row[0]: dict(zip(page.tables["joints-table"][0], row)) for row in page.tables["joints-table"][1:]}
    check(sorted(overview) == sorted(joints), f"joints {overview}")
    for joint, cells in overview.items():
        last = [row for row in resultants if row["joint"] == joint and float(row["path_length"]) == 0.0
                and float(row["t"]) <= len(summary["parameters"]["Stages"])][-1]
        same(next(text for name, text in cells.items() if name.startswith("N [")), float(last["N"]), f"{joint}: N")
        same(cells["sliding safety"], float(last["sliding_safety"]), f"{joint}: sliding safety")
        same(cells["open [%]"], 100.0 * float(last["share_open"]), f"{joint}: open", 5e-3)
    least = [min([number_of(cells[name]) for name in ("sliding safety", "overturning safety")
                  if name in cells and number_of(cells[name]) >= 0.0], default=math.inf) for cells in overview.values()]
    check(least == sorted(least), f"the joints are not in the order of their safeties: {least}")
    for (name, _, value, within), (key, expected) in zip(page.tables["certificate-table"][1:],
                                                         summary["certificate"]["entries"].items()):
        check(name == key and within == "yes", f"certificate: {name}")
        same(value, expected, f"certificate: {name}", 0.06)
    check(len(page.tables["certificate-table"]) == 1 + len(summary["certificate"]["entries"]), "entries of the certificate")
    listed = page.tables["event-table"][1:]
    check(len(listed) == len(events) == summary["events"]["total"], f"{len(listed)} events listed")
    for row, event in zip(listed, events):
        same(row[1], float(event["t"]), f"t of event {event['event']}")
        check(row[-2] == event["from"] and row[-1] == event["to"], f"states of event {event['event']}")
    sizes = {row[0]: row[1] for row in page.tables["sizes-table"]}
    for name, value in summary["sizes"].items():
        check(sizes[name.replace("_", " ")] == str(value), f"size: {name}")
    check(f"Exit code {summary['exit_code']}." in page.words, "the exit code")
    check(summary["title"] in page.words, "the title")


def fuga(*arguments):
    return subprocess.run([FUGA, *map(str, arguments)], capture_output=True, text=True)


def with_monitors(folder, name="paper_2_linear", crest="0, 12", heel=None):
    """A copy of a parameter file with a point, and with another one that has stress."""
    text = (ROOT / f"parameters/{name}.prm").read_text(encoding="utf-8").replace("../meshes", str(ROOT / "meshes"))
    copy = folder / "monitored.prm"
    copy.write_text(text + f"\nsubsection Monitors\nsubsection crest\nset Point = {crest}\nend\n"
                    + (f"subsection heel\nset Point = {heel}\nset Stress = true\nend\n" if heel else "") + "end\n", encoding="utf-8")
    return copy


def check_monitors(page, directory):
    rows = rows_of(directory / "monitors.csv")
    for k, (monitor, n_rows) in enumerate((("crest", 2), ("heel", 6))):
        head, *body = page.tables[f"monitor-{k}"]
        check(len(body) == n_rows, f"{monitor}: {len(body)} rows")
        for name, unit, *cells in body:
            factor = 1e3 if unit == "mm" else 1.0
            for title, cell in zip(head[2:], cells):
                t = number_of(title.removeprefix("t = "))
                source = min((r for r in rows if r["monitor"] == monitor), key=lambda r: abs(float(r["t"]) - t))
                value = factor * float(source[name.replace(" ", "_")])
                same(cell, value, f"{monitor}, {name} at {t}", rounding=1e-9)
    check("displacements of the monitors" in page.words, "the diagram of the monitors")


def run_with_pictures(directory):
    run = fuga(with_monitors(directory.parent, heel="0.5, 0.5"), "--quiet", "--output-dir", directory,
               "--set", "Output/Report=true", "--set", "Output/Fields=end", "--set", "Title=a < b & \"c\"")
    check(run.returncode == 0 and run.stdout == "", f"the run: {run.returncode} {run.stdout} {run.stderr}")
    sections = RUN_SECTIONS.copy()
    sections.insert(sections.index("safety"), "monitors")
    page = read_page(directory, sections)
    check_tables(page, directory)
    check_monitors(page, directory)
    brief = read_page(directory, SHORT_SECTIONS, "report_short.html")
    for one in (page, brief):
        check(re.search(r"Figure 1\.\s*Joint \u201cbase\u201d: normal stress", one.words) is not None, "the first figure")
        check(re.search(r"Figure 2\.\s*The model and its loads", one.words) is not None, "the second figure")
        for words in ("weight: weight", "push: pressure", "held in all directions", "held in x only"):
            check(words in one.words, f"the sketch lacks '{words}'")
    check("Done" in page.words and "3060" in page.words, "verdict and parameters of a run that is done")


def limit_load(directory):
    run = fuga(ROOT / "parameters/scene_g_f02.prm", "--quiet", "--output-dir", directory, "--set", "Output/Fields=never",
               "--set", "Mesh/File=../meshes/scene_g_9.msh", "--set", "Stages/water/Loads=water: 0.6*t",
               "--set", "Solver/Beyond limit load=arc length")
    check(run.returncode == 3, f"the run to the limit load: {run.returncode} {run.stderr}")
    report = fuga("report", directory)
    check(report.returncode == 0 and report.stdout.split() == [f"{directory}/report.html", f"{directory}/report_short.html"],
          f"report: {report}")
    page = read_page(directory, RUN_SECTIONS)
    check_tables(page, directory)
    expected = 0.2 * 24. * 20. * 40. / (9.81 * 40. ** 2 / 2.)
    check(f"water {expected:.4f}" in page.words, "the limit load in the verdict")
    check("limit load, mechanism sliding" in page.words, "the mechanism in the verdict")
    check("Beyond the limit load" in page.words, "the path beyond the limit load")
    check("wrote no fields" in page.words, "that there are no fields is not said")


def many_joints(directory):
    """Six joints: the tables have all of them, the least safe first, diagrams the first four. A screen sees what is done."""
    run = fuga(ROOT / "parameters/pier.prm", "--quiet", "--output-dir", directory, "--set", "Output/Fields=never")
    check(run.returncode == 0, f"the pier: {run.returncode} {run.stderr}")
    screen, writing = pty.openpty()
    report = subprocess.Popen([FUGA, "report", directory], stdout=writing)
    os.close(writing)
    said = b""
    try:
        while part := os.read(screen, 4096):
            said += part
    except OSError:  # the other end is closed
        pass
    check(report.wait() == 0 and b"drawing joint 'joint_" in said and said.rstrip().endswith(b"report_short.html"), f"said {said}")
    page = read_page(directory, RUN_SECTIONS)
    check_tables(page, directory)
    check("The 4 least safe of 6 joints." in page.words, "that not all joints are drawn")
    check(len(re.findall(r"Joint \u201cjoint_\d\u201d: normal stress", page.words)) == 4, "four joints are drawn")


def in_space(directory):
    run = fuga(with_monitors(directory.parent, "dam_block_3d", "1, 1, 5"), "--quiet", "--output-dir", directory,
               "--set", "Output/Fields=end", "--set", "Output/Report=true")
    check(run.returncode == 0, f"the block in space: {run.returncode} {run.stderr}")
    page = read_page(directory, SPACE_SECTIONS)
    check_tables(page, directory)
    head, *listed = page.tables["event-table"]
    heights = [row[[name.split(" ")[0] for name in head].index("z")] for row in listed]
    for text, event in zip(heights, rows_of(directory / "events.csv")):
        same(text, float(event["z"]), "z of an event")
    check("Monitor \u201ccrest\u201d at (1.000, 1.000, 5.000)" in page.words, "a monitor has no z")
    check("uz" in [row[0] for row in page.tables["monitor-0"]], "a monitor has no uz")
    check("Joint \u201cbase\u201d in its plane" in page.words, "the map of the joint")
    check("Von Mises stress of dam," in page.words, "the dam without the rock")


def strength_reduction(directory):
    """A block that slides: F = f N / T. The state found is named by it, in words and in the tables."""
    run = fuga(ROOT / "parameters/scene_g_f06.prm", "--quiet", "--output-dir", directory, "--set", "Output/Fields=never",
               "--set", "Mesh/File=../meshes/scene_g_9.msh", "--set", "Safety/Strength reduction=yes", "--set", "Output/Report=true")
    check(run.returncode == 0, f"the strength reduction: {run.returncode} {run.stderr}")
    page = read_page(directory, RUN_SECTIONS)
    check_tables(page, directory)
    name = f"F = {0.6 * 24. * 20. * 40. / (9.81 * 40. ** 2 / 2.):.3f}"
    check(page.tables["resultants-0"][1][-1] == name, f"the state is called {page.tables['resultants-0'][1][-1]}, not {name}")
    check(page.words.count(name) >= 4 and " % of 'strength" not in page.words, f"{name} stands nowhere")


def boundaries(directory):
    """The oriented faces of the block of 20 m x 40 m go all round it; the joint is 20 m long; names are those of the input."""
    rows = rows_of(directory / "boundaries.csv")
    corners = [[float(row[name]) for name in ("x1", "y1", "x2", "y2")] for row in rows]
    area = sum(0.5 * (x1 * y2 - x2 * y1) for row, (x1, y1, x2, y2) in zip(rows, corners) if row["body"] == "block")
    check(abs(area - 800.) < 1e-9, f"area of the block {area}")
    length = sum(math.hypot(x2 - x1, y2 - y1) for row, (x1, y1, x2, y2) in zip(rows, corners) if row["joint"] == "base")
    check(abs(length - 40.) < 1e-9, f"length of both sides of the joint {length}")
    parameters = json.loads((directory / "summary.json").read_text(encoding="utf-8"))["parameters"]
    names = {row["boundary"] for row in rows if not row["joint"]}
    check(names == set(parameters["Boundaries"]) | {"upstream"}, f"boundaries {names}")


def words():
    """Numbers as an engineer writes them, by hand; levels to which arrows are drawn out of the entries."""
    sys.path.insert(0, str(ROOT / "source/python"))
    from report.drawings.load_arrows import level_of  # pylint: disable=import-outside-toplevel
    from report.text.words import rounded  # pylint: disable=import-outside-toplevel

    for value, digits, text in ((7920.0000000000027, 4, "7920"), (-6353.3066, 4, "\u22126353"), (123456., 4, "123500"),
                                (0.99996, 4, "1.000"), (1.51e-14, 2, "1.5\u00b710\u207b\u00b9\u2074"), (0., 4, "0"),
                                (12345678., 3, "1.23\u00b710\u2077"), (math.inf, 4, "\u221e"), (37, 4, "37"), (0.000256, 4, "0.0002560")):
        check(rounded(value, digits) == text, f"{value!r} is written {rounded(value, digits)}, not {text}")
    for level, t, expected in (("1: 0; 2: 28", 1.5, 14.), ("1: 0; 2: 28", 0.5, 0.), ("1: 0; 2: 28", 3., 28.), ("H*(t - 1)", 1.5, 20.),
                               ("40", 0., 40.), ("if(t < 1, 2, 3)", 1., None)):
        check(level_of({"Level": level}, {"H": "40"}, t) == expected, f"level '{level}' at {t}")


def sweep(directory):
    run = fuga(ROOT / "parameters/scene_g_f02.prm", "--quiet", "--output-dir", directory,
               "--set", "Mesh/File=../meshes/scene_g_9.msh", "--set", "Stages/water/Loads=water: 0.6*t",
               "--set", "Sweep/Friction coefficient=0.1, 0.2, 0.3", "--set", "Sweep/Cohesion=0, 20",
               "--set", "Output/Report=true")
    check(run.returncode == 0, f"the sweep: {run.returncode} {run.stderr}")
    page = read_page(directory, ["limits", "variants", "files"])
    check(not (directory / "report_short.html").exists(), "a short report of a sweep")
    variants = rows_of(directory / "sweep.csv")
    table = page.tables["variants-table"][1:]
    check(len(table) == len(variants) == 6, f"{len(table)} variants")
    names = list(variants[0])
    for row, variant in zip(table, variants):
        same(row[names.index("t")], float(variant["t"]), f"t of variant {variant['variant']}")
        check(row[names.index("verdict")] == variant["verdict"], f"verdict of variant {variant['variant']}")


def laws(directory):
    """The tables of --plot-law have a page of their own, whether or not there are results beside them."""
    plotted = fuga(ROOT / "parameters/paper_3_cubic_root.prm", "--plot-law", "--output-dir", directory)
    check(plotted.returncode == 0 and f"fuga report {directory}" in plotted.stdout, f"--plot-law: {plotted}")
    report = fuga("report", directory)
    check(report.returncode == 0 and sorted(os.listdir(directory)) == ["law_base.csv", "laws.html"], f"report of laws: {report}")
    page = (directory / "laws.html").read_text(encoding="utf-8")
    for part in ("pressure [MPa]", "closure [mm]", "shear stress [MPa]", "tangent at zero", "limit"):
        check(part in page, f"laws.html has no '{part}'")
    read_page(directory, ["law-0"], "laws.html")


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
    for name in ("report.html", "report_short.html"):
        check(not (directory / name).exists(), f"{name} of an earlier run is still there")
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
        many_joints(folder / "joints")
        in_space(folder / "space")
        strength_reduction(folder / "reduced")
        boundaries(folder / "reduced")
        words()
        sweep(folder / "sweep")
        laws(folder / "laws")
        refused(folder / "refused")
        later_run_removes_the_report(folder / "run")
    print("\n".join(complaints[:40]) or "all reports are as they should be")
    sys.exit(1 if complaints else 0)


main()
