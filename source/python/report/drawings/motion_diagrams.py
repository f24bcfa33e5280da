# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Histories of stages in which inertia acts."""

import matplotlib.ticker
import numpy

from report.drawings.figures import new_figure, set_margins, to_figure
from report.text.words import rounded

SHOWN_JOINTS = 4
SHOWN_MONITORS = 4


def _slides(of_joint):
    """Ends of the steps of time, and how fast the joint slid in each, in the mean of its area; in space the size of that."""
    steps = [numpy.diff(of_joint[name]) for name in ("mean_slip", "mean_slip2") if name in of_joint]
    way = numpy.hypot(*steps) if len(steps) == 2 else steps[0]
    return of_joint["time"].iloc[1:], way / numpy.diff(of_joint["time"])


def histories(results):
    """Ground, forces, motions and velocities of the joints and energies over the time of the last motion; None without one."""
    if results.motion is None or results.motion.frame.empty:
        return None
    table = results.motion
    frame, units = table.frame, table.units
    motions = (frame["time"].diff() < 0.0).cumsum()
    frame = frame[motions == motions.iloc[-1]]
    joints = list(dict.fromkeys(frame["joint"]))[:SHOWN_JOINTS]
    one = frame[frame["joint"] == joints[0]]
    figure = new_figure(8.8)
    rows = figure.subplots(5, sharex=True)
    for column in ("ground_x", "ground_y", "ground_z"):
        if column in table and one[column].any():
            rows[0].plot(one["time"], one[column], linewidth=0.6, label=column.replace("_", " "))
    rows[0].set_ylabel(f"ground [{units['ground_x'].replace('s2', 's²')}]")
    for joint in joints:
        of_joint, suffix = frame[frame["joint"] == joint], f" of {joint}" if len(joints) > 1 else ""
        rows[1].plot(of_joint["time"], of_joint["T"], linewidth=0.7, label="T" + suffix)
        rows[1].plot(of_joint["time"], of_joint["N"], linewidth=0.7, label="N" + suffix)
        rows[2].plot(of_joint["time"], of_joint["mean_slip"], linewidth=0.9, label="mean slip" + suffix)
        rows[2].plot(of_joint["time"], of_joint["largest_gap"], linewidth=0.7, label="largest gap" + suffix)
        rows[3].plot(*_slides(of_joint), linewidth=0.7, label="sliding" + suffix)
    rows[1].set_ylabel(f"force [{units['T']}]")
    rows[2].set_ylabel(f"[{units['mean_slip']}]")
    rows[3].set_ylabel(f"[{units['mean_slip']}/s]")
    names = {"work": "work", "joint_work": "joints", "damping": "damping", "kinetic_energy": "kinetic",
             "energy_bodies": "bodies"}
    for column, name in names.items():
        rows[4].plot(one["time"], one[column], linewidth=0.8, label=name)
    rows[4].set_ylabel(f"energy [{units['work']}]")
    rows[4].set_xlabel("time [s]")
    for axes in rows:
        axes.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(5))
        if axes.get_legend_handles_labels()[0]:
            axes.legend(loc="upper left", ncols=5)
    set_margins(figure, hspace=0.12)
    last = {joint: frame[frame["joint"] == joint].iloc[-1] for joint in joints}
    fastest = {joint: max(abs(_slides(frame[frame["joint"] == joint])[1]), default=0.0) for joint in joints}
    remains = "; ".join(f"'{joint}' {rounded(row['mean_slip'], 4)} {units['mean_slip']} of slip in the mean (at most "
                        f"{rounded(float(fastest[joint]), 3)} {units['mean_slip']}/s on the way), "
                        f"{rounded(row['largest_gap'], 3)} {units['largest_gap']} of largest gap" for joint, row in last.items())
    return to_figure(figure, "Histories over the time since the motion began: acceleration of the ground, forces and motions of the "
                             f"joints, mean velocity at which they slide, energies since then. At its end: {remains}.")


def spectra(results):
    """Response spectra of the monitors in the last stage that has some; None without them."""
    if results.spectra is None or results.spectra.frame.empty:
        return None
    frame, units = results.spectra.frame, results.spectra.units
    stage = frame["stage"].iloc[-1]
    frame = frame[(frame["stage"] == stage) & (frame["period"] > 0.0)]
    # Where nothing moves there is nothing to see.
    axes_that_move = [axis for axis, rows in frame.groupby("axis") if rows["pseudo_acceleration"].any()] or ["x"]
    monitors = list(dict.fromkeys(frame["monitor"]))[:SHOWN_MONITORS]
    figure = new_figure(1.2 + 2.2 * len(axes_that_move))
    for axes, axis in zip(figure.subplots(len(axes_that_move), sharex=True, squeeze=False)[:, 0], axes_that_move):
        for monitor in monitors:
            rows = frame[(frame["axis"] == axis) & (frame["monitor"] == monitor)].sort_values("period")
            axes.plot(rows["period"], rows["pseudo_acceleration"], linewidth=1.0, label=monitor)
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
        axes.set_ylim(bottom=0.0)
        axes.set_ylabel(f"along {axis} [{units['pseudo_acceleration'].replace('s2', 's²')}]")
        axes.legend(loc="upper right")
    axes.set_xlabel("period [s]")
    set_margins(figure, hspace=0.12)
    damping = float(results.summary["parameters"]["Output"]["Spectrum damping"])
    return to_figure(figure, f"Response spectra of the monitors in stage ‘{stage}’: largest pseudo-acceleration of oscillators with "
                             f"{rounded(100.0 * damping, 3)} % of the critical damping that stand there, under the absolute acceleration. "
                             "All monitors: spectra.csv.")
