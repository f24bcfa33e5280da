# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Reads the result directory of one run of fuga. Needs pandas (Debian: python3-pandas)."""

import json
import math
import os
import re
import typing
import xml.etree.ElementTree as xml

import numpy
import pandas

OPEN, STICK, SLIP, BONDED = "open", "stick", "slip", "bonded"
STATES = (OPEN, STICK, SLIP)
# The array `state` of the joint fields holds indices into this.
STATE_OF_CODE = (OPEN, STICK, SLIP, BONDED)
# The same colours in every picture.
STATE_COLOURS = {OPEN: "#c4c4c4", STICK: "#0072b2", SLIP: "#e69f00", BONDED: "#009e73"}
# For black and white print.
HATCHES = {OPEN: "", STICK: "", SLIP: "////", BONDED: "...."}
STATE_MARKERS = {OPEN: "o", STICK: "s", SLIP: "^", BONDED: "D"}

_TEXT_COLUMNS = ("joint", "stage", "state", "from", "to", "verdict", "mechanism", "monitor", "occasion", "driven_by",
                 "motion", "axis")


class Table:
    """A CSV file of fuga: `frame` is a pandas data frame by column name; the units stand apart."""

    def __init__(self, path):
        # Names are text even if they look like numbers, or like a missing value.
        self.frame = pandas.read_csv(path, dtype={name: str for name in _TEXT_COLUMNS}, na_values=["nan"],
                                     keep_default_na=False, float_precision="round_trip")
        header = [re.fullmatch(r"([^\[]*)(?:\[(.*)\])?", name).groups() for name in self.frame.columns]
        self.units = {name: unit for name, unit in header}
        self.frame.columns = [name for name, _ in header]

    def __contains__(self, column):
        return column in self.frame.columns

    def up_to_the_limit(self):
        """This table without its rows beyond a limit load."""
        if "path_length" in self:
            self.frame = self.frame[self.frame["path_length"] == 0.0]
        return self

    def label(self, column, text=None):
        """The name of a column with its unit, for an axis."""
        unit = self.units[column]
        return f"{text or column.replace('_', ' ')} [{unit}]" if unit else text or column.replace("_", " ")


class JointStrength(typing.NamedTuple):
    """|T|/A <= f G(p) + c while the bond holds, with G(p) = p or, along a curved envelope,
    G(p) = r/b ((1 + p/r)^b - 1). It breaks where the joint opens, or also at the first slip; friction falls
    to its residual value at the first slip or opening. Stresses as in the files."""

    friction: float
    residual_friction: float
    cohesion: float
    tensile_strength: float
    bond_lost_by_slip: bool
    envelope_exponent: float
    envelope_pressure: float

    def is_curved(self):
        """Is the strength a curve over the pressure?"""
        return self.envelope_exponent != 1.0

    @property
    def pressure_term(self):
        """What friction multiplies, in formulas."""
        return "G(p)" if self.is_curved() else "p"

    def resisting(self, pressure):
        """G(p), for an array of pressures."""
        b, r = self.envelope_exponent, self.envelope_pressure
        if not self.is_curved():
            return pressure
        return numpy.where(pressure > 0.0, r / b * ((1.0 + numpy.maximum(pressure, 0.0) / r) ** b - 1.0), pressure)


class Profile:
    """One joint at one load: the contact elements in their order along it, as arrays by column.

    Besides the columns of joint_history.csv it has `along`, the distance from the first element, and
    `closure`, the compression of a layer without initial gap (0 where the element is open).
    """

    def __init__(self, t, frame):
        self.t = t
        self._frame = frame.sort_values("element")

    def __getitem__(self, column):
        if column == "along":
            steps = numpy.hypot(numpy.diff(self["x"]), numpy.diff(self["y"]))
            return numpy.concatenate([[0.0], numpy.cumsum(steps)])
        if column == "closure":
            return numpy.where(self["state"] == OPEN, 0.0, numpy.maximum(0.0, -self["jump_n"]))
        return self._frame[column].to_numpy()

    def __contains__(self, column):
        return column in self._frame

    def __len__(self):
        return len(self._frame)

    def edges(self):
        """Ends of the parts of the joint that the elements stand for, as distances along it."""
        along = self["along"]
        return numpy.concatenate([along[:1], 0.5 * (along[1:] + along[:-1]), along[-1:]])

    def count(self, state):
        """Number of elements in a state."""
        return int((self["state"] == state).sum())

    def share(self, state):
        """Share of the joint's area that is in a state."""
        areas = self["area"]
        return areas[self["state"] == state].sum() / areas.sum()


class Results:
    """The tables and the summary of one result directory.

    A run that was followed beyond its limit load has two parts: the tables here end at the limit load;
    `beyond` holds the rest of the resultants, by growing `path_length`, and `all_events` every event.
    """

    def __init__(self, directory):
        self.directory = directory
        with open(self._path("summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        self.all_events = Table(self._path("events.csv")).frame
        self.beyond = Table(self._path("resultants.csv")).frame.query("path_length > 0")
        self.events, self.history, self.resultants = (
            Table(self._path(name)).up_to_the_limit() for name in ("events.csv", "joint_history.csv", "resultants.csv"))
        # States of elements; jumps, and motions as a whole, have an energy.
        if "energy" in self.events:
            self.events.frame = self.events.frame[self.events.frame["energy"].isna()]
        # Only in runs with monitors.
        self.monitors = (Table(self._path("monitors.csv")).up_to_the_limit()
                         if os.path.exists(self._path("monitors.csv")) else None)
        # Only in runs with a stage in which inertia acts.
        self.motion = Table(self._path("earthquake.csv")) if os.path.exists(self._path("earthquake.csv")) else None
        # Only on request: Output/Response spectra.
        self.spectra = Table(self._path("spectra.csv")) if os.path.exists(self._path("spectra.csv")) else None
        self._joints = dict(list(self.history.frame.groupby("joint", sort=False)))

    def _path(self, name):
        return os.path.join(self.directory, name)

    @property
    def title(self):
        return self.summary["title"]

    @property
    def in_space(self):
        """Whether the model has three dimensions."""
        return str(self.summary["parameters"].get("Dimension", "2")) == "3"

    @property
    def joints(self):
        """Names of the joints, in the order of the file."""
        return list(self._joints)

    @property
    def stages(self):
        """Names of the stages; the end of stage i is the load time i + 1."""
        return list(self.summary["parameters"]["Stages"])

    @property
    def levels(self):
        """The load times at which there are results."""
        return sorted(self.history.frame["t"].unique().tolist())

    def levels_of(self, joint, levels=None):
        """Those levels (of the given ones) at which the joint is there: one that is built later has fewer."""
        there = set(self._joints[joint]["t"])
        return [t for t in (self.levels if levels is None else levels) if t in there]

    def representative_levels(self, number=6):
        """At most so many levels: ends of stages and the last, and evenly between them."""
        levels = numpy.array(self.levels)
        ends = [t for t in levels if abs(t - round(t)) < 1e-9 or t == levels[-1]]
        if len(ends) > number:
            return [ends[i] for i in numpy.linspace(0, len(ends) - 1, number).round().astype(int)]
        ends = sorted({levels[0], *ends}) if len(ends) < number else ends
        pieces = [1] * (len(ends) - 1)
        for _ in range(number - len(ends) if pieces else 0):
            pieces[int(numpy.argmax(numpy.diff(ends) / pieces))] += 1
        wanted = ends[-1:] + [left + k * (right - left) / n
                              for left, right, n in zip(ends, ends[1:], pieces) for k in range(n)]
        return sorted({float(levels[numpy.abs(levels - t).argmin()]) for t in wanted})

    def unit(self, column):
        """Unit of a column of joint_history.csv."""
        return self.history.units[column]

    def joint_frame(self, joint):
        """The rows of joint_history.csv of one joint."""
        return self._joints[joint]

    def profile(self, joint=None, t=None):
        """The profile of a joint (default: the first) at the level nearest to t (default: the last)."""
        frame = self._joints[joint or self.joints[0]]
        levels = self.levels_of(joint or self.joints[0])
        level = levels[-1] if t is None else min(levels, key=lambda level: abs(level - t))
        return Profile(level, frame[frame["t"] == level])

    def strength_parameters(self, joint):
        """The strength of a joint; see JointStrength."""
        entries = self.summary["parameters"]["Joints"][joint]

        def friction(name, otherwise):
            if f"{name} angle" in entries:
                return math.tan(math.radians(float(entries[f"{name} angle"])))
            return float(entries.get(f"{name} coefficient", otherwise))
        virgin = friction("Friction", 0.0)
        return JointStrength(virgin, friction("Residual friction", virgin), float(entries.get("Cohesion", 0.0)),
                             float(entries.get("Tensile strength", 0.0)), entries.get("Bond lost by") == SLIP,
                             float(entries.get("Envelope exponent", 1.0)), float(entries.get("Envelope pressure", 1.0)))

    def strength(self, joint, profile):
        """Shear strength f G(p) + c of the elements of a profile [stress], with what they have lost; 0 where open."""
        law = self.strength_parameters(joint)
        events = self.events.frame
        events = events[(events["joint"] == joint) & (events["t"] <= profile.t)]
        opened = numpy.isin(profile["element"], events["element"][(events["to"] == OPEN) | (events["from"] == OPEN)])
        slipped = numpy.isin(profile["element"], events["element"][events["to"] == SLIP])
        friction = numpy.where(opened | slipped, law.residual_friction, law.friction)
        bond = numpy.where(opened | (slipped & law.bond_lost_by_slip), 0.0, law.cohesion)
        strength = numpy.maximum(0.0, friction * law.resisting(profile["pressure"]) + bond)
        return numpy.where(profile["state"] == OPEN, 0.0, strength)

    def describe_time(self, t):
        """Load time in words: stages are counted from 0, and the end of a stage belongs to it. In a search for safety, which
        is after all stages, it is the factor that says where one is: "F = 1.185"."""
        t = round(t, 9)  # levels carry rounding
        if t > len(self.stages):
            return "{} = {:.4g}".format(*self.drive(t))
        number = min(max(math.ceil(t) - 1, 0), len(self.stages) - 1)
        fraction = t - number
        stage = f"stage '{self.stages[number]}'"
        return f"end of {stage}" if fraction == 1.0 else f"{100 * fraction:.4g} % of {stage}"

    def drive(self, t):
        """What drives the stage at the level nearest to t, and its value there: ("level of water", 18.9)."""
        frame = self.resultants.frame
        row = frame.iloc[(frame["t"] - t).abs().to_numpy().argmin()]
        return row["driven_by"], row["drive"]

    def describe_state(self, t):
        """describe_time() with the quantity that drives the stage: "50 % of stage 'filling', level of water = 9"."""
        words = self.describe_time(t)
        return words if round(t, 9) > len(self.stages) else "{}, {} = {:.4g}".format(words, *self.drive(t))

    def field_file(self, collection, t=None):
        """Path of the VTU file of a collection (bodies, joints, joints_exploded) nearest to t; after a run of several
        processes that of the PVTU file, which names those of the bodies."""
        tree = xml.parse(self._path(collection + ".pvd"))
        entries = [(float(entry.get("timestep")), entry.get("file")) for entry in tree.iter("DataSet")]
        nearest = entries[-1] if t is None else min(entries, key=lambda entry: abs(entry[0] - t))
        return self._path(nearest[1])

    def field_pieces(self, collection, t=None):
        """Paths of the VTU files that make up field_file()."""
        path = self.field_file(collection, t)
        if not path.endswith(".pvtu"):
            return [path]
        return [self._path(piece.get("Source")) for piece in xml.parse(path).iter("Piece")]
