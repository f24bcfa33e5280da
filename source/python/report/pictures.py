# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Pictures of the deformed bodies and of the joints at the last load level."""

import os
import subprocess
import sys
import tempfile

import matplotlib
import matplotlib.pyplot as plt
import numpy
from matplotlib.lines import Line2D

from fuga_results import STATE_COLOURS, STATE_MARKERS, STATE_OF_CODE
from report.figures import MARKED_ELEMENTS, WIDTH, mark_every, to_figure

TALLEST = 3.6  # inches: two on a printed page
MAPS = {"von Mises stress": "viridis", "principal stress": "RdBu_r"}


class NoPictures(Exception):
    """The reason why there are none, in words."""


def rendered(directory):
    """The arrays that report.render makes. Raises NoPictures."""
    if not os.path.exists(os.path.join(directory, "bodies.pvd")):
        raise NoPictures("This run wrote no fields (Output/Fields = never), so there are no pictures of the bodies.")
    scripts = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "pictures.npz")
        process = subprocess.run([sys.executable, "-m", "report.render", os.path.abspath(directory), path], cwd=scripts,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if process.returncode != 0:
            lines = process.stderr.strip().splitlines() or [f"the process ended with {process.returncode}"]
            raise NoPictures(f"The pictures of the bodies could not be drawn: {lines[-1]}")
        with numpy.load(path) as arrays:
            return dict(arrays)


def _axes(extent, results, right=0.1, top=0.1):
    """Axes of the shape of a part of the plane; `right` and `top`: inches beside them."""
    left, bottom = 0.65, 0.5
    width, height = extent[1] - extent[0], extent[3] - extent[2]
    scale = min((WIDTH - left - right) / width, TALLEST / height)
    figure = plt.figure(figsize=(WIDTH, scale * height + bottom + top))
    size = figure.get_size_inches()
    box = left / size[0], bottom / size[1], scale * width / size[0], scale * height / size[1]
    axes = figure.add_axes(box)
    axes.grid(False)
    for side in axes.spines.values():
        side.set_visible(False)
    axes.set_xlabel(f"x [{results.unit('x')}]")
    axes.set_ylabel(f"y [{results.unit('y')}]")
    return figure, axes, box


def _stress_picture(results, arrays, name, where):
    extent, limits = arrays["extent"], arrays[name + " limits"]
    figure, axes, box = _axes(extent, results, right=1.25)
    axes.imshow(arrays[name], extent=extent, interpolation="antialiased", aspect="auto")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), MAPS[name])
    bar = figure.colorbar(scale, extend="both", cax=figure.add_axes((box[0] + box[2] + 0.02, box[1], 0.02, box[3])))
    signs = ", tension +" if name == "principal stress" else ""
    bar.set_label(f"{name} [{results.unit('pressure')}]{signs}")
    bar.outline.set_visible(False)
    text = {"von Mises stress": "Von Mises stress",
            "principal stress": "Principal stress in the plane of larger magnitude, with its sign (tension positive; black "
                                "line: change of sign)"}[name]
    return to_figure(figure, f"{text}, {where}. Displacements are drawn {arrays['factor']:g} times. Colours of the joint "
                             "lines: states of the elements. The map leaves out the highest and lowest half per cent of the "
                             "nodes: stresses at corners grow with every refinement.")


def _joint_picture(results, arrays, where):
    extent = arrays["joints extent"]
    figure, axes, _ = _axes(extent, results, top=0.4)
    axes.imshow(arrays["joints"], extent=extent, interpolation="antialiased", aspect="auto")
    codes = arrays["states"].round().astype(int)
    # The ends of neighbouring faces are one node.
    _, first = numpy.unique(arrays["lips"][0].round(9), axis=0, return_index=True)
    handles = []
    axes.autoscale(False)
    for code in sorted(set(codes)):
        state = STATE_OF_CODE[code]
        nodes = [node for node in first if codes[node] == code]
        if len(first) > MARKED_ELEMENTS:
            nodes = nodes[::mark_every(len(first))]
        look = {"marker": STATE_MARKERS[state], "linestyle": "", "markerfacecolor": STATE_COLOURS[state],
                "markeredgecolor": "black", "markersize": 6, "markeredgewidth": 0.8}
        for lip in arrays["lips"]:
            axes.plot(lip[nodes, 0], lip[nodes, 1], clip_on=False, **look)
        handles.append(Line2D([], [], label=state if state != "bonded" else "no element", **look))
    figure.legend(handles=handles, loc="upper left", ncols=4)
    return to_figure(figure, f"The joints, {where}: both sides of each joint with the states of its elements. "
                             f"Displacements are drawn {arrays['factor']:g} times.")


def _picture_in_space(results):
    if not os.path.exists(os.path.join(results.directory, "bodies.pvd")):
        raise NoPictures("This run wrote no fields (Output/Fields = never), so there are no pictures of the bodies.")
    from space_rendering import figure_in_space
    figure, caption = figure_in_space(results, "von_mises_stress")
    where = results.describe_time(results.levels[-1])
    return to_figure(figure, f"Von Mises stress of the bodies, pressures and states of the joints, {where}. {caption}")


def pictures(results):
    """Figures of the last load level. Raises NoPictures."""
    if results.in_space:
        return [_picture_in_space(results)]
    arrays = rendered(results.directory)
    where = results.describe_time(results.levels[-1])
    found = [_stress_picture(results, arrays, name, where) for name in MAPS if name in arrays]
    return found + ([_joint_picture(results, arrays, where)] if "joints" in arrays else [])
