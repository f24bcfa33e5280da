# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Draws the fields of one load level with VTK into arrays of pixels. Needs an X display: see x_display()."""

import contextlib
import os
import subprocess

import matplotlib
import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers the renderer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

from fuga_results import STATE_COLOURS, STATE_OF_CODE

# Widths of the lines of the lips, in pixels of a picture 1500 high.
RIM, LIP, REFERENCE_HEIGHT = 17.0, 10.0, 1500
# Stresses at corners grow with every refinement: the map covers all but these shares of the nodes.
CLIPPED = (0.5, 99.5)


@contextlib.contextmanager
def x_display():
    """A screen in memory, so that pictures come out the same with and without a screen of one's own."""
    reading, writing = os.pipe()
    try:
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24",
                                   "-nolisten", "tcp"], pass_fds=(writing,),
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    except FileNotFoundError:
        raise SystemExit("Pictures of the bodies need Xvfb: sudo apt install xvfb") from None
    os.close(writing)
    try:
        with os.fdopen(reading) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise SystemExit("Xvfb does not start: no pictures of the bodies can be drawn.")
        os.environ["DISPLAY"] = ":" + number
        yield
    finally:
        server.terminate()
        server.wait()


def read_grid(path):
    reader = vtkXMLPUnstructuredGridReader() if path.endswith(".pvtu") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()).astype(float)


def array_names(grid):
    return [grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())]


def array_of(grid, name):
    data = grid.GetPointData().GetArray(name)
    if data is None:
        raise SystemExit(f"There is no array '{name}'. There are: {', '.join(array_names(grid))}.")
    return vtk_to_numpy(data).astype(float)


def add_array(grid, name, values):
    data = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    data.SetName(name)
    grid.GetPointData().AddArray(data)


class View:
    """The part of the plane that is shown, in deformed coordinates."""

    def __init__(self, box):
        self.left, self.right, self.bottom, self.top = box
        self.width, self.height = self.right - self.left, self.top - self.bottom

    @property
    def extent(self):
        return self.left, self.right, self.bottom, self.top


def default_view(bodies, displacement_share=0.1):
    """The whole model, with a margin."""
    points = points_of(bodies)
    low, high = points.min(axis=0), points.max(axis=0)
    margin = displacement_share * (high - low)
    return View((low[0] - margin[0], high[0] + margin[0], low[1] - margin[1], high[1] + margin[1]))


def is_inside(points, view):
    return ((points[:, 0] >= view.left) & (points[:, 0] <= view.right)
            & (points[:, 1] >= view.bottom) & (points[:, 1] <= view.top))


def colour_range(values, diverging):
    low, high = numpy.percentile(values, CLIPPED)
    if diverging:
        high = max(abs(low), abs(high))
        low = -high
    return low, high


def lookup_table(colour_map, limits):
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, colour in enumerate(colour_map(numpy.linspace(0.0, 1.0, 256))):
        table.SetTableValue(i, *colour)
    table.SetRange(*limits)
    table.Build()
    return table


def deformed_surface(bodies, factor):
    bodies.GetPointData().SetActiveVectors("displacement")
    warp = vtkWarpVector()
    warp.SetInputData(bodies)
    warp.SetScaleFactor(factor)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputConnection(warp.GetOutputPort())
    return surface


def flat_actor(mapper):
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def surface_actor(bodies, array, table, factor, edges=True):
    """The deformed bodies, with the edges of the mesh; coloured by an array, or light grey without one."""
    if array:
        bodies.GetPointData().SetActiveScalars(array)
    # A port does not keep its filter alive; the mapper does once they are connected.
    surface = deformed_surface(bodies, factor)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    if array:
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    else:
        mapper.ScalarVisibilityOff()
    actor = flat_actor(mapper)
    actor.GetProperty().SetColor(0.93, 0.93, 0.93)
    actor.GetProperty().SetEdgeVisibility(edges)
    actor.GetProperty().SetEdgeColor(*(3 * [0.25 if array else 0.7]))
    actor.GetProperty().SetLineWidth(0.4)
    return actor


def averaged(bodies, values):
    """The mean at each node of what the cells of a body say there."""
    points, body = points_of(bodies), array_of(bodies, "body")
    keys = numpy.column_stack([(points / numpy.abs(points).max()).round(7), body])
    _, node = numpy.unique(keys, axis=0, return_inverse=True)
    return (numpy.bincount(node, values) / numpy.bincount(node))[node]


def contour_actor(bodies, array, value, factor, depth):
    """The line on which an array has a value; what a diverging map loses in black and white."""
    bodies.GetPointData().SetActiveScalars(array)
    surface = deformed_surface(bodies, factor)
    contour = vtkContourFilter()
    contour.SetInputConnection(surface.GetOutputPort())
    contour.SetValue(0, value)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(contour.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = flat_actor(mapper)
    actor.GetProperty().SetColor(0.0, 0.0, 0.0)
    actor.GetProperty().SetLineWidth(3.0)
    actor.SetPosition(0.0, 0.0, depth)
    return actor


def line_actor(points, lines, colours, width, depth):
    """Line segments with a colour each. `depth` lifts them above the bodies."""
    poly, cells, vtk_points = vtkPolyData(), vtkCellArray(), vtkPoints()
    for x, y in points:
        vtk_points.InsertNextPoint(x, y, depth)
    for a, b in lines:
        cells.InsertNextCell(2)
        cells.InsertCellPoint(a)
        cells.InsertCellPoint(b)
    poly.SetPoints(vtk_points)
    poly.SetLines(cells)
    rgb = numpy_to_vtk(numpy.array(colours, dtype=numpy.uint8), deep=True)
    poly.GetCellData().SetScalars(rgb)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(poly)
    actor = flat_actor(mapper)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().SetRenderLinesAsTubes(False)
    return actor


def _displacements_by_body(bodies, positions, tolerance):
    """Of each position: a list of displacements per body; more than one at the nodes of a crack inside a body."""
    points, displacement, body = points_of(bodies), array_of(bodies, "displacement")[:, :2], array_of(bodies, "body")
    for position in positions:
        here = numpy.flatnonzero(numpy.abs(points - position).max(axis=1) < tolerance)
        found = {}
        for node in here[numpy.argsort(body[here], kind="stable")]:
            values = found.setdefault(body[node], [])
            if not any((displacement[node] == value).all() for value in values):
                values.append(displacement[node])
        yield found


def lip_displacements(bodies, joints, tolerance):
    """Displacements of the two lips at the points of the joints; equal at a tip or against a rigid obstacle.

    Where joints meet, the lips of a face are those of the two bodies that both its ends belong to.
    """
    positions = points_of(joints)
    by_body = list(_displacements_by_body(bodies, positions, tolerance))
    lips = numpy.zeros((2, len(positions), 2))
    for cell in range(joints.GetNumberOfCells()):
        ids = joints.GetCell(cell).GetPointIds()
        ends = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        common = sorted(set.intersection(*(set(by_body[node]) for node in ends)))
        for node in ends:
            if len(common) >= 2:
                lips[:, node] = [by_body[node][one][0] for one in common[:2]]
            else:
                values = [value for found in by_body[node].values() for value in found]
                lips[:, node] = values[0], values[1 if len(values) > 1 else 0]
    return lips


def joint_actors(bodies, joints, factor, view, pixels):
    """Both lips; each node colours the half of its faces that is next to it. White between and around."""
    positions, state = points_of(joints), array_of(joints, "state")
    colour_of = [[int(255 * c) for c in matplotlib.colors.to_rgb(STATE_COLOURS[name])] for name in STATE_OF_CODE]
    scale = pixels / REFERENCE_HEIGHT
    actors = []
    for lip in lip_displacements(bodies, joints, 1e-6 * view.height):
        drawn = positions[:, :2] + factor * lip
        points, lines, colours = [], [], []
        for cell in range(joints.GetNumberOfCells()):
            ids = joints.GetCell(cell).GetPointIds()
            ends = ids.GetId(0), ids.GetId(1)
            centre = 0.5 * (drawn[ends[0]] + drawn[ends[1]])
            for node in ends:
                lines.append((len(points), len(points) + 1))
                points += [drawn[node], centre]
                colours.append(colour_of[int(round(state[node]))])
        white = [[255, 255, 255]] * len(lines)
        actors += [line_actor(points, lines, white, scale * RIM, 0.01 * view.height),
                   line_actor(points, lines, colours, scale * LIP, 0.02 * view.height)]
    return actors


def render(actors, view, pixels):
    """Pixels of the view, `pixels` high, first row on top."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    x, y = 0.5 * (view.left + view.right), 0.5 * (view.bottom + view.top)
    camera.SetFocalPoint(x, y, 0.0)
    camera.SetPosition(x, y, 10.0 * view.height)
    camera.SetParallelScale(0.5 * view.height)
    renderer.ResetCameraClippingRange()
    return pixels_of(renderer, (int(pixels * view.width / view.height), pixels))


def pixels_of(renderer, size):
    """What a renderer shows, first row on top."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    image = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1].copy()
    # The display may end before Python collects the window.
    window.Finalize()
    return image
