# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The first figure of a report: what presses across a joint, by itself and together with the water in it."""

import numpy
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from fuga_results import OPEN, STATE_COLOURS, STATES
from report.drawings.figures import legend_on_top, new_figure, short, to_figure
from report.text.words import describe, end_of_loads, rounded

SMALL_PANELS = 3  # ends of stages below the last state
WATER = "#9ecae1"
STRIP = 0.045  # height of the strip of states, in axes


def water_pressure(profile):
    """Pressure of the water in the joint [stress]; 0 without."""
    return profile["water_pressure"] if "water_pressure" in profile else numpy.zeros(len(profile))


def panel_times(results, joint):
    """The end of the loads first; then ends of earlier stages, and the states that searches for safety found."""
    last = min(results.levels_of(joint), key=lambda t: abs(t - end_of_loads(results)))
    ends = [t for t in results.levels_of(joint) if t != last and (abs(t - round(t)) < 1e-9 or t > last)]
    found = [t for t in ends if t > last]
    # Of a search only its last state.
    found = [t for t in found if t == max(one for one in found if int(one - 1e-9) == int(t - 1e-9))]
    stages = [t for t in ends if t < last]
    return [last] + (stages[-(SMALL_PANELS - min(len(found), 2)):] + found[:2] if stages or found else [])


def _draw(axes, profile):
    along, edges = profile["along"], profile.edges()
    effective, water = profile["pressure"], water_pressure(profile)
    axes.axhline(0.0, color="black", linewidth=0.8)
    axes.fill_between(along, water, color=WATER, linewidth=0)
    axes.plot(along, effective, color="black", linewidth=1.5)
    if water.any():
        axes.plot(along, effective + water, color="#b00020", linewidth=1.2, linestyle=(0, (5, 2)))
    runs = numpy.flatnonzero(numpy.concatenate([[True], profile["state"][1:] != profile["state"][:-1], [True]]))
    for first, last in zip(runs, runs[1:]):
        state = profile["state"][first]
        if state == OPEN:
            axes.axvspan(edges[first], edges[last], color="#f2e6d8", linewidth=0, zorder=0)
        axes.axvspan(edges[first], edges[last], ymax=STRIP, color=STATE_COLOURS[state], linewidth=0, zorder=3)
    low, high = min(effective.min(), 0.0), max((effective + water).max(), 1e-300)
    # The strip of states stays below the curves.
    axes.set_ylim(low - (STRIP + 0.03) * (high - low) / (1.0 - STRIP), high + 0.08 * (high - low))
    axes.set_xlim(edges[0], edges[-1])


def _sums(results, joint, profile):
    """In words: resultants across the joint and its open part."""
    rows = results.resultants.frame
    row = rows[(rows["joint"] == joint) & (rows["t"] == profile.t)].iloc[0]
    unit = results.resultants.units["N"]
    text = f"effective normal force {rounded(-row['N'])} {unit}"
    if "water" in row and row["water"] != 0.0:
        text += (f", water in the joint {rounded(row['water'])} {unit}, together {rounded(row['water'] - row['N'])} {unit}")
    opened = profile.share(OPEN)
    return text + ("; closed everywhere." if opened == 0.0 else
                   f"; open over {rounded(100.0 * opened, 3)} % of its area.")


def joint_stresses(results, joint):
    """Uplift, effective and total normal stress along a joint in the plane."""
    times = panel_times(results, joint)
    small = times[1:]
    figure = new_figure(4.0 if small else 2.9)
    grid = figure.add_gridspec(2 if small else 1, max(2, len(small)), height_ratios=[2.2, 1.0] if small else [1.0])
    profiles = [results.profile(joint, t) for t in times]
    panels = [figure.add_subplot(grid[0, :])] + [figure.add_subplot(grid[1, k]) for k in range(len(small))]
    for axes, profile in zip(panels, profiles):
        _draw(axes, profile)
        axes.set_title(short(describe(results, profile.t), 90 if axes is panels[0] else 36), fontsize=8, loc="left", pad=3)
    panels[0].set_ylabel(f"normal stress [{results.unit('pressure')}]\ncompression +")
    for axes in panels[1:]:
        axes.set_ylabel(f"[{results.unit('pressure')}]")
    for axes in panels:
        axes.set_xlabel(f"distance{' along the joint' if axes is panels[0] else ''} [{results.unit('x')}]")
    there = set().union(*(profile["state"] for profile in profiles))
    handles = [Line2D([], [], color="black", linewidth=1.5, label="effective stress")]
    if any(water_pressure(profile).any() for profile in profiles):
        handles += [Patch(facecolor=WATER, label="uplift (water in the joint)"),
                    Line2D([], [], color="#b00020", linewidth=1.2, linestyle=(0, (5, 2)), label="total = effective + uplift")]
    handles += [Patch(facecolor=STATE_COLOURS[state], label=state) for state in STATES if state in there]
    legend_on_top(figure, handles, 3, hspace=0.6, wspace=0.36)
    return to_figure(figure, f"Joint \u201c{joint}\u201d: normal stress across the joint at the end of the loads"
                             f"{' and at other states' if small else ''}. The strip along the bottom is the state of the "
                             "elements; shaded: open. "
                             f"{describe(results, profiles[0].t).capitalize()}: {_sums(results, joint, profiles[0])}")
