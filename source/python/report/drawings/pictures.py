# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Pictures of the deformed bodies and of the joints at the end of the loads."""

import os

import matplotlib
import numpy
from matplotlib.lines import Line2D

from fuga_results import STATE_COLOURS, STATE_MARKERS, STATE_OF_CODE
from report.drawings.figures import MARKED_ELEMENTS, WIDTH, mark_every, new_figure, to_figure
from report.text.words import describe, end_of_loads

TALLEST, LOWEST = 3.1, 1.7  # inches: two on a printed page; room for a scale of colours
SHOWN_DISPLACEMENT = 0.06  # largest drawn displacement, as share of the size of the model
CELLS_WITH_EDGES = 800  # edges of more would cover a stress


class NoPictures(Exception):
    """The reason why there are none, in words."""


def plane_axes(view, results, right=0.1, top=0.1):
    """Axes of the shape of a part of the plane; `right` and `top`: inches beside them."""
    left, bottom = 0.65, 0.5
    scale = min((WIDTH - left - right) / view.width, TALLEST / view.height)
    figure = new_figure(max(scale * view.height + bottom + top, LOWEST))
    size = figure.get_size_inches()
    axes = figure.add_axes((left / size[0], bottom / size[1], scale * view.width / size[0], scale * view.height / size[1]))
    axes.grid(False)
    for side in axes.spines.values():
        side.set_visible(False)
    view.show(axes)
    axes.set_autoscale_on(False)
    axes.set_xlabel(f"x [{results.unit('x')}]")
    axes.set_ylabel(f"y [{results.unit('y')}]")
    return figure, axes


class Fields:
    """Bodies and joints at the end of the loads. Raises NoPictures if the run wrote none."""

    def __init__(self, results):
        if not os.path.exists(os.path.join(results.directory, "bodies.pvd")):
            raise NoPictures("This run wrote no fields (Output/Fields = never), so there are no pictures of the bodies.")
        from field_rendering import read_grid

        self.t = end_of_loads(results)
        self.bodies, self.joints = (read_grid(results.field_file(name, self.t)) for name in ("bodies", "joints"))


class _PlanePictures:
    def __init__(self, results, fields):
        import field_rendering

        self._render, self._results = field_rendering, results
        self._bodies, self._joints = fields.bodies, fields.joints
        self._where = describe(results, fields.t)
        self._whole = field_rendering.default_view(self._bodies)
        moved = numpy.abs(field_rendering.array_of(self._bodies, "displacement")).max()
        size = max(self._whole.width, self._whole.height)
        self._factor = field_rendering.round_down(SHOWN_DISPLACEMENT * size / moved) if moved > 0.0 else 1.0

    def stress(self, array, name, colours, text):
        if array not in self._render.array_names(self._bodies):
            return None
        figure, axes = plane_axes(self._whole, self._results, right=1.25)
        box = axes.get_position().bounds
        limits = self._render.colour_range(self._render.array_of(self._bodies, array), colours == "RdBu_r")
        self._render.draw_stress(axes, self._bodies, array, limits, colours, self._factor,
                                 self._bodies.GetNumberOfCells() <= CELLS_WITH_EDGES)
        if colours == "RdBu_r":
            self._render.draw_contour(axes, self._bodies, "sum_of_principal", 0.0, self._factor)
        self._render.draw_joints(axes, self._bodies, self._joints, self._factor, self._whole.height)
        scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), colours)
        bar = figure.colorbar(scale, extend="both",
                              cax=figure.add_axes((box[0] + box[2] + 0.02, box[1], 0.02, 0.96 - box[1])))
        bar.set_label(f"{name} [{self._results.unit('pressure')}]")
        bar.outline.set_visible(False)
        return to_figure(figure, f"{text}, {self._where}. Displacements are drawn {self._factor:g} times. Colours of the "
                                 "joint lines: states of the elements. The map leaves out the highest and lowest half per "
                                 "cent of the nodes: stresses at corners grow with every refinement.")

    def principal_stress(self):
        """That of larger magnitude, with its sign: the sign of the sum of both."""
        if not {"principal_stress_1", "principal_stress_2"} <= set(self._render.array_names(self._bodies)):
            return None
        first, second = (self._render.array_of(self._bodies, f"principal_stress_{k}") for k in (1, 2))
        self._render.add_array(self._bodies, "signed_principal",
                               numpy.where(numpy.abs(first) >= numpy.abs(second), first, second))
        self._render.add_array(self._bodies, "sum_of_principal", self._render.averaged(self._bodies, first + second))
        return self.stress("signed_principal", "principal stress, tension +", "RdBu_r",
                           "Principal stress in the plane of larger magnitude, with its sign (tension positive; black line: "
                           "change of sign)")

    def joint_states(self):
        if self._joints.GetNumberOfCells() == 0:
            return None
        points = self._render.points_of(self._joints)[:, :2]
        figure, axes = plane_axes(_joint_view(self._render.View, points, self._whole), self._results, top=0.4)
        self._render.draw_cells(axes, self._bodies, self._factor, "#eeeeee", "#b0b0b0")
        sides = self._render.draw_joints(axes, self._bodies, self._joints, self._factor, self._whole.height)
        codes = self._render.array_of(self._joints, "state").round().astype(int)
        # The ends of neighbouring faces are one node.
        _, first = numpy.unique(sides[0].round(9), axis=0, return_index=True)
        handles = []
        for code in sorted(set(codes)):
            state = STATE_OF_CODE[code]
            nodes = first[codes[first] == code]
            if len(first) > MARKED_ELEMENTS:
                nodes = nodes[::mark_every(len(first))]
            look = {"marker": STATE_MARKERS[state], "linestyle": "", "markerfacecolor": STATE_COLOURS[state],
                    "markeredgecolor": "black", "markersize": 6, "markeredgewidth": 0.8}
            for side in sides:
                axes.plot(side[nodes, 0], side[nodes, 1], **look)
            handles.append(Line2D([], [], label=state if state != "bonded" else "no element", **look))
        figure.legend(handles=handles, loc="upper left", ncols=4)
        return to_figure(figure, f"The joints, {self._where}: both sides of each joint with the states of its elements. "
                                 f"Displacements are drawn {self._factor:g} times.")


def _joint_view(view, points, whole):
    """The surroundings of the joints, neither a strip nor a column, inside the picture of the whole."""
    low, high = points.min(axis=0), points.max(axis=0)
    size = 1.25 * (high - low).max()
    width, height = numpy.maximum(1.25 * (high - low), [0.7 * size, 0.45 * size])
    x, y = 0.5 * (low + high)
    return view((max(x - width / 2, whole.left), min(x + width / 2, whole.right),
                 max(y - height / 2, whole.bottom), min(y + height / 2, whole.top)))


def plane_pictures(results, fields):
    """By name: figures of the bodies in the plane; None where the fields lack an array."""
    made = _PlanePictures(results, fields)
    return {"mises": made.stress("von_mises_stress", "von Mises stress", "viridis", "Von Mises stress"),
            "principal": made.principal_stress(), "joints": made.joint_states()}
