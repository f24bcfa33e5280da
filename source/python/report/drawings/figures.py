# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What all diagrams of a report share: look, axes of load time and length, conversion to inline SVG."""

import io
import itertools
import re

import matplotlib
import numpy
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure as MatplotlibFigure

from report.text.page import Figure
from report.text.words import describe

WIDTH = 7.2  # inches; the print of an A4 page
GREY = "#555555"
# Up to this many elements each gets a marker.
MARKED_ELEMENTS = 40
MARKERS = ("o", "s", "^", "D", "v", "P")
LINES = ((0, (1.0, 1.2)), (0, (3.0, 1.2)), (0, (6.0, 1.5, 1.0, 1.5)), (0, (6.0, 1.5, 1.0, 1.5, 1.0, 1.5)),
         (0, (9.0, 2.0)), "-")
# More events or levels are told apart by nobody: drawn as pixels.
MANY_MARKS = 2000
DOTS_PER_INCH = 150  # of what is drawn as pixels
# Room for labels around the axes, in inches.
LEFT, RIGHT, BOTTOM, TOP = 0.9, 0.15, 0.5, 0.25
_numbers = itertools.count(1)


def style():
    matplotlib.rcParams.update({"font.size": 9, "font.family": "DejaVu Sans", "axes.spines.top": False,
                                "axes.spines.right": False, "axes.grid": True, "grid.color": "#e0e0e0",
                                "grid.linewidth": 0.6, "axes.axisbelow": True, "hatch.linewidth": 0.7,
                                "legend.frameon": False, "legend.fontsize": 8, "svg.fonttype": "none",
                                "svg.hashsalt": "fuga", "axes.formatter.limits": (-3, 5), "axes.formatter.useoffset": False,
                                "figure.dpi": 100})


def new_figure(height, width=WIDTH):
    """An empty drawing; sizes in inches."""
    figure = MatplotlibFigure(figsize=(width, height))
    FigureCanvasSVG(figure)
    return figure


def set_margins(figure, left=LEFT, right=RIGHT, bottom=BOTTOM, top=TOP, **between):
    """Room around all axes, in inches, and between them, in axes."""
    width, height = figure.get_size_inches()
    figure.subplots_adjust(left=left / width, right=1.0 - right / width, bottom=bottom / height, top=1.0 - top / height,
                           **between)


def to_figure(figure, caption):
    """The inline SVG of a matplotlib figure, with names of its own so that figures cannot mix theirs."""
    text = io.StringIO()
    figure.savefig(text, format="svg", dpi=DOTS_PER_INCH, metadata={"Date": None})
    svg = text.getvalue()
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    prefix = f"f{next(_numbers)}-"
    svg = re.sub(r'\bid="', f'id="{prefix}', svg)
    svg = re.sub(r'href="#', f'href="#{prefix}', svg)
    svg = re.sub(r"url\(#", f"url(#{prefix}", svg)
    return Figure(svg, caption)


def level_styles(number):
    """Line style, marker and colour of each of up to six levels; the last is black and solid."""
    shades = [matplotlib.colormaps["viridis"](x) for x in numpy.linspace(0.72, 0.05, max(number - 1, 1))]
    colours = shades[:number - 1] + ["black"]
    return [{"linestyle": line, "marker": marker, "color": colour, "markersize": 4.0, "markerfacecolor": "white",
             "markeredgewidth": 0.9, "linewidth": 1.4}
            for line, marker, colour in zip(LINES[-number:], MARKERS[-number:], colours)]


def mark_every(number):
    """At most about twelve markers on a long line."""
    return 1 if number <= MARKED_ELEMENTS else max(1, number // 12)


def short(text, length=18):
    return text if len(text) <= length else text[:length - 1] + "\u2026"


def load_time_axis(axes, results, end=None):
    """Load time on the lowest of several axes: a line at every end of a stage, its name on top."""
    end = end or max(results.levels[-1], results.summary["t"])
    stages = results.stages + [name.replace("_", " ") for name in results.summary.get("safety", {})]
    axes[0].set_xlim(-0.01 * end, 1.01 * end)
    axes[-1].set_xlabel("load time t: number of the stage + share of the stage done [\u2013]")
    for one in axes:
        for number in range(1, len(stages)):
            if number < end:
                one.axvline(number, color=GREY, linewidth=0.8, linestyle=(0, (4, 3)), zorder=1)
    # Room for a name, in letters of the width of the figure.
    room = int(92 / end)
    for number, name in enumerate(stages):
        left, right = number, min(number + 1, end)
        if left < end and room * (right - left) >= 3:
            axes[0].annotate(short(name, max(3, int(room * (right - left)))), ((left + right) / 2, 1.0),
                             xycoords=("data", "axes fraction"), xytext=(0, 3), textcoords="offset points",
                             ha="center", va="bottom", fontsize=8, color=GREY)


def level_label(results, t):
    return f"t = {t:.4g}, {describe(results, t)}"


def legend_on_top(figure, handles, columns, **between):
    """A legend over all axes, row by row; the axes get the room that is left."""
    rows = -(-len(handles) // columns)
    set_margins(figure, top=0.185 * rows + 0.08 + TOP, **between)
    # matplotlib fills column by column.
    ordered = [handles[row * columns + column] for column in range(columns) for row in range(rows)
               if row * columns + column < len(handles)]
    figure.legend(handles=ordered, loc="upper left", bbox_to_anchor=(0.0, 1.0), borderaxespad=0.1, ncols=columns,
                  handlelength=3.6, columnspacing=1.6)
