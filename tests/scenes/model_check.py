#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What fuga --check says a model adds up to, against hand calculations; no warning about shipped files; one about every
mistake that is put into them.

usage: model_check.py FUGA
"""
import pathlib
import re
import subprocess
import sys
import tempfile

FUGA = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[2]
PRINTED = 1e-5  # relative: six digits are printed
complaints = []
n_checks = 0


def check(condition, text):
    global n_checks
    n_checks += 1
    if not condition:
        complaints.append(text)


class Check:
    """The tables and warnings that the check of a shipped file prints; with `again`, the entries of one more load."""

    def __init__(self, name, *settings, again=()):
        self.name = " ".join((name,) + settings + tuple(again))
        path = ROOT / "parameters" / (name + ".prm")
        arguments = [item for setting in settings for item in ("--set", setting)]
        with tempfile.TemporaryDirectory() as folder:
            if again:
                load = "subsection Loads\n  subsection again\n" + "".join(f"    set {line}\n" for line in again) + "  end\n"
                text = path.read_text(encoding="utf-8").replace("subsection Loads\n", load, 1)
                for name_of_boundary in re.findall(r"Boundaries = (\w+)", load):
                    text = text.replace(f"  subsection {name_of_boundary}\n    set Fixed = free\n  end\n", "")
                text = text.replace("../meshes", str(ROOT / "meshes")).replace("water: 1; uplift: 1", "water: 1; uplift: 1; again: t")
                path = pathlib.Path(folder) / (name + ".prm")
                path.write_text(text, encoding="utf-8")
            run = subprocess.run([FUGA, "--check", str(path), *arguments], capture_output=True, text=True, timeout=300)
        check(run.returncode == 0, f"{self.name}: exit code {run.returncode}: {run.stderr}")
        self.lines = run.stdout.splitlines()
        self.warnings = [line[len("Warning: "):] for line in self.lines if line.startswith("Warning: ")]
        word = {0: "", 1: ", one warning"}.get(len(self.warnings), f", {len(self.warnings)} warnings")
        check(self.lines[-1:] and self.lines[-1].endswith(f"{name}.prm: no errors found{word}."),
              f"{self.name}: the last line is {self.lines[-1:]}")

    def table(self, title):
        """Rows of cells under the title, without the header; an empty cell is missing."""
        at = next((i for i, line in enumerate(self.lines) if line.startswith(title)), len(self.lines))
        rows = []
        for line in self.lines[at + 2:]:
            if not line.startswith("  "):
                break
            rows.append(re.split(r"\s{2,}", line.strip()))
        return rows

    def expect(self, row, expected):
        """Texts are equal, numbers agree as printed."""
        same = len(row) == len(expected) and all(
            cell == value if isinstance(value, str) else abs(float(cell) - value) <= PRINTED * abs(value)
            for cell, value in zip(row, expected))
        check(same, f"{self.name}: {row} instead of {expected}")


def dam():
    """The polygon (0,0), (18,0), (4,30), (0,30): 330 m2, 7920 kN, its centroid (18^2 + 18 4 + 4^2)/(3 22) = 412/66 from
    the face and 10 (18 + 2 4)/22 above the base. Water 28 m deep: 9.81 28^2/2 at 28/3 on the face, 36 m of the bed
    with 9.81 28 in their middle x = -18. Uplift in units of 9.81 28: 1 at the heel, (1 - 0.5)(1 - 3/18) = 5/12 at the
    drains 3 m from it, 0 at the toe, hence 3 (1 + 5/12)/2 + 15 5/24 = 5.25 m with the moment 3^2/6 (1 + 10/12) +
    8 15 5/24 = 27.75 m2 about the heel."""
    of_dam = Check("dam")
    bodies = of_dam.table("Bodies")
    of_dam.expect(bodies[0], ["dam", 330, "396", 7920, "6.24242, 11.8182"])  # 18 x 22 cells; 10 x (10 + 18 + 10)
    of_dam.expect(bodies[1], ["rock", 90 * 36, "380", "0", "9, -18"])
    of_dam.expect(of_dam.table("Joints")[0], ["base", 18, "37", "0", "0", "0, 1"])  # 18 quadratic faces
    supports = of_dam.table("Supports")
    of_dam.expect(supports[0], ["rock_bottom", "x, y", 90, "77"])  # 10 + 18 + 10 quadratic faces
    of_dam.expect(supports[1], ["rock_sides", "x", 72, "42"])  # twice 10 faces

    weight = of_dam.table("Loads at the end of stage 'weight' (t = 1)")
    check(len(weight) == 1, f"dam: {weight}")
    of_dam.expect(weight[0], ["weight", "1", "Fy", -7920, 412 / 66])
    rows = of_dam.table("Loads at the end of stage 'reservoir' (t = 2)")
    head = 9.81 * 28
    of_dam.expect(rows[0], ["weight", "1", "Fy", -7920, 412 / 66])
    of_dam.expect(rows[1], ["water", "1", "28", "Fx", head * 28 / 2, 28 / 3])
    of_dam.expect(rows[2], ["Fy", -head * 36, -18])
    of_dam.expect(rows[3], ["uplift in base", "1", "28", "Fy", head * 5.25, 27.75 / 5.25])
    # Uplift presses both sides of the joint: it is no part of the sum.
    total = -7920 - head * 36
    of_dam.expect(rows[4], ["all, without water in joints", "Fx", head * 28 / 2, 28 / 3])
    of_dam.expect(rows[5], ["Fy", total, (-7920 * 412 / 66 + head * 36 * 18) / total])
    check(len(rows) == 6, f"dam: {rows}")


def block_in_space():
    """(24 + 4)/2 30 15 = 6300 m3, 151200 kN; centroid (24^2 + 24 4 + 4^2)/(3 28) = 688/84 from the face, 7.5 m along it,
    10 (24 + 8)/28 above the base. Water 27 m deep: 9.81 27^2/2 15 at y = 7.5, z = 9; on the bed 9.81 27 36 15."""
    block = Check("dam_block_3d")
    block.expect(block.table("Bodies")[0], ["dam", 6300, "400", 151200, "8.19048, 7.5, 11.4286"])
    block.expect(block.table("Joints")[0], ["base", 360, "54", "0", "0", "0, 0, 1"])  # (8 + 1)(5 + 1) nodes
    rows = block.table("Loads at the end of stage 'reservoir' (t = 2)")
    block.expect(rows[0], ["weight", "1", "Fz", -151200, 688 / 84, 7.5])
    block.expect(rows[1], ["water", "1", "27", "Fx", 9.81 * 27**2 / 2 * 15, 7.5, 9])
    block.expect(rows[2], ["Fz", -9.81 * 27 * 36 * 15, -18, 7.5])


def others():
    """Names of units; phases of construction; gaps; loads that are no forces; a quiet check says nothing."""
    text = "\n".join(Check("dam", "Output/Force unit=daN", "Output/Length unit=dm").lines)
    for words in ("area [dm2]", "weight [daN]", "centroid x, y [dm]", "level [dm]", "at x [dm]"):
        check(words in text, f"'{words}' is not in\n{text}")
    check("weight [MN]" in "\n".join(Check("paper_2_linear").lines), "units by default")
    check(" 0.25 " in " ".join(Check("paper_2_linear", "Joints/base/Initial gap=0.25").lines), "initial gap")
    quiet = subprocess.run([FUGA, "--check", "--quiet", str(ROOT / "parameters" / "dam.prm")], capture_output=True, text=True)
    check(quiet.returncode == 0 and quiet.stdout + quiet.stderr == "", f"quiet: {quiet}")


def shipped():
    """No false alarms; the layer of the number as printed in the paper is stiffer than the bodies, and that is said."""
    for path in sorted((ROOT / "parameters").glob("*.prm")):
        warnings = Check(path.stem).warnings
        expected = 1 if path.stem == "paper_2_as_printed" else 0
        check(len(warnings) == expected, f"{path.name}: warnings {warnings}")


def expect_warning(name, words, *settings, again=()):
    """Exactly one warning, with these words."""
    warnings = Check(name, *settings, again=again).warnings
    check(len(warnings) == 1 and all(word in warnings[0] for word in words), f"{settings}: {warnings}, not {words}")


def implausible_data():
    """Each with the number and the usual range in the units of the file, kN and m; none of them without units."""
    cases = [
        (["Bodies/dam/Weight density = 2400 kN/m3", "5 kN/m3 to 80 kN/m3", "mass"], "Bodies/dam/Weight density=2400"),
        (["Bodies/dam/Young modulus = 2.5e+10 kPa", "5e+05 kPa to 2e+08 kPa"], "Bodies/dam/Young modulus=2.5e10"),
        (["Bodies/dam/Young modulus = 2.5e+04 kPa", "heavy as concrete"], "Bodies/dam/Young modulus=2.5e4"),
        (["Bodies/rock/Young modulus = 20 kPa", "1000 kPa to 4e+08 kPa"], "Bodies/rock/Young modulus=20"),
        (["Bodies/dam/Poisson ratio = 0.499", "0.05 to 0.49", "lock"], "Bodies/dam/Poisson ratio=0.499"),
        (["Bodies/dam/Poisson ratio = 0.02", "0.05 to 0.49"], "Bodies/dam/Poisson ratio=0.02"),
        (["Loads/uplift/Unit weight = 15 kN/m3", "9 kN/m3 to 14 kN/m3"], "Loads/uplift/Unit weight=15"),
        (["friction coefficient = 2.5", "0.03 to 1.5", "Friction angle"], "Joints/base/Friction coefficient=2.5"),
        (["normal stiffness = 20 kPa/m", "1000 kPa/m and more"], "Joints/base/Normal stiffness=20"),
        (["cohesion = 2e+05 kPa", "at most 2e+04 kPa"], "Joints/base/Cohesion=2e5"),
    ]
    for words, setting in cases:
        expect_warning("dam", words, setting)
        without = Check("dam", setting, "Output/Force unit=").warnings
        check(not without, f"{setting} without units: {without}")
    # Water as 1000 (kg/m3) wherever it stands.
    water = [f"Loads/{load}/Unit weight=1000" for load in ("water", "uplift")]
    warnings = Check("dam", *water).warnings
    check(len(warnings) == 2 and all("Unit weight = 1000 kN/m3" in w and "9 kN/m3 to 14 kN/m3. Water has 9.81 kN/m3" in w
                                     for w in warnings), f"water: {warnings}")
    # An angle of 0.7 degrees instead of a coefficient of 0.7: tan 0.7 deg = 0.0122.
    expect_warning("dam", ["friction coefficient = 0.01222", "in degrees"], "Joints/base/Friction coefficient=",
                   "Joints/base/Friction angle=0.7")
    # The same model in MN and mm: every number is wrong by the size of the unit, and so is the mesh, 90 m across.
    of_mesh = [w for w in Check("dam", "Output/Length unit=mm").warnings if "mesh" in w]
    check(len(of_mesh) == 1 and "90 mm" in of_mesh[0] and "300 mm to 5e+06 mm" in of_mesh[0], f"mesh: {of_mesh}")
    of_mesh = [w for w in Check("dam", "Output/Length unit=km").warnings if "mesh" in w]
    check(len(of_mesh) == 1 and "90 km" in of_mesh[0] and "5 km" in of_mesh[0], f"mesh: {of_mesh}")
    unknown = Check("dam", "Bodies/dam/Weight density=2400", "Output/Force unit=stone").warnings
    check(not unknown, f"an unknown unit: {unknown}")


def implausible_loads():
    """Contradictions among loads, whatever the units."""
    water = ["Type = hydrostatic", "Unit weight = 9.81"]
    expect_warning("dam", ["'again' and 'water'", "upstream", "twice"], again=water + ["Boundaries = upstream", "Level = 28"])
    elsewhere = Check("dam", again=water + ["Boundaries = valley", "Level = -1"]).warnings
    check(not elsewhere, f"water elsewhere: {elsewhere}")
    expect_warning("dam", ["'again' and 'weight'", "dam"], again=["Type = weight"])
    check(not Check("dam", again=["Type = seismic", "Horizontal coefficient = 0.1"]).warnings, "an earthquake is no second weight")
    for name, pressure in (("dam", "274.7 kPa"), ("dam_block_3d", "264.9 kPa")):
        expect_warning(name, ["'uplift'", "'base'", pressure, "dry side"], "Loads/uplift/Upstream end=right")
        expect_warning(name, ["'water'", "level 31 m", "ends at 30 m", "'crest'"], "Loads/water/Level=1: 0; 2: 31",
                       "Loads/uplift/Level=1: 0; 2: 31")
    # Water on the downstream face without tailwater in the joint.
    downstream = water + ["Boundaries = downstream", "Level = 5"]
    expect_warning("dam", ["'downstream'", "49.05 kPa", "tailwater"], again=downstream)
    with_tailwater = Check("dam", "Loads/uplift/Tailwater level=5",
                           "Stages/reservoir/Loads=water: t; uplift: t; again: t", again=downstream)
    check(not with_tailwater.warnings, f"tailwater: {with_tailwater.warnings}")
    levels = [row for row in with_tailwater.table("Loads at the end of stage 'reservoir'") if row[0] == "uplift in base"]
    check(levels and levels[0][2] == "28 / 5", f"levels of reservoir and tailwater: {levels}")


def size_of_output():
    """A million levels: as much as the 15 levels of the shipped dam write, multiplied, within a third."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([FUGA, "--quiet", "--output-dir", folder, str(ROOT / "parameters" / "dam.prm")], timeout=300)
        sizes = {path.name: path.stat().st_size for path in pathlib.Path(folder).iterdir()}
    tables = sum(size for name, size in sizes.items() if name in ("joint_history.csv", "resultants.csv"))
    fields = sum(size for name, size in sizes.items() if name.endswith(".vtu"))
    warnings = Check("dam", "Stages/reservoir/Levels=999999").warnings
    numbers = re.findall(r"([\d.e+]+) GB", warnings[0]) if warnings else []
    check(len(warnings) == 1 and warnings[0].startswith("1000000 load levels") and len(numbers) == 2, f"size: {warnings}")
    for number, bytes_of_15 in zip(numbers, (tables, fields)):
        check(abs(float(number) * 15e3 / bytes_of_15 - 1) < 1 / 3, f"size: {number} GB from {bytes_of_15} bytes of 15 levels")
    expect_warning("dam", ["0 GB of fields"], "Stages/reservoir/Levels=1000000", "Output/Fields=end")
    check(not Check("dam", "Stages/reservoir/Levels=1000").warnings, "a thousand levels")


def wrong_monitors():
    """Points that the mesh does not have are told together."""
    wrong = ["--set", "Monitors/crest/Point=5000, 0", "--set", "Monitors/top of lower lift/Point=6000, 0"]
    run = subprocess.run([FUGA, "--check", str(ROOT / "parameters" / "retaining_wall.prm"), *wrong], capture_output=True,
                         text=True, timeout=300)
    check(run.returncode == 1 and "2 errors" in run.stderr and "(5000, 0)" in run.stderr and "(6000, 0)" in run.stderr,
          f"two monitors outside: exit code {run.returncode}: {run.stderr}")


for test in (dam, block_in_space, others, shipped, implausible_data, implausible_loads, size_of_output,
             wrong_monitors):
    test()
print("\n".join(complaints) or f"{n_checks} checks: the model adds up, mistakes are noticed, nothing else is")
sys.exit(1 if complaints or n_checks < 80 else 0)
