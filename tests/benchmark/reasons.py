# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Why a required figure is not reached, as found by profiling: (pattern of the row, reason). Kept by hand.

Shown only beside rows that were not reached in the run at hand.
"""
import re

REASONS = (
    (r"whole process: CalculiX, increments per stage: 1$",
     "the start of the program: `fuga --version` alone (last table) takes four fifths of the whole process. 84 % of "
     "it is the dynamic linker looking up 190 000 symbols of the 204 shared libraries that Debian's deal.II needs; "
     "nothing of ours. After start-up fuga is faster"),
    (r"variant of a sweep.*after start-up$",
     "a variant costs about what the phase 'path' of a separate run costs; the whole of such a run after start-up is "
     "only some twenty times as much"),
    (r"GetFEM, increments per stage",
     "GetFEM needs fewer solutions here than where the bound comes from: 44 in place of 60 at n = 129, 11 in place of "
     "16 at n = 513 (numbers in notes.json); for each of its solutions the ratio is above the one asked for"),
    (r"n = 33: cost of rigid",
     "0.01 s of difference between processes of 0.2 s, their start taken off: the resolution of the clock of the "
     "kernel. The phases are equal"),
    (r"V9 Raous at the error of",
     "the error comes from where the ends of the zones fall between nodes, not from the fields: only the number of "
     "contact elements helps, whatever the degree, and no setting gets by with a fifth of them. Graded Q3 comes "
     "within 1.4 times the error of the finest uniform Q1 in a seventh of its time; MPI and MUMPS need 0.02 s to begin whatever the size"),
)


def reason(what):
    return next((text for pattern, text in REASONS if re.search(pattern, what)), "not yet known")
