# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Diagrams along one joint: contact stresses, relative displacements; paths of its most used elements."""

import numpy
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from fuga_results import OPEN, STATE_COLOURS, STATE_MARKERS, STATES
from report.drawings.figures import (GREY, MARKED_ELEMENTS, legend_on_top, level_label, level_styles, mark_every,
                                     new_figure, to_figure)
from report.text.words import Length

# A reversal counts if the jump goes back by more than this share of its range.
REVERSAL = 0.02
PATHS = 4
# Elements nearer to each other than this part of the joint tell the same.
NEIGHBOURS = 16


def _along(axes, results):
    axes.set_xlabel(f"distance along the joint [{results.unit('x')}]")


def _levels_diagram(results, joint, levels, panels):
    """One line per level in each panel; panels are (values of a profile, label of the axis)."""
    levels = results.levels_of(joint, levels)
    figure = new_figure(len(panels) + 3.1)
    axes = figure.subplots(len(panels), 1, sharex=True)
    profiles = [results.profile(joint, t) for t in levels]
    for one, (values_of, label) in zip(axes, panels):
        one.axhline(0.0, color="black", linewidth=0.8, zorder=2)
        for profile, look in zip(profiles, level_styles(len(levels))):
            one.plot(profile["along"], values_of(profile), markevery=mark_every(len(profile)),
                     label=level_label(results, profile.t), **look)
        one.set_ylabel(label)
    _along(axes[-1], results)
    figure.align_ylabels(axes)
    legend_on_top(figure, axes[0].get_legend_handles_labels()[0], 2)
    return figure


def pressures(results, joint, levels):
    figure = _levels_diagram(results, joint, levels, [
        (lambda profile: profile["pressure"], f"pressure p [{results.unit('pressure')}]"),
        (lambda profile: profile["shear1"], f"shear stress \u03c4 [{results.unit('pressure')}]")])
    return to_figure(figure, f"Joint \u201c{joint}\u201d: contact pressure p = \u2212N/A and shear stress \u03c4 = T/A "
                             "at the chosen load levels. A positive \u03c4 has the direction of the tangent of the joint.")


def _strength_words(results, joint):
    """The strength of a joint, and what elements lose of it."""
    law, unit = results.strength_parameters(joint), results.unit("pressure")
    words = [f"f = {law.friction:.4g}"]
    if law.residual_friction != law.friction:
        words.append(f"{law.residual_friction:.4g} after the first slip or opening")
    words.append(f"c = {law.cohesion:.4g} {unit}")
    if law.is_curved():
        words.append(f"G(p) = r/b [(1 + p/r)^b \u2212 1] with b = {law.envelope_exponent:.4g}, "
                     f"r = {law.envelope_pressure:.4g} {unit}")
    if law.tensile_strength > 0.0:
        words.append(f"tensile strength {law.tensile_strength:.4g} {unit}")
    lost = ""
    if law.cohesion > 0.0 or law.tensile_strength > 0.0:
        lost = (" The bond is lost where the joint has once been open"
                + (" or has slipped." if law.bond_lost_by_slip else "."))
    return ", ".join(words) + "." + lost


def shear_and_strength(results, joint, levels):
    """One small diagram per level: the shear stress inside its limits."""
    levels = results.levels_of(joint, levels)
    formula = f"f {results.strength_parameters(joint).pressure_term} + c"
    rows = (len(levels) + 1) // 2
    figure = new_figure(0.9 + 1.75 * rows)
    axes = figure.subplots(rows, 2, sharex=True, sharey=True, squeeze=False)
    for one, t in zip(axes.flat, levels):
        profile = results.profile(joint, t)
        along, strength = profile["along"], results.strength(joint, profile)
        one.fill_between(along, -strength, strength, color="#ececec", linewidth=0)
        for sign in (-1.0, 1.0):
            one.plot(along, sign * strength, color=GREY, linewidth=0.9, linestyle=(0, (4, 1.6)))
        one.plot(along, profile["shear1"], color="black", linewidth=1.2)
        for state in STATES:
            here = profile["state"] == state
            shown = numpy.flatnonzero(here)[::mark_every(len(profile))] if len(profile) > MARKED_ELEMENTS else here
            one.plot(along[shown], profile["shear1"][shown], STATE_MARKERS[state], color="black", markersize=4.5,
                     markeredgewidth=0.7, markerfacecolor=STATE_COLOURS[state])
        one.set_title(level_label(results, t), fontsize=8, loc="left")
    for one in axes.flat[len(levels):]:
        one.set_axis_off()
    for one in axes[:, 0]:
        one.set_ylabel(f"\u03c4 [{results.unit('pressure')}]")
    for column in range(2):
        last = axes[rows - 1 - (1 if column == 1 and len(levels) % 2 else 0), column]
        _along(last, results)
        last.tick_params(labelbottom=True)
    handles = [Line2D([], [], color="black", linewidth=1.2, label="shear stress \u03c4"),
               Patch(facecolor="#ececec", edgecolor=GREY, linestyle="--", label=f"within \u00b1({formula})")]
    handles += [Line2D([], [], linestyle="", marker=STATE_MARKERS[s], markerfacecolor=STATE_COLOURS[s], color="black",
                       markersize=5, label=s) for s in STATES]
    legend_on_top(figure, handles, 5, hspace=0.25, wspace=0.08)
    return to_figure(figure, f"Joint \u201c{joint}\u201d: shear stress against its limits \u00b1({formula}). {_strength_words(results, joint)} "
                             "An element that slips is on the limit.")


def displacements(results, joint, levels):
    length = Length(results.unit("gap"))
    figure = _levels_diagram(results, joint, levels, [
        (lambda profile: length.factor * profile["jump_n"], f"normal jump [{length.unit}]\ngap +, closure \u2212"),
        (lambda profile: length.factor * profile["jump_t1"], f"shear jump [{length.unit}]"),
        (lambda profile: length.factor * profile["slip1"], f"slip [{length.unit}]")])
    return to_figure(figure, f"Joint \u201c{joint}\u201d: relative displacements of the two sides at the chosen load levels. "
                             "Slip is the part of the shear jump that is not elastic deformation of the layer; "
                             "while an element is open it follows the shear jump.")


def most_used(results, joint):
    """Numbers of the elements that came nearest to the shear strength; among equals most work of friction first."""
    use, work, before = {}, {}, None
    for t in results.levels:
        profile = results.profile(joint, t)
        strength, shear = results.strength(joint, profile), numpy.abs(profile["shear1"])
        shares = numpy.divide(shear, strength, out=numpy.zeros(len(profile)), where=strength > 0.0)
        slid = numpy.abs(profile["slip1"] - before["slip1"]) if before else numpy.abs(profile["slip1"])
        for element, share, done in zip(profile["element"], shares, shear * slid):
            use[element] = max(use.get(element, 0.0), min(round(share, 9), 1.0))
            work[element] = work.get(element, 0.0) + done
        before = profile
    chosen = []
    for element in sorted(use, key=lambda element: (-use[element], -work[element], element)):
        if all(abs(element - other) > len(use) // NEIGHBOURS for other in chosen):
            chosen.append(element)
    return sorted(chosen[:PATHS])


def _element_paths(results, joint, elements):
    frame = results.joint_frame(joint)
    for element, look in zip(elements, level_styles(len(elements))):
        yield element, frame[frame["element"] == element].sort_values("t"), look


def coulomb_paths(results, joint):
    elements = most_used(results, joint)
    figure = new_figure(4.0)
    axes = figure.subplots()
    law = results.strength_parameters(joint)
    lowest = highest = 0.0
    for element, path, look in _element_paths(results, joint, elements):
        axes.plot(path["pressure"], path["shear1"], markevery=mark_every(len(path)), label=f"element {element:g}", **look)
        axes.plot(path["pressure"].iloc[-1:], path["shear1"].iloc[-1:], "*", color="black", markersize=11, zorder=4)
        lowest, highest = min(lowest, path["pressure"].min()), max(highest, path["pressure"].max())
    ends = (1.05 * lowest, 1.05 * highest or 1.0)
    p = numpy.union1d(numpy.linspace(*ends, 200 if law.is_curved() else 2), 0.0)
    resisting, name = law.resisting(p), law.pressure_term
    for sign in (-1.0, 1.0):
        axes.plot(p, sign * numpy.maximum(0.0, law.friction * resisting + law.cohesion), color="black", linewidth=1.8,
                  label=f"strength \u00b1(f {name} + c)" if sign > 0 else None)
        if (law.friction, law.cohesion) != (law.residual_friction, 0.0):
            axes.plot(p, sign * numpy.maximum(0.0, law.residual_friction * resisting), color="black", linewidth=1.0,
                      linestyle=(0, (1, 2)), label=f"after loss of bond \u00b1f {name}" if sign > 0 else None)
    axes.plot([], [], "*", color="black", markersize=11, linestyle="", label="last level")
    axes.axhline(0.0, color="black", linewidth=0.8)
    axes.set_xlim(*ends)
    axes.set_xlabel(f"pressure p = \u2212N/A [{results.unit('pressure')}]")
    axes.set_ylabel(f"shear stress \u03c4 = T/A [{results.unit('pressure')}]")
    legend_on_top(figure, axes.get_legend_handles_labels()[0], 4)
    return to_figure(figure, f"Joint \u201c{joint}\u201d: paths of its most used elements in the Mohr\u2013Coulomb plane, from "
                             "load level to load level (markers). Most used: those that came nearest to the shear "
                             "strength, and among equals those with the most work of friction.")


def is_reversed(values):
    """Whether a history goes back by a visible part of its range and then has turned."""
    values = numpy.asarray(values)
    spread = values.max() - values.min()
    if len(values) < 3 or spread == 0.0:
        return False
    fall = (numpy.maximum.accumulate(values) - values).max()
    rise = (values - numpy.minimum.accumulate(values)).max()
    return min(fall, rise) > REVERSAL * spread


def hysteresis(results, joint):
    """Shear against shear jump of the most used elements; None if no jump ever turns back."""
    paths = [(element, path, look) for element, path, look in _element_paths(results, joint, most_used(results, joint))
             if is_reversed(path["jump_t1"]) and (path["state"] != OPEN).any()]
    if not paths:
        return None
    length = Length(results.unit("gap"))
    figure = new_figure(3.5)
    axes = figure.subplots(1, 2, sharey=True)
    for element, path, look in paths:
        for one, column in zip(axes, ("jump_t1", "slip1")):
            one.plot(length.factor * path[column], path["shear1"], label=f"element {element:g}",
                     markevery=mark_every(len(path)), **look)
            one.plot(length.factor * path[column].iloc[-1:], path["shear1"].iloc[-1:], "*", color="black",
                     markersize=11, zorder=4)
    for one, label in zip(axes, ("shear jump", "slip")):
        one.axhline(0.0, color="black", linewidth=0.8)
        one.set_xlabel(f"{label} [{length.unit}]")
    axes[0].set_ylabel(f"shear stress \u03c4 [{results.unit('pressure')}]")
    axes[0].plot([], [], "*", color="black", markersize=11, linestyle="", label="last level")
    legend_on_top(figure, axes[0].get_legend_handles_labels()[0], 5, wspace=0.08)
    return to_figure(figure, f"Joint \u201c{joint}\u201d: shear stress against shear jump (left) and against slip (right) of the "
                             "most used elements, from load level to load level. The area of a loop on the right is the "
                             "work of friction per area.")
