# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The cases of each part in rounds: the tools take turns, one round right after the other, so that what is compared has
met the same minutes of the machine; short cases, to which a slow second does most, come in all rounds."""
import csv
import dataclasses
import itertools
import math
import statistics
import time

AMPLE = 10.       # CPU seconds; a case that has taken as many is not run again
SAME = 0.02       # two runs that differ by less need no third,
SHORT = 2.        # unless they are shorter: one pause of the machine would count half
UNKNOWN = 10.     # seconds of a run nobody has measured


@dataclasses.dataclass
class Case:
    scene: str
    tool: str
    variant: str
    run: callable
    part: str = ""
    results: list = dataclasses.field(default_factory=list)
    seconds: float = UNKNOWN  # by the clock, with its preparation: measured or expected

    @property
    def key(self):
        return self.scene, self.tool, self.variant

    def is_settled(self):
        taken = [result.phases["total"] for result in self.results]
        return sum(taken) > AMPLE or (len(taken) > 1 and SHORT < max(taken) < (1. + SAME) * min(taken))

    def rows(self):
        """Medians; of the runs that came to the end, if some did."""
        good = [result for result in self.results if not result.failure] or self.results
        phases = dict.fromkeys(name for result in good for name in result.phases)
        error = "failed" if good[0].failure else ("" if good[0].error is None else "%.3e" % good[0].error)
        variant = self.variant.split(" n=")[0]
        for phase in phases:
            seconds = statistics.median(result.phases.get(phase, 0.) for result in good)
            yield (self.scene, self.tool, variant, good[0].elements, good[0].dofs, phase, "%.6f" % seconds,
                   "%.1f" % statistics.median(result.memory_MB for result in good), error, len(self.results))

    def notes(self):
        """What the CSV has no column for."""
        return {"failures": [result.failure for result in self.results if result.failure], **self.results[-1].info}


def expect(cases, recorded):
    """Times of the last whole run, from its phases.csv, for the remaining time alone."""
    known = {}
    if recorded.exists():
        with open(recorded, newline="") as file:
            for row in csv.DictReader(file):
                if row["phase"] == "total":
                    for variant in (row["variant"], "%s n=%s" % (row["variant"], row["elements"])):
                        known[row["scene"], row["tool"], variant] = float(row["seconds"])
    for case in cases:
        case.seconds = known.get(case.key, UNKNOWN)


def _remaining(cases, repeats, number, behind):
    """Seconds of a part, if all goes as measured or expected; `behind`: how many cases of this round are done."""
    left = 0.
    for k, case in enumerate(cases):
        if not case.is_settled():
            later = min(repeats, math.ceil(AMPLE / max(case.seconds, 0.1))) - number - 1
            left += (max(later, 0) + (k >= behind)) * case.seconds
    return left


def measure_all(cases, repeats):
    begin, parts = time.time(), {case.part: [] for case in cases}
    for case in cases:
        parts[case.part].append(case)
    for place, (part, of_part) in enumerate(parts.items(), 1):
        later = sum(_remaining(parts[other], repeats, 0, 0) for other in list(parts)[place:])
        for number, (k, case) in itertools.product(range(repeats), enumerate(of_part, 1)):
            if case.is_settled():
                continue
            start = time.time()
            result = case.run()
            case.results.append(result)
            case.seconds = time.time() - start
            print("%5.1f min, %4.1f left: %s (%d of %d), round %d of %d, %d of %d: %s %s %s: %.3f s%s%s" % (
                (time.time() - begin) / 60., (_remaining(of_part, repeats, number, k) + later) / 60.,
                part, place, len(parts), number + 1, repeats, k, len(of_part), *case.key,
                result.phases["total"], "" if result.error is None else ", error %.1e" % result.error,
                ", " + result.failure if result.failure else ""), flush=True)
