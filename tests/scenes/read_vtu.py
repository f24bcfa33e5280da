#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Reads the fields of a run with VTK's own readers and compares them with the tables of the same run.

usage: read_vtu.py FUGA

Expected: the arrays of doc/results.md; as many cells as summary.json says; joint values
equal to joint_history.csv within single precision (the files' type, 6e-8 of the largest); displacement zero
where the model is held; principal and von Mises stresses by their definition from the tensor.
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

ROOT = pathlib.Path(__file__).resolve().parents[2]
SINGLE = 1e-6  # single precision with a few operations
BODY_ARRAYS = ["displacement", "stress", "principal_stress_1", "principal_stress_2", "von_mises_stress", "body"]
JOINT_ARRAYS = ["gap", "closure", "slip", "shear_jump", "pressure", "shear", "utilisation", "state", "area", "dissipation"]
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def read_vtu(path):
    errors = []
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *arguments: errors.append(arguments))
    reader.SetFileName(str(path))
    reader.Update()
    check(not errors and reader.GetErrorCode() == 0, f"{path.name}: VTK cannot read it")
    return reader.GetOutput()


def arrays(grid):
    result = {}
    for data in (grid.GetPointData(), grid.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            result[data.GetArrayName(i)] = vtk_to_numpy(data.GetArray(i))
    return result


def collection(directory, name, levels):
    """Grids of a .pvd file, which must name one file per load level."""
    entries = xml.parse(directory / (name + ".pvd")).getroot().findall("./Collection/DataSet")
    times = [float(entry.get("timestep")) for entry in entries]
    check(len(times) == len(levels) and all(abs(a - b) < 1e-5 for a, b in zip(times, levels)),
          f"{name}.pvd: timesteps {times} instead of {levels}")
    return [read_vtu(directory / entry.get("file")) for entry in entries]


def near(a, b, scale, text):
    check(len(a) == len(b) and all(abs(x - y) <= SINGLE * scale for x, y in zip(a, b)), text)


def check_bodies(directory, summary, levels):
    for grid in collection(directory, "bodies", levels):
        found = arrays(grid)
        for name in BODY_ARRAYS:
            check(name in found, f"bodies: no array {name}")
        check(grid.GetNumberOfCells() == summary["sizes"]["cells"],
              f"bodies: {grid.GetNumberOfCells()} cells instead of {summary['sizes']['cells']}")
        if grid.GetNumberOfCells() == 0 or any(name not in found for name in BODY_ARRAYS):
            continue
        points = vtk_to_numpy(grid.GetPoints().GetData())
        u = found["displacement"]
        bottom = points[:, 1] < points[:, 1].min() + 1e-3
        check(bottom.any() and abs(u[bottom]).max() == 0., "bodies: the fixed bottom moves")
        check(u.shape[1] == 3 and abs(u).max() > 0., "bodies: no displacement vectors")
        stress = found["stress"].reshape(-1, 3, 3)
        scale = abs(stress).max()
        xx, yy, xy = stress[:, 0, 0], stress[:, 1, 1], stress[:, 0, 1]
        middle, radius = (xx + yy) / 2, ((xx - yy) ** 2 / 4 + xy ** 2) ** .5
        near(found["principal_stress_1"], middle + radius, 4 * scale, "bodies: principal stress 1")
        near(found["principal_stress_2"], middle - radius, 4 * scale, "bodies: principal stress 2")
        check(set(found["body"]) <= {0., 1.} and len(set(found["body"])) == 2, "bodies: body numbers")


def check_joints(directory, summary, levels, history, n_faces):
    for name, copies in (("joints", 1), ("joints_exploded", 2)):
        for grid, level in zip(collection(directory, name, levels), levels):
            found = arrays(grid)
            for array in JOINT_ARRAYS:
                check(array in found, f"{name}: no array {array}")
            check(grid.GetNumberOfCells() == copies * n_faces,
                  f"{name}: {grid.GetNumberOfCells()} cells instead of {copies * n_faces}")
            if grid.GetNumberOfCells() == 0 or any(array not in found for array in JOINT_ARRAYS):
                continue
            check(all(grid.GetCellType(i) == vtk.VTK_LINE for i in range(grid.GetNumberOfCells())), f"{name}: no lines")
            rows = [row for row in history if abs(float(row["t"]) - level) < 1e-9]
            points = vtk_to_numpy(grid.GetPoints().GetData())
            codes = {"open": 0, "stick": 1, "slip": 2}
            for array, column in (("gap", "gap"), ("slip", "slip1"), ("shear_jump", "jump_t1"), ("pressure", "pressure"),
                                  ("shear", "shear1"), ("area", "area"), ("state", "state")):
                values = [codes[row[column]] if column == "state" else float(row[column]) for row in rows]
                scale = max(map(abs, values)) or 1.
                for point, value in zip(points, found[array]):
                    nearest = min(range(len(rows)), key=lambda i: abs(float(rows[i]["x"]) - point[0]))
                    check(abs(values[nearest] - value) <= SINGLE * scale,
                          f"{name}: {array} at x = {point[0]} is {value} instead of {values[nearest]}")
            check(found["utilisation"].min() >= 0. and found["utilisation"].max() <= 1. + SINGLE, f"{name}: utilisation")
            check(found["dissipation"].min() >= 0. and found["closure"].min() >= 0. and found["gap"].min() >= 0.,
                  f"{name}: a negative dissipation, closure or gap")


def check_scene(fuga, file, n_faces):
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        subprocess.run([fuga, str(ROOT / "parameters" / file), "--quiet", "--output-dir", name], check=True)
        summary = json.loads((directory / "summary.json").read_text())
        with open(directory / "joint_history.csv", newline="") as text:
            history = [{key.split("[")[0]: value for key, value in row.items()} for row in csv.DictReader(text)]
        levels = sorted({float(row["t"]) for row in history})
        check(not any(math.isnan(level) for level in levels), "load levels")
        check_bodies(directory, summary, levels)
        check_joints(directory, summary, levels, history, n_faces)


def main():
    vtk.vtkObject.GlobalWarningDisplayOff()
    check_scene(sys.argv[1], "paper_2_linear.prm", 8)
    check_scene(sys.argv[1], "scene_g_rigid_f06.prm", 32)
    print("\n".join(sorted(set(complaints))[:40]) or "all fields are as the tables say")
    sys.exit(1 if complaints else 0)


main()
