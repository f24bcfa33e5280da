# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Reads the result directory of one run of fuga. Standard library only."""

import csv
import json
import os
import re
import xml.etree.ElementTree as xml

OPEN, STICK, SLIP = STATES = ("open", "stick", "slip")
# The same colours in every picture.
STATE_COLOURS = {OPEN: "#c4c4c4", STICK: "#0072b2", SLIP: "#e69f00", "bonded": "#009e73"}
# For black and white print.
HATCHES = {OPEN: "", STICK: "", SLIP: "////"}


class Table:
    """A CSV file of fuga: rows are dicts by column name; the units of the columns stand apart."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            reader = csv.reader(file)
            header = [re.fullmatch(r"([^\[]*)(?:\[(.*)\])?", name).groups() for name in next(reader)]
            self.units = {name: unit for name, unit in header}
            names = [name for name, _ in header]
            self.rows = [dict(zip(names, map(_value, row))) for row in reader]


def _value(text):
    try:
        return float(text)
    except ValueError:
        return text


class Profile:
    """One joint at one load: the contact elements in their order along it, as lists by column.

    Besides the columns of joint_history.csv it has `along`, the distance from the first element, and
    `closure`, the compression of a layer without initial gap (0 where the element is open).
    """

    def __init__(self, t, rows):
        rows = sorted(rows, key=lambda row: row["element"])
        self.t = t
        self._columns = {name: [row[name] for row in rows] for name in rows[0]}
        x, y = self["x"], self["y"]
        along = [0.0]
        for i in range(1, len(x)):
            along.append(along[-1] + ((x[i] - x[i - 1]) ** 2 + (y[i] - y[i - 1]) ** 2) ** 0.5)
        self._columns["along"] = along
        self._columns["closure"] = [0.0 if state == OPEN else max(0.0, -jump)
                                    for state, jump in zip(self["state"], self["jump_n"])]

    def __getitem__(self, column):
        return self._columns[column]

    def __len__(self):
        return len(self["element"])

    def count(self, state):
        """Number of elements in a state."""
        return self["state"].count(state)

    def share(self, state):
        """Share of the joint's area that is in a state."""
        areas = self["area"]
        return sum(A for A, s in zip(areas, self["state"]) if s == state) / sum(areas)


class Results:
    """The tables and the summary of one result directory."""

    def __init__(self, directory):
        self.directory = directory
        with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        self.events = Table(os.path.join(directory, "events.csv"))
        self.history = Table(os.path.join(directory, "joint_history.csv"))
        self.resultants = Table(os.path.join(directory, "resultants.csv"))

    @property
    def title(self):
        return self.summary["title"]

    @property
    def joints(self):
        """Names of the joints, in the order of the file."""
        return list(dict.fromkeys(row["joint"] for row in self.history.rows))

    @property
    def levels(self):
        """The load times at which there are results."""
        return sorted({row["t"] for row in self.history.rows})

    def unit(self, column):
        """Unit of a column of joint_history.csv."""
        return self.history.units[column]

    def profile(self, joint=None, t=None):
        """The profile of a joint (default: the first) at the level nearest to t (default: the last)."""
        joint = joint or self.joints[0]
        level = self.levels[-1] if t is None else min(self.levels, key=lambda level: abs(level - t))
        return Profile(level, [row for row in self.history.rows
                               if row["joint"] == joint and row["t"] == level])

    def field_file(self, collection, t=None):
        """Path of the VTU file of a collection (bodies, joints, joints_exploded) nearest to t."""
        tree = xml.parse(os.path.join(self.directory, collection + ".pvd"))
        entries = [(float(entry.get("timestep")), entry.get("file")) for entry in tree.iter("DataSet")]
        nearest = entries[-1] if t is None else min(entries, key=lambda entry: abs(entry[0] - t))
        return os.path.join(self.directory, nearest[1])
