# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Decks for CalculiX (calculix-ccx), made from the same mesh, loads and joint; runs and their errors.

Elements CPE4 (fully integrated), thickness 1; loads as the consistent nodal forces of bilinear elements, which are
what fuga assembles; penalty contact whose normal stiffness and stick slope are those of the joint. Default
tolerances and solver. A step is a stage; the increments have the given number per stage unless CalculiX cuts them.
"""
import math
import re

import fuga_runs
from process import Result, measure

PROGRAM = "ccx"
# Tension that the smoothed pressure-overclosure curve keeps at large gaps, relative to k_n.
TENSION = 1e-10
TYPES = {"nts": "NODE TO SURFACE", "sts": "SURFACE TO SURFACE"}


def start_seconds():
    directory = fuga_runs.WORK / "runs"
    directory.mkdir(parents=True, exist_ok=True)
    return measure([PROGRAM, "-v"], str(directory)).cpu


def _numbers(values, per_line=12):
    values = list(values)
    return "\n".join(", ".join(map(str, values[i:i + per_line])) for i in range(0, len(values), per_line))


def _faces(cells, first, nodes):
    """CalculiX names the faces of a cell S1 ... S4: nodes 1-2, 2-3, 3-4, 4-1. Those between the nodes given."""
    result = []
    for k, cell in enumerate(cells):
        for side in range(4):
            if cell[side] in nodes and cell[(side + 1) % 4] in nodes:
                result.append("%d, S%d" % (first + k, side + 1))
    return "\n".join(result)


def deck(scene, kind, increments):
    """(text, [(lower node, upper node)] from left to right); CalculiX reads no more than 20 characters of a number."""
    mesh, double = scene.mesh.opened("base", scene.structure)
    lower, upper = list(double), list(double.values())
    joint, first, lines, faces = scene.joint, 1, ["*NODE, NSET=ALL"], {}
    lines += ["%d, %.12e, %.12e, 0." % (k, x, y) for k, (x, y) in enumerate(mesh.nodes, 1)]
    for name, cells in mesh.bodies():
        E, nu, _ = scene.bodies[name]
        lines.append("*ELEMENT, TYPE=CPE4, ELSET=%s" % name.upper())
        lines += ["%d, %s" % (first + k, ", ".join(map(str, cell))) for k, cell in enumerate(cells)]
        lines += ["*MATERIAL, NAME=M_%s\n*ELASTIC\n%.12e, %.12e" % (name.upper(), E, nu),
                  "*SOLID SECTION, ELSET=%s, MATERIAL=M_%s\n1." % (name.upper(), name.upper())]
        # The lower surface is the whole top of the foundation: where it ended with the block, the outermost slave
        # nodes would leave it with their first slip, and the node-to-surface error would be 20 %.
        surface = upper if name == scene.structure else lower + mesh.line_nodes("foundation_top")
        faces[name] = _faces(cells, first, set(surface))
        first += len(cells)
    for name, components in (("foundation_bottom", "1, 2"), ("foundation_sides", "1, 1")):
        lines += ["*NSET, NSET=%s\n%s" % (name.upper(), _numbers(mesh.line_nodes(name))),
                  "*BOUNDARY\n%s, %s" % (name.upper(), components)]
    lines.append("*NSET, NSET=LIPS\n" + _numbers(lower + upper))
    # For both types a surface of faces: CalculiX takes the areas of the slave nodes from it.
    lines += ["*SURFACE, NAME=SLAVE, TYPE=ELEMENT\n" + faces[scene.structure],
              "*SURFACE, NAME=MASTER, TYPE=ELEMENT\n" + faces["foundation"],
              "*SURFACE INTERACTION, NAME=JOINT",
              "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n%.12e, %.12e, %.12e" % (
                  joint["kn"], TENSION * joint["kn"], 1e-2),
              "*FRICTION\n%.12e, %.12e" % (joint["f"], joint["kt"]),
              "*CONTACT PAIR, INTERACTION=JOINT, TYPE=%s\nSLAVE, MASTER" % TYPES[kind]]
    loads = scene.nodal_loads(mesh)
    for number, stage in enumerate(scene.stages):
        # With reversals the weight, which changes no state, has no more than ten: they are wanted later.
        size = 1. / (increments if number or len(scene.stages) == 2 else min(increments, 10))
        lines.append("*STEP, INC=100000\n*STATIC\n%.12e, 1., 1e-8, %.12e" % (size, size))
        for load, factor in stage.items():
            lines.append("*CLOAD")
            for v, force in loads[load].items():
                lines += ["%d, %d, %.12e" % (v, d + 1, factor * force[d]) for d in (0, 1) if force[d]]
        lines.append("*NODE PRINT, NSET=LIPS, FREQUENCY=1000000\nU\n*END STEP")
    return "\n".join(lines) + "\n", list(zip(lower, upper))


def _stage_displacements(path, n_stages):
    """[{node: (ux, uy)}] of the blocks of the .dat file; None if the last is not the end of the last step."""
    text = path.read_text() if path.exists() else ""
    blocks = re.split(r"displacements .* and time +(\S+)\n", text)
    if len(blocks) != 2 * n_stages + 1 or not math.isclose(float(blocks[-2]), n_stages, rel_tol=1e-6):
        return None
    tables = [[line.split() for line in block.splitlines() if len(line.split()) == 4] for block in blocks[2::2]]
    return [{int(v): (float(x), float(y)) for v, x, y, _ in rows} for rows in tables]


def _failure(process, limit):
    if process.timed_out:
        return "stopped at the limit of %d s of CPU time" % limit
    found = re.findall(r"\*ERROR[^\n]*|[^\n]*(?:too many cutbacks|smaller than minimum)[^\n]*", process.output, re.I)
    lines = dict.fromkeys(" ".join(line.replace("*ERROR:", "").split()) for line in found)
    return "; ".join(lines) or "ended without the end state (exit code %d)" % process.code


def run_scene(scene, kind, increments, reference, cpu_limit=600):
    """Errors of both jumps against the reference [(normal jumps, tangential jumps)] at the ends of the stages."""
    variant = "%r_%r_%s_%d" % (scene.joint["kn"], scene.joint["f"], kind, increments)
    tag = "calculix_" + fuga_runs.tag_of(scene, variant)
    directory = fuga_runs.WORK / "runs" / tag
    directory.mkdir(parents=True, exist_ok=True)
    for old in directory.iterdir():
        old.unlink()
    text, pairs = deck(scene, kind, increments)
    (directory / "run.inp").write_text(text)
    start = start_seconds()
    process = measure([PROGRAM, "run"], str(directory), cpu_limit)
    result = Result({"total": process.cpu, "total_after_start": process.cpu - start}, process.memory_MB, scene.n,
                    scene.dofs)
    convergence = (directory / "run.sta").read_text().splitlines() if (directory / "run.sta").exists() else []
    rows = [line.split() for line in convergence if line.split() and line.split()[0].isdigit()]
    result.info = {"increments": len(rows), "iterations": sum(int(row[3]) for row in rows if row[3].isdigit())}
    displacements = _stage_displacements(directory / "run.dat", len(scene.stages))
    if displacements is None or process.code != 0 or "*ERROR" in process.output:
        result.failure = _failure(process, cpu_limit)
    else:
        jumps = [tuple([u[upper][d] - u[lower][d] for lower, upper in pairs] for d in (1, 0)) for u in displacements]
        result.error, result.info["stage errors"] = scene.error(jumps, reference)
    for name in ("run.inp", "run.frd", "spooles.out"):
        (directory / name).unlink(missing_ok=True)
    return result
