# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Why a required figure is not reached, as found by profiling: (pattern of the row, reason). Kept by hand.

Shown only beside rows that were not reached in the run at hand.
"""
import re

REASONS = (
    (r"whole process: CalculiX, increments per stage: 1$",
     "the start of the program: loading the shared libraries (`fuga --version`, last table) takes four fifths of the "
     "whole process; after start-up fuga is faster"),
    (r"variant of a sweep.*after start-up$",
     "a variant costs about what the phase 'path' of a separate run costs; the whole of such a run after start-up is "
     "only some fifteen times as much"),
)


def reason(what):
    return next((text for pattern, text in REASONS if re.search(pattern, what)), "not yet known")
