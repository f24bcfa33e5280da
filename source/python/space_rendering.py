# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Draws bodies in space as their outer faces, seen in parallel from upstream, front and above, onto matplotlib axes: those
behind first."""

import matplotlib
import numpy
from matplotlib.collections import PolyCollection
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from field_rendering import array_of, cells_of, colour_range, points_of, round_down

FROM = numpy.array((-1.0, -1.4, 0.9))  # where the eye is: upstream, in front and above
BEHIND = numpy.array((1.0, -1.4, 0.9))  # the same from downstream
LIGHT = numpy.array((0.3, 0.5, 1.1))  # where the light is, in parts of where the eye is
DARKEST = 0.75  # of a face turned away from the light
SHOWN_DISPLACEMENT = 0.05  # largest drawn displacement, as share of the size of the model
CELLS_WITH_EDGES = 4000


def magnification(bodies):
    """1, 2 or 5 times a power of ten."""
    points = points_of(bodies)
    moved = numpy.abs(array_of(bodies, "displacement")).max()
    return round_down(SHOWN_DISPLACEMENT * (points.max(axis=0) - points.min(axis=0)).max() / moved) if moved > 0.0 else 1.0


def _axes_of_view(eye):
    """Right, up and towards the eye."""
    towards = eye / numpy.linalg.norm(eye)
    right = numpy.cross((0.0, 0.0, 1.0), towards)
    right /= numpy.linalg.norm(right)
    return numpy.array((right, numpy.cross(towards, right), towards))


def projected(points, eye=FROM):
    """Positions on the picture and, last, towards the eye."""
    return numpy.asarray(points) @ _axes_of_view(eye).T


def outer_faces(bodies, shown=None):
    """Numbers of the points of the faces around the bodies, one array per number of corners. `shown`: numbers of bodies;
    without it all."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(bodies)
    surface.PassThroughPointIdsOn()
    surface.SetOriginalPointIdsName("point")
    surface.Update()
    faces = surface.GetOutput()
    original = array_of(faces, "point").astype(int)
    points, body = points_of(bodies), array_of(bodies, "body")
    size = numpy.abs(points).max()
    found = []
    for cells in cells_of(faces.GetPolys()):
        cells = original[cells]
        if shown is not None:
            cells = cells[numpy.isin(body[cells[:, 0]], list(shown))]
        # Cells share no points in the file: an inner face is there twice.
        keys = numpy.column_stack([(points[cells].mean(axis=1) / size).round(7), body[cells[:, 0]]])
        _, place, count = numpy.unique(keys, axis=0, return_inverse=True, return_counts=True)
        found.append(cells[count[place] == 1])
    return found


def draw_faces(axes, points, faces, colours, eye=FROM):
    """Faces (arrays of numbers of points) in their colours (arrays of RGB per face), those behind first; faces that look
    away are left out."""
    polygons, shades, depths = [], [], []
    light = eye * LIGHT
    light /= numpy.linalg.norm(light)
    for cells, colour in zip(faces, colours):
        corners = points[cells]
        normal = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, -1] - corners[:, 0])
        normal /= numpy.maximum(numpy.linalg.norm(normal, axis=1), 1e-300)[:, None]
        visible = normal @ eye > 1e-6
        shade = DARKEST + (1.0 - DARKEST) * numpy.clip(normal @ light, 0.0, 1.0)
        flat = projected(corners[visible], eye)
        polygons += list(flat[:, :, :2])
        depths.append(flat[:, :, 2].mean(axis=1))
        shades.append(numpy.asarray(colour)[visible, :3] * shade[visible, None])
    order = numpy.argsort(numpy.concatenate(depths))
    colours = numpy.concatenate(shades)[order]
    edges = len(order) <= CELLS_WITH_EDGES
    axes.add_collection(PolyCollection([polygons[k] for k in order], facecolors=colours,
                                       edgecolors=(0.2, 0.2, 0.2) if edges else colours, linewidths=0.2, rasterized=True))


def fit(axes, points, eye=FROM):
    """Shows all points in true proportions, without axes."""
    flat = projected(points, eye)
    low, high = flat.min(axis=0), flat.max(axis=0)
    margin = 0.03 * (high - low).max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.set_axis_off()


def figure_in_space(results, bodies, array, figure, shown=None):
    """Draws the deformed bodies, coloured by a scalar, from both sides into a figure; returns a caption. `shown`: numbers of
    the bodies that are drawn; without it all."""
    factor = magnification(bodies)
    points = points_of(bodies) + factor * array_of(bodies, "displacement")
    values, faces = array_of(bodies, array), outer_faces(bodies, shown)
    limits = colour_range(numpy.concatenate([values[cells].ravel() for cells in faces]), False)
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), "viridis")
    colours = [scale.to_rgba(values[cells].mean(axis=1)) for cells in faces]
    drawn = points[numpy.concatenate([cells.ravel() for cells in faces])]
    all_axes = figure.subplots(1, 2)
    for axes, eye in zip(all_axes, (FROM, BEHIND)):
        draw_faces(axes, points, faces, colours, eye)
        fit(axes, drawn, eye)
    figure.subplots_adjust(left=0.01, right=0.99, top=0.98, bottom=0.16, wspace=0.04)
    bar = figure.colorbar(scale, cax=figure.add_axes((0.25, 0.12, 0.5, 0.03)), extend="both", orientation="horizontal")
    bar.set_label(array.replace("_", " ") + (f" [{results.unit('pressure')}]" if "stress" in array else ""))
    return f"Seen from the left and from the right, in front and above; displacements are drawn {factor:g} times."
