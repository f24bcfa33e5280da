#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""doc/stability.md and doc/stability.png from the table of the stress campaign.

usage: report.py SCENES.csv STRESS_PROGRAM [--doc DIRECTORY]
"""
import argparse
import pathlib
import subprocess
import sys
import textwrap

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "tools"))
from remarks import by_hand  # noqa: E402

BOUND = 1e-9
# Classes of every axis: lower ends. Zero has a class of its own where it means something special.
AXES = [("rho_min", "smallest ρ in the scene [m/MPa]", [0, 1e-300, 1e-9, 1e-6, 1e-3, 1]),
        ("rho_max", "largest ρ [m/MPa]", [0, 1e-300, 1e-9, 1e-6, 1e-3, 1, 1e2]),
        ("friction", "largest f", [0, 1e-300, .3, .6, 1, 1.5, 2, 2.5]),
        ("cohesion", "cohesion", [0, 1e-300]),
        ("poisson", "largest ν", [0, .1, .3, .45, .4999]),
        ("stiffness_ratio", "ratio of moduli", [1, 10, 1e3, 1e5]),
        ("aspect", "aspect of elements", [1, 10, 100, 1e3, 1e4, 1e5]),
        ("size_ratio", "size ratio of elements", [1, 10, 100, 1e4, 1e5]),
        ("offset", "distance from the origin [m]", [0, 1e3, 1e5]),
        ("elements", "contact elements", [1, 2, 5, 20, 50, 100, 200]),
        ("bodies", "bodies", [1, 2, 3, 5, 10]),
        ("stages", "stages", [1, 2, 5, 60, 120]),
        ("events", "events", [0, 1, 10, 100, 1000])]
# Which kinds contain what: the list of the ways in which event-driven contact is known to break.
DEGENERACIES = [
    ("Virgin apex: all events of a proportional load at t = 0+", ["virgin", "symmetric", "stack"]),
    ("Simultaneous events: symmetry, uniform pressure, load reversal", ["symmetric", "reversal", "high friction"]),
    ("Zero-length steps, chattering", ["symmetric", "virgin", "stages"]),
    ("Re-stick inside and at the beginning of a segment", ["reversal", "cubic root", "stages"]),
    ("Order of slip and opening", ["stack", "cohesion", "gap"]),
    ("Strength that is lost on the way, one loss causing the next", ["residual", "bonds", "all laws", "all laws crossing"]),
    ("All contact lost and found again at one load", ["lift-off"]),
    ("Singular scheme: all bars of a body slip or open", ["limit", "tower", "soft", "wedge"]),
    ("Beyond critical friction", ["high friction", "stiff"]),
    ("Rigid bodies on rigid joints", ["rigid bodies", "masonry"]),
    ("Nonlinear layers, to the closure limit", ["cubic root", "cubic root crossing", "curved laws", "coupled shear", "lift-off"]),
    ("Dependence on the path, cycles", ["reversal", "stages", "extruded reversal"]),
    ("Many elements, hundreds of events", ["many elements"]),
    ("Closing at the apex at high friction", ["high friction", "gap", "reversal"]),
    ("Very soft joints near collapse", ["soft", "limit"]),
    ("Detection of limits", ["limit", "soft", "wedge", "tower"]),
    ("Slip in the very first stage", ["virgin", "stack", "many elements"]),
    ("Directions of slip that turn", ["blocks in space", "pair in space", "wedge in space"]),
    ("Joints at any angle that cross, meet in T or end at the outline, on unstructured cells", ["polygons", "polygons with laws"]),
    ("Joints in space that meet", ["pair in space"])]


DIMENSIONS = {2: "plane", 3: "space"}


def exponent(value):
    return "0" if value == 0 else "%.1e" % value


def table(header, rows):
    lines = [header, ["---"] * len(header)] + [[str(cell).replace("|", "\\|") for cell in row] for row in rows]
    return "\n".join("| %s |" % " | ".join(line) for line in lines) + "\n"


def classes(lower_ends):
    """(low, high, name) of every class."""
    for low, high in zip(lower_ends, lower_ends[1:] + [np.inf]):
        if high == 1e-300:
            yield 0., 1e-300, "0"
        else:
            start = "> 0" if low == 1e-300 else "%g" % low
            yield low, high, start + (" and more" if np.isinf(high) else " … %g" % high)


def axis_table(scenes, column, name, lower_ends):
    rows = []
    for low, high, text in classes(lower_ends):
        part = scenes[(scenes[column] >= low) & (scenes[column] < high)]
        if len(part):
            rows.append([text, len(part), exponent(part.certificate.max()), int(part.events.sum()),
                         int((part.verdict == "limit load").sum()), int((part.verdict == "no continuation").sum()),
                         int(part.failed.sum())])
    return "### %s\n\n%s" % (name[0].upper() + name[1:], table(
        ["class", "scenes", "worst certificate", "events", "limit loads", "no continuation", "failures"], rows))


def verdict_table(scenes):
    rows = []
    for (verdict, by), part in scenes.groupby(["verdict", "confirmed_by"]):
        rows.append([verdict, by or "not confirmed", len(part), exponent(part.certificate.max())])
    return table(["verdict", "confirmed by", "scenes", "worst certificate"], rows)


END_NAMES = ["scenes", "done", "limit load", "no continuation", "interrupted", "outside of the law", "exit code 2", "certificate above bound", "other failures"]


def ends(part):
    """How many scenes end how, in the order of END_NAMES."""
    uncertified = part.failure.str.startswith("certificate")
    outside = part.confirmed_by == "limit of the law"
    not_computed = (part.verdict == "numerical failure") & ~outside
    return [len(part), *[int((part.verdict == v).sum()) for v in ("done", "limit load", "no continuation", "interrupted")],
            int(outside.sum()), int(not_computed.sum()), int((uncertified & ~not_computed).sum()),
            int((part.failed & ~uncertified & ~not_computed).sum())]


def dimension_table(scenes):
    return table(["dimension", *END_NAMES],
                 [[DIMENSIONS[dimension], *ends(part)] for dimension, part in scenes.groupby("dimension")])


def feature_table(scenes):
    """Ends of all scenes that have a feature, plane and space apart."""
    of_scene = scenes.features.map(lambda text: text.split("; "))
    rows = []
    for feature in sorted({feature for features in of_scene for feature in features if feature}):
        for dimension, part in scenes[of_scene.map(lambda features: feature in features)].groupby("dimension"):
            rows.append([feature, DIMENSIONS[dimension], *ends(part)])
    return table(["feature", "dimension", *END_NAMES], rows)


def kind_table(scenes, kinds):
    rows = []
    for kind, purpose in kinds:
        part = scenes[scenes.scene == kind]
        if len(part):
            rows.append([kind, purpose, len(part), *[int((part.verdict == v).sum()) for v in
                        ("done", "limit load", "no continuation")], int(part.events.sum()), int(part.zero_steps.sum()),
                         exponent(part.certificate.max()), "%.2f" % part.seconds.max(), int(part.failed.sum())])
    return table(["kind", "contains", "scenes", "done", "limit load", "no continuation", "events", "zero-length steps",
                  "worst certificate", "longest [s]", "failures"], rows)


def failure_table(failed):
    if not len(failed):
        return "None.\n"
    return table(["scene", "seed", "verdict", "what"],
                 [[row.scene, row.seed, row.verdict, row.failure] for row in failed.itertuples()])


def cause_table(failed, causes):
    """What the program says itself comes first."""
    def cause(row):
        said = str(row.message)
        return said if said.startswith("ill-conditioned") else causes.get((row.scene, int(row.seed)), "unknown")
    return table(["scene", "seed", "cause"], [[row.scene, row.seed, cause(row)] for row in failed.itertuples()])


def known_causes():
    """tests/stress/causes.csv: scene,seed,cause of failures that have been understood."""
    path = pathlib.Path(__file__).parent / "causes.csv"
    if not path.is_file():
        return {}
    return {(row.scene, int(row.seed)): row.cause for row in pd.read_csv(path).itertuples()}


def plot(scenes, path):
    """Worst certificate over the largest compliance and the largest friction coefficient of a scene."""
    rho_classes = [0, 1e-300] + [10. ** e for e in range(-11, 4, 2)]
    f_classes = [0, 1e-300] + [.25 * i for i in range(1, 13)]
    worst = np.full((len(f_classes), len(rho_classes)), np.nan)
    column = np.digitize(scenes.rho_max, rho_classes) - 1
    row = np.digitize(scenes.friction, f_classes) - 1
    for i, j, value in zip(row, column, scenes.certificate):
        worst[i, j] = np.fmax(worst[i, j], max(value, 1e-17))
    figure, axes = plt.subplots(figsize=(8.5, 5.5))
    image = axes.pcolormesh(np.log10(worst), cmap="viridis", vmin=-17, vmax=np.log10(BOUND), edgecolors="white", linewidth=.5)
    for i in range(worst.shape[0]):
        for j in range(worst.shape[1]):
            if np.isfinite(worst[i, j]):
                axes.text(j + .5, i + .5, "%.0f" % np.log10(worst[i, j]), ha="center", va="center", fontsize=7,
                          color="white" if worst[i, j] < 1e-12 else "black")
    axes.set_xticks(np.arange(len(rho_classes)) + .5)
    axes.set_xticklabels(["0", "to 1e-11"] + ["%.0e" % v for v in rho_classes[2:]], rotation=45, ha="right")
    axes.set_yticks(np.arange(len(f_classes)) + .5)
    axes.set_yticklabels(["0", "to 0.25"] + ["from %g" % v for v in f_classes[2:]])
    axes.set_xlabel("largest compliance ρ of the scene, class from [m/MPa]")
    axes.set_ylabel("largest friction coefficient f of the scene")
    figure.colorbar(image, label="log10 of the worst certificate (bound: %.0f)" % np.log10(BOUND))
    axes.set_title("%d scenes: worst certificate in each class" % len(scenes))
    figure.tight_layout()
    figure.savefig(path, dpi=110, metadata={"Software": None})


def page(scenes, kinds, causes):
    failed = int(scenes.failed.sum())
    confirmed = int((~scenes.confirmed_by.isin(["", "certificate"])).sum())
    of_ends = dict(zip(END_NAMES, ends(scenes)))
    not_right = of_ends["exit code 2"] + of_ends["certificate above bound"]
    motions = scenes.not_accounted
    head = """
    <!-- Generated by `./check stress`. Do not edit: run it again. -->
    # Stability: random scenes against independent solvers

    `./check stress` draws scenes from %d families, all numbers at random from a kind and a seed, runs each like a
    user's (parameter file, mesh, bodies, path, results) in a process of its own, and has the outcome examined by
    the judges of `tests/judges`, which share nothing with the solver. One scene again:
    `build/release/tests/stress_campaign --kind KIND --seed SEED --seeds 1 --keep DIRECTORY`.

    * **%d scenes, %d failures.** %d verdicts confirmed by an independent solver.
    * Worst certificate: **%s** (bound %.0e). %d of the scenes are above 1e-10, %d above 1e-12.
    * Exit code 2 or 4: %d scenes, %.2f %%.
    * %d events, %d steps, %d of them of zero length.
    * %d motions: %d of them have a ledger that accounts for all energy but 1e-10 of the largest.
    * %d contact elements in the largest scene; longest scene %.1f s.
    """ % (scenes.scene.nunique(), len(scenes), failed, confirmed, exponent(scenes.certificate.max()), BOUND,
           (scenes.certificate > 1e-10).sum(), (scenes.certificate > 1e-12).sum(), not_right, 100. * not_right / len(scenes),
           scenes.events.sum(), scenes.steps.sum(), scenes.zero_steps.sum(), motions.count(), (motions <= 1e-10).sum(),
           scenes.elements.max(), scenes.seconds.max())
    text = textwrap.dedent(head).lstrip()
    text += """
![Worst certificate over compliance and friction](stability.png)

## What confirms a verdict

A **done** needs a certificate below the bound (theory, section 8). In addition up to seven steps of the path, the
last one among them, are solved again by a semismooth Newton method, or by lexicographic Lemke, from the slips at
their beginning: "solved again" means that all gave the same forces and jumps to 1e-6; "residual" that for some the
other solver found no solution or another one (with much friction there are several), while the state of the path
satisfies all conditions of the step, measured by the judges, to 1e-8.

A **limit load** or **no continuation** needs proof that the path cannot go on: "enumeration" means that all
combinations of states of the elements on a boundary were tried and none satisfies the rate inequalities; "Lemke
ray" that there are too many to try and lexicographic Lemke, with twelve covering vectors, and an implicit step to a load larger by
1e-6 of a stage found none. "Mechanism" is a further witness: the motion that the program reports changes no force,
parts no pressed lips and slides only where the strength is exhausted.

Scenes **in space**: an extruded plane scene is compared with the path of its section at all load levels ("plane section": end, verdict,
forces per area, opening and slip to 1e-6). Of the others up to seven steps are solved again by a semismooth Newton method for circular cones;
where directions of slip turn, an implicit step is another one, and "residual" says that the state satisfies all conditions but the direction.
"No implicit step" means that this method finds none to a load larger by 1e-4 and 1e-3 of a stage (in the plane, where bodies that move freely leave
the rates undecided: 1e-5 and 1e-4). Where the continuation is not unique, "implicit
step" means that it finds one of them; how many there are is not examined in space.

A **motion** is **interrupted** after twenty seconds of a processor, as a user would with Ctrl-C, and what it has reached is
examined like the others: certificate, energies, and up to four seconds of it followed again, every fifth piece solved again.

"Limit of the law": the run ended with the message that a layer is outside of its law, and by the forces there it has closed by its
`Shear growth closure`, all but a millionth. Such a draw has no answer; it is not counted as a failure.

"Certificate" means that no independent solver was asked. They know linear and rigid layers, law (9) as a secant,
friction (residual friction included) and cohesion; whether a path can go on they also say on other layers without
coupling, by their tangents. Tensile strength, dilatancy and forces that broken bonds have not yet released are left to the
certificate: equilibrium, strengths, laws and energy, checked with the data and without the solver.

"""
    text += verdict_table(scenes)
    text += "\n## Failures\n\n" + failure_table(scenes[scenes.failed])
    text += "\n## How scenes end\n\n" + dimension_table(scenes) + "\n" + feature_table(scenes)
    for dimension, name in DIMENSIONS.items():
        text += "\n## Kinds of scenes: %s\n\n" % name + kind_table(scenes[scenes.dimension == dimension], kinds)
    text += "\n## Which known weakness is where\n\n" + table(["weakness", "kinds"], [
        [name, ", ".join(kind for kind in where if (scenes.scene == kind).any())] for name, where in DEGENERACIES])
    text += "\n## Worst certificates along the axes\n\n"
    text += "\n".join(axis_table(scenes, *axis) for axis in AXES)
    law_rows = [[law, len(part), exponent(part.certificate.max()), int(part.failed.sum())]
                for law, part in scenes.groupby("law")]
    text += "\n### Laws of the layer\n\n" + table(["law", "scenes", "worst certificate", "failures"], law_rows)
    entry_rows = [[entry, len(part), exponent(part.certificate.max())] for entry, part in scenes.groupby("worst_entry")]
    text += "\n### Worst entry of the certificate\n\n" + table(["entry", "scenes", "largest"], entry_rows)
    if failed:
        text += "\n" + by_hand("tests/stress/causes.csv", "../tests/stress/causes.csv",
                               "Causes of the failures:\n\n" + cause_table(scenes[scenes.failed], causes))
    return text


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("table")
    parser.add_argument("program")
    parser.add_argument("--doc", default=str(TOP / "doc"))
    options = parser.parse_args()
    scenes = pd.read_csv(options.table, keep_default_na=False, na_values={c: [""] for c in
                         ("certificate", "events", "zero_steps", "seconds", "steps", "elements", "difference", "t", "dimension",
                          "not_accounted")})
    scenes["failed"] = scenes.failure != ""
    kinds = [line.split("\t") for line in
             subprocess.run([options.program, "--list"], capture_output=True, text=True, check=True).stdout.splitlines()]
    doc = pathlib.Path(options.doc)
    plot(scenes[~scenes.certificate.isna()], doc / "stability.png")
    (doc / "stability.md").write_text(page(scenes, kinds, known_causes()), encoding="utf-8")
    print("%s: %d scenes, %d failures" % (doc / "stability.md", len(scenes), scenes.failed.sum()))


main()
