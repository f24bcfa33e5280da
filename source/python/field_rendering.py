# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Reads the fields of one load level with VTK and draws those of bodies in the plane onto matplotlib axes."""

import matplotlib
import numpy
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.tri import Triangulation
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader

from fuga_results import STATE_COLOURS, STATE_OF_CODE

# Widths of the lines of the joint's sides and of the white around them, in points.
RIM, SIDE = 3.2, 1.9
# Stresses at corners grow with every refinement: the map covers all but these shares of the nodes.
CLIPPED = (0.5, 99.5)


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


def cells_of(cell_array):
    """Numbers of the points of all cells, as one array per number of points."""
    offsets = vtk_to_numpy(cell_array.GetOffsetsArray()).astype(int)
    points = vtk_to_numpy(cell_array.GetConnectivityArray()).astype(int)
    sizes = numpy.diff(offsets)
    return [points[offsets[:-1][sizes == size][:, None] + numpy.arange(size)] for size in numpy.unique(sizes)]


class View:
    """The part of the plane that is shown, in deformed coordinates."""

    def __init__(self, box):
        self.left, self.right, self.bottom, self.top = box
        self.width, self.height = self.right - self.left, self.top - self.bottom

    def show(self, axes):
        axes.set_xlim(self.left, self.right)
        axes.set_ylim(self.bottom, self.top)


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
    return low, high if high > low else low + 1.0


def round_down(factor):
    """The next smaller number of the sequence 1, 2, 5, 10 ..."""
    power = 10.0 ** numpy.floor(numpy.log10(factor))
    return float(max(step for step in (1.0, 2.0, 5.0) if step * power <= factor * (1.0 + 1e-12)) * power)


def deformed(bodies, factor):
    """Positions of the points, with displacements drawn `factor` times."""
    return points_of(bodies) + factor * array_of(bodies, "displacement")


def _triangulation(bodies, factor):
    points = deformed(bodies, factor)
    triangles = [cells[:, [0, k, k + 1]] for cells in cells_of(bodies.GetCells()) for k in range(1, cells.shape[1] - 1)]
    return Triangulation(points[:, 0], points[:, 1], numpy.concatenate(triangles))


def draw_stress(axes, bodies, array, limits, colour_map, factor, edges=True):
    """The deformed bodies coloured by a scalar, as pixels."""
    axes.tripcolor(_triangulation(bodies, factor), array_of(bodies, array), shading="gouraud", cmap=colour_map,
                   vmin=limits[0], vmax=limits[1], rasterized=True)
    if edges:
        draw_cells(axes, bodies, factor, "none", (0.25, 0.25, 0.25, 0.6))


def draw_cells(axes, bodies, factor, colour, edge_colour):
    """The deformed cells in one colour."""
    points = deformed(bodies, factor)[:, :2]
    for cells in cells_of(bodies.GetCells()):
        axes.add_collection(PolyCollection(points[cells], facecolor=colour, edgecolor=edge_colour, linewidth=0.25,
                                           rasterized=True))


def draw_contour(axes, bodies, array, value, factor):
    """The line on which an array has a value; what a diverging map loses in black and white."""
    lines = axes.tricontour(_triangulation(bodies, factor), array_of(bodies, array), levels=[value], colors="black",
                            linewidths=0.8)
    for line in lines.collections:
        line.set_rasterized(True)


def averaged(bodies, values):
    """The mean at each node of what the cells of a body say there."""
    points, body = points_of(bodies), array_of(bodies, "body")
    keys = numpy.column_stack([(points / numpy.abs(points).max()).round(7), body])
    _, node = numpy.unique(keys, axis=0, return_inverse=True)
    return (numpy.bincount(node, values) / numpy.bincount(node))[node]


def _displacements_by_body(bodies, positions, tolerance):
    """Of each position: a list of displacements per body; more than one at the nodes of a crack inside a body."""
    points, displacement, body = points_of(bodies), array_of(bodies, "displacement")[:, :2], array_of(bodies, "body")
    order = numpy.argsort(points[:, 0])
    first, last = (numpy.searchsorted(points[order, 0], positions[:, 0] + shift) for shift in (-tolerance, tolerance))
    for position, a, b in zip(positions, first, last):
        near = order[a:b]
        here = near[numpy.abs(points[near] - position).max(axis=1) < tolerance]
        found = {}
        for node in here[numpy.lexsort((here, body[here]))]:
            values = found.setdefault(body[node], [])
            if not any((displacement[node] == value).all() for value in values):
                values.append(displacement[node])
        yield found


def _faces(joints):
    """Numbers of the two points of each face of the joints."""
    return numpy.concatenate([cells[:, :2] for cells in cells_of(joints.GetCells())])


def side_displacements(bodies, joints, tolerance):
    """Displacements of the two sides at the points of the joints; equal at a tip or against a rigid obstacle.

    Where joints meet, the sides of a face are those of the two bodies that both its ends belong to.
    """
    positions = points_of(joints)
    by_body = list(_displacements_by_body(bodies, positions, tolerance))
    sides = numpy.zeros((2, len(positions), 2))
    for ends in _faces(joints):
        common = sorted(set.intersection(*(set(by_body[node]) for node in ends)))
        for node in ends:
            if len(common) >= 2:
                sides[:, node] = [by_body[node][one][0] for one in common[:2]]
            else:
                values = [value for found in by_body[node].values() for value in found]
                sides[:, node] = values[0], values[1 if len(values) > 1 else 0]
    return sides


def draw_joints(axes, bodies, joints, factor, height):
    """Both sides; each node colours the half of its faces that is next to it. White between and around. Returns the drawn
    positions of the two sides. `height`: that of the view."""
    if joints.GetNumberOfCells() == 0:
        return []
    positions, codes, faces = points_of(joints)[:, :2], array_of(joints, "state").round().astype(int), _faces(joints)
    colours = numpy.array([matplotlib.colors.to_rgb(STATE_COLOURS[name]) for name in STATE_OF_CODE])
    drawn = [positions + factor * side for side in side_displacements(bodies, joints, 1e-6 * height)]
    for side in drawn:
        centres = 0.5 * (side[faces[:, 0]] + side[faces[:, 1]])
        halves = numpy.concatenate([numpy.stack([side[faces[:, end]], centres], axis=1) for end in (0, 1)])
        states = codes[numpy.concatenate([faces[:, 0], faces[:, 1]])]
        axes.add_collection(LineCollection(halves, colors="white", linewidths=RIM, rasterized=True))
        axes.add_collection(LineCollection(halves, colors=colours[states], linewidths=SIDE, rasterized=True))
    return drawn
