# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Pictures of bodies in space: the deformed bodies, and the joints seen for themselves. Needs an X display."""

import matplotlib
import matplotlib.pyplot as plt
import numpy
from matplotlib.patches import Patch
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkRenderer

from field_rendering import (array_of, colour_range, flat_actor, lookup_table, pixels_of, points_of, read_grid,
                             surface_actor, x_display)
from fuga_results import STATE_COLOURS, STATE_OF_CODE

PIXELS = 1400
FROM = (-1.0, -1.4, 0.9)  # where the camera stands: upstream, in front and above
SHOWN_DISPLACEMENT = 0.05  # largest drawn displacement, as share of the size of the model


def magnification(bodies):
    """1, 2 or 5 times a power of ten."""
    points = points_of(bodies)
    moved = numpy.abs(array_of(bodies, "displacement")).max()
    wanted = SHOWN_DISPLACEMENT * (points.max(axis=0) - points.min(axis=0)).max() / moved if moved > 0.0 else 1.0
    power = 10.0 ** numpy.floor(numpy.log10(wanted))
    return max(step for step in (1.0, 2.0, 5.0) if step * power <= wanted * 1.000001) * power


def _joint_actor(joints, array, table, edges):
    joints.GetPointData().SetActiveScalars(array)
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(joints)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = flat_actor(mapper)
    actor.GetProperty().SetEdgeVisibility(edges)
    actor.GetProperty().SetEdgeColor(0.25, 0.25, 0.25)
    actor.GetProperty().SetLineWidth(0.4)
    return actor


def _render(actor, direction):
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(*direction)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    pixels = pixels_of(renderer, (PIXELS, PIXELS))
    drawn = (pixels < 255).any(axis=2)
    rows, columns = numpy.flatnonzero(drawn.any(axis=1)), numpy.flatnonzero(drawn.any(axis=0))
    return pixels[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]


def pictures_in_space(bodies_file, joints_file, array):
    """(pixels, limits of the colours, name) of the bodies and, with joints, of their pressures and states; and the factor
    of the displacements."""
    bodies, joints = read_grid(bodies_file), read_grid(joints_file)
    factor = magnification(bodies)
    limits = colour_range(array_of(bodies, array), False)
    found = []
    with x_display():
        actor = surface_actor(bodies, array, lookup_table(matplotlib.colormaps["viridis"], limits), factor)
        found.append((_render(actor, FROM), limits, array.replace("_", " ")))
        if joints.GetNumberOfCells() > 0:
            pressures = array_of(joints, "pressure")
            limits = (0.0, max(pressures.max(), 1e-300))
            actor = _joint_actor(joints, "pressure", lookup_table(matplotlib.colormaps["viridis"], limits), True)
            found.append((_render(actor, FROM), limits, "pressure"))
            states = lookup_table(matplotlib.colors.ListedColormap([STATE_COLOURS[s] for s in STATE_OF_CODE]),
                                  (-0.5, len(STATE_OF_CODE) - 0.5))
            found.append((_render(_joint_actor(joints, "state", states, True), FROM), None, "state"))
    return found, factor


def figure_in_space(results, array, t=None):
    """(figure, caption)"""
    found, factor = pictures_in_space(results.field_file("bodies", t), results.field_file("joints", t), array)
    figure, all_axes = plt.subplots(1, len(found), figsize=(4.2 * len(found), 4.6))
    unit = results.unit("pressure")
    for axes, (pixels, limits, name) in zip(numpy.atleast_1d(all_axes), found):
        axes.imshow(pixels, interpolation="antialiased")
        axes.set_axis_off()
        if limits is None:
            axes.legend(handles=[Patch(facecolor=STATE_COLOURS[s], label=s if s != "bonded" else "no element")
                                 for s in STATE_OF_CODE], ncol=2, frameon=False, loc="upper center",
                        bbox_to_anchor=(0.5, 0.0))
            axes.set_title("states of the joints", fontsize=10)
            continue
        scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), "viridis")
        figure.colorbar(scale, ax=axes, orientation="horizontal", shrink=0.8, pad=0.02).set_label(f"[{unit}]")
        axes.set_title(name, fontsize=10)
    return figure, (f"Seen from the left, the front and above; displacements of the bodies are drawn {factor:g} times; "
                    "joints where the undeformed lips are.")
