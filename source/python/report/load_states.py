# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What stands beside a load time for a reader: the stage and its share, the factor of a search for safety, the level of
the water where it moves."""

import math
import re

from report.numbers import rounded

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
    """The level of the water (or the ground) of a load [length]; None where its entry says it in other words."""
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


def end_of_loads(results):
    """The last level that is not part of a search for safety."""
    return max((t for t in results.levels if t <= len(results.stages) + 1e-9), default=results.levels[-1])


def _search(results, t):
    """(method, share done) of the search for safety a load time is part of, or None."""
    number = math.ceil(t - 1e-9) - 1 - len(results.stages)
    methods = list(results.summary.get("safety", {}))
    return (methods[number].replace("_", " "), t - len(results.stages) - number) if 0 <= number < len(methods) else None


def factor_of(results, t):
    """(method, factor) of a state in a search for safety: by what strength is divided or loads are multiplied; or None."""
    found = _search(results, t)
    if found is None:
        return None
    method, done = found
    largest = float(results.summary["parameters"].get("Safety", {}).get("Largest factor", 10.0))
    return method, (1.0 / (1.0 - done * (1.0 - 1.0 / largest)) if method == "strength reduction"
                    else 1.0 + done * (largest - 1.0))


def moving_level(results, t):
    """The level of the water at a load time in a stage that moves it, or None."""
    stage = max(0, math.ceil(t - 1e-9) - 1)
    parameters = results.summary["parameters"]
    for load in parameters.get("Loads", {}).values():
        level, before, after = (level_of(load, parameters.get("Constants", {}), time) for time in (t, stage, stage + 1))
        if None not in (level, before, after) and (before != level or after != level):
            return level
    return None


def describe(results, t):
    """A load time in words: "end of 'weight'", "50 % of 'reservoir', level 14.0 m", "F = 1.156"."""
    factor = factor_of(results, t)
    if factor:
        method, value = factor
        return f"F = {rounded(value)}" if method == "strength reduction" else f"{method} {rounded(value)}"
    words = results.describe_time(t).replace("stage ", "")
    level = moving_level(results, t)
    return words if level is None else f"{words}, level {rounded(level)} {results.unit('x')}"
