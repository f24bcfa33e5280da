# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Sections of parameter files, meshes and runs that tests of models in space share."""
import json
import subprocess


def body(name, young_modulus, density):
    return f"""  subsection {name}
    set Young modulus  = {young_modulus}
    set Poisson ratio  = 0.2
    set Weight density = {density}
  end
"""


def joint(name, plus, minus, friction, stiffness, dilatancy=0):
    """@p stiffness: the normal one [kPa/m], of which the shear stiffness is half, or "rigid"; @p dilatancy: an angle."""
    layer = ("    set Normal law = rigid\n    set Shear law = rigid\n" if stiffness == "rigid" else
             f"    set Normal stiffness = {stiffness}\n    set Shear stiffness  = {float(stiffness) / 2}\n")
    return f"""  subsection {name}
    set Line       = {name}
    set Plus body  = {plus}
    set Minus body = {minus}
    set Friction coefficient = {friction}
    set Dilatancy angle = {dilatancy!r}
{layer}  end
"""


def mesh(folder, name, geometry):
    path = folder / f"{name}.geo"
    path.write_text(geometry, encoding="utf-8")
    subprocess.run(["gmsh", "-3", "-v", "1", "-format", "msh41", str(path)], check=True)
    return path.with_suffix(".msh")


def run(fuga, path, parameters):
    """Runs the text @p parameters as the file @p path: the directory of the results, exit code, summary, output."""
    path.write_text(parameters, encoding="utf-8")
    out = path.with_suffix("")
    done = subprocess.run([fuga, path, "--output-dir", out], capture_output=True, text=True, check=False)
    return out, done.returncode, json.loads((out / "summary.json").read_text()), done.stdout + done.stderr
