#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Pictures and table that compare three variants of the paper's test (its Fig. 2 b, c, d).

usage: plot_paper.py RESULTS_DIR VARIANT_1 VARIANT_2 VARIANT_3

Reads RESULTS_DIR/VARIANT_i and writes paper_contact_stresses and paper_relative_displacements
(.png and .svg) into RESULTS_DIR.
"""

import os
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

# The reader of results is installed with the program.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "source/python"))

from fuga_results import HATCHES, STATE_COLOURS, STATES, Results
from paper_quantities import MILLIMETRES, PaperQuantities, law_9_stiffening, percent

NAMES = ("1  rigid joint", "2  linear joint", "3  law (9), cubic root")
LINES = ("-", "--", ":")  # as in the paper: solid, dashed, dotted
WIDTHS = (1.5, 1.5, 2.4)
EDGE = 0.02  # room beside the base, as share of its length
PRESSURES_OF_INTEREST = (0.5, 2.0)  # MPa, the range of which the paper's test speaks


def style():
    plt.rcParams.update({"font.size": 9, "font.family": "DejaVu Sans", "axes.spines.top": False,
                         "axes.spines.right": False, "axes.grid": True, "grid.color": "#e4e4e4",
                         "grid.linewidth": 0.6, "svg.hashsalt": "fuga", "axes.axisbelow": True,
                         "hatch.linewidth": 0.8})


def draw_curves(axes, profiles, values_of, label):
    """One line per variant; the small ticks on the zero line are the contact elements."""
    axes.axhline(0.0, color="black", linewidth=0.8, zorder=2)
    axes.plot(profiles[0]["x"], [0.0] * len(profiles[0]), "|", color="black", markersize=6, zorder=2)
    for profile, line, width in zip(profiles, LINES, WIDTHS):
        axes.plot(profile["x"], values_of(profile), line, color="black", linewidth=width, zorder=3)
    axes.set_ylabel(label)


def draw_states(axes, profiles):
    """A row per variant, a box per contact element, as wide as the base it stands for."""
    for variant, profile in enumerate(profiles):
        x = profile["x"]
        edges = [x[0]] + [0.5 * (a + b) for a, b in zip(x, x[1:])] + [x[-1]]
        for left, right, state in zip(edges, edges[1:], profile["state"]):
            axes.barh(-variant, right - left, left=left, height=0.72, color=STATE_COLOURS[state],
                      edgecolor="white", linewidth=1.0, hatch=HATCHES[state])
    axes.set_yticks([-variant for variant in range(len(profiles))],
                    [name.split()[0] for name in NAMES[:len(profiles)]])
    axes.set_ylabel("state in\nvariant")
    axes.tick_params(left=False)
    axes.spines["left"].set_visible(False)
    axes.grid(False)


def picture(profiles, title, upper, lower, path):
    """Two diagrams and the states, one above the other. Returns the paths of the files."""
    figure, axes = plt.subplots(3, 1, figsize=(7.2, 7.0), sharex=True,
                                gridspec_kw={"left": 0.115, "right": 0.975, "top": 0.875, "bottom": 0.07,
                                             "hspace": 0.14, "height_ratios": (3.0, 3.0, 1.0)})
    figure.suptitle(title, x=0.115, y=0.985, ha="left", fontsize=11, fontweight="bold")
    draw_curves(axes[0], profiles, *upper)
    draw_curves(axes[1], profiles, *lower)
    draw_states(axes[2], profiles)
    axes[2].set_xlabel("distance along the base from the loaded side [m]", labelpad=3)
    axes[2].set_xlim(-EDGE * profiles[0]["x"][-1], (1.0 + EDGE) * profiles[0]["x"][-1])
    figure.align_ylabels(axes)

    lines = [Line2D([], [], color="black", linestyle=line, linewidth=width, label=name)
             for line, width, name in zip(LINES, WIDTHS, NAMES)]
    boxes = [Patch(facecolor=STATE_COLOURS[s], edgecolor="white", hatch=HATCHES[s], label=s) for s in STATES]
    place = {"frameon": False, "borderaxespad": 0.0, "handlelength": 2.4, "columnspacing": 1.4}
    figure.legend(handles=lines, loc="upper left", bbox_to_anchor=(0.115, 0.945), ncol=3, **place)
    figure.legend(handles=boxes, loc="upper left", bbox_to_anchor=(0.115, 0.917), ncol=3, **place)

    paths = [path + extension for extension in (".png", ".svg")]
    for one in paths:
        figure.savefig(one, dpi=160, metadata={"Date": None} if one.endswith("svg") else None)
    plt.close(figure)
    return paths


def plot_stresses(profiles, path):
    return picture(profiles, "Contact stresses along the base (Fig. 2 b of the paper)",
                   (lambda profile: profile["pressure"], "pressure p [MPa]"),
                   (lambda profile: profile["shear1"], "shear stress \u03c4 [MPa]"), path)


def plot_displacements(profiles, path):
    def in_millimetres(column):
        return lambda profile: [MILLIMETRES * value for value in profile[column]]
    return picture(profiles, "Relative displacements of the lips (Fig. 2 c, d of the paper)",
                   (in_millimetres("jump_n"), "normal: gap +, closure \u2212 [mm]"),
                   (in_millimetres("jump_t1"), "tangential: shear jump [mm]"), path)


def print_table(quantities):
    heading = ("variant", "p_max", "open/stick/slip", "largest gap", "closure", "largest jump",
               "mean jump added", "ratio")
    units = ("", "MPa", "", "mm", "mm", "mm", "by stage 2, mm", "to 1")
    widths = (24, 8, 17, 13, 9, 14, 17, 7)
    for line in (heading, units):
        print("".join(f"{text:>{w}}" if i else f"{text:<{w}}" for i, (text, w) in enumerate(zip(line, widths))))
    print("-" * sum(widths))
    for name, q in zip(NAMES, quantities):
        ratio = q.mean_jump_added / quantities[0].mean_jump_added
        cells = (name, f"{q.largest_pressure:.4f}", "/".join(map(str, q.counts)), f"{q.largest_gap:.4f}",
                 f"{q.largest_closure:.4f}", f"{q.largest_jump:.4f}", f"{q.mean_jump_added:.4f}",
                 f"{ratio:.2f}")
        print("".join(f"{text:>{w}}" if i else f"{text:<{w}}" for i, (text, w) in enumerate(zip(cells, widths))))


def print_trends(quantities, compliance, thickness):
    rigid, linear, law_9 = quantities
    stiffer = [law_9_stiffening(p, compliance, thickness) for p in PRESSURES_OF_INTEREST]
    trends = (
        ("The zone of opening is longest for the rigid joint, a little shorter with compliance",
         f"{rigid.open_length:.2f} / {linear.open_length:.2f} / {law_9.open_length:.2f} m on this mesh; "
         "129 elements tell them apart: doc/paper_trends.md"),
        ("The horizontal relative displacement grows by tens of percent",
         f"largest jump {percent(linear.largest_jump, rigid.largest_jump)}, "
         f"mean jump added by stage 2 {percent(linear.mean_jump_added, rigid.mean_jump_added)}"),
        ("The contact stresses are slightly lower with compliance",
         f"largest pressure {percent(linear.largest_pressure, rigid.largest_pressure)}"),
        ("Law (9) redistributes the closure",
         f"largest closure {percent(law_9.largest_closure, linear.largest_closure)} against variant 2; "
         f"bars stiffer by {stiffer[0]:.2f} at {PRESSURES_OF_INTEREST[0]:g} MPa, "
         f"{stiffer[1]:.2f} at {PRESSURES_OF_INTEREST[1]:g} MPa"))
    print("\nWhat the paper reports, and what this run shows "
          f"(compliance {compliance:g} m/MPa: its number read as m^3/kN)")
    for trend, number in trends:
        print(f"  {trend}:\n      {number}")


def main(arguments):
    if len(arguments) != 4:
        sys.exit(__doc__)
    directory = arguments[0]
    variants = [Results(os.path.join(directory, name)) for name in arguments[1:]]
    profiles = [variant.profile() for variant in variants]
    quantities = [PaperQuantities(variant) for variant in variants]

    style()
    pictures = plot_stresses(profiles, os.path.join(directory, "paper_contact_stresses"))
    pictures += plot_displacements(profiles, os.path.join(directory, "paper_relative_displacements"))

    print_table(quantities)
    joint = variants[2].summary["parameters"]["Joints"]["base"]
    print_trends(quantities, float(joint["Normal compliance"]), float(joint["Thickness"]))
    print("\nPictures:")
    for picture in pictures:
        print(f"  {picture}")


if __name__ == "__main__":
    main(sys.argv[1:])
