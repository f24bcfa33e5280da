# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Diagrams of a sweep: what each varied parameter does to the limit load and to the safety of the joints."""

import pandas

from report.drawings.figures import legend_on_top, level_styles, new_figure, set_margins, short, to_figure
from report.text.page import Table, Verdict
from report.text.words import rounded

CURVES = 6
CARRIED = "done"


def varied(table):
    """The varied entries: the columns between the number of the variant and its verdict."""
    names = list(table.frame.columns)
    return names[names.index("variant") + 1:names.index("verdict")]


def _axis_values(column):
    """Numbers stay numbers; words become places along the axis, with their names."""
    numbers = pandas.to_numeric(column, errors="coerce")
    if numbers.notna().all():
        return numbers, None
    words = list(dict.fromkeys(column))
    return column.map(words.index), words


def _curves(frame, entry, others):
    """(label, rows) of at most CURVES combinations of the other entries, spread over all of them."""
    groups = [(", ".join(f"{name} = {value}" for name, value in zip(others, key)), rows)
              for key, rows in frame.groupby(others, sort=False)] if len(others) > 1 else (
             [(f"{others[0]} = {key}", rows) for key, rows in frame.groupby(others[0], sort=False)] if others
             else [("", frame)])
    step = max(1, -(-len(groups) // CURVES))
    return groups[::step], len(groups)


def diagrams(table):
    """One diagram per varied entry: load time at the end above, safety of the joints below."""
    entries = varied(table)
    # At a limit load by sliding it is 1 by definition.
    safeties = [] if CARRIED not in set(table.frame["verdict"]) else [name for name in table.frame.columns if name.endswith(" sliding_safety")][:2]
    for entry in entries:
        frame = table.frame.assign(place=_axis_values(table.frame[entry])[0])
        words = _axis_values(table.frame[entry])[1]
        curves, n_curves = _curves(frame, entry, [name for name in entries if name != entry])
        panels = [("t", "load time t at the end [\u2013]")]
        panels += [(name, "sliding safety at the\nend, " + short(name[:-len(" sliding_safety")]) + " [\u2013]") for name in safeties]
        figure = new_figure(1.0 + 2.2 * len(panels))
        axes = figure.subplots(len(panels), 1, sharex=True, squeeze=False)
        for one, (column, label) in zip(axes[:, 0], panels):
            for (name, rows), look in zip(curves, level_styles(len(curves))):
                rows = rows.sort_values("place")
                one.plot(rows["place"], rows[column], **{**look, "marker": "", "label": name})
                carried = rows["verdict"] == CARRIED
                look = {**look, "linestyle": ""}
                one.plot(rows["place"][carried], rows[column][carried], **look)
                one.plot(rows["place"][~carried], rows[column][~carried],
                         **{**look, "markerfacecolor": look["color"], "markersize": 6.0})
            one.set_ylabel(label)
            if column != "t":
                one.set_ylim(bottom=0.0)
        if words:
            axes[-1, 0].set_xticks(range(len(words)), [short(str(word), 24) for word in words])
        axes[-1, 0].set_xlabel(table.label(entry))
        figure.align_ylabels(axes[:, 0])
        handles = axes[0, 0].get_legend_handles_labels()[0]
        if len(curves) > 1:
            legend_on_top(figure, handles, 2)
        else:
            set_margins(figure)
        some = f" {len(curves)} of {n_curves} combinations of the other entries are drawn." if len(curves) < n_curves else ""
        yield to_figure(figure, f"Limit load against {entry}. Full markers: the load could not be carried further. Hollow "
                                f"markers: the whole load was carried.{some}")


def verdict(table):
    """How many variants ended how."""
    counts = table.frame["verdict"].value_counts()
    words = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    ends = table.frame.loc[table.frame["verdict"] != CARRIED, "t"]
    sentences = [f"{len(table.frame)} variants: {words}."]
    if not ends.empty:
        sentences.append(f"Loss of equilibrium between t = {rounded(float(ends.min()))} and {rounded(float(ends.max()))}.")
    sentences.append(f"Worst certificate {rounded(float(table.frame['certificate'].max()), 2)}.")
    return Verdict("", f"Sweep over {', '.join(varied(table))}", sentences)


def variants(table):
    rows = [[value.item() if hasattr(value, "item") else value for value in row]
            for row in table.frame.itertuples(index=False)]
    return Table(rows, [table.label(name) for name in table.frame.columns], "variants-table")
