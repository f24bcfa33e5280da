# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Numbers as an engineer writes them: few significant digits. The exact ones are in the CSV files."""

import math

DIGITS = 4
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
