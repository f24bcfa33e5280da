# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Decks for CalculiX (calculix-ccx), made from the same mesh, loads and joint; runs and their errors.

Elements CPE4 of thickness 1 and C3D8 (fully integrated); loads as the consistent nodal forces of (tri)linear elements,
which are what fuga assembles; penalty contact whose normal stiffness and stick slope are those of the joint. Default
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
# By the number of nodes of a cell: its name, and the nodes of its faces S1, S2 ...
CELLS = {4: ("CPE4", ((0, 1), (1, 2), (2, 3), (3, 0))),
         8: ("C3D8", ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)))}


def start_seconds():
    directory = fuga_runs.WORK / "runs"
    directory.mkdir(parents=True, exist_ok=True)
    return measure([PROGRAM, "-v"], str(directory)).cpu


def _numbers(values, per_line=12):
    values = list(values)
    return "\n".join(", ".join(map(str, values[i:i + per_line])) for i in range(0, len(values), per_line))


def _faces(cells, first, nodes):
    """Those between the nodes given."""
    return "\n".join("%d, S%d" % (number, side) for number, cell in enumerate(cells, first)
                     for side, corners in enumerate(CELLS[len(cell)][1], 1) if all(cell[c] in nodes for c in corners))


def deck(scene, kind, increments):
    """(text, [(lower node, upper node)] in the order of places); CalculiX reads no more than 20 characters of a number."""
    mesh, double = scene.mesh.opened("base", scene.structure)
    lower, upper = list(double), list(double.values())
    joint, first, lines, faces = scene.joint, 1, ["*NODE, NSET=ALL"], {}
    lines += ["%d, %s" % (k, ", ".join("%.12e" % x for x in (*node, 0.)[:3])) for k, node in enumerate(mesh.nodes, 1)]
    for name, cells in mesh.bodies():
        E, nu, _ = scene.bodies[name]
        lines.append("*ELEMENT, TYPE=%s, ELSET=%s" % (CELLS[len(cells[0])][0], name.upper()))
        lines += ["%d, %s" % (first + k, ", ".join(map(str, cell))) for k, cell in enumerate(cells)]
        lines += ["*MATERIAL, NAME=M_%s\n*ELASTIC\n%.12e, %.12e" % (name.upper(), E, nu),
                  "*SOLID SECTION, ELSET=%s, MATERIAL=M_%s\n1." % (name.upper(), name.upper())]
        # The lower surface is the whole top of the foundation: where it ended with the block, the outermost slave
        # nodes would leave it with their first slip, and the node-to-surface error would be 20 %.
        beside = [v for part in scene.beside_base for v in mesh.line_nodes(part)]
        surface = upper if name == scene.structure else lower + beside
        faces[name] = _faces(cells, first, set(surface))
        first += len(cells)
    for name, components in scene.supports:
        lines += ["*NSET, NSET=%s\n%s" % (name.upper(), _numbers(mesh.line_nodes(name))), "*BOUNDARY",
                  *("%s, %d, %d" % (name.upper(), *("xyz".index(c) + 1,) * 2) for c in components)]
    lines.append("*NSET, NSET=LIPS\n" + _numbers(lower + upper))
    # For both types a surface of faces: CalculiX takes the areas of the slave nodes from it.
    lines += ["*SURFACE, NAME=SLAVE, TYPE=ELEMENT\n" + faces[scene.structure],
              "*SURFACE, NAME=MASTER, TYPE=ELEMENT\n" + faces[scene.foundation],
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
                lines += ["%d, %d, %.12e" % (v, d + 1, factor * force[d]) for d in range(scene.dim) if force[d]]
        lines.append("*NODE PRINT, NSET=LIPS, FREQUENCY=1000000\nU\n*END STEP")
    return "\n".join(lines) + "\n", list(zip(lower, upper))


def _stage_displacements(path, n_stages):
    """[{node: (ux, uy, uz)}] of the blocks of the .dat file; None if the last is not the end of the last step."""
    text = path.read_text() if path.exists() else ""
    blocks = re.split(r"displacements .* and time +(\S+)\n", text)
    if len(blocks) != 2 * n_stages + 1 or not math.isclose(float(blocks[-2]), n_stages, rel_tol=1e-6):
        return None
    tables = [[line.split() for line in block.splitlines() if len(line.split()) == 4] for block in blocks[2::2]]
    return [{int(v): tuple(map(float, u)) for v, *u in rows} for rows in tables]


def _failure(process, limit):
    if process.timed_out:
        return "stopped at the limit of %d s of CPU time" % limit
    found = re.findall(r"\*ERROR[^\n]*|[^\n]*(?:too many cutbacks|smaller than minimum)[^\n]*", process.output, re.I)
    lines = dict.fromkeys(" ".join(line.replace("*ERROR:", "").split()) for line in found)
    return "; ".join(lines) or "ended without the end state (exit code %d)" % process.code


def run_scene(scene, kind, increments, reference, cpu_limit=600):
    """Errors of all jumps against the reference in the form of fuga_runs.stage_jumps, if there is one; with a limit, of the
    load at which the run stops."""
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
    result = Result({"total": process.cpu, "total_after_start": process.cpu - start, "wall": process.wall},
                    process.memory_MB, scene.n, scene.dofs)
    convergence = (directory / "run.sta").read_text().splitlines() if (directory / "run.sta").exists() else []
    rows = [line.split() for line in convergence if line.split() and line.split()[0].isdigit()]
    result.info = {"increments": len(rows), "iterations": sum(int(row[3]) for row in rows if row[3].isdigit())}
    displacements = _stage_displacements(directory / "run.dat", len(scene.stages))
    borne = [float(row[4]) for row in rows if row[2].isdigit()]  # times at the ends of increments that converged
    if scene.limit and borne and not process.timed_out:  # it shall stop, or else has gone past the limit
        result.error = abs(scene.stages[-1]["push"] * (borne[-1] - len(scene.stages) + 1) / scene.limit - 1.)
    elif displacements is None or process.code != 0 or "*ERROR" in process.output:
        result.failure = _failure(process, cpu_limit)
    elif reference:
        normal = scene.dim - 1
        jumps = [[[u[upper][d] - u[lower][d] for lower, upper in pairs] for d in (normal, *range(normal))]
                 for u in displacements]
        result.error, result.info["stage errors"] = scene.error(jumps, reference)
    for name in ("run.inp", "run.frd", "spooles.out"):
        (directory / name).unlink(missing_ok=True)
    return result
