# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What was to be reached, against what was measured. Every check gives rows (what, required, measured, reached)."""
from page.figures import exponent

BULK = ("mesh", "mesh and degrees of freedom", "joints and supports", "assembly", "ordering", "analysis",
        "factorisation", "loads", "condensation of loads")
TITLES = {"s0": "S0", "scene_g": "scene G", "dam_block": "dam block in space"}


def _at_most(what, bound, value, text="%.2f"):
    """A row; value None: not measured."""
    if value is None:
        return what, "≤ " + text % bound, "not measured", "-"
    return what, "≤ " + text % bound, text % value, "yes" if value <= bound else "no"


def _faster(what, factor, theirs, ours, label=""):
    """A row for 'our time is at most 1/factor of theirs'."""
    required = "≥ %g times faster" % factor
    if not theirs or not ours:
        return what, required, "not measured", "-"
    measured = "%.3g (%.3f s against %.4f s%s)" % (theirs / ours, theirs, ours, ", " + label if label else "")
    return what, required, measured, "yes" if theirs / ours >= factor else "no"


def _ratio(ours, base, further=0.):
    """Of the sums of phases; `further` seconds are added to ours. None: one was not measured, or failed."""
    sums = ours.all_phases(), base.all_phases()
    return (sums[0] + further) / sums[1] if all(sums) else None


def _over_control(figures, scene, variant, n):
    """The control contains the recovery of the displacements: the path shall, too. None: not measured."""
    path, control = figures.fuga(scene, variant, n), figures.fuga(scene, "bonded", n)
    return _ratio(path, control, control.phases.get("recovery of displacements", 0.))


def bonded(figures):
    for scene, variant, bound, sizes in (
            ("s0", "linear", 1.2, (129, 257)), ("s0", "law9", 1.5, (129, 257)), ("scene_g", "f0.2", 1.2, (129, 513)),
            ("scene_g", "f0.6", 1.2, (129, 513))):
        for n in sizes:
            yield _at_most("%s, n = %d, %s: all events / bonded control, all phases after start-up" % (
                TITLES[scene], n, variant), bound, _over_control(figures, scene, variant, n))
    for one in figures.series("dam_block", "linear"):
        ratio = _over_control(figures, "dam_block", "linear", one.n)
        yield "%s, n = %d: all events / bonded control, all phases after start-up" % (
            TITLES["dam_block"], one.n), "reported", "%.2f" % ratio if ratio else "not measured", "yes" if ratio else "-"


def _calculix(figures, scene, variant, increments, n, start=False):
    """(CPU seconds, kind of contact) of the faster one that came to the end."""
    found = [figures.at(scene, "calculix", "%s %s x%d" % (variant, kind, increments), n) for kind in ("nts", "sts")]
    return min(((one.clock(start), one.variant) for one in found if not one.failed), default=(None, ""))


def peers(figures):
    for n, ten, one, getfem, factor in ((129, 60., 15., 10, 100.), (513, 40., 12., 1, 25.)):
        for f in ("f0.2", "f0.6"):
            for increments, bound in ((10, ten), (1, one)):
                theirs, label = _calculix(figures, "scene_g", f, increments, n)
                yield _faster("scene G, n = %d, %s: CalculiX, increments per stage: %d" % (n, f, increments), bound,
                              theirs, figures.fuga("scene_g", f, n).seconds, label)
            theirs = figures.at("scene_g", "getfem", "%s x%d" % (f, getfem), n)
            # GetFEM's joint is rigid: so is ours here.
            yield _faster("scene G, n = %d, %s: GetFEM, increments per stage: %d" % (n, f, getfem), factor,
                          None if theirs.failed else theirs.seconds, figures.fuga("scene_g", "rigid " + f, n).seconds)
    for n, factor in ((33, 3.), (9, 1.)):
        for f in ("f0.2", "f0.6"):
            for increments in (10, 1):
                theirs, label = _calculix(figures, "scene_g", f, increments, n, True)
                what = "scene G, n = %d, %s, whole process: CalculiX, increments per stage: %d" % (n, f, increments)
                yield _faster(what, factor, theirs, figures.fuga("scene_g", f, n).total, label)
    for increments, factor in ((10, 60.), (1, 20.)):
        theirs, label = _calculix(figures, "s0", "linear", increments, 65)
        yield _faster("S0, n = 65: CalculiX, increments per stage: %d" % increments, factor, theirs,
                      figures.fuga("s0", "linear", 65).seconds, label)


def accuracy(figures):
    for n, bound in ((9, 1e-8), (33, 1e-8), (129, 1e-8), (513, 1e-6)):
        for variant in ("f0.2", "f0.6", "rigid f0.2", "rigid f0.6"):
            error = figures.fuga("scene_g", variant, n).error
            if error is not None:
                what = "scene G, n = %d, %s: error against the independent solution" % (n, variant)
                yield _at_most(what, bound, error, "%.1e")


def space(figures):
    for ours in figures.series("dam_block", "linear"):
        for increments in (10, 1):
            theirs, label = _calculix(figures, "dam_block", "linear", increments, ours.n)
            if theirs:
                yield "%s, n = %d: CalculiX, increments per stage: %d" % (TITLES["dam_block"], ours.n, increments), \
                    "reported", "%.3g times faster (%.1f s against %.3f s, %s)" % (
                        theirs / ours.seconds, theirs, ours.seconds, label), "yes"
    for ours in figures.series("dam_block_limit", "linear"):
        yield _at_most("%s, n = %d: limit of sliding, error against its closed form" % (
            TITLES["dam_block"], ours.n), 1e-6, ours.error, "%.1e")


def threads(figures):
    for scene, variant in (("scene_g", "f0.6"), ("s0", "linear"), ("dam_block", "linear")):
        for one in figures.series(scene, variant + " threads 1"):
            two = figures.fuga(scene, variant + " threads 2", one.n)
            if two:
                yield _at_most("%s, n = %d: two threads / one, by the clock (the same: within a twentieth)" % (
                    TITLES[scene], one.n), 1.05, two.phase("wall") / one.phase("wall"))


def reversal(figures):
    scene = "scene_g_reversal"
    for ours in figures.series(scene, "f0.6"):
        tried = [figures.at(scene, "calculix", variant, ours.n) for variant in figures.variants(scene, "calculix")]
        ended = [one for one in tried if " nts " in one.variant and not one.failed]
        if ended:
            finest = max(ended, key=lambda one: int(one.variant.split("x")[-1]))
            yield _faster("scene G with reversal, n = %d: CalculiX, finest tried (%s, its error %.1e)" % (
                ours.n, finest.variant, finest.error), 500., finest.seconds, ours.seconds)


def stiffness(figures):
    for n in (33, 129):
        base = figures.fuga("scene_g", "kn1e+06 f0.6", n)
        for variant in ("kn1e+12 f0.6", "rigid f0.6"):
            ours = figures.fuga("scene_g", variant, n)
            yield _at_most("scene G, n = %d: cost of %s / cost of k_n = 1e6 (the same: within a quarter)" % (
                n, variant.split()[0]), 1.25, _ratio(ours, base))
    tried = [figures.at("scene_g", "calculix", v, 33) for v in figures.variants("scene_g", "calculix")
             if v.startswith("kn1e+12")]
    if tried:
        failed = sum(one.failed for one in tried)
        yield "scene G, n = 33, k_n = 1e12: CalculiX fails", "fails", \
            "%d of %d kinds of contact fail" % (failed, len(tried)), "yes" if failed == len(tried) else "in part"


def growth(figures):
    for scene, variants in (("s0", ("linear", "law9", "rigid")), ("scene_g", ("f0.2", "f0.6"))):
        for variant in variants:
            last = [one for one in figures.series(scene, variant)[-3:] if one.note.get("steps")]
            slope = exponent([(one.n, one.phases.get("path", 0.) / one.note["steps"]) for one in last])
            yield _at_most("%s, %s: growth of the cost of one event with n" % (scene, variant), 2.1, slope)
    largest = figures.series("s0", "linear")[-4:]
    for phase in BULK:
        if largest and largest[-1].phases.get(phase, 0.) > 0.01:  # shorter phases are noise
            slope = exponent([(one.dofs, one.phase(phase)) for one in largest])
            yield _at_most("S0: growth of '%s' with dofs" % phase, 1.3, slope)
    for variant in ("linear", "law9", "rigid"):
        yield _at_most("S0, n = 257, 1.4e6 dofs, %s: memory [MB]" % variant, 8192.,
                       figures.fuga("s0", variant, 257).memory, "%.0f")


def sweep(figures):
    many = [v for v in figures.variants("scene_g") if v.startswith("sweep of ") and v != "sweep of 1"]
    if not many:
        yield "one further variant of a sweep, n = 129", "≥ 50 times faster than a run", "not available", "-"
        return
    swept = figures.fuga("scene_g", many[0])
    single, separate = (figures.fuga("scene_g", variant, swept.n) for variant in ("sweep of 1", "f0.6"))
    what = "one further variant of a sweep, n = %d, against a separate run, " % swept.n
    if swept.failed or single.failed:
        yield what, "≥ 50 times faster", swept.failure(), "no"
        return
    further = (swept.total - single.total) / (int(many[0].split()[-1]) - 1)
    for start, words in ((True, "whole process"), (False, "after start-up")):
        if further > 0.:
            yield _faster(what + words, 50., separate.clock(start), further)
        else:
            yield what + words, "≥ 50 times faster", "below the noise of the machine", "-"


def stage_ends(figures):
    """Point 2 of the issue: the end state alone, without the events."""
    for n in (129, 513):
        for f in ("f0.2", "f0.6"):
            events, step = figures.fuga("scene_g", f, n), figures.fuga("scene_g", f + " stage ends", n)
            if events and step:
                measured = "%.2g ms / %.2g ms" % (1e3 * events.phase("path"), 1e3 * step.phase("path"))
                yield "scene G, n = %d, %s: phase 'path' by events / by one implicit step per stage" % (n, f), \
                    "reported", step.failure() if step.failed else measured + (
                        "" if step.error is None else ", error %.1e" % step.error), "no" if step.failed else "yes"


def equal_error(figures):
    """At the error of each of the two finest uniform Q1 runs, the fastest setting that is at least as good."""
    for problem in ("V7 Hertz", "V9 Raous"):
        settings = [figures.fuga(problem, variant) for variant in figures.variants(problem)]
        settings = [one for one in settings if one.error is not None]
        for q1 in [one for one in settings if one.variant.startswith("uniform Q1")][-2:]:
            best = min((one for one in settings if one.error <= q1.error), key=lambda one: one.seconds)
            yield _faster("%s at the error of %s (%.1e): %s (%.1e)" % (
                problem, q1.variant, q1.error, best.variant, best.error), 5., q1.seconds, best.seconds)


def startup(figures):
    version, scene = figures.fuga("none", "version"), figures.fuga("scene_g", "f0.6", 9)
    if version and scene:
        phases = "mesh", "mesh and degrees of freedom", "joints and supports"
        before = sum(scene.phases.get(name, 0.) for name in phases)
        yield "scene G, n = 9: from main to the first assembly, beside `fuga --version` (loading the libraries)", \
            "reported", "%.1f ms beside %.0f ms" % (1e3 * before, 1e3 * version.total), "yes"


CHECKS = (("The price of one linear solution", bonded), ("Peers", peers), ("In space", space), ("Accuracy", accuracy),
          ("Reversals", reversal), ("Stiff and rigid joints", stiffness), ("Growth and memory", growth),
          ("Sweeps", sweep), ("Threads", threads), ("Stage ends only", stage_ends),
          ("Equal error", equal_error), ("Start-up", startup))


def by_title(figures):
    """[(title, rows)]"""
    return [(title, list(check(figures))) for title, check in CHECKS]
