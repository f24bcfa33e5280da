# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The words and tables of a report."""

import math
import os

import numpy

from report.text.page import Fold, Heading, Number, Table, Text, Verdict
from report.text.words import DIGITS, Length, describe, end_of_loads, rounded

# The list of events is cut in the middle of a longer one.
LISTED_EVENTS = 400
# What is so much smaller than the largest number of its row is rounding, and shown as 0.
ROUNDING = 1e-12
# Columns of one kind: rounding is judged beside the largest of all.
ALIKE = (("N", "T", "T2", "water"), ("M", "M1", "Mn"), ("eccentricity", "eccentricity2", "position_x", "position_y", "position_z"),
         ("external_work", "energy_bodies", "energy_layer", "dissipation", "joint_dissipation"), ("ux", "uy", "uz"),
         ("stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_xz"))
# Columns of lengths that are read in millimetres where the model is in metres.
SMALL_LENGTHS = ("largest_gap", "largest_slip", "ux", "uy", "uz")

CERTIFICATE = {
    "equilibrium": "forces of the bodies, the joints and the loads balance at every interface coordinate",
    "body equilibrium": "forces and moments on every floating body",
    "penetration": "no overlap where there is no layer to close",
    "tension": "no tension in a contact element",
    "cone": "shear within f|N| + cA",
    "complementarity": "no force where the joint is open",
    "slip direction": "slip only at the strength, and against friction",
    "layer law": "closure and elastic shear as the law of the layer gives them for the forces",
    "energy": "external work = energy of bodies + energy of layers + dissipation",
}

FILES = {
    "summary.json": "verdict, sizes, certificate, parameters",
    "events.csv": "every change of state, at its exact load",
    "joint_history.csv": "every contact element at every load level",
    "resultants.csv": "every joint at every load level",
    "monitors.csv": "displacements of the monitored points",
    "earthquake.csv": "every joint at every step of time of a motion, with the energies",
    "accelerations.csv": "absolute accelerations of the monitored points in stages with a Duration",
    "spectra.csv": "their response spectra",
    "boundaries.csv": "faces of boundaries and joints",
    "sweep.csv": "every variant of the sweep",
    "bodies.pvd": "displacements and stresses, for ParaView",
    "joints.pvd": "fields of the joints, for ParaView",
    "joints_exploded.pvd": "the same with both lips apart",
    "view_in_paraview.py": "opens the fields: paraview --script=view_in_paraview.py",
    "log.txt": "what was on the screen",
}


def place_of(summary):
    """Where a run ended, in words."""
    return (f"{rounded(100.0 * summary['stage_fraction'])} % of stage \u2018{summary['stage']}\u2019, "
            f"t = {rounded(summary['t'])}")


def _verdict_words(summary):
    """(class of the box, heading, sentences) for the verdict of a run."""
    code, verdict, place = summary["exit_code"], summary["verdict"], place_of(summary)
    if code == 0:
        return "good", "Done: the whole load is carried.", [f"Reached {place}."]
    if code == 4:
        worst = summary["certificate"]
        return "bad", "The certificate is above its bound: do not use these results.", [
            f"Worst entry {rounded(worst['worst'], 2)}, bound {rounded(worst['bound'], 2)}; the run ended with "
            f"\u201c{verdict}\u201d at {place}."]
    if code == 2:
        return "bad", "Numerical failure.", [summary.get("message", ""), f"The run ended at {place}."]
    limit = summary.get("limit_load")
    heading = f"Loss of equilibrium: {verdict}" + (f", mechanism {limit['mechanism']}." if limit else ".")
    sentences = [f"The load can be carried up to {place}. All results up to there are complete and valid."]
    if limit:
        factors = ", ".join(f"{name} {rounded(factor)}" for name, factor in limit["load_factors"].items())
        sentences.append(f"Load factors at the limit: {factors}.")
        for motion in summary.get("continuations", [])[-1:]:
            sentences.append(f"After {rounded(motion['seconds'], 3)} s the bodies still move, with "
                             f"{rounded(motion['largest_velocity_at_end'], 3)} units of length per second.")
    elif "mechanism" in (jump := summary["events"].get("jump", {})):
        sentences.append(f"There {jump['motion']}, and nothing resists it (mechanism {jump['mechanism']}) before it comes "
                         f"to rest after a jump of {rounded(jump['size'], 3)} units of length. "
                         "Solver/No continuation = jump goes on from there.")
    else:
        sentences.append("Nothing moves freely there, yet no quasi-static continuation exists: friction is beyond its "
                         "critical value.")
    return "limit", heading, sentences


def _safety_words(summary):
    """A sentence for each factor of safety that was looked for."""
    sentences = []
    for method, found in summary.get("safety", {}).items():
        subject = ", ".join(found.get("joints", found.get("loads", [])))
        text = f"Factor of safety by {method.replace('_', ' ')} ({subject}): "
        if found["factor"] is not None:
            text += f"{'F = ' if method == 'strength_reduction' else ''}{rounded(found['factor'])}, {found['verdict']}"
            if "mechanism" in found:
                text += f", mechanism {found['mechanism']} of {', '.join(found['mechanism_joints'])}"
        elif "factor_at_least" in found:
            text += f"above {rounded(found['factor_at_least'])}, the largest factor asked for"
        else:
            text += "not computed, because the loads are not carried to their end"
        sentences.append(text + ".")
    return sentences


def _accuracy_words(summary):
    """How accurate the quantity of section Target accuracy is, if there is one."""
    accuracy = summary.get("accuracy")
    if accuracy is None:
        return []
    estimate = accuracy["estimated_error"]
    text = f"Estimated error of the {accuracy['quantity']}: "
    text += "not known" if estimate is None else f"{rounded(100.0 * estimate, 3)} %"
    text += f", target {rounded(100.0 * accuracy['target'], 3)} %; mesh {len(accuracy['rounds'])}"
    return [text + ("." if accuracy["reached"] else f". The target is not reached: {accuracy['end']}.")]


def verdict(summary):
    look, heading, sentences = _verdict_words(summary)
    worst = summary["certificate"]
    return Verdict(look, heading, sentences + _safety_words(summary) + _accuracy_words(summary)
                   + [f"Exit code {summary['exit_code']}. Certificate {rounded(worst['worst'], 2)}, bound "
                      f"{rounded(worst['bound'], 2)}."])


def joint_overview(results):
    """A row per joint at the end of the loads, the least safe first: by the smaller of its safeties."""
    frame, units = results.resultants.frame, results.resultants.units
    length = Length(units["largest_gap"])
    rows, keys = [], []
    for joint in results.joints:
        there = results.levels_of(joint)
        t = min(there, key=lambda level: abs(level - end_of_loads(results)))
        row = frame[(frame["joint"] == joint) & (frame["t"] == t)].iloc[0]
        shear = math.hypot(row["T"], row["T2"]) if results.in_space else row["T"]
        rows.append([joint, float(row["N"]), float(shear)] + ([float(row["water"])] if "water" in row else [])
                    + [Number(rounded(100.0 * row["share_open"], 3)), Number(rounded(100.0 * row["share_slip"], 3)),
                       length.factor * float(row["largest_gap"]), length.factor * float(row["largest_slip"]),
                       float(row["sliding_safety"])]
                    + ([float(row["overturning_safety"])] if "overturning_safety" in row else []))
        factors = [row[name] for name in ("sliding_safety", "overturning_safety") if name in row and row[name] >= 0.0]
        keys.append((min(factors, default=math.inf), -row["share_open"], len(keys)))
    head = ["joint", f"N [{units['N']}]", f"{'|T|' if results.in_space else 'T'} [{units['T']}]"]
    head += [f"water [{units['water']}]"] if "water" in units else []
    head += ["open [%]", "slip [%]", f"largest gap [{length.unit}]", f"largest slip [{length.unit}]", "sliding safety"]
    head += ["overturning safety"] if "overturning_safety" in units else []
    ordered = [rows[k] for k in sorted(range(len(rows)), key=lambda k: keys[k])]
    if "overturning_safety" in units and all(math.isnan(row[-1]) for row in rows):
        head, ordered = head[:-1], [row[:-1] for row in ordered]
    return Table(ordered, head, "joints-table")


def shortened(whole, rows):
    """The first rows of a table; says so if it has more."""
    if len(whole.rows) <= rows:
        return whole
    return Table(whole.rows[:rows] + [[f"and {len(whole.rows) - rows} more"] + [""] * (len(whole.head) - 1)], whole.head,
                 whole.name, whole.digits)


def _level_heads(results, levels):
    return [f"t = {t:.5g}" for t in levels]


def _cells(name, values, largest):
    """One row of numbers; what is rounding beside the largest number it is made of is shown as 0."""
    digits = 2 if name == "certificate" else DIGITS
    return [Number(rounded(0.0 if abs(value) < ROUNDING * largest else float(value), digits)) for value in values]


def _largest(rows, names):
    """The largest finite size in some columns."""
    sizes = numpy.abs(rows[[name for name in names if name in rows]].to_numpy(float))
    return float(sizes[numpy.isfinite(sizes)].max(initial=0.0))


def _level_row(name, unit, rows):
    """Name, unit and one number per level; small lengths in a unit that one can read."""
    length = Length(unit) if name in SMALL_LENGTHS else Length("")
    largest = _largest(rows, next((alike for alike in ALIKE if name in alike), (name,)))
    return ([name.replace("_", " "), (length.unit or unit) or "\u2013"]
            + _cells(name, length.factor * rows[name], length.factor * largest))


def resultant_tables(results, levels):
    """Per joint: a row per column of resultants.csv, a column per level."""
    frame, units = results.resultants.frame, results.resultants.units
    parts = [Text("N, T: sums of the bar forces along the mean normal and tangent of the joint, tension positive; M: moment "
                  "about the centroid of the joint, counter-clockwise. All levels with all digits: resultants.csv.")]
    # Columns of words name the state, which stands in the head; the frame of a joint does not change.
    names = [name for name in frame.columns if name not in ("t", "joint", "path_length")
             and not name.startswith(("normal_", "t1_")) and frame[name].dtype.kind in "fi"]
    for k, joint in enumerate(results.joints):
        there = results.levels_of(joint, levels)
        rows = frame[frame["joint"] == joint].drop_duplicates("t").set_index("t").loc[there]
        body = [["", ""] + [describe(results, t) for t in there]]
        body += [_level_row(name, units[name], rows) for name in names if rows[name].notna().any()]
        parts += [Heading(f"Joint \u201c{joint}\u201d"), Table(body, ["", "unit"] + _level_heads(results, there),
                                                               f"resultants-{k}")]
    return parts


def monitor_tables(results, levels):
    """Per monitor: a row per displacement and stress, a column per level; nothing without monitors."""
    if results.monitors is None or results.monitors.frame.empty:
        return []
    frame, units = results.monitors.frame, results.monitors.units
    frame = frame[frame["occasion"] == "level"]
    parts = [Text("Displacements; stresses positive in tension" + ("" if results.in_space else ", zz across the plane")
                  + ". All levels: monitors.csv.")]
    for k, (name, rows) in enumerate(frame.groupby("monitor", sort=False)):
        rows = rows.drop_duplicates("t").set_index("t").loc[levels]
        place = ", ".join(rounded(float(rows[c].iloc[0])) for c in ("x", "y", "z")[:3 if results.in_space else 2])
        columns = [c for c in frame.columns if c.startswith(("u", "stress_")) and c in units and rows[c].notna().all()
                   and (results.in_space or c != "uz")]
        body = [_level_row(c, units[c], rows) for c in columns]
        parts += [Heading(f"Monitor \u201c{name}\u201d at ({place})"),
                  Table(body, ["", "unit"] + _level_heads(results, levels), f"monitor-{k}")]
    return parts


def certificate_table(summary):
    bound = summary["certificate"]["bound"]
    rows = [[name, CERTIFICATE.get(name, ""), float(value), "yes" if value <= bound else "NO"]
            for name, value in summary["certificate"]["entries"].items()]
    return [Text("A part of the program that knows the data but not the solver has judged every state. Largest values of "
                 f"the whole run, relative; the bound is {rounded(bound, 2)}."),
            Table(rows, ["entry", "condition", "largest", "within the bound"], "certificate-table", 2)]


def _flat(value, path=""):
    """(path, number or text) of nested objects."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from _flat(inner, f"{path} / {name}" if path else str(name))
    else:
        yield path, value if isinstance(value, (int, float, str)) else ", ".join(map(str, value))


def _words(section, prefix=""):
    return [[prefix + path.replace("_", " "), value] for path, value in _flat(section)]


def continuations(results):
    """A row per motion after the loss of an equilibrium."""
    motions = results.summary.get("continuations", [])
    if not motions:
        return None
    length, energy = results.resultants.units["largest_slip"], results.resultants.units["external_work"]
    rows = [[motion["cause"], motion["t"], motion["t_of_loads"], "rest" if motion["comes_to_rest"] else "still moving",
             motion["seconds"], motion["largest_slip"], motion["largest_opening"], motion["work"], motion["friction_work"],
             motion["damping"]] for motion in motions]
    head = ["cause", "t", "t of the loads", "end", "seconds", f"largest slip [{length}]", f"opening [{length}]",
            f"work of the loads [{energy}]", f"friction [{energy}]", f"damping [{energy}]"]
    return Table(rows, head, "continuations-table")


def sizes(summary):
    rows = (_words(summary.get("sizes", {})) + _words(summary.get("events", {}), "events: ")
            + _words(summary.get("iterations", {}), "iterations: "))
    seconds = summary.get("seconds", {})
    rows += [["seconds in all", float(sum(seconds.values()))], ["memory, MB", float(summary.get("memory_MB", 0.0))]]
    parts = [Table(rows, name="sizes-table", digits=3)]
    if "work" in summary:
        parts.append(Fold("Work by counts", [Table(_words(summary["work"]), name="work-table", digits=3)]))
    return parts + [Fold("Seconds by phase", [Table([[name, float(s)] for name, s in seconds.items()], digits=2)])]


def warnings(summary):
    return [Text(text, "warning") for text in summary.get("warnings", [])]


def remarks(summary):
    """Warnings and what the program says of each joint."""
    return warnings(summary) + [Text(text) for text in summary.get("joints", [])]


def event_list(results):
    frame = results.all_events
    columns = ["event", "t", "stage", "stage_fraction", "joint", "element", "x", "y", "z", "from", "to"]
    if not results.in_space:
        columns.remove("z")
    if frame.empty:
        return [Text("No contact element changed its state, or the path was not followed from event to event.")]
    half, number = LISTED_EVENTS // 2, len(frame)
    shown = frame if number <= LISTED_EVENTS else frame.iloc[[*range(half), *range(number - half, number)]]
    cut = ([] if number <= LISTED_EVENTS else
           [Text(f"The first and the last {half} of {number} events; all of them: events.csv.")])
    head = [results.events.label(name) for name in columns]
    rows = [[value.item() if hasattr(value, "item") else value for value in row]
            for row in shown[columns].itertuples(index=False)]
    return cut + [Fold(f"All {number} events" if not cut else "Events", [Table(rows, head, "event-table")])]


def parameters(summary):
    parts = []
    plain = [[name, value] for name, value in summary["parameters"].items() if not isinstance(value, dict)]
    if plain:
        parts.append(Table(plain, name="parameters-general"))
    for name, section in summary["parameters"].items():
        if isinstance(section, dict) and section:
            parts += [Heading(name), Table([list(row) for row in _flat(section)])]
    return [Fold("All parameters as they were used", parts)]


def main_parameters(summary):
    """Data of bodies, joints, loads and supports, without what says nothing."""
    parts = []
    for name in ("Bodies", "Joints", "Boundaries", "Loads", "Stages"):
        rows = [[subject, ", ".join(f"{entry} {value}" for entry, value in data.items() if value not in ("", "0"))]
                for subject, data in summary["parameters"].get(name, {}).items()]
        if rows:
            parts += [Heading(name), Table(rows)]
    return parts


def files(directory):
    return [Table([[name, meaning] for name, meaning in FILES.items() if os.path.exists(os.path.join(directory, name))])]


def footer(summary):
    versions = ", ".join(f"{name} {version}" for name, version in summary.get("versions", {}).items())
    source = f"Parameter file: {summary['parameter_file']}. " if "parameter_file" in summary else ""
    return f"{source}Numbers are rounded; the CSV files have all digits. Written by fuga report. {versions}"
