#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Sweeps of any entry of a parameter file.

* Every row is the run of that variant alone, to the last digit: verdict, load time, number of events, what drives the stage,
  resultants, displacements, certificate, factors of safety, and the slips, openings and energies of a motion. Varied are strength,
  layers, elasticity, drains, levels, seismic coefficients, constants, the mesh, the order of the stages, records and their scale.
* Factors of safety of a block on a plane inclined by alpha, F = tan phi / tan alpha, and of a dam that slides on its base,
  F = f N / T, by statics. Tolerance 1e-9: rounding.
* Variants that differ in their joints only share one condensation; with dynamic stages there is one for each length of step and one
  more for the stages that follow the first.
* The fit of tools/fragility_page.py: where two levels have shares p and q the curve of the largest likelihood goes through both,
  so that theta and beta follow from quantiles of the normal distribution; counts that decide nothing give none.
* A wrong value is told before anything is computed, in the words of the parameter file with the line of the sweep.

usage: sweep.py FUGA
"""
import csv
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

FUGA = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
ROUNDING = 1e-9
MONITOR = "\nsubsection Monitors\n  subsection crest\n    set Point = {}\n  end\nend\n"
LEVELS = tuple(f"Loads/{load}/Level=1: 0; 2: {{}}" for load in ("water", "uplift"))
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def fuga(parameters, folder, settings):
    words = [word for setting in (*settings, "Output/Fields=never") for word in ("--set", setting)]
    return subprocess.run([FUGA, parameters, "--quiet", "--output-dir", folder, *words], capture_output=True, text=True, check=False)


def rows(path):
    """The rows of a table by the names of the columns, without units."""
    with open(path, newline="", encoding="utf-8") as file:
        return [{name.split("[")[0]: value for name, value in row.items()} for row in csv.DictReader(file)]


def write(folder, name, monitor=None, changes=()):
    """A file of parameters/, with a monitor and other changes, that is read from anywhere."""
    text = (ROOT / f"parameters/{name}.prm").read_text(encoding="utf-8").replace("../meshes", str(ROOT / "meshes"))
    for old, new in changes:
        if old not in text:
            sys.exit(f"{name}.prm does not contain {old}")
        text = text.replace(old, new)
    path = folder / f"{name}.prm"
    path.write_text(text + (MONITOR.format(monitor) if monitor else ""), encoding="utf-8")
    return path


def single_run(folder):
    """What a row says, out of the files of a run."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    result = {"verdict": summary["verdict"], "t": summary["t"], "exit_code": summary["exit_code"],
              "driven_by": summary["driven_by"], "drive": summary["drive"], "certificate": summary["certificate"]["worst"]}
    if "safety" not in summary:  # whose events count as well
        result["events"] = summary["events"]["total"]
    result["mechanism"] = summary.get("limit_load", {}).get("mechanism", "none")
    for method, safety in summary.get("safety", {}).items():
        result[f"safety_{method}"] = "nan" if safety["factor"] is None else safety["factor"]
        result[f"safety_{method}_verdict"] = safety["verdict"]
    for row in rows(folder / "resultants.csv"):  # the last ones up to the end of the loads
        if float(row["t"]) <= summary["t"]:
            for name in ("N", "T", "T2", "M", "share_open", "share_slip", "largest_pressure", "sliding_safety",
                         "overturning_safety", "cracked_length"):
                if name in row:
                    result[f"{row['joint']} {name}"] = row[name]
    if (folder / "earthquake.csv").exists():
        moments = rows(folder / "earthquake.csv")
        result["base largest_opening"] = max(float(row["largest_gap"]) for row in moments)
        result["largest_energy"] = summary["motion"]["largest_energy"]
        names = ["work", "kinetic_energy", "energy_bodies", "damping", "joint_work", "numerical", "sudden"]
        result.update({name: moments[-1][name] for name in names})
        if float(moments[-1]["t"]) == summary["t"]:
            result.update({f"base {name}": moments[-1][name] for name in ("mean_slip", "largest_slip")})
    if (folder / "monitors.csv").exists():
        for row in rows(folder / "monitors.csv"):
            if float(row["t"]) <= summary["t"]:
                result.update({f"{row['monitor']} {name}": row[name] for name in ("ux", "uy", "uz") if name in row})
    return result


def same(one, other):
    try:
        a, b = float(one), float(other)
        return a == b or (math.isnan(a) and math.isnan(b))
    except ValueError:
        return one == other


def compare(what, folder, parameters, sweep, variants, fixed=(), condensations=1, factorisations=None):
    """Rows of a sweep against runs. `variants`: the settings of the runs, in the order of the rows. `factorisations`: the
    largest number of them, where they are not one for each condensation."""
    run = fuga(parameters, folder / "sweep", (*sweep, *fixed))
    check(run.returncode == 0, f"{what}: exit code {run.returncode}: {run.stdout}{run.stderr}")
    if run.returncode != 0:
        return []
    table = rows(folder / "sweep/sweep.csv")
    check(len(table) == len(variants), f"{what}: {len(table)} rows instead of {len(variants)}")
    summary = json.loads((folder / "sweep/summary.json").read_text(encoding="utf-8"))
    check(summary["condensations"] == condensations, f"{what}: {summary['condensations']} condensations")
    made = summary["work"]["factorisations_of_bodies"]
    check(made <= factorisations if factorisations else made == condensations, f"{what}: {made} factorisations")
    log = (folder / "sweep/log.txt").read_text(encoding="utf-8")
    for i, (row, settings) in enumerate(zip(table, variants)):
        check(row["variant"] == str(i + 1), f"{what}: variant {row['variant']} in row {i + 1}")
        alone = folder / f"run_{i}"
        run = fuga(parameters, alone, (*settings, *fixed))
        expected = single_run(alone)
        check(run.returncode == int(row["exit_code"]), f"{what}, {settings}: exit code {run.returncode}, not {row['exit_code']}")
        if not any(name.endswith(" uz") for name in row):  # monitors.csv has it also in the plane
            expected = {name: value for name, value in expected.items() if not name.endswith(" uz")}
        for name, value in expected.items():
            check(same(row[name], value), f"{what}, {settings}: {name} = {row[name]} in the sweep, {value} in the run")
        check(f"t = {float(row['t']):<12.9g}" in log, f"{what}: no line of the log for variant {i + 1}")
    return table


def dams(folder):
    dam = write(folder, "dam", "1, 10")
    low = tuple(level.format(28) for level in LEVELS)
    high = tuple(level.format(36) for level in LEVELS)
    strength = "Joints/base/Friction coefficient"
    table = compare("strength and cohesion", folder / "strength", dam, [f"Sweep/{strength}=0.5, 0.7", "Sweep/Joints/*/Cohesion=0, 20"],
                    [(f"{strength}={f}", f"Joints/base/Cohesion={c}") for f in (0.5, 0.7) for c in (0, 20)])
    if table:
        check([row[strength] for row in table] == ["0.5", "0.5", "0.7", "0.7"], f"the column of {strength}")
    compare("angle and elasticity", folder / "elasticity", dam,
            ["Sweep/Joints/base/Friction angle=30, 40", "Sweep/Bodies/dam/Young modulus=2.5e7, 2*2.5e7"],
            [("Joints/base/Friction coefficient=", f"Joints/base/Friction angle={phi}", f"Bodies/dam/Young modulus={E}")
             for E in (2.5e7, 5e7) for phi in (30, 40)], condensations=2)
    compare("drains", folder / "drains", dam, ["Sweep/Loads/uplift/Drain distance=3, 6", "Sweep/Loads/uplift/Drain efficiency=0.5, 0.9",
                                               "Sweep/Combination=in step"],
            [(f"Loads/uplift/Drain distance={d}", f"Loads/uplift/Drain efficiency={e}") for d, e in ((3, 0.5), (6, 0.9))], condensations=2)
    compare("levels", folder / "levels", dam, ["Sweep/Loads/water, uplift/Level=1: 0; 2: 28 | 1: 0; 2: 36"], [low, high], condensations=2)
    table = compare("levels and safety", folder / "safety", dam,
            ["Sweep/Loads/water, uplift/Level=1: 0; 2: 28 | 1: 0; 2: 36", f"Sweep/{strength}=0.7, 0.9"],
            [(*level, f"{strength}={f}") for level in (low, high) for f in (0.7, 0.9)], condensations=2,
            fixed=("Safety/Strength reduction=yes", "Safety/Load factor=water", "Safety/Largest factor=2"))
    check([row["verdict"] for row in table][:2] == ["done", "done"], "the dam does not hold at 28 m")
    for row in table[:2]:  # it slides as a whole
        factor = float(row[strength]) * abs(float(row["base N"])) / float(row["base T"])
        check(abs(float(row["safety_strength_reduction"]) - factor) <= ROUNDING * factor,
              f"F = {row['safety_strength_reduction']} instead of f N / T = {factor}")


def other_models(folder):
    high_dam = write(folder, "high_dam", "3, 20")
    compare("seismic coefficient", folder / "seismic", high_dam, ["Sweep/Constants/kh=-0.05, 0.05"],
            [(f"Constants/kh={k}",) for k in (-0.05, 0.05)], fixed=("Mesh/Polynomial degree=1",), condensations=2)
    block = write(folder, "scene_g_f02", "0, 40", [("scene_g_33", "scene_g_9")])
    compare("mesh", folder / "mesh", block, ["Sweep/Mesh/Refinements=0, 1"],
            [(f"Mesh/Refinements={n}",) for n in (0, 1)], condensations=2)
    compare("laws", folder / "laws", block, ["Sweep/Joints/base/Normal law=rigid, linear", "Sweep/Joints/base/Friction coefficient=0.1, 0"],
            [(f"Joints/base/Normal law={law}", *(("Joints/base/Normal stiffness=",) if law == "rigid" else ()), f"Joints/base/Friction coefficient={f}")
             for f in (0.1, 0) for law in ("rigid", "linear")], condensations=2)
    in_space = write(folder, "dam_block_3d", "1, 1, 5")
    compare("friction in space", folder / "space", in_space, ["Sweep/Joints/base/Friction coefficient=0.7, 0.5"],
            [(f"Joints/base/Friction coefficient={f}",) for f in (0.7, 0.5)])


def earthquakes(folder):
    """The records with the smaller peaks last longer. Behind the second dam's earthquake comes no other stage."""
    for frequency in (3, 4, 5):
        subprocess.run([sys.executable, ROOT / "tools/synthetic_record.py", "ricker", "--frequency", str(frequency), "--peak",
                        str(0.1 * frequency), "--output", folder / f"wave_{frequency}.txt"], check=True)
    record = ("records/noise.txt", "wave_3.txt")
    shaken = write(folder, "dam_earthquake", "1, 10", [record])
    (folder / "last").mkdir()
    last = write(folder / "last", "dam_earthquake", "1, 10", [
        ("records/noise.txt", "../wave_3.txt"), ("  subsection afterwards\n    set Loads = weight: 1\n  end\n", "")])
    fixed = ("Stages/earthquake/Duration=2.5", "Stages/earthquake/Levels=2", "Dynamics/Event tolerance=1e-3")
    strength, scale, waves = "Joints/base/Friction coefficient", "Earthquake/Scale", "Earthquake/Record x"
    variants = [(f"{waves}=wave_{f}.txt", f"{scale}={s}", f"{strength}={mu}") for f, s, mu in ((3, 1.2, 0.7), (4, 0.9, 0.8), (5, 1, 0.75))]
    table = compare("earthquakes", folder / "sweep", shaken, [
        f"Sweep/{waves}=wave_3.txt, wave_4.txt, wave_5.txt", f"Sweep/{scale}=1.2, 0.9, 1", f"Sweep/{strength}=0.7, 0.8, 0.75",
        "Sweep/Combination=in step"], variants, fixed, factorisations=8)
    check(len({row["base largest_slip"] for row in table}) == 3, "all earthquakes let the dam slide alike")
    compare("earthquakes at the end", folder / "last", last, [f"Sweep/{scale}=0.9, 1.2"], [(f"{scale}={s}",) for s in (0.9, 1.2)],
            fixed, factorisations=8)


def fragility(_):
    sys.path.insert(0, str(ROOT / "tools"))
    from fragility_page import fit
    normal = statistics.NormalDist()
    p, q = normal.inv_cdf(0.2), normal.inv_cdf(0.9)
    beta = math.log(0.5 / 0.2) / (q - p)
    expected = (0.2 * math.exp(-beta * p), beta)
    for found, known in zip(fit((0.2, 0.5), (2, 9), 10) or (math.nan, math.nan), expected):
        check(abs(found - known) <= ROUNDING * known, f"fit of two levels: {found} instead of {known}")
    for counts in ((0, 0, 0), (0, 10, 10), (0, 5, 10), (5, 5, 5)):
        check(fit((0.2, 0.3, 0.5), counts, 10) is None, f"a fit of the counts {counts}")


def inclined_block(folder):
    """The weight inclined by alpha instead of the plane; the resultant stays in the base, so that the block slides."""
    prm = write(folder, "scene_g_f06", None, [("scene_g_33", "scene_g_9")])
    angles, frictions = (10, 15), (20, 30, 35)
    run = fuga(prm, folder / "sweep", (
        "Constants/alpha=10", "Loads/weight/Value=sin(alpha*pi/180); -cos(alpha*pi/180)", "Stages/water/Loads=water: 0",
        "Sweep/Constants/alpha=10, 15", "Sweep/Joints/base/Friction angle=20, 30, 35", "Safety/Strength reduction=yes"))
    check(run.returncode == 0, f"inclined block: {run.returncode}: {run.stderr}")
    table = rows(folder / "sweep/sweep.csv") if run.returncode == 0 else []
    expected = [(alpha, phi) for alpha in angles for phi in frictions]
    check(len(table) == len(expected), f"inclined block: {len(table)} rows")
    for row, (alpha, phi) in zip(table, expected):
        factor = math.tan(math.radians(phi)) / math.tan(math.radians(alpha))
        check(abs(float(row["safety_strength_reduction"]) - factor) <= ROUNDING * factor,
              f"alpha {alpha}, phi {phi}: F = {row['safety_strength_reduction']} instead of {factor}")
        check(row["safety_strength_reduction_verdict"] == "limit load", f"verdict {row['safety_strength_reduction_verdict']}")


def wrong_input(folder):
    """Nothing is computed, also where only the mesh tells what is wrong, and only in the last variant."""
    dam = write(folder, "dam")
    for settings, parts in (
            (("Sweep/Joints/base/Friction coefficient=0.5, high",), ("Sweep/Joints/base", "= 'high'", "finite number")),
            (("Sweep/Loads/uplift/Drain positoin=3, 6",), ("unknown entry 'Drain positoin'", "Drain")),
            (("Sweep/Boundaries/crest/Fixed=free, all, held",), ("'held'",)),
            (("Sweep/Loads/water/Boundaries=upstream, reservoir_bed | upstream, seabed",),
             ("no boundary 'seabed'", "(In the variant Loads/water/Boundaries = upstream, seabed.)")),
            (("Sweep/Joints/base/Initial gap=0, -0.001",), ("initial gap", "(In the variant Joints/base/Initial gap = -0.001.)"))):
        for option in ((), ("--check",)):
            out = folder / "nothing"
            words = [word for setting in settings for word in ("--set", setting)]
            run = subprocess.run([FUGA, dam, *option, "--output-dir", out, *words], capture_output=True, text=True, check=False)
            check(run.returncode == 1, f"{settings}: exit code {run.returncode}")
            for part in parts:
                check(part in run.stderr, f"{settings}: no {part!r} in {run.stderr}")
            check(not (out / "sweep.csv").exists(), f"{settings}: there is a table")
    run = subprocess.run([FUGA, dam, "--check", "--set", "Sweep/Bodies/dam/Young modulus=1e7, 2e7", "--set", "Sweep/Cohesion=0, 1"],
                         capture_output=True, text=True, check=False)
    check(run.returncode == 0 and "4 variants" in run.stdout and "2 times" in run.stdout, f"check of a sweep: {run.stdout}{run.stderr}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for part in (dams, other_models, earthquakes, fragility, inclined_block, wrong_input):
            directory = folder / part.__name__
            directory.mkdir()
            part(directory)
    print("\n".join(complaints[:30]) or "every row of a sweep is the run of its variant")
    sys.exit(1 if complaints else 0)


main()
