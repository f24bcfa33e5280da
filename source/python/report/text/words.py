# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Numbers and load times in words. Numbers have few significant digits; the exact ones are in the CSV files. A load time is
told by its stage and the share of it that is done, by the factor of a search for safety, or by the level of the water where that
moves: factors and levels are those of the columns `driven_by` and `drive` of the tables."""

import math

DIGITS = 4
# What drives the searches for safety.
_SEARCHES = ("F", "load factor")
_EXPONENT = str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079")


def rounded(value, digits=DIGITS):
    """A number in words of at most so many significant digits; counts stay whole."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return str(value).replace("-", "\u2212")
    if value is None or math.isnan(value):
        return "\u2013"
    if math.isinf(value):
        return "\u221e" if value > 0.0 else "\u2212\u221e"
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    power = int(exponent)
    if float(mantissa) == 0.0:
        return "0"
    if -4 <= power < 6:
        text = f"{float(f'{mantissa}e{power}'):.{max(0, digits - 1 - power)}f}"
    else:
        text = f"{mantissa}\u00b710{str(power).translate(_EXPONENT)}"
    return text.replace("-", "\u2212")


class Length:
    """Small lengths in a unit that one can read: metres become millimetres, others stay."""

    def __init__(self, unit):
        self.factor, self.unit = {"m": (1e3, "mm")}.get(unit, (1.0, unit))


def end_of_loads(results):
    """The last level that is not part of a search for safety."""
    return max((t for t in results.levels if t <= len(results.stages) + 1e-9), default=results.levels[-1])


def describe(results, t):
    """A load time in words: "end of 'weight'", "50 % of 'reservoir', level of water 14.0 m", "F = 1.156"."""
    name, value = results.drive(t)
    if name in _SEARCHES:
        return f"{name} = {rounded(value)}"
    words = results.describe_time(t).replace("stage ", "")
    return f"{words}, {name} {rounded(value)} {results.unit('x')}" if name.startswith("level of ") else words
