# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Log-log plots of the figures: work-precision, scaling, peers, reversal."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "svg.hashsalt": "fuga",
                     "legend.fontsize": 8, "figure.dpi": 120})


def _save(figure, directory, name):
    figure.tight_layout()
    figure.savefig(directory / (name + ".png"))
    figure.savefig(directory / (name + ".svg"), metadata={"Date": None})
    plt.close(figure)
    return name


def _line(axes, points, label, style="o-"):
    points = sorted((x, y) for x, y in points if x and y and x > 0 and y > 0)
    if points:
        axes.loglog(*zip(*points), style, label=label, markersize=4)


def _finish(axes, title, xlabel, ylabel):
    axes.set(title=title, xlabel=xlabel, ylabel=ylabel, xscale="log", yscale="log")
    if axes.has_data():
        axes.legend(framealpha=0.6)


def precision(figures, directory):
    problems = [problem for problem in ("V5 pull-out", "V7 Hertz", "V8 punch", "V9 Raous") if figures.variants(problem)]
    if not problems:
        return None
    figure, grid = plt.subplots(2, 2, figsize=(9, 7))
    for axes, problem in zip(grid.flat, problems):
        for kind, style in (("uniform", "o-"), ("graded", "s--")):
            for degree in (1, 2, 3):
                runs = [figures.fuga(problem, variant) for variant in figures.variants(problem)
                        if variant.startswith("%s Q%d " % (kind, degree))]
                _line(axes, [(one.seconds, one.error) for one in runs], "Q%d %s" % (degree, kind), style)
        _finish(axes, problem, "CPU time after start [s]", "relative error")
    return _save(figure, directory, "benchmark_precision")


def scaling(figures, directory):
    if not figures.variants("s0"):
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2))
    for variant in ("linear", "law9", "rigid", "bonded"):
        _line(left, [(one.dofs, one.without_fields()) for one in figures.series("s0", variant)], "S0 " + variant)
    for phase in ("mesh", "mesh and degrees of freedom", "assembly", "factorisation", "condensation of loads", "path"):
        _line(right, [(one.dofs, one.phase(phase)) for one in figures.series("s0", "linear")], phase)
    _finish(left, "S0: all work after start-up, no fields", "degrees of freedom", "CPU time [s]")
    _finish(right, "S0, linear joint: phases", "degrees of freedom", "time [s]")
    return _save(figure, directory, "benchmark_scaling")


def peers(figures, directory):
    if not figures.variants("scene_g", "calculix"):
        return None
    figure, grid = plt.subplots(1, 2, figsize=(10, 4.2))
    for axes, f in zip(grid, ("f0.2", "f0.6")):
        for tool, variant, label in (
                ("fuga", f, "fuga, every event"), ("fuga", f + " stage ends", "fuga, stage ends"),
                ("calculix", f + " nts x10", "CalculiX node-to-surface, 10 increments"),
                ("calculix", f + " sts x10", "CalculiX surface-to-surface, 10"),
                ("calculix", f + " nts x1", "CalculiX node-to-surface, 1"), ("getfem", f + " x10", "GetFEM, 10"),
                ("getfem", f + " x1", "GetFEM, 1")):
            ended = [one for one in figures.series("scene_g", variant, tool) if not one.failed]
            _line(axes, [(one.n, one.seconds) for one in ended], label, "o-" if tool == "fuga" else "s--")
        axes.set_ylim(top=2e4)  # room for the legend
        _finish(axes, "scene G, f = %s" % f[1:], "contact elements", "CPU time after start [s]")
    return _save(figure, directory, "benchmark_peers")


def reversal(figures, directory):
    scene = "scene_g_reversal"
    if not figures.variants(scene, "calculix"):
        return None
    figure, axes = plt.subplots(figsize=(6.5, 4.5))
    for ours, style in zip(figures.series(scene, "f0.6"), ("-", ":")):
        for kind in ("nts", "sts"):
            runs = [figures.at(scene, "calculix", variant, ours.n) for variant in figures.variants(scene, "calculix")
                    if " %s " % kind in variant]
            _line(axes, [(one.seconds, one.error) for one in runs], "CalculiX %s, n = %d" % (kind, ours.n), "o" + style)
        axes.axvline(ours.seconds, linestyle=style, color="k", label="fuga, exact path, n = %d" % ours.n)
    _finish(axes, "scene G, +L, −L, +L", "CPU time after start [s]", "largest error of the jumps")
    return _save(figure, directory, "benchmark_reversal")


def write(figures, directory):
    return [name for name in (make(figures, directory) for make in (precision, scaling, peers, reversal)) if name]
