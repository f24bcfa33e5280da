# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The numbers by which the variants of the paper's test are compared."""

from fuga_results import OPEN, SLIP, STICK

MILLIMETRES = 1e3  # per metre
END_OF_FIRST_STAGE = 1.0


class PaperQuantities:
    """What one variant of problem S0 shows at the end of its second stage. Lengths in millimetres."""

    def __init__(self, results):
        end, before = results.profile(), results.profile(t=END_OF_FIRST_STAGE)
        self.end = end
        self.certificate = results.summary["certificate"]["worst"]
        self.counts = tuple(end.count(state) for state in (OPEN, STICK, SLIP))
        self.open_length = end.share(OPEN) * sum(end["area"])  # thickness 1
        self.largest_pressure = max(end["pressure"])
        self.largest_gap = MILLIMETRES * max(end["gap"])
        self.largest_closure = MILLIMETRES * max(end["closure"])
        self.largest_jump = MILLIMETRES * max(abs(jump) for jump in end["jump_t1"])
        self.mean_jump_added = MILLIMETRES * sum(
            after - first for after, first in zip(end["jump_t1"], before["jump_t1"])) / len(end)
        openings = results.events.frame.query("to == @OPEN")["t"]
        self.first_opening = None if openings.empty else openings.iloc[0] - END_OF_FIRST_STAGE

    @property
    def closure_unevenness(self):
        """Largest closure divided by the mean one of the closed elements; None for a rigid joint."""
        closed = [w for w, state in zip(self.end["closure"], self.end["state"]) if state != OPEN]
        mean = MILLIMETRES * sum(closed) / len(closed)
        return self.largest_closure / mean if self.largest_closure > 1e-9 else None

    def stiffening(self, initial_compliance):
        """Smallest and largest ratio of the bars' secant stiffness to the one at zero closure."""
        ratios = [p * initial_compliance / w
                  for p, w in zip(self.end["pressure"], self.end["closure"]) if w > 0.0]
        return min(ratios), max(ratios)


def law_9_stiffening(pressure, initial_compliance, thickness):
    """Secant stiffness of law (9) at a pressure, relative to the one at zero closure: 1/(1 - q)."""
    target = pressure * initial_compliance / thickness  # = q^3 / (1 - q), increasing in q
    low, high = 0.0, 1.0
    for _ in range(60):
        q = 0.5 * (low + high)
        low, high = (q, high) if q**3 < target * (1.0 - q) else (low, q)
    return 1.0 / (1.0 - low)


def percent(value, reference):
    """Change against a reference, as text."""
    change = 100.0 * (value / reference - 1.0)
    return f"{change:+.0f} %" if abs(change) >= 1.0 else f"{change:+.2f} %"
