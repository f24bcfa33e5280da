#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Fields of a column that is built in layers, read with VTK, against the column by hand.

usage: construction_fields.py FUGA

Three layers of height 1 and weight density 2, two cells each, nu = 0, bonded, each built in a stage of its own.
Expected at the end of every stage: cells only of the layers that are there; the vertical stress of a cell is minus
the weight of what is there above its middle (bilinear elements: constant in a cell, exact in the mean); at the end
of stage k the top of layer j has settled as doc/theory.md, section 12, says. Tolerance: single precision.
"""
import pathlib
import subprocess
import sys
import tempfile

import vtk
from vtk.util.numpy_support import vtk_to_numpy

E, WEIGHT, LAYERS = 1000.0, 2.0, 3
SINGLE = 1e-6
ROWS = 2 * LAYERS


def mesh():
    nodes = [(i, j / 2) for j in range(ROWS + 1) for i in range(2)]
    names = [(1, 1, "bottom"), (1, 2, "top"), (1, 3, "sides")] + [(2, 4 + k, f"layer{k + 1}") for k in range(LAYERS)]
    elements = [(1, 1, 1, 2), (1, 2, 2 * ROWS + 1, 2 * ROWS + 2)]
    for j in range(ROWS):
        a = 2 * j + 1
        elements += [(1, 3, a, a + 2), (1, 3, a + 1, a + 3), (3, 4 + j // 2, a, a + 1, a + 3, a + 2)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names))]
    lines += [f'{d} {tag} "{name}"' for d, tag, name in names] + ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{n + 1} {x} {y} 0" for n, (x, y) in enumerate(nodes)] + ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{n + 1} {e[0]} 2 {e[1]} {e[1]} {' '.join(map(str, e[2:]))}" for n, e in enumerate(elements)]
    return "\n".join(lines + ["$EndElements", ""])


def parameters():
    bodies = "".join(
        f"subsection layer{k}\nset Young modulus = {E}\nset Poisson ratio = 0\nset Weight density = {WEIGHT}\n"
        + (f"set Built at stage = stage{k}\n" if k > 1 else "") + "end\n" for k in range(1, LAYERS + 1))
    stages = "".join(f"subsection stage{k}\nset Loads = weight: {'t' if k == 1 else 1}\nend\n"
                     for k in range(1, LAYERS + 1))
    return (f"subsection Mesh\nset File = column.msh\nend\nsubsection Bodies\n{bodies}end\n"
            "subsection Boundaries\nsubsection bottom\nset Fixed = all\nend\nsubsection top\nset Fixed = free\nend\n"
            "subsection sides\nset Fixed = free\nend\nend\nsubsection Loads\nsubsection weight\nset Type = weight\n"
            f"end\nend\nsubsection Stages\n{stages}end\n")


def check(grid, stage):
    complaints = []
    if grid.GetNumberOfCells() != 2 * stage:
        return [f"stage {stage}: {grid.GetNumberOfCells()} cells instead of {2 * stage}"]
    stress = vtk_to_numpy(grid.GetPointData().GetArray("stress"))
    displacement = vtk_to_numpy(grid.GetPointData().GetArray("displacement"))
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        points = [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]
        middle = sum(grid.GetPoint(p)[1] for p in points) / len(points)
        for p in points:
            expected = -WEIGHT * (stage - middle)
            if abs(stress[p][4] - expected) > SINGLE * WEIGHT * LAYERS:
                complaints.append(f"stage {stage}, cell at {middle}: stress {stress[p][4]} instead of {expected}")
    for p in range(grid.GetNumberOfPoints()):
        z = grid.GetPoint(p)[1]
        if z in (1.0, 2.0, 3.0):
            expected = -WEIGHT * (z * (stage - z) + (z - 1) + 0.5) / E
            if abs(displacement[p][1] - expected) > SINGLE * WEIGHT * LAYERS**2 / E:
                complaints.append(f"stage {stage}, z = {z}: displacement {displacement[p][1]} instead of {expected}")
    return complaints


def main():
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        (directory / "column.msh").write_text(mesh())
        (directory / "column.prm").write_text(parameters())
        subprocess.run([sys.argv[1], str(directory / "column.prm"), "--quiet", "--output-dir", str(directory / "out")],
                       check=True)
        complaints = []
        for stage in range(1, LAYERS + 1):
            reader = vtk.vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(directory / "out" / f"bodies_{stage - 1:04d}.vtu"))
            reader.Update()
            complaints += check(reader.GetOutput(), stage)
    print("\n".join(complaints) or "the fields are those of the column by hand")
    return 1 if complaints else 0


sys.exit(main())
