#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""An earthquake along any horizontal direction: a model in space, turned about z by 90 and 30 degrees with its water and
its earthquake, has the resultants of the model that is not turned, which are those of statics.

usage: seismic_direction.py FUGA
"""
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

FUGA = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[2]
TOLERANCE = 1e-12
complaints = []

PARAMETERS = """
set Dimension = 3
subsection Mesh
  set File = turned.msh
end
subsection Bodies
  subsection dam
    set Young modulus  = 2.5e7
    set Poisson ratio  = 0.2
    set Weight density = 24
  end
  subsection rock
    set Young modulus = 2e7
    set Poisson ratio = 0.25
  end
end
subsection Joints
  subsection base
    set Line       = base
    set Plus body  = dam
    set Minus body = rock
    set Normal stiffness = 2e7
    set Shear stiffness  = 1e7
    set Friction coefficient = 0.9
  end
end
subsection Boundaries
  subsection rock_bottom
    set Fixed = all
  end
{free}
end
subsection Loads
  subsection weight
    set Type   = weight
    set Bodies = dam
  end
  subsection shaking
    set Type   = seismic
    set Bodies = dam
    set Horizontal coefficient = {horizontal}
    {direction}
    set Vertical coefficient   = 0.05
  end
  subsection moved_water
    set Type        = westergaard
    set Boundaries  = upstream
    set Level       = 20
    set Unit weight = 9.81
    set Horizontal coefficient = 0.1
    set Bottom level = 0
  end
end
subsection Stages
  subsection weight
    set Loads = weight: t
  end
  subsection earthquake
    set Loads = shaking: t; moved_water: t
  end
end
subsection Output
  set Fields = never
  set Checkpoint = never
end
"""


def check(condition, text):
    if not condition:
        complaints.append(text)


def turned_mesh(angle):
    """The shipped mesh with turned nodes; the coordinates of a node are the only lines of three numbers there."""
    lines = (ROOT / "meshes" / "dam_block_3d.msh").read_text().splitlines()
    begin, end = lines.index("$Nodes"), lines.index("$EndNodes")
    c, s = math.cos(angle), math.sin(angle)
    for i in range(begin + 2, end):
        words = lines[i].split()
        if len(words) == 3:
            x, y = float(words[0]), float(words[1])
            lines[i] = f"{c * x - s * y!r} {s * x + c * y!r} {words[2]}"
    return "\n".join(lines) + "\n"


def last_row(folder, degrees, horizontal, direction):
    folder = pathlib.Path(folder)
    (folder / "turned.msh").write_text(turned_mesh(math.radians(degrees)))
    free = "\n".join(f"  subsection {name}\n    set Fixed = free\n  end" for name in
                     ("rock_sides", "rock_ends", "dam_ends", "downstream", "crest", "reservoir_bed", "valley"))
    (folder / "turned.prm").write_text(PARAMETERS.format(free=free, horizontal=horizontal, direction=direction))
    run = subprocess.run([FUGA, str(folder / "turned.prm"), "--quiet", "--output-dir", str(folder / "results")],
                         capture_output=True, text=True, timeout=300)
    check(run.returncode == 0, f"{degrees} degrees: exit code {run.returncode} {run.stderr}")
    with open(folder / "results" / "resultants.csv", newline="", encoding="utf-8") as file:
        row = list(csv.DictReader(file))[-1]
    return {key.split("[")[0]: float(value) for key, value in row.items() if key not in ("joint", "driven_by") and value}


def main():
    with tempfile.TemporaryDirectory() as folder:
        # Along x by default, and along the normal of the dam when it is turned.
        straight = last_row(folder, 0, 0.1, "")
        along = [last_row(folder, 0, 0.1, "set Horizontal direction = 7; 0"),
                 last_row(folder, 90, 0.1, "set Horizontal direction = 0; 1"),
                 last_row(folder, 30, 0.1, f"set Horizontal direction = {math.cos(math.pi / 6)!r}; 0.5"),
                 last_row(folder, 90, -0.1, "set Horizontal direction = 0; -0.001")]
        across = last_row(folder, 0, 0.1, "set Horizontal direction = 0; 1")
        for words, direction in (("two numbers", "0; 1; 0"), ("two numbers", "y"), ("no direction", "0; 0")):
            run = subprocess.run([FUGA, "--check", str(pathlib.Path(folder) / "turned.prm"), "--set",
                                  f"Loads/shaking/Horizontal direction={direction}"], capture_output=True, text=True)
            check(run.returncode == 1 and words in run.stderr and f"'{direction}'" in run.stderr, f"{direction}: {run.stderr}")
        run = subprocess.run([FUGA, "--check", str(ROOT / "parameters" / "dam.prm"), "--set", "Loads/weight/Type=seismic", "--set",
                              "Loads/weight/Horizontal coefficient=0.1", "--set", "Loads/weight/Horizontal direction=0; 1"],
                             capture_output=True, text=True)
        check(run.returncode == 1 and "in the plane the only horizontal direction is x" in run.stderr, run.stderr)
    # Weight 24 (24 + 4)/2 30 15 kN, lifted by a twentieth; the water that an earthquake moves presses with
    # 7/8 0.1 9.81 sqrt(20) 2/3 20^(3/2) = 7/12 0.1 9.81 20^2 per metre.
    weight, water = 24 * 6300, 7 / 12 * 0.1 * 9.81 * 20**2 * 15
    for row in [straight] + along:
        force = math.hypot(row["T"], row["T2"])
        check(abs(row["N"] + 0.95 * weight) <= TOLERANCE * weight, f"N = {row['N']!r}, by hand {-0.95 * weight}")
        check(abs(force - 0.1 * weight - water) <= TOLERANCE * weight,
              f"T = {force!r}, by hand {0.1 * weight + water!r}")
    force = math.hypot(across["T"], across["T2"])
    by_hand = math.hypot(0.1 * weight, water)
    check(abs(force - by_hand) <= TOLERANCE * weight, f"across the water T = {force!r}, by hand {by_hand!r}")
    print("\n".join(complaints) or "resultants turn with the model")
    sys.exit(1 if complaints else 0)


main()
