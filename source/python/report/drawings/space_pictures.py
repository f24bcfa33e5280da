# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Pictures of a model in space: the bodies, and maps of each joint in its plane."""

import os

import matplotlib
import numpy
from matplotlib.collections import PolyCollection
from matplotlib.ticker import MaxNLocator

from fuga_results import STATE_COLOURS, STATE_OF_CODE
from report.drawings.boundaries import Boundaries, supports
from report.drawings.figures import WIDTH, new_figure, to_figure
from report.text.words import Length, describe


def _standing(results, bodies):
    """Numbers of the bodies that stand on others, and their names; None, and no names, if that are all."""
    import field_rendering

    path = os.path.join(results.directory, "boundaries.csv")
    if not os.path.exists(path):
        return None, []
    faces = Boundaries(results.directory)
    names = faces.standing([name for name, _ in supports(results.summary["parameters"])])
    if len(names) == len(faces.bodies):
        return None, []
    points, body = field_rendering.points_of(bodies), field_rendering.array_of(bodies, "body").astype(int)
    size = numpy.abs(points).max()
    keys = [tuple(place) for place in (points / size).round(6)]
    numbers = set()
    for name in names:
        corners = {tuple(place) for place in (faces.body(name).reshape(-1, 3) / size).round(6)}
        # A neighbour has the corners on the joint only.
        numbers.add(int(numpy.bincount([number for key, number in set(zip(keys, body)) if key in corners]).argmax()))
    return numbers, names


def space_pictures(results, fields):
    """By name: figures of the bodies."""
    from space_rendering import figure_in_space

    shown, names = _standing(results, fields.bodies)
    figure = new_figure(3.9)
    caption = figure_in_space(results, fields.bodies, "von_mises_stress", figure, shown)
    what = "Von Mises stress of " + (", ".join(names) if names else "the bodies")
    return {"bodies": to_figure(figure, f"{what}, {describe(results, fields.t)}. {caption}")}


def _frame(results, joint):
    """Directions of the plane of a joint: two rows."""
    rows = results.resultants.frame
    row = rows[rows["joint"] == joint].iloc[-1]
    normal, first = ([row[f"{name}_{c}"] for c in "xyz"] for name in ("normal", "t1"))
    return numpy.array([first, numpy.cross(normal, first)])


def _cells_of_joint(results, fields, joint):
    """Cells of the joint fields that belong to a joint, one array per number of corners."""
    import field_rendering

    points = field_rendering.points_of(fields.joints)
    size = numpy.abs(points).max()
    elements = results.joint_frame(joint).drop_duplicates("element")
    known = {(int(e), *numpy.round(numpy.array(place) / size, 6)) for e, *place in elements[["element", "x", "y", "z"]].to_numpy()}
    numbers = field_rendering.array_of(fields.joints, "element").round().astype(int)
    here = numpy.array([(number, *place) in known for number, place in zip(numbers, numpy.round(points / size, 6))])
    cells = [some[here[some].all(axis=1)] for some in field_rendering.cells_of(fields.joints.GetCells())]
    return points, [some for some in cells if len(some)]


def joint_maps(results, joint, fields):
    """Pressure, state and slip of a joint, seen along its normal; None where the fields do not tell it."""
    import field_rendering

    points, cells = _cells_of_joint(results, fields, joint)
    if not cells:
        return None
    flat = points @ _frame(results, joint).T
    used = flat[numpy.unique(numpy.concatenate([some.ravel() for some in cells]))]
    low, high = used.min(axis=0), used.max(axis=0)
    size = numpy.maximum(high - low, 1e-12)
    stacked = size[0] > 1.6 * size[1]
    height = (0.55 + (WIDTH - 2.0) * size[1] / size[0]) * 3 + 0.4 if stacked else 1.1 + (WIDTH / 3 - 0.5) * size[1] / size[0]
    figure = new_figure(min(max(height, 2.6), 7.6))
    figure.set_layout_engine("constrained")
    panels = figure.subplots(*((3, 1) if stacked else (1, 3)), sharex=True, sharey=True)
    where = "right" if stacked else "top"
    length = Length(results.unit("gap"))
    arrays = field_rendering.array_of
    slip = length.factor * numpy.hypot(arrays(fields.joints, "slip"), arrays(fields.joints, "slip2"))
    values = {f"pressure [{results.unit('pressure')}]": arrays(fields.joints, "pressure"), f"slip [{length.unit}]": slip}
    for axes, (label, value) in zip((panels[0], panels[2]), values.items()):
        scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0.0, max(value[c].max() for c in cells) or 1.0), "viridis")
        for some in cells:
            axes.add_collection(PolyCollection(flat[some], facecolors=scale.to_rgba(value[some].mean(axis=1)),
                                               edgecolors="white", linewidths=0.2))
        figure.colorbar(scale, ax=axes, location=where, shrink=0.9, ticks=MaxNLocator(4)).set_label(label)
    codes = arrays(fields.joints, "state").round().astype(int)
    for some in cells:
        panels[1].add_collection(PolyCollection(flat[some], facecolors="#f4f4f4", edgecolors="#cccccc", linewidths=0.3))
        for code in range(len(STATE_OF_CODE)):
            nodes = numpy.unique(some[codes[some] == code])
            panels[1].plot(*flat[nodes].T, "s", color=STATE_COLOURS[STATE_OF_CODE[code]], markersize=4.5)
    there = sorted({int(code) for some in cells for code in codes[some].ravel()})
    colours = matplotlib.colors.ListedColormap([STATE_COLOURS[STATE_OF_CODE[code]] for code in there])
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0.0, len(there)), colours)
    bar = figure.colorbar(scale, ax=panels[1], location=where, shrink=0.9, ticks=[k + 0.5 for k in range(len(there))])
    bar.set_ticklabels([STATE_OF_CODE[code] if STATE_OF_CODE[code] != "bonded" else "no element" for code in there])
    bar.set_label("state")
    for axes in panels:
        axes.set_xlim(low[0] - 0.02 * size[0], high[0] + 0.02 * size[0])
        axes.set_ylim(low[1] - 0.02 * size[1], high[1] + 0.02 * size[1])
        axes.set_aspect("equal")
        axes.grid(False)
    panels[-1].set_xlabel(f"along t1 [{results.unit('x')}]")
    panels[0].set_ylabel(f"along t2 [{results.unit('x')}]")
    return to_figure(figure, f"Joint \u201c{joint}\u201d in its plane, {describe(results, fields.t)}: contact pressure, states "
                             "of the elements, size of the slip.")
