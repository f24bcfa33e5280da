# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Diagrams over the load time: displacements, events, states, safety, energies."""

import math

import numpy
import pandas
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch

from fuga_results import BONDED, HATCHES, OPEN, SLIP, STATE_COLOURS, STATE_MARKERS, STATES, STICK
from report.drawings.figures import (MANY_MARKS, legend_on_top, level_styles, load_time_axis, mark_every, new_figure,
                                     set_margins, to_figure)
from report.text.words import Length, rounded

SAFETY_DRAWN = 10.0
CURVES = 6


def _event_rows(axes, events):
    """A row of ticks per state that elements enter: readable without colours."""
    rows = (OPEN, SLIP, STICK)
    for row, state in enumerate(rows):
        times = events["t"][events["to"] == state]
        axes.plot(times, [-row] * len(times), "|", color="black", markersize=9, markeredgewidth=0.8,
                  rasterized=len(times) > MANY_MARKS)
        axes.plot(times, [-row] * len(times), STATE_MARKERS[state], markersize=3.5, markeredgewidth=0.5, color="black",
                  markerfacecolor=STATE_COLOURS[state], rasterized=len(times) > MANY_MARKS)
    axes.set_ylim(-len(rows) + 0.3, 0.7)
    axes.set_yticks([-row for row in range(len(rows))], [f"\u2192 {state}" for state in rows])
    axes.set_ylabel("events")
    axes.grid(False, axis="y")
    axes.tick_params(left=False)


def _jump_curves(results, length, joints):
    """(name, t, value) of the largest opening and the largest shear jump of the first joints."""
    for joint in joints[:CURVES // 2]:
        levels = results.joint_frame(joint).groupby("t")
        yield f"{joint}: largest gap", levels["gap"].max() * length.factor
        yield f"{joint}: largest |shear jump|", levels["jump_t1"].agg(lambda jumps: jumps.abs().max()) * length.factor


def _monitor_curves(results, length):
    frame = results.monitors.frame
    components = [c for c in ("ux", "uy", "uz") if c in frame and frame[c].abs().max() > 0.0]
    for name, rows in list(frame.groupby("monitor", sort=False))[:CURVES // max(1, len(components))]:
        for component in components:
            yield f"{name}: {component}", rows.set_index("t")[component] * length.factor


def load_displacement(results, joints):
    """Displacements of the monitors, or of the joints if there are none; `joints`: all, those that matter most first."""
    length = Length(results.unit("gap"))
    has_monitors = results.monitors is not None and not results.monitors.frame.empty
    curves = list(_monitor_curves(results, length) if has_monitors else _jump_curves(results, length, joints))
    figure = new_figure(3.9)
    axes = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": (3.4, 1.0)})
    for (name, curve), look in zip(curves, level_styles(len(curves))):
        axes[0].plot(curve.index, curve.to_numpy(), label=name, markevery=mark_every(len(curve)), **look)
    axes[0].axhline(0.0, color="black", linewidth=0.8)
    axes[0].set_ylabel(f"displacement [{length.unit}]" if has_monitors else f"relative\ndisplacement [{length.unit}]")
    _event_rows(axes[1], results.events.frame)
    load_time_axis(axes, results)
    figure.align_ylabels(axes)
    legend_on_top(figure, axes[0].get_legend_handles_labels()[0], 2)
    what = ("displacements of the monitors" if has_monitors
            else "largest opening and largest shear jump of each joint (there are no monitors)")
    if not has_monitors and len(results.joints) > CURVES // 2:
        what = f"largest opening and shear jump of the {CURVES // 2} least safe of {len(results.joints)} joints"
    return to_figure(figure, f"Load\u2013displacement: {what} at the load levels. Below, a tick for every event: an "
                             "element opens, begins to slip, or sticks again.")


def beyond_limit(results):
    """Load and shear forces while the mechanism moves; None if the run was not followed there."""
    if results.beyond.empty:
        return None
    length = Length(results.unit("gap"))
    rows = pandas.concat([results.resultants.frame[results.resultants.frame["t"] == results.levels[-1]], results.beyond])
    figure = new_figure(4.2)
    axes = figure.subplots(2, 1, sharex=True)
    steps = rows.drop_duplicates("path_length")
    axes[0].plot(length.factor * steps["path_length"], steps["t"], "-o", color="black", markersize=3)
    axes[0].set_ylabel("load time t [\u2013]")
    joints = results.joints[:CURVES]
    for joint, look in zip(joints, level_styles(len(joints))):
        part = rows[rows["joint"] == joint]
        axes[1].plot(length.factor * part["path_length"], part["T"], label=joint, markevery=mark_every(len(part)), **look)
    axes[1].set_ylabel(f"T [{results.resultants.units['T']}]")
    axes[1].set_xlabel(f"growth of the largest jump beyond the limit load [{length.unit}]")
    figure.align_ylabels(axes)
    if len(joints) > 1:
        legend_on_top(figure, axes[1].get_legend_handles_labels()[0], 4)
    else:
        set_margins(figure)
    return to_figure(figure, "Beyond the limit load: the load that can still be carried, and the shear forces of the joints, "
                             "while the mechanism moves.")


def state_intervals(results, joint):
    """(element, state, from, to) over the load time of a joint: from its events, which are exact.

    Where a run took implicit steps no events are known; then a state found at a level is drawn from the
    level before.
    """
    frame, end = results.joint_frame(joint), results.levels[-1]
    if results.summary.get("events", {}).get("implicit_steps", 0):
        starts = dict(zip(results.levels, [0.0] + results.levels[:-1]))
        return [(row.element, row.state, starts[row.t], row.t) for row in frame.itertuples()]
    first = results.levels_of(joint)[0]
    built = 0.0 if first == results.levels[0] else math.ceil(first - 1e-9) - 1.0
    intervals = []
    events = results.events.frame
    by_element = dict(list(events[events["joint"] == joint].groupby("element")))
    for element, state in frame.groupby("element", sort=True)["state"].first().items():
        begin = built
        changes = by_element.get(element)
        if changes is not None:
            state = changes["from"].iloc[0]
            for t, after in zip(changes["t"], changes["to"]):
                if t > begin:
                    intervals.append((element, state, begin, t))
                begin, state = t, after
        if begin < end:
            intervals.append((element, state, begin, end))
    return intervals


def timeline(results):
    """Element against load time; the colour, and in black and white the hatching, is the state."""
    joints = results.joints[:CURVES]
    counts = [results.joint_frame(joint)["element"].nunique() for joint in joints]
    heights = [min(3.2, max(1.1, 0.09 * count)) for count in counts]
    figure = new_figure(sum(heights) + 1.0)
    axes = figure.subplots(len(joints), 1, sharex=True, squeeze=False, gridspec_kw={"height_ratios": heights})[:, 0]
    shown = set()
    for one, joint in zip(axes, joints):
        intervals = state_intervals(results, joint)
        for state in STATES + (BONDED,):
            boxes = [((a, k - 0.5), (b, k - 0.5), (b, k + 0.5), (a, k + 0.5)) for k, s, a, b in intervals if s == state]
            if boxes:
                shown.add(state)
                pixels = len(intervals) > MANY_MARKS
                # Edges close the seams between neighbours; those of a hatched box have the colour of the hatching.
                one.add_collection(PolyCollection(boxes, facecolor=STATE_COLOURS[state], edgecolor=STATE_COLOURS[state],
                                                  linewidth=0.5, rasterized=pixels))
                if HATCHES[state]:
                    one.add_collection(PolyCollection(boxes, facecolor="none", edgecolor="#7a5400", linewidth=0.0,
                                                      hatch=HATCHES[state], rasterized=pixels))
        numbers = [k for k, _, _, _ in intervals]
        one.set_ylim(min(numbers) - 0.5, max(numbers) + 0.5)
        one.yaxis.get_major_locator().set_params(integer=True)
        one.set_ylabel(f"{joint}\nelement" if len(joints) > 1 else "element")
        one.grid(False)
    load_time_axis(axes, results)
    figure.align_ylabels(axes)
    legend_on_top(figure, [Patch(facecolor=STATE_COLOURS[s], edgecolor="#7a5400" if s == SLIP else STATE_COLOURS[s],
                                 linewidth=0.0, hatch=HATCHES[s], label=s)
                           for s in STATES + (BONDED,) if s in shown], 4)
    known = ("; the run took implicit steps, so states are known at load levels only"
             if results.summary.get("events", {}).get("implicit_steps", 0) else "")
    return to_figure(figure, "States of the contact elements over the load, changes at the exact loads of the events"
                             f"{known}. Elements are numbered along the joint.")


def safety(results, all_joints):
    """Safety factors and the compressed share of the joints; of all of them, those that matter most first."""
    frame = results.resultants.frame
    figure = new_figure(3.9)
    axes = figure.subplots(2, 1, sharex=True)
    columns = [c for c in ("sliding_safety", "overturning_safety") if c in frame]
    joints = all_joints[:CURVES // len(columns)]
    curves = [(joint, column) for joint in joints for column in columns]
    rows = {joint: part.sort_values("t") for joint, part in frame.groupby("joint", sort=False)}
    finite = []
    for (joint, column), look in zip(curves, level_styles(len(curves))):
        values = rows[joint][column].to_numpy()
        drawn = numpy.where(numpy.isfinite(values) & (values <= SAFETY_DRAWN), values, numpy.nan)
        finite += drawn[numpy.isfinite(drawn)].tolist()
        axes[0].plot(rows[joint]["t"], drawn, label=f"{joint}: {column.replace('_safety', '')}",
                     markevery=mark_every(len(drawn)), **look)
    axes[0].axhline(1.0, color="black", linewidth=1.0, linestyle=(0, (6, 2)))
    axes[0].set_ylim(0.0, 1.08 * max(finite + [1.5]))
    axes[0].set_ylabel("safety factor [\u2013]")
    for joint, look in zip(joints, level_styles(len(joints))):
        part = rows[joint]
        share = part["share_compression"] if "share_compression" in frame else 1.0 - part["share_open"]
        axes[1].plot(part["t"], share, label=joint, markevery=mark_every(len(part)), **look)
    axes[1].set_ylim(0.0, 1.05)
    axes[1].set_ylabel("compressed share\nof the joint [\u2013]")
    if len(joints) > 1:
        axes[1].legend(loc="lower left", handlelength=3.6)
    load_time_axis(axes, results)
    figure.align_ylabels(axes)
    legend_on_top(figure, axes[0].get_legend_handles_labels()[0], 2)
    of_joints = f" of the {len(joints)} least safe of {len(results.joints)} joints" if len(joints) < len(results.joints) else ""
    return to_figure(figure, f"Safety factors{of_joints} and share of the joint's area in compression. Sliding: "
                             "\u03a3(f|N| + cA)/|\u03a3T| over the closed elements; it may be above 1 at a limit load whose "
                             f"mechanism is another. Values above {SAFETY_DRAWN:g}, such as those without any shear, are "
                             "not drawn.")


def energies(results):
    frame = results.resultants.frame.drop_duplicates("t")
    frame = frame[frame["external_work"].notna()]
    if frame.empty:
        return None
    unit = results.resultants.units["external_work"]
    figure = new_figure(3.4)
    axes = figure.subplots()
    columns = {"dissipation": "dissipation by friction", "energy_layer": "energy of the layer",
               "energy_bodies": "energy of the bodies", "external_work": "external work"}
    for (column, name), look in zip(columns.items(), level_styles(4)):
        axes.plot(frame["t"], frame[column], label=name, markevery=mark_every(len(frame)), **look)
    axes.axhline(0.0, color="black", linewidth=0.8)
    axes.set_ylabel(f"energy [{unit}]")
    load_time_axis([axes], results)
    legend_on_top(figure, axes.get_legend_handles_labels()[0], 4)
    rest = frame["external_work"] - frame["energy_bodies"] - frame["energy_layer"] - frame["dissipation"]
    return to_figure(figure, "Energy balance of the whole model, without the part of the bonded structure: external work = "
                             "energy of the bodies + energy of the layer + dissipation. Largest difference: "
                             f"{rounded(rest.abs().max(), 2)} {unit}, with a largest external work of "
                             f"{rounded(frame['external_work'].abs().max())} {unit}.")
