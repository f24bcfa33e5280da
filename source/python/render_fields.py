#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Picture of one load level: the deformed bodies with a stress, the states of the joint elements, and
beside them the stresses along one joint; of bodies in space the bodies alone (options --array, --t).

usage: render_fields.py RESULT_DIR [-o PICTURE.png] [options]; --help lists them

Needs VTK (Debian: python3-vtk9).
"""

import argparse
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy
from matplotlib.patches import Patch

from field_rendering import (View, array_of, colour_range, default_view, draw_joints, draw_stress, is_inside, points_of,
                             read_grid, round_down)
from fuga_results import STATE_COLOURS, STATES, Results
from space_rendering import figure_in_space

SHOWN_DISPLACEMENT = 0.2  # largest drawn displacement at most, as share of the height of the view


def draw_bodies(axes, bar_axes, view, limits, colour_map, label, factor, units):
    axes.set_aspect("equal")
    view.show(axes)
    axes.set_xlabel(f"x [{units['length']}]", labelpad=2)
    axes.set_ylabel(f"y [{units['length']}]", labelpad=2)
    axes.set_title(f"deformed shape, displacements drawn {factor:g} times", loc="left", fontsize=9)
    for side in axes.spines.values():
        side.set_visible(False)
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), colour_map)
    bar = axes.figure.colorbar(scale, cax=bar_axes, orientation="horizontal", extend="both")
    bar.set_label(f"{label} [{units['stress']}], tension positive")
    bar.outline.set_visible(False)


def shade_states(axes, profile):
    along, edges = profile["along"], profile.edges()
    for left, right, state in zip(edges, edges[1:], profile["state"]):
        axes.axvspan(left, right, color=STATE_COLOURS[state], alpha=0.28, linewidth=0)
    axes.set_xlim(along[0], along[-1])
    axes.axhline(0.0, color="black", linewidth=0.8)


def draw_profile(axes, profile, strength, units):
    along = profile["along"]
    for one in axes:
        shade_states(one, profile)
    axes[0].plot(along, profile["pressure"], color="black", linewidth=1.6)
    axes[0].set_ylabel(f"pressure [{units['stress']}]")
    axes[1].plot(along, profile["shear1"], color="black", linewidth=1.6, label="shear stress")
    axes[1].plot(along, strength, "--", color="black", linewidth=1.0, label="strength f p + c")
    if min(profile["shear1"]) < 0.0:
        axes[1].plot(along, -strength, "--", color="black", linewidth=1.0)
    axes[1].set_ylabel(f"shear [{units['stress']}]")
    axes[1].legend(frameon=False, fontsize=8, loc="upper left")
    axes[2].plot(along, 1e3 * profile["jump_n"], color="black", linewidth=1.6,
                 label="normal: gap +, closure \u2212")
    axes[2].plot(along, 1e3 * profile["jump_t1"], "--", color="black", linewidth=1.6,
                 label="tangential")
    axes[2].set_ylabel(f"jump [{units['length']}/1000]")
    axes[2].legend(frameon=False, fontsize=8)
    axes[2].set_xlabel(f"distance along the joint [{units['length']}]")


def compose(results, options, fields, view, limits, factor, path):
    profile = results.profile(options.joint, options.t)
    units = {"length": results.unit("x"), "stress": results.unit("pressure")}
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    figure = plt.figure(figsize=(11.0, 6.4))
    left = figure.add_gridspec(2, 1, left=0.065, right=0.505, top=0.885, bottom=0.085, hspace=0.22,
                               height_ratios=(1.0, 0.03))
    right = figure.add_gridspec(3, 1, left=0.585, right=0.985, top=0.885, bottom=0.085, hspace=0.13)
    plane = figure.add_subplot(left[0])
    draw_stress(plane, fields["bodies"], options.array, limits, options.map, factor)
    draw_joints(plane, fields["bodies"], fields["joints"], factor, view.height)
    draw_bodies(plane, figure.add_subplot(left[1]), view, limits, options.map, options.array.replace("_", " "), factor, units)
    axes = [figure.add_subplot(right[0])]
    axes += [figure.add_subplot(right[i], sharex=axes[0]) for i in (1, 2)]
    for one in axes[:2]:
        one.tick_params(labelbottom=False)
    draw_profile(axes, profile, results.strength(options.joint or results.joints[0], profile), units)
    figure.align_ylabels(axes)
    axes[0].legend(handles=[Patch(facecolor=STATE_COLOURS[s], label=s) for s in STATES], ncol=3,
                   frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0), borderaxespad=0.2)
    figure.suptitle(f"{results.title} \u2013 {results.describe_state(profile.t)}", fontsize=12, fontweight="bold",
                    x=0.02, y=0.975, ha="left")
    figure.savefig(path, dpi=140)


def parse(arguments):
    parser = argparse.ArgumentParser(description="Picture of one load level of a run of fuga.")
    parser.add_argument("directory", help="result directory")
    parser.add_argument("-o", "--output", help="picture; default: fields.png in the result directory")
    parser.add_argument("--array", default="principal_stress_2", help="scalar of bodies.pvd; default: %(default)s")
    parser.add_argument("--t", type=float, help="load time; default: the last")
    parser.add_argument("--joint", help="joint of the diagrams; default: the first")
    parser.add_argument("--view", type=float, nargs=4, metavar=("X0", "X1", "Y0", "Y1"), help="part to show")
    parser.add_argument("--factor", type=float, help="magnification of displacements")
    parser.add_argument("--map", default="viridis", help="matplotlib colour map; default: %(default)s")
    parser.add_argument("--diverging", action="store_true", help="centre the colours on zero")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    results = Results(options.directory)
    path = options.output or os.path.join(options.directory, "fields.png")
    if results.in_space:
        figure = plt.figure(figsize=(9.0, 6.4))
        caption = figure_in_space(results, read_grid(results.field_file("bodies", options.t)), options.array, figure)
        figure.suptitle(f"{results.title} \u2013 {results.describe_state(results.profile(None, options.t).t)}\n{caption}",
                        fontsize=9)
        figure.savefig(path, dpi=140)
        print(path)
        return
    fields = {name: read_grid(results.field_file(name, options.t)) for name in ("bodies", "joints")}
    view = View(options.view) if options.view else default_view(fields["bodies"])
    inside = is_inside(points_of(fields["bodies"]), view)
    moved = numpy.abs(array_of(fields["bodies"], "displacement")[inside]).max()
    factor = options.factor or (round_down(SHOWN_DISPLACEMENT * view.height / moved) if moved > 0.0 else 1.0)
    limits = colour_range(array_of(fields["bodies"], options.array)[inside], options.diverging)
    compose(results, options, fields, view, limits, factor, path)
    print(path)


if __name__ == "__main__":
    main(sys.argv[1:])
