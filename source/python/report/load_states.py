# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What stands beside a load time for a reader: the stage and its share, the factor of a search for safety, the level of
the water where it moves. Factors and levels are those of the columns `driven_by` and `drive` of the tables."""

from report.numbers import rounded

# What drives the searches for safety.
_SEARCHES = ("F", "load factor")


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
