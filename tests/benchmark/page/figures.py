# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The measured figures as written to phases.csv and notes.json, and what is computed from them."""
import csv
import json
import math

TOTALS = ("total", "total_after_start", "wall")


def exponent(points):
    """Slope of log y over log x by least squares; None for fewer than two points."""
    points = [(math.log(x), math.log(y)) for x, y in points if x and y and x > 0 and y > 0]
    if len(points) < 2:
        return None
    mx, my = (sum(p[d] for p in points) / len(points) for d in (0, 1))
    spread = sum((x - mx) ** 2 for x, _ in points)
    return sum((x - mx) * (y - my) for x, y in points) / spread if spread else None


class Measurement:
    """One scene, tool, variant and size. What was not measured is None; then `failed` is true."""

    def __init__(self, key, rows, note):
        self.scene, self.tool, self.variant, self.n = key
        self.phases = {row["phase"]: float(row["seconds"]) for row in rows}
        self.note = note  # events, iterations, failures ...
        self.total, self.seconds = (self.phases.get(name) for name in TOTALS[:2])
        first = rows[0] if rows else {"dofs": 0, "memory_MB": 0, "error": "failed"}
        self.dofs, self.memory = int(first["dofs"]) or None, float(first["memory_MB"]) or None
        self.failed = first["error"] == "failed"
        self.error = None if self.failed or first["error"] == "" else float(first["error"])

    def __bool__(self):
        return bool(self.phases)

    def phase(self, name):
        return self.phases.get(name)

    def clock(self, start):
        """CPU seconds with or without the start of the program."""
        return self.total if start else self.seconds

    def without_fields(self, start=False):
        """All work but the writing of VTU files."""
        return self.clock(start) and self.clock(start) - self.phases.get("fields", 0.)

    def all_phases(self):
        """Sum of the medians of all phases but the start and the writing of VTU files; zero for a run that failed."""
        return 0. if self.failed else sum(
            seconds for name, seconds in self.phases.items() if name not in (*TOTALS, "start", "fields"))

    def failure(self):
        return "failed: " + "; ".join(self.note.get("failures", [])[:1])


class Figures:
    def __init__(self, directory):
        self.rows = {}
        with open(directory / "phases.csv", newline="") as file:
            for row in csv.DictReader(file):
                key = row["scene"], row["tool"], row["variant"], int(row["elements"])
                self.rows.setdefault(key, []).append(row)
        notes = json.loads((directory / "notes.json").read_text())
        self.machine, self.references, self.notes = notes["machine"], notes["references"], notes["cases"]

    def variants(self, scene, tool="fuga"):
        return list(dict.fromkeys(key[2] for key in self.rows if key[:2] == (scene, tool)))

    def at(self, scene, tool, variant, n=None):
        """The measurement of this size; without n that of the only size."""
        if n is None:
            n = next((key[3] for key in self.rows if key[:3] == (scene, tool, variant)), 0)
        key, name = (scene, tool, variant, n), "%s|%s|%s" % (scene, tool, variant)
        note = self.notes.get("%s n=%d" % (name, n)) or self.notes.get(name, {})
        return Measurement(key, self.rows.get(key, []), note)

    def fuga(self, scene, variant, n=None):
        return self.at(scene, "fuga", variant, n)

    def series(self, scene, variant, tool="fuga"):
        """All sizes in growing order."""
        return [self.at(*key) for key in sorted(key for key in self.rows if key[:3] == (scene, tool, variant))]

    def all_of(self, scene):
        return [self.at(*key) for key in self.rows if key[0] == scene]
