# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The laws of a joint, from the table that fuga --plot-law writes: stress against deformation in both directions."""

import math

from report.drawings.figures import GREY, legend_on_top, new_figure, to_figure
from report.text.words import Length

# By direction of the table: names of the axes.
AXES = {"normal": ("closure", "pressure"), "shear": ("elastic shear jump", "shear stress")}


def diagram(joint, table):
    """The curves, dashed the tangents at zero, dotted the limits of the deformation."""
    length = Length(table.units["deformation"])
    figure = new_figure(3.5)
    panels = figure.subplots(1, len(AXES))
    for axes, (direction, (deformation, stress)) in zip(panels, AXES.items()):
        rows = table.frame[table.frame["direction"] == direction]
        axes.set_xlabel(f"{deformation} [{length.unit}]")
        axes.set_ylabel(table.label("stress", stress))
        if rows.empty:
            axes.text(0.5, 0.5, "no deformation at any stress", transform=axes.transAxes, ha="center")
            continue
        w, limit = length.factor * rows["deformation"], length.factor * rows["limit"].iloc[0]
        axes.plot(w, rows["stress"], color="black", linewidth=1.6, label="law")
        axes.plot(w, rows["tangent"].iloc[0] * rows["deformation"], color="black", linewidth=1.0, linestyle=(0, (5, 3)),
                  label="tangent at zero")
        if math.isfinite(limit):
            axes.axvline(limit, color=GREY, linewidth=1.2, linestyle=(0, (1, 2)), label="limit")
        axes.set_ylim(0.0, 1.05 * rows["stress"].max())
        axes.set_xlim(left=0.0)
    handles = {handle.get_label(): handle for axes in panels for handle in axes.get_legend_handles_labels()[0]}
    legend_on_top(figure, list(handles.values()), 3, wspace=0.3)
    return to_figure(figure, f"Joint \u201c{joint}\u201d: the laws of its layer. A shear law whose stiffness grows with closure or "
                             "pressure is that of the unloaded layer.")
