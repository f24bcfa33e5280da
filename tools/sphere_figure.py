#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Two like spheres, pressed and then sheared, against Hertz, Cattaneo and Mindlin: draws doc/spheres.png.

usage: sphere_figure.py [--fuga BIN] [--output FILE]

The scene of LargeSpheres.CattaneoMindlin in tests/scenes/sphere_test.cc; takes about a minute.
"""
import argparse
import csv
import json
import math
import os
import subprocess
import tempfile

import matplotlib
import numpy

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MODULUS, RADIUS, FRICTION, SIZE, LEVEL, GROWTH, STEPS = 1000.0, 50.0, 0.3, 16.0, 4, 1.8, 5


def grown(begin, end):
    """Grid lines with intervals of 1/LEVEL, each GROWTH times as long as the one before."""
    sizes = [1 / LEVEL]
    while sum(sizes) < end - begin:
        sizes.append(sizes[-1] * GROWTH)
    return [begin + (end - begin) * sum(sizes[:i]) / sum(sizes) for i in range(len(sizes))] + [end]


def write_mesh(path):
    """Halves (y > 0) of two blocks on both sides of z = 0, as a Gmsh file (2.2)."""
    half = [i / LEVEL for i in range(5)] + grown(1.25, SIZE)
    up = grown(0.0, SIZE)
    xs, ys, zs = [-x for x in half[:0:-1]] + half, half, [-z for z in up[:0:-1]] + up
    n = {(x, y, z): i + 1 for i, (x, y, z) in enumerate((x, y, z) for z in zs for y in ys for x in xs)}
    pairs = lambda axis: list(zip(axis, axis[1:]))
    faces = lambda lines, others, place: [[n[place(a, c)], n[place(b, c)], n[place(b, d)], n[place(a, d)]]
                                          for a, b in pairs(lines) for c, d in pairs(others)]
    cells = lambda part: [[n[p] for z in (e, f) for p in ((a, c, z), (b, c, z), (b, d, z), (a, d, z))]
                          for e, f in pairs(part) for c, d in pairs(ys) for a, b in pairs(xs)]
    middle = zs.index(0.0)
    groups = [(3, "lower", 5, cells(zs[:middle + 1])), (3, "upper", 5, cells(zs[middle:]))]
    for name, z in (("bottom", -SIZE), ("joint", 0.0), ("top", SIZE)):
        groups.append((2, name, 3, faces(xs, ys, lambda x, y, z=z: (x, y, z))))
    groups.append((2, "symmetry", 3, faces(xs, zs, lambda x, z: (x, 0.0, z))))
    groups.append((2, "sides", 3, faces(xs, zs, lambda x, z: (x, SIZE, z))
                   + [face for end in (-SIZE, SIZE) for face in faces(ys, zs, lambda y, z, x=end: (x, y, z))]))
    names = "".join(f'{dimension} {i + 1} "{name}"\n' for i, (dimension, name, _, _) in enumerate(groups))
    elements = [f"{kind} 2 {i + 1} {i + 1} " + " ".join(map(str, nodes))
                for i, (_, _, kind, found) in enumerate(groups) for nodes in found]
    with open(path, "w", encoding="ascii") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(groups)}\n{names}$EndPhysicalNames\n")
        file.write(f"$Nodes\n{len(n)}\n" + "".join(f"{i} {x!r} {y!r} {z!r}\n" for (x, y, z), i in n.items()))
        file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        file.write("".join(f"{i + 1} {element}\n" for i, element in enumerate(elements)) + "$EndElements\n")


def scene():
    move = lambda boundary, value: {"Type": "displacement", "Boundaries": boundary, "Value": value}
    material = {"Young modulus": MODULUS, "Poisson ratio": 0}
    return {"Dimension": 3, "Mesh": {"File": "mesh.msh", "Polynomial degree": 2},
            "Bodies": {"lower": material, "upper": material},
            "Joints": {"spheres": {"Line": "joint", "Plus body": "upper", "Minus body": "lower", "Normal law": "rigid",
                                   "Shear law": "rigid", "Friction coefficient": FRICTION,
                                   "Initial gap": f"(x^2 + y^2)/{2 * RADIUS}"}},
            "Boundaries": {"symmetry": {"Fixed": "y"}, "sides": {"Fixed": "free"}, "bottom": {"Fixed": "all"}, "top": {"Fixed": "all"}},
            "Loads": {"down": move("top", "0; 0; -0.0102"), "up": move("bottom", "0; 0; 0.0102"),
                      "right": move("top", "0.0022; 0; 0"), "left": move("bottom", "-0.0022; 0; 0")},
            "Stages": {"press": {"Loads": "down: t; up: t"}, "shear": {"Loads": "right: t; left: t", "Levels": STEPS}},
            "Output": {"Fields": "never", "Log": "levels"}}


def run(fuga, folder):
    """{load time: {column: values}} of the joint."""
    write_mesh(f"{folder}/mesh.msh")
    with open(f"{folder}/run.json", "w", encoding="utf-8") as file:
        json.dump(scene(), file)
    done = subprocess.run([fuga, "run.json", "--output-dir", "results"], cwd=folder, capture_output=True, text=True,
                          check=False, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    if done.returncode != 0:
        raise RuntimeError(f"exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    levels = {}
    with open(f"{folder}/results/joint_history.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            values = {key.split("[")[0]: value for key, value in row.items()}
            level = levels.setdefault(round(float(values["t"]), 9), {})
            for key in ("x", "y", "N", "T1", "pressure", "shear1", "state"):
                level.setdefault(key, []).append(values[key] if key == "state" else float(values[key]))
    return {t: {key: numpy.array(values) for key, values in level.items()} for t, level in levels.items()}


def hemisphere(r, c):
    return numpy.sqrt(numpy.maximum(0, 1 - (r / c)**2))


def draw_profiles(axes, levels, force, a):
    top = 1.5 * force / (math.pi * a * a)
    line = numpy.linspace(-1.2, 1.2, 961)
    for t, colour in zip(sorted(levels)[::2], ("C7", "C1", "C0")):
        level = levels[t]
        share = 2 * level["T1"].sum() / (FRICTION * force)
        c = (1 - share)**(1 / 3)
        on_axis = (level["y"] == 0) & (abs(level["x"]) < 1.2 * a)
        if t > 1:
            axes.plot(line, hemisphere(line, 1) - c * hemisphere(line, c), color=colour,
                      label=f"$q/fp_0$, $Q$ = {share:.2f} $fP$")
            axes.plot(level["x"][on_axis] / a, level["shear1"][on_axis] / (FRICTION * top), "o", color=colour, markersize=4)
        else:
            axes.plot(line, hemisphere(line, 1), color=colour, label="$p/p_0$")
            axes.plot(level["x"][on_axis] / a, level["pressure"][on_axis] / top, "o", color=colour, markersize=4)
    axes.set_xlabel("$x/a$")
    axes.set_title("Along $y = 0$: closed forms (lines), nodes (points)", fontsize=10)
    axes.legend(fontsize=8)
    axes.grid(alpha=0.3)


def draw_ring(axes, level, force, a):
    share = 2 * level["T1"].sum() / (FRICTION * force)
    c = (1 - share)**(1 / 3)
    top = 1.5 * force / (math.pi * a * a)
    near = numpy.hypot(level["x"], level["y"]) < 1.6 * a
    x, y, q, state = (numpy.concatenate((level[key][near], level[key][near] * (-1 if key == "y" else 1)) if key != "state"
                                        else (level[key][near], level[key][near])) for key in ("x", "y", "shear1", "state"))
    apart = numpy.concatenate((numpy.ones(near.sum(), bool), level["y"][near] > 0)) # the axis once
    x, y, q, state = x[apart] / a, y[apart] / a, q[apart] / (FRICTION * top), state[apart]
    filled = axes.tricontourf(x, y, q, numpy.linspace(0, 1, 21), cmap="YlGnBu", extend="max")
    for name, marker in (("stick", "s"), ("slip", "o"), ("open", ".")):
        axes.plot(x[state == name], y[state == name], marker, color="k", fillstyle="none", markersize=3,
                  linestyle="none", label=name, alpha=0.7)
    angle = numpy.linspace(0, 2 * math.pi, 200)
    for radius, name in ((1, "$a$, $c$: closed forms"), (c, None)):
        axes.plot(radius * numpy.cos(angle), radius * numpy.sin(angle), "C3", linewidth=1.5, label=name)
    axes.set_aspect("equal")
    axes.set_xlim(-1.25, 1.25)
    axes.set_ylim(-1.25, 1.25)
    axes.set_ylabel("$y/a$")
    axes.set_title(f"Shear $q/fp_0$ at $Q$ = {share:.2f} $fP$", fontsize=10)
    axes.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=4, frameon=False)
    return filled


def draw(fuga, path):
    with tempfile.TemporaryDirectory() as folder:
        levels = run(os.path.abspath(fuga), folder)
    force = -2 * levels[1.0]["N"].sum()
    a = (0.75 * force * RADIUS / (MODULUS / 2))**(1 / 3)
    fig, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.6))
    draw_profiles(left, levels, force, a)
    fig.colorbar(draw_ring(right, levels[1.6], force, a), ax=right, ticks=numpy.linspace(0, 1, 6))
    fig.tight_layout()
    fig.savefig(path, dpi=90, bbox_inches="tight")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--fuga", default=os.path.join(TOP, "build", "release", "fuga"))
    arguments.add_argument("--output", default=os.path.join(TOP, "doc", "spheres.png"))
    options = arguments.parse_args()
    draw(options.fuga, options.output)


if __name__ == "__main__":
    main()
