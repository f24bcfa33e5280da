#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Runs the view_in_paraview.py of a run against a stand-in for paraview.simple that reads the files with VTK.

usage: paraview_script.py FUGA

The files it opens and the arrays it names have to exist, its four states are those of the program with the colours of
all other pictures, and the magnification it computes has to draw the largest displacement between 1/50 and 1/20 of the
size of the model (the steps 1, 2, 5, 10 are at most a factor 2.5 apart).
"""
import csv
import pathlib
import runpy
import subprocess
import sys
import tempfile
import types
import xml.etree.ElementTree as xml
from unittest import mock

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "source/python"))
from fuga_results import STATE_COLOURS  # noqa: E402

complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


class Array:
    def __init__(self, values):
        self.values = values.reshape(len(values), -1)

    def GetRange(self, component):
        values = (self.values ** 2).sum(axis=1) ** 0.5 if component == -1 else self.values[:, component]
        return float(values.min()), float(values.max())


class Fields:
    """A PVDReader: the last file of the collection."""

    def __init__(self, FileName, **_):
        check(pathlib.Path(FileName).is_file(), f"{FileName} is not there")
        entries = list(xml.parse(FileName).iter("DataSet"))
        self.TimestepValues = [float(entry.get("timestep")) for entry in entries]
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(pathlib.Path(FileName).parent / entries[-1].get("file")))
        reader.Update()
        self.grid, data = reader.GetOutput(), reader.GetOutput().GetPointData()
        self.PointData = {data.GetArrayName(i): Array(vtk_to_numpy(data.GetArray(i)))
                          for i in range(data.GetNumberOfArrays())}

    def UpdatePipeline(self, time):
        check(time == self.TimestepValues[-1], f"updated to {time}")

    def GetDataInformation(self):
        return types.SimpleNamespace(GetBounds=self.grid.GetBounds)


class Simple:
    """Stand-in for paraview.simple: what is not here is recorded and does nothing."""

    def __init__(self):
        self.recorded, self.readers, self.tables, self.warps = mock.MagicMock(), [], [], []

    def __getattr__(self, name):
        return getattr(self.recorded, name)

    def PVDReader(self, **options):
        self.readers.append(Fields(**options))
        return self.readers[-1]

    def CSVReader(self, FileName, **_):
        self.tables += FileName
        return mock.MagicMock()

    def WarpByVector(self, Input, Vectors, ScaleFactor, **_):
        check(Vectors[0] == "POINTS" and Vectors[1] in Input.PointData, f"warped by {Vectors}")
        low_x, high_x, low_y, high_y, _, _ = Input.grid.GetBounds()
        drawn = ScaleFactor * Input.PointData[Vectors[1]].GetRange(-1)[1] / max(high_x - low_x, high_y - low_y)
        check(0.02 <= drawn <= 0.05 * 1.00001, f"largest displacement drawn as {drawn} of the model")
        self.warps.append(Input)
        return mock.MagicMock()

    def ColorBy(self, _, array):
        names = {name for reader in self.readers for name in reader.PointData}
        check(array[0] == "POINTS" and array[1] in names, f"coloured by {array}")
        self.recorded.ColorBy(_, array)


def run_script(directory, arguments):
    simple = Simple()
    package = types.ModuleType("paraview")
    package.simple = simple
    with mock.patch.dict(sys.modules, {"paraview": package, "paraview.simple": simple}), \
            mock.patch.object(sys, "argv", ["view_in_paraview.py", *arguments]):
        runpy.run_path(str(directory / "view_in_paraview.py"))
    return simple


def check_script(directory):
    simple = run_script(directory, [])
    check(len(simple.readers) == 3 and len(simple.warps) == 1, f"{len(simple.readers)} collections opened")
    arrays = [call.args[1][1] for call in simple.recorded.ColorBy.call_args_list]
    check(arrays == ["von_mises_stress", "state"], f"coloured by {arrays}")
    colours = simple.recorded.GetColorTransferFunction.return_value
    check(colours.Annotations[::2] == ["0", "1", "2", "3"] and colours.Annotations[1:6:2] == ["open", "stick", "slip"],
          f"states {colours.Annotations}")
    expected = [int(colour[i:i + 2], 16) / 255. for colour in STATE_COLOURS.values() for i in (1, 3, 5)]
    check(len(colours.IndexedColors) == 12 and all(abs(a - b) < 0.002 for a, b in zip(colours.IndexedColors, expected)),
          f"colours {colours.IndexedColors}")
    check(len(simple.tables) == 1, "the events")
    with open(simple.tables[0], newline="", encoding="utf-8") as file:
        header = next(csv.reader(file))
    check({"t", "event"} <= set(header), f"columns of the events: {header}")
    check(not simple.recorded.SaveScreenshot.called, "a picture nobody asked for")
    check(run_script(directory, ["picture.png"]).recorded.SaveScreenshot.called, "no picture")


def main():
    with tempfile.TemporaryDirectory() as name:
        subprocess.run([sys.argv[1], str(ROOT / "parameters/paper_2_linear.prm"), "--quiet", "--output-dir", name,
                        "--set", "Output/Fields=end"], check=True)
        check_script(pathlib.Path(name))
    print("\n".join(complaints[:40]) or "view_in_paraview.py names what exists")
    sys.exit(1 if complaints else 0)


main()
