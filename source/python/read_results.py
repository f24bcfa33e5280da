#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Reads every result file of a run or a sweep, prints a summary and draws one picture: a start for scripts
of your own. Needs python3-pandas, python3-matplotlib, python3-meshio.

usage: read_results.py RESULT_DIR [-o PICTURE.png]
"""

import argparse
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy

from fuga_results import Results, Table


def print_run(results):
    """The tables are pandas data frames by column name; `units` has the unit of every column."""
    summary = results.summary
    print(f"{results.title}\n{summary['verdict']} (exit code {summary['exit_code']}) at t = {summary['t']:.12g}, "
          f"{results.describe_time(summary['t'])}, {summary['driven_by']} = {summary['drive']:.6g}")
    if "limit_load" in summary:
        limit = summary["limit_load"]
        print(f"limit load: mechanism {limit['mechanism']} ({limit['motion']}), factors {limit['load_factors']}")
    for method, found in summary.get("safety", {}).items():
        print(f"safety by {method.replace('_', ' ')}: {found['factor']}, {found['verdict']}")
    print(f"certificate {summary['certificate']['worst']:.1e}, {len(results.events.frame)} events, "
          f"{len(results.levels)} load levels")
    kinds = results.events.frame.groupby(["joint", "from", "to"]).size()
    print("\nevents by joint and kind" + "".join(f"\n  {joint}: {a} -> {b}  {n}" for (joint, a, b), n in kinds.items()))
    last = results.resultants.frame.groupby("joint", sort=False).last()
    last.columns = [results.resultants.label(name, name) for name in last.columns]
    print(f"\nresultants at the last level\n{last.T.to_string()}")
    if results.monitors is not None:
        print(f"\nmonitors at the end\n{results.monitors.frame.groupby('monitor', sort=False).last().to_string()}")


def print_fields(results):
    """The fields of the last level, as arrays by name."""
    for name in ("bodies", "joints", "joints_exploded"):
        pieces = [meshio.read(path) for path in results.field_pieces(name)]  # one, without several processes
        n_cells = sum(len(block.data) for mesh in pieces for block in mesh.cells)
        print(f"\n{name}: {sum(len(mesh.points) for mesh in pieces)} points, {n_cells} cells")
        for array in pieces[0].point_data:
            values = numpy.concatenate([mesh.point_data[array] for mesh in pieces])
            print(f"  {array:<20} from {values.min():.6g} to {values.max():.6g}")


def draw(results, path):
    """Pressure, shear and strength along the first joint at the last level; the displacements over the load."""
    figure, axes = plt.subplots(2, 1, figsize=(7.0, 6.0), layout="constrained")
    joint = results.joints[0]
    profile = results.profile(joint)
    strength = results.strength(joint, profile)
    axes[0].plot(profile["along"], profile["pressure"], "k-o", markersize=3, label="pressure")
    axes[0].plot(profile["along"], profile["shear1"], "k--s", markersize=3, label="shear stress")
    axes[0].fill_between(profile["along"], -strength, strength, color="#dddddd", label="\u00b1(f p + c)")
    axes[0].set(xlabel=f"distance along {joint} [{results.unit('x')}]", ylabel=f"stress [{results.unit('pressure')}]",
                title=f"{results.title}, {results.describe_state(profile.t)}")
    axes[0].legend()
    for joint in results.joints:
        levels = results.joint_frame(joint).groupby("t")
        axes[1].plot(levels["jump_t1"].agg(lambda jump: numpy.abs(jump).max()), label=f"{joint}: largest shear jump")
        axes[1].plot(levels["gap"].max(), "--", label=f"{joint}: largest gap")
    axes[1].set(xlabel="load time t", ylabel=f"jump [{results.unit('gap')}]")
    axes[1].legend()
    figure.savefig(path, dpi=150)
    print(f"\n{path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("directory", help="result directory")
    parser.add_argument("-o", "--output", help="picture; default: results.png in the result directory")
    options = parser.parse_args()
    sweep = os.path.join(options.directory, "sweep.csv")
    if os.path.exists(sweep):
        print(Table(sweep).frame.to_string(index=False))
        return
    results = Results(options.directory)
    print_run(results)
    if os.path.exists(os.path.join(options.directory, "bodies.pvd")):
        print_fields(results)
    draw(results, options.output or os.path.join(options.directory, "results.png"))


if __name__ == "__main__":
    main()
