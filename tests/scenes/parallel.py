#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Runs scenes on one process and on several: the results have to be those of one process.

usage: parallel.py FUGA [small | large | iterative]

Expected: the same exit code and the same events (kind, joint, element, order); every number of the tables, of
summary.json and of a sweep within 1e-9 of the largest of its column (what two orders of summation leave, with the
condition of these scenes, is 1e-12); certificates below their bound; the fields of bodies.pvd, joined from their
pieces by VTK's own reader, within single precision (the files' type) of the file of one process, cell by cell. A
wrong input: exit code 1, one message, and no process waits for another.
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import vtk
from vtk.util.numpy_support import vtk_to_numpy

from launcher import run as fuga

ROOT = pathlib.Path(__file__).resolve().parents[2]
NEAR = 1e-9
SINGLE = 2.4e-7  # two units in the last place of single precision
complaints = []

ITERATIVE = ["Solver/Bodies=iterative"]
MATRIX_FREE = ["Solver/Bodies=iterative matrix-free", "Solver/Follow=stage ends"]
FEW_LEVELS = ["Stages/reservoir/Levels=1", "Solver/Load knots=1"]

# Name, parameter file, entries that are set, numbers of processes.
SMALL = [
    ("Q1", "paper_2_linear.prm", [], (2,)),
    ("P1", "paper_2_linear.prm", ["Mesh/File=../meshes/s0_tri.msh"], (3,)),
    ("refined", "paper_2_linear.prm", ["Mesh/Refinements=1", "Mesh/Polynomial degree=2"], (2,)),
    ("iterative", "paper_2_linear.prm", ITERATIVE, (2,)),
]
LARGE = [
    ("Q1", "paper_2_linear.prm", [], (3,)),
    ("Q2", "paper_2_linear.prm", ["Mesh/Polynomial degree=2"], (2,)),
    ("law (9)", "paper_3_cubic_root.prm", [], (2,)),
    ("limit load", "scene_g_f02.prm", [], (2,)),
    ("several joints", "pier.prm", [], (2,)),
    ("crossing joints", "arch.prm", [], (2,)),
    ("construction in stages", "anchor.prm", [], (2,)),
    ("uplift", "dam.prm", [], (2, 3)),
    ("target accuracy", "punch_adaptive.prm", [], (2,)),
    ("P1 refined", "paper_2_linear.prm", ["Mesh/File=../meshes/s0_tri.msh", "Mesh/Refinements=1"], (2,)),
    ("in space", "dam_block_3d.prm", [], (2, 3)),
    ("target accuracy in space", "dam_block_3d.prm", ["Target accuracy/Quantity=contact pressure",
                                                      "Target accuracy/Largest number of rounds=2", *FEW_LEVELS], (2,)),
]
ITERATIVE_LARGE = [
    ("iterative", "scene_g_f06.prm", ITERATIVE, (3,)),
    ("matrix-free", "scene_g_f06.prm", MATRIX_FREE + ["Stages/water/Levels=1"], (2, 3)),
    ("iterative, crossing joints", "arch.prm", ITERATIVE, (2,)),
    ("iterative on hanging nodes", "punch_adaptive.prm", ITERATIVE + ["Target accuracy/Largest number of rounds=2"], (2,)),
    ("iterative in space", "dam_block_3d.prm", ITERATIVE + FEW_LEVELS, (2, 3)),
    ("matrix-free in space", "dam_block_3d.prm", MATRIX_FREE + FEW_LEVELS, (2, 3)),
]


def check(condition, text):
    if not condition:
        complaints.append(text)


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def family(name):
    """Columns that are components of one quantity have one size: what is zero by symmetry is so up to that."""
    quantity = name.split("[")[0].split()[-1].rstrip("0123456789n")
    return "force" if quantity in ("N", "T") else quantity


def compare_columns(one, other, text):
    """Columns of texts: words equal, numbers near."""
    scales = {}
    for name, column in one.items():
        finite = [abs(x) for x in map(number, column) if x is not None and math.isfinite(x)]
        scales[family(name)] = max([scales.get(family(name), 0.)] + finite)
    for name in one:
        a, b = list(map(number, one[name])), list(map(number, other[name]))
        if family(name) in ("certificate", "seconds"):
            continue
        scale = scales[family(name)]
        for x, y, u, v in zip(a, b, one[name], other[name]):
            if x is None or y is None or not math.isfinite(x) or not math.isfinite(y):
                check(u == v, f"{text}: {name}: {v} instead of {u}")
        for x, y in zip(a, b):
            if x is not None and y is not None and math.isfinite(x) and math.isfinite(y):
                check(abs(x - y) <= NEAR * scale, f"{text}: {name}: {y} instead of {x}")


def compare_tables(one, other, text):
    names = sorted(path.name for path in one.glob("*.csv"))
    check(names == sorted(path.name for path in other.glob("*.csv")), f"{text}: not the same tables")
    check("events.csv" in names or "sweep.csv" in names, f"{text}: no events")
    for name in names:
        columns = []
        for directory in (one, other):
            with open(directory / name, newline="") as file:
                rows = list(csv.DictReader(file))
            columns.append({key: [row[key] for row in rows] for key in rows[0]} if rows else {})
        lengths = [len(next(iter(c.values()), [])) for c in columns]
        check(lengths[0] == lengths[1] and list(columns[0]) == list(columns[1]),
              f"{text}: {name}: {lengths[1]} rows instead of {lengths[0]}, or other columns")
        if lengths[0] == lengths[1]:
            compare_columns(columns[0], columns[1], f"{text}: {name}")


def leaves(json_value, path=""):
    """Numbers and words of a JSON value by their paths."""
    if isinstance(json_value, dict):
        for key, value in json_value.items():
            yield from leaves(value, f"{path}/{key}")
    elif isinstance(json_value, list):
        for i, value in enumerate(json_value):
            yield from leaves(value, f"{path}/{i}")
    else:
        yield path, json_value


def compare_summaries(one, other, text, n_processes):
    # Costs, and what is zero but for rounding.
    apart = ("seconds", "memory_MB", "memory_of_processes_MB", "work", "iterations", "parameters", "parameter_file",
             "certificate")
    certificate = other["certificate"]
    check(certificate["worst"] <= certificate["bound"], f"{text}: certificate {certificate['worst']}")
    n = one["work"]["processes"], other["work"]["processes"]
    check(n == (1, n_processes) and len(other.get("memory_of_processes_MB", [0])) == n_processes, f"{text}: processes {n}")
    a, b = (dict(leaves({k: v for k, v in s.items() if k not in apart})) for s in (one, other))
    check(sorted(a) == sorted(b), f"{text}: summary.json has other entries")
    for path, value in a.items():
        if isinstance(value, float) and isinstance(b.get(path), float):
            check(abs(value - b[path]) <= NEAR * max(1e-3, abs(value)), f"{text}: {path}: {b[path]} instead of {value}")
        else:
            check(value == b.get(path), f"{text}: {path}: {b.get(path)} instead of {value}")


def read_grid(path):
    reader = vtk.vtkXMLPUnstructuredGridReader() if path.suffix == ".pvtu" else vtk.vtkXMLUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *arguments: errors.append(arguments))
    reader.SetFileName(str(path))
    reader.Update()
    check(not errors, f"{path.name}: VTK cannot read it")
    return reader.GetOutput()


def cells_of(grid):
    """By place and body of a cell, its arrays at its points; every cell has points of its own."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    data = grid.GetPointData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}
    body = arrays["body"] if "body" in arrays else vtk_to_numpy(grid.GetCellData().GetArray("body"))
    cells = {}
    for i in range(grid.GetNumberOfCells()):
        ids = grid.GetCell(i).GetPointIds()
        ids = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        owner = float(body[ids[0]] if "body" in arrays else body[i])
        cells[(points[ids].tobytes(), owner)] = {name: array[ids] for name, array in arrays.items()}
    check(len(cells) == grid.GetNumberOfCells(), "a cell is there twice")
    return cells


def compare_fields(one, other, text, n_processes):
    collections = [xml.parse(directory / "bodies.pvd").getroot().findall("./Collection/DataSet")
                   for directory in (one, other)]
    check(len(collections[0]) == len(collections[1]), f"{text}: not the same levels in bodies.pvd")
    entries = list(zip(*collections))
    check(entries[-1][1].get("file").endswith(".pvtu" if n_processes > 1 else ".vtu"), f"{text}: pieces of fields")
    for a, b in (entries[0], entries[-1]):
        cells, others = cells_of(read_grid(one / a.get("file"))), cells_of(read_grid(other / b.get("file")))
        check(sorted(cells) == sorted(others), f"{text}: {b.get('file')}: {len(others)} cells instead of {len(cells)}")
        names = next(iter(cells.values())).keys()
        scale = {name: max(abs(cell[name]).max() for cell in cells.values()) for name in names}
        scale.update((name, scale["stress"]) for name in names if "stress" in name)
        for key, cell in cells.items():
            for name in names if key in others else ():
                difference = abs(cell[name] - others[key][name]).max() if name in others[key] else math.inf
                check(difference <= SINGLE * scale[name], f"{text}: {b.get('file')}: {name} differs by {difference}")


def compare_runs(one, other, text, n_processes):
    summaries = [json.loads((directory / "summary.json").read_text()) for directory in (one, other)]
    compare_tables(one, other, text)
    compare_summaries(*summaries, text, n_processes)
    if (one / "bodies.pvd").exists():
        compare_fields(one, other, text, n_processes)
    for name in ("joints", "joints_exploded"):
        check(len(list(one.glob(name + "_0*.vtu"))) == len(list(other.glob(name + "_0*.vtu"))), f"{text}: {name}")


def check_scene(program, directory, name, file, entries, numbers):
    path = file if isinstance(file, pathlib.Path) else ROOT / "parameters" / file
    settings = [word for entry in entries for word in ("--set", entry)]
    serial = directory / f"{name} on 1".replace(" ", "_")
    alone = fuga(program, 1, path, *settings, "--output-dir", serial)
    check(alone.returncode in (0, 3), f"{name}: {alone.stderr}")
    for n in numbers if alone.returncode in (0, 3) else ():
        text = f"{name} on {n} processes"
        parallel = directory / text.replace(" ", "_")
        together = fuga(program, n, path, *settings, "--output-dir", parallel)
        check(together.returncode == alone.returncode, f"{text}: exit code {together.returncode}\n{together.stderr}")
        check(together.stdout.count("Verdict") == 1, f"{text}: {together.stdout.count('Verdict')} closing tables")
        if together.returncode == alone.returncode:
            compare_runs(serial, parallel, text, n)
    return serial


def check_tetrahedra(program, directory):
    """One block pressed and pushed along another, as it is and refined."""
    scene = {"Dimension": 3, "Mesh": {"File": str(ROOT / "meshes" / "patch_tet.msh")},
             "Bodies": {name: {"Young modulus": 1000., "Poisson ratio": 0.25} for name in ("lower", "upper")},
             "Joints": {"joint": {"Line": "joint", "Plus body": "upper", "Minus body": "lower", "Normal stiffness": 1e4,
                                  "Shear stiffness": 5e3, "Friction coefficient": 0.4}},
             "Boundaries": {"bottom": {"Fixed": "x, y, z"},
                            **{side: {"Fixed": "free"} for side in ("front", "right", "back", "left")}},
             "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": "1"},
                       "push": {"Type": "traction", "Boundaries": "top", "Value": "0.1*x; 0.1; 0"}},
             "Stages": {"press": {"Loads": "press: t"}, "push": {"Loads": "push: t", "Levels": 3}}}
    path = directory / "tetrahedra.json"
    path.write_text(json.dumps(scene, indent=1))
    check_scene(program, directory, "tetrahedra", path, [], (2,))
    check_scene(program, directory, "tetrahedra refined", path, ["Mesh/Refinements=1"], (3,))


def check_restart(program, directory):
    """A run of two processes to which stages are added is continued on one and on three."""
    text = (ROOT / "parameters" / "paper_2_linear.prm").read_text().replace("../meshes", str(ROOT / "meshes"))
    first, both = directory / "first.prm", directory / "both.prm"
    first.write_text(text)
    both.write_text(text.replace("set Levels = 10", "set Levels = 10\n  end\n  subsection back\n    set Loads = push: 1-1.7*t"))
    serial = check_scene(program, directory, "restart", both, [], ())
    for n in (1, 3):
        parallel = directory / f"restart_on_{n}"
        begin = fuga(program, 2, first, "--output-dir", parallel)
        end = fuga(program, n, both, "--output-dir", parallel, "--restart")
        check(begin.returncode == end.returncode == 0, f"restart on {n}: {begin.stderr}{end.stderr}")
        if begin.returncode == end.returncode == 0:
            compare_runs(serial, parallel, f"restart on {n}", n)


def check_sweep(program, directory):
    entries = ["Sweep/Friction coefficient=0.2, 0.4, 0.6", "Sweep/Cohesion=0, 0.01"]
    tables = []
    for n in (1, 2):
        results = directory / f"sweep_on_{n}"
        run = fuga(program, n, ROOT / "parameters" / "scene_g_f02.prm", "--output-dir", results,
                   *(word for entry in entries for word in ("--set", entry)))
        check(run.returncode == 0 and run.stdout.count("6 variants") == 1, f"sweep on {n}: {run.stdout}{run.stderr}")
        tables.append(results)
    compare_tables(*tables, "sweep")


def check_refused(program, text, message, *arguments):
    """Exit code 1, the message once. Open MPI adds that a process ended with another code than 0."""
    try:
        run = fuga(program, 2, *arguments)
    except subprocess.TimeoutExpired:
        check(False, f"{text}: hangs")
        return
    said = run.stderr + run.stdout
    check(run.returncode == 1 and said.count(message) == 1,
          f"{text}: exit code {run.returncode}, the message {said.count(message)} times\n{said}")


def check_refusals(program, directory):
    scene = ROOT / "parameters" / "paper_2_linear.prm"
    check_refused(program, "parameter", "Error:", scene, "--set", "Bodies/structure/Young modulus=-1")
    # An error of the first process alone, when all have condensed the bodies.
    (directory / "a_file").write_text("")
    check_refused(program, "no place for results", "cannot be made", scene, "--output-dir", directory / "a_file" / "out")


def check_more_refusals(program, directory):
    scene = ROOT / "parameters" / "paper_2_linear.prm"
    check_refused(program, "no file", "Error:", "nowhere.prm")
    check_refused(program, "command line", "--nonsense", scene, "--nonsense")
    check_refused(program, "mesh", "Error:", scene, "--set", "Mesh/File=no_mesh.msh")
    check_refused(program, "a body that nothing holds", "Error:", scene, "--set", "Boundaries/foundation_bottom/Fixed=free",
                  "--output-dir", directory / "free")
    check(not (directory / "free").exists(), "results of a wrong input")
    for words in (["--version"], ["--help"], ["--check", scene], ["--print-parameters"]):
        runs = [fuga(program, n, *words) for n in (1, 2)]
        check(runs[0].returncode == runs[1].returncode == 0 and
              runs[0].stdout.splitlines() == runs[1].stdout.splitlines(), f"{words[0]} says something else on two")


def main():
    vtk.vtkObject.GlobalWarningDisplayOff()
    program, label = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "small"
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        for scene in {"small": SMALL, "large": LARGE, "iterative": ITERATIVE_LARGE}[label]:
            check_scene(program, directory, *scene)
        if label == "small":
            check_refusals(program, directory)
        elif label == "large":
            check_tetrahedra(program, directory)
            check_restart(program, directory)
            check_sweep(program, directory)
            check_more_refusals(program, directory)
    print("\n".join(dict.fromkeys(complaints).keys()) if complaints else "several processes find what one finds")
    sys.exit(1 if complaints else 0)


main()
