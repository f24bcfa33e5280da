# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Shows the results of the directory in which this file lies: the deformed bodies with their stress, the
joints with both lips apart and the states of their elements, the events as ticks and as a table.

usage: paraview --script=view_in_paraview.py           (in the directory of the results)
       pvpython view_in_paraview.py PICTURE.png        (without a window)
"""

import os
import sys

from paraview import simple

DIRECTORY = os.path.dirname(os.path.abspath(globals().get("__file__", "view_in_paraview.py")))
SHOWN_DISPLACEMENT = 0.05  # largest drawn displacement, as share of the size of the model
# Number, name and colour of the states, as in all other pictures.
STATES = (("0", "open", (0.769, 0.769, 0.769)), ("1", "stick", (0.0, 0.447, 0.698)),
          ("2", "slip", (0.902, 0.624, 0.0)), ("3", "no element", (0.0, 0.620, 0.451)))


def results(name):
    path = os.path.join(DIRECTORY, name)
    if not os.path.exists(path):
        raise SystemExit(f"{path} is missing. Start ParaView in the directory of the results.")
    return path


def magnification(bodies):
    """1, 2 or 5 times a power of ten."""
    low_x, high_x, low_y, high_y, low_z, high_z = bodies.GetDataInformation().GetBounds()
    moved = bodies.PointData["displacement"].GetRange(-1)[1]
    wanted = SHOWN_DISPLACEMENT * max(high_x - low_x, high_y - low_y, high_z - low_z) / moved if moved > 0.0 else 1.0
    power = 10.0 ** int(f"{wanted:e}".split("e")[1])
    return max(step for step in (1.0, 2.0, 5.0) if step * power <= wanted * 1.000001) * power


def show_bodies(view):
    bodies = simple.PVDReader(registrationName="bodies", FileName=results("bodies.pvd"))
    last = bodies.TimestepValues[-1] if hasattr(bodies.TimestepValues, "__len__") else bodies.TimestepValues
    bodies.UpdatePipeline(last)
    factor = magnification(bodies)
    deformed = simple.WarpByVector(registrationName=f"bodies, displacements {factor:g} times", Input=bodies,
                                   Vectors=["POINTS", "displacement"], ScaleFactor=factor)
    display = simple.Show(deformed, view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("POINTS", "von_mises_stress"))
    simple.GetColorTransferFunction("von_mises_stress").ApplyPreset("Viridis (matplotlib)", True)
    # Ready for use by ColorBy: compression blue, tension red, zero in the middle.
    for name in [f"principal_stress_{i}" for i in (1, 2, 3) if f"principal_stress_{i}" in bodies.PointData.keys()]:
        largest = max(abs(value) for value in bodies.PointData[name].GetRange(0))
        colours = simple.GetColorTransferFunction(name)
        colours.ApplyPreset("Cool to Warm", True)
        colours.RescaleTransferFunction(-largest, largest)
    display.SetScalarBarVisibility(view, True)
    simple.Show(simple.AnnotateTimeFilter(registrationName="load time", Input=bodies), view)
    _, _, _, _, low_z, high_z = bodies.GetDataInformation().GetBounds()
    return display, last, high_z > low_z


def show_joints(view):
    joints = simple.PVDReader(registrationName="joints, lips apart", FileName=results("joints_exploded.pvd"))
    display = simple.Show(joints, view)
    display.LineWidth = 8.0
    simple.ColorBy(display, ("POINTS", "state"))
    colours = simple.GetColorTransferFunction("state")
    colours.InterpretValuesAsCategories = 1
    colours.Annotations = [text for number, name, _ in STATES for text in (number, name)]
    colours.IndexedColors = [part for _, _, colour in STATES for part in colour]
    display.SetScalarBarVisibility(view, True)
    # Hidden, for diagrams and other colours: the joints where they are.
    simple.PVDReader(registrationName="joints", FileName=results("joints.pvd"))


def show_events(chart, sheet):
    events = simple.CSVReader(registrationName="events", FileName=[results("events.csv")])
    ticks = simple.Show(events, chart, "XYChartRepresentation")
    ticks.XArrayName = "t"
    ticks.UseIndexForXAxis = 0
    ticks.SeriesVisibility = ["event"]
    ticks.SeriesLineStyle = ["event", "0"]
    ticks.SeriesMarkerStyle = ["event", "2"]
    chart.ChartTitle = "Events: number against load time"
    chart.BottomAxisTitle = "load time t"
    chart.LeftAxisTitle = "event"
    if sheet:
        simple.Show(events, sheet, "SpreadSheetRepresentation")


def main(picture):
    simple.LoadPalette("WhiteBackground")
    bodies, joints = simple.CreateView("RenderView"), simple.CreateView("RenderView")
    chart = simple.CreateView("XYChartView")
    # A table of cells cannot be drawn without a window.
    sheet = None if picture else simple.CreateView("SpreadSheetView")
    simple.SetActiveView(None)
    layout = simple.CreateLayout("fuga")
    upper = layout.SplitVertical(0, 0.65)
    layout.SplitHorizontal(upper, 0.5)
    for view, place in ((bodies, 3), (joints, 4)):
        view.OrientationAxesVisibility = 0
        simple.AssignViewToLayout(view, layout, place)
    if sheet:
        layout.SplitHorizontal(2, 0.5)
        simple.AssignViewToLayout(sheet, layout, 6)
    simple.AssignViewToLayout(chart, layout, 5 if sheet else 2)

    surface, last, in_space = show_bodies(bodies)
    show_joints(joints)
    show_events(chart, sheet)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = last
    surface.RescaleTransferFunctionToDataRange(False, True)
    for view in (bodies, joints):
        view.InteractionMode = "3D" if in_space else "2D"
        if in_space:
            view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (-1.0, -1.4, 0.9), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)
        simple.ResetCamera(view)
    # Brings its tab to the front.
    simple.SetActiveView(bodies)
    simple.RenderAllViews()
    if picture:
        layout.SetSize(1600, 1200)
        simple.SaveScreenshot(picture, layout)


main(sys.argv[1] if len(sys.argv) == 2 and sys.argv[1].endswith(".png") else None)
