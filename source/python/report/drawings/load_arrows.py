# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The loads of a model as arrows and words, for its sketch."""

import dataclasses
import math
import re

import numpy

from report.drawings.boundaries import centre_of
from report.text.words import rounded

ARROWS = 12  # on a boundary
LONGEST = 0.09  # arrow, as share of the size of the model

# Words of an expression that Python reads otherwise or not at all.
_FUNCTIONS = {name: getattr(math, name) for name in ("sin", "cos", "tan", "exp", "sqrt", "log", "pi")}
_FUNCTIONS.update({"abs": abs, "min": min, "max": max})
_ARITHMETIC = re.compile(r"[\w\s.+\-*/^(),]+")


def value_of(text, constants, t, **places):
    """An entry that is a number or a simple expression of the load time and of `places`; None for others."""
    if not _ARITHMETIC.fullmatch(text) or "__" in text:
        return None
    names = {**_FUNCTIONS, **{name: float(number) for name, number in constants.items()}, "t": t, **places}
    try:
        return float(eval(text.replace("^", "**"), {"__builtins__": {}}, names))
    except (ArithmeticError, NameError, SyntaxError, TypeError, ValueError):
        return None


def level_of(load, constants, t):
    """The level up to which the arrows of a load reach [length]; None where its entry says it in other words."""
    text = load.get("Level")
    if text is None:
        return None
    if ":" not in text:
        return value_of(text, constants, t)
    points = [[value_of(word, constants, t) for word in pair.split(":")] for pair in text.split(";") if pair.strip()]
    if any(len(point) != 2 or None in point for point in points):
        return None
    if t <= points[0][0]:
        return points[0][1]
    for (t0, h0), (t1, h1) in zip(points, points[1:]):
        if t < t1:
            return h0 + (h1 - h0) * (t - t0) / (t1 - t0)
    return points[-1][1]


@dataclasses.dataclass
class DrawnLoad:
    """A load at the end of the stages. `arrows`: (tails, tips, normals), each an array of points; normals are those of the
    faces, 0 without. `level`: of the water, with the faces it is in front of."""

    kind: str
    words: str
    arrows: tuple = None
    level: float = None
    wet: numpy.ndarray = None


class _Pressures:
    """Pressures of a load at places, as far as its entries tell; those that are expressions in other words count 1."""

    def __init__(self, load, constants, t, vertical):
        self._load, self._constants, self._t, self._vertical = load, constants, t, vertical
        self.level = level_of(load, constants, t)

    def _number(self, entry, otherwise=0.0):
        return float(self._load.get(entry, otherwise))

    def at(self, place):
        kind = self._load["Type"]
        if kind == "pressure":
            x, y, z = place
            value = value_of(self._load.get("Value", "1"), self._constants, self._t, x=x, y=y, z=z)
            return 1.0 if value is None else value
        if self.level is None:
            return 1.0
        depth = self.level - place[self._vertical]
        if depth <= 0.0:
            return 0.0
        if kind == "earth pressure":
            return self._number("Earth pressure coefficient") * (self._number("Unit weight") * depth + self._number("Surcharge"))
        if kind == "westergaard":
            whole = max(0.0, self.level - self._number("Bottom level"))
            return 0.875 * self._number("Horizontal coefficient") * self._number("Unit weight") * math.sqrt(whole * depth)
        return self._number("Unit weight") * depth


def _names(text):
    return [name.strip() for name in text.split(",") if name.strip()]


def _thinned(faces):
    return faces[::max(1, -(-len(faces) // ARROWS))]


def _vector(text, constants, t, places=(0.0, 0.0, 0.0)):
    """Components of an entry 'a; b; c'; unknown ones are 0."""
    x, y, z = places
    parts = [value_of(part, constants, t, x=x, y=y, z=z) or 0.0 for part in text.split(";")]
    return numpy.array((parts + [0.0, 0.0, 0.0])[:3])


class LoadArrows:
    """Makes DrawnLoads out of the parameters of a run."""

    def __init__(self, results, boundaries):
        self._parameters, self._boundaries = results.summary["parameters"], boundaries
        self._factors = results.summary.get("load_factors", {})
        self._t = min(results.summary["t"], float(len(results.stages)))
        self._unit = results.unit("x")
        corners = boundaries.outer
        self.size = (corners.max(axis=(0, 1)) - corners.min(axis=(0, 1))).max()
        self._vertical = 2 if boundaries.in_space else 1
        self._constants = self._parameters.get("Constants", {})

    def all(self):
        return [self._drawn(name, load) for name, load in self._parameters.get("Loads", {}).items()]

    def _drawn(self, name, load):
        factor = self._factors.get(name, 1.0)
        words = f"{name}: {load['Type']}" + ("" if factor in (0.0, 1.0) else f", factor {rounded(factor)}")
        if factor == 0.0:
            return DrawnLoad(load["Type"], words + ", not acting at the end")
        level = level_of(load, self._constants, self._t)
        if level is not None:
            words += f", level {rounded(level)} {self._unit}"
        make = {"weight": self._on_bodies, "seismic": self._on_bodies, "traction": self._tractions,
                "point force": self._at_point, "pressure": self._pressures, "hydrostatic": self._pressures,
                "earth pressure": self._pressures, "westergaard": self._pressures}.get(load["Type"])
        arrows = make(load, factor) if make else None
        drawn = DrawnLoad(load["Type"], words, arrows)
        if load["Type"] == "hydrostatic" and level is not None:
            drawn.level, drawn.wet = level, self._faces(load)
        return drawn

    def _faces(self, load, chosen=lambda faces: faces):
        """Those that are chosen of each of its boundaries."""
        faces = [chosen(self._boundaries.boundary(name)) for name in _names(load.get("Boundaries", ""))]
        return numpy.concatenate(faces) if faces else self._boundaries.outer[:0]

    def _scaled(self, places, vectors, normals, towards=True):
        """Arrows whose longest has the longest length; `towards` the places or away from them."""
        longest = numpy.linalg.norm(vectors, axis=1).max(initial=0.0)
        if longest == 0.0:
            return None
        there = numpy.linalg.norm(vectors, axis=1) > 0.02 * longest
        shift = vectors[there] * (LONGEST * self.size / longest)
        places = places[there]
        return (places - shift, places, normals[there]) if towards else (places, places + shift, normals[there])

    def _pressures(self, load, factor):
        pressures = _Pressures(load, self._constants, self._t, self._vertical)
        faces = self._faces(load, _thinned)
        centres, normals = faces.mean(axis=1), self._boundaries.normals(faces)
        sizes = factor * numpy.array([pressures.at(place) for place in centres])
        return self._scaled(centres, -normals * sizes[:, None], normals)

    def _tractions(self, load, factor):
        faces = _thinned(self._faces(load))
        centres = faces.mean(axis=1)
        vectors = factor * numpy.array([_vector(load.get("Value", ""), self._constants, self._t, place) for place in centres])
        return self._scaled(centres, vectors.reshape(-1, 3), self._boundaries.normals(faces))

    def _on_bodies(self, load, factor):
        places = numpy.array([centre_of(self._boundaries, name)
                              for name in _names(load.get("Bodies", "")) or self._boundaries.bodies])
        vector = numpy.zeros(3)
        if load["Type"] == "seismic":
            vector[0] = float(load.get("Horizontal coefficient", 0.0))
            vector[self._vertical] = float(load.get("Vertical coefficient", 0.0))
        elif load.get("Value"):
            vector = _vector(load["Value"], self._constants, self._t)
        else:
            vector[self._vertical] = -1.0
        return self._scaled(places, numpy.tile(factor * vector, (len(places), 1)), numpy.zeros_like(places), False)

    def _at_point(self, load, factor):
        try:
            place = [float(word) for word in load.get("Point", "").split(",")]
        except ValueError:
            return None  # a point by its name
        places = numpy.array([(place + [0.0, 0.0])[:3]])
        return self._scaled(places, factor * _vector(load.get("Value", ""), self._constants, self._t)[None], numpy.zeros((1, 3)))
