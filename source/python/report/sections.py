# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The words and tables of a report."""

import math
import os

from report.page import Shown, collapsed, escape, number, table

# The list of events is cut in the middle of a longer one.
LISTED_EVENTS = 400
ROUNDING = 1e-12
NO_UNITS = ("", None)

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
    "sweep.csv": "every variant of the sweep",
    "bodies.pvd": "displacements and stresses, for ParaView",
    "joints.pvd": "fields of the joints, for ParaView",
    "joints_exploded.pvd": "the same with both lips apart",
    "view_in_paraview.py": "opens the fields: paraview --script=view_in_paraview.py",
    "log.txt": "what was on the screen",
}


def verdict_words(summary):
    """(class of the box, heading, sentences) for the verdict of a run."""
    code, verdict = summary["exit_code"], summary["verdict"]
    place = f"{100 * summary['stage_fraction']:.6g} % of stage \u2018{summary['stage']}\u2019, t = "
    place = escape(place) + number(summary["t"], 12)
    if code == 0:
        return "good", "Done: the whole load is carried.", [f"Reached {place}."]
    if code == 4:
        worst = summary["certificate"]
        return "bad", "The certificate is above its bound: do not use these results.", [
            f"Worst entry {number(worst['worst'], 3)}, bound {number(worst['bound'], 3)}; the run ended with "
            f"\u201c{escape(verdict)}\u201d at {place}."]
    if code == 2:
        return "bad", "Numerical failure.", [escape(summary.get("message", "")), f"The run ended at {place}."]
    limit = summary.get("limit_load")
    heading = f"Loss of equilibrium: {verdict}" + (f", mechanism {limit['mechanism']}." if limit else ".")
    sentences = [f"The load can be carried up to {place}. All results up to there are complete and valid."]
    if limit:
        factors = ", ".join(f"{escape(name)} {number(factor, 9)}" for name, factor in limit["load_factors"].items())
        sentences.append(f"Load factors at the limit: {factors}.")
    else:
        sentences.append("Nothing moves freely there, yet no quasi-static continuation exists: friction is beyond its "
                         "critical value.")
    return "limit", heading, sentences


def safety_words(summary):
    """A sentence for each factor of safety that was looked for."""
    sentences = []
    for method, found in summary.get("safety", {}).items():
        subject = ", ".join(escape(name) for name in found.get("joints", found.get("loads", [])))
        text = f"Factor of safety by {method.replace('_', ' ')} ({subject}): "
        if found["factor"] is not None:
            text += number(found["factor"], 9) + f", {escape(found['verdict'])}"
            if "mechanism" in found:
                moving = ", ".join(escape(name) for name in found["mechanism_joints"])
                text += f", mechanism {escape(found['mechanism'])} of {moving}"
        elif "factor_at_least" in found:
            text += "above " + number(found["factor_at_least"], 9) + ", the largest factor asked for"
        else:
            text += "not computed, because the loads are not carried to their end"
        sentences.append(text + ".")
    return sentences


def accuracy_words(summary):
    """How accurate the quantity of section Target accuracy is, if there is one."""
    accuracy = summary.get("accuracy")
    if accuracy is None:
        return []
    estimate = accuracy["estimated_error"]
    text = f"Estimated error of the {escape(accuracy['quantity'])}: "
    text += "not known" if estimate is None else f"{number(100 * estimate, 3)} %"
    text += f", target {number(100 * accuracy['target'], 3)} %; mesh {len(accuracy['rounds'])}"
    return [text + ("." if accuracy["reached"] else f". The target is not reached: {escape(accuracy['end'])}.")]


def verdict_box(summary):
    kind, heading, sentences = verdict_words(summary)
    sentences += safety_words(summary)
    sentences += accuracy_words(summary)
    lines = "".join(f"<p>{sentence}</p>" for sentence in sentences if sentence)
    return (f'<div class="verdict {kind}" id="verdict"><strong>{escape(heading)}</strong>{lines}'
            f"<p>Exit code {number(summary['exit_code'])}.</p></div>")


def _cells(name, values):
    """One row of the resultants. What is rounding beside the largest value of the row is shown as 0."""
    finite = [abs(value) for value in values if math.isfinite(value)]
    rounding = ROUNDING * max(finite, default=0.0)
    digits = 2 if name == "certificate" else 6
    return [Shown(number(float(value), digits, shown=0.0 if abs(value) < rounding else None)) for value in values]


def resultant_tables(results, levels):
    """Per joint: a row per column of resultants.csv, a column per level."""
    frame, units = results.resultants.frame, results.resultants.units
    text = ("<p>N, T: sums of the bar forces along the mean normal and tangent of the joint, tension positive; M: moment "
            "about the centroid of the joint, counter-clockwise. All levels: resultants.csv.</p>")
    names = [name for name in frame.columns if name not in ("t", "joint")]
    for k, joint in enumerate(results.joints):
        there = results.levels_of(joint, levels)
        rows = frame[frame["joint"] == joint].set_index("t").loc[there]
        head = ["", "unit"] + [f"t = {t:.6g}" for t in there]
        body = [[name.replace("_", " "), units[name] or "\u2013"] + _cells(name, rows[name]) for name in names]
        text += f"<h3>Joint \u201c{escape(joint)}\u201d</h3>" + table(body, head, f"resultants-{k}")
    return text


def monitor_tables(results, levels):
    """Per monitor: a row per displacement and stress, a column per level; nothing without monitors."""
    if results.monitors is None or results.monitors.frame.empty:
        return ""
    frame, units = results.monitors.frame, results.monitors.units
    frame = frame[frame["occasion"] == "level"]
    text = ""
    for k, (name, rows) in enumerate(frame.groupby("monitor", sort=False)):
        rows = rows.drop_duplicates("t").set_index("t").loc[levels]
        place = ", ".join(f"{rows[c].iloc[0]:.6g}" for c in ("x", "y"))
        columns = [c for c in ("ux", "uy", "stress_xx", "stress_yy", "stress_zz", "stress_xy") if rows[c].notna().all()]
        head = ["", "unit"] + [f"t = {t:.6g}" for t in levels]
        body = [[c.replace("_", " "), units[c] or "\u2013"] + _cells(c, rows[c]) for c in columns]
        text += (f"<h3>Monitor \u201c{escape(name)}\u201d at ({place})</h3>" + table(body, head, f"monitor-{k}"))
    return text and ("<p>Displacements; stresses positive in tension, zz across the plane. All levels: monitors.csv.</p>" + text)


def certificate_table(summary):
    entries = summary["certificate"]["entries"]
    bound = summary["certificate"]["bound"]
    rows = [[name, CERTIFICATE.get(name, ""), float(value), "yes" if value <= bound else "NO"]
            for name, value in entries.items()]
    return ("<p>A part of the program that knows the data but not the solver has judged every state. Largest values of "
            f"the whole run, relative; the bound is {number(bound, 3)}.</p>"
            + table(rows, ["entry", "condition", "largest", "within the bound"], "certificate-table", digits=3))


def _flat(value, path=""):
    """(path, number or text) of nested objects."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield from _flat(inner, f"{path} / {name}" if path else str(name))
    else:
        yield path, value if isinstance(value, (int, float, str)) else ", ".join(map(str, value))


def sizes(summary):
    rows = [[path.replace("_", " "), value] for path, value in _flat(summary.get("sizes", {}))]
    rows += [["events: " + path.replace("_", " "), value] for path, value in _flat(summary.get("events", {}))]
    rows += [["iterations: " + path.replace("_", " "), value] for path, value in _flat(summary.get("iterations", {}))]
    seconds = summary.get("seconds", {})
    rows += [["seconds in all", float(sum(seconds.values()))], ["memory, MB", float(summary.get("memory_MB", 0.0))]]
    work = [[path.replace("_", " "), value] for path, value in _flat(summary.get("work", {}))]
    text = table(rows, name="sizes-table", digits=4)
    if work:
        text += collapsed("Work by counts", table(work, name="work-table"))
    return text + collapsed("Seconds by phase", table([[name, float(s)] for name, s in seconds.items()], digits=3))


def remarks(summary):
    """Warnings and what the program says of each joint."""
    warnings = "".join(f'<p class="warning">{escape(text)}</p>' for text in summary.get("warnings", []))
    lines = "".join(f"<p>{escape(text)}</p>" for text in summary.get("joints", []))
    return warnings + lines


def event_list(results):
    frame = results.all_events
    columns = ["event", "t", "stage", "stage_fraction", "joint", "element", "x", "y", "from", "to"]
    if frame.empty:
        return "<p>No contact element changed its state, or the path was not followed from event to event.</p>"
    shown = frame if len(frame) <= LISTED_EVENTS else frame.iloc[[*range(LISTED_EVENTS // 2),
                                                                 *range(len(frame) - LISTED_EVENTS // 2, len(frame))]]
    cut = "" if len(frame) <= LISTED_EVENTS else (
        f"<p>The first and the last {LISTED_EVENTS // 2} of {len(frame)} events; all of them: events.csv.</p>")
    head = [results.events.label(name) for name in columns]
    rows = [[value.item() if hasattr(value, "item") else value for value in row]
            for row in shown[columns].itertuples(index=False)]
    return cut + collapsed(f"All {len(frame)} events" if not cut else "Events", table(rows, head, "event-table", digits=9))


def parameters(summary):
    text = ""
    plain = [[name, value] for name, value in summary["parameters"].items() if not isinstance(value, dict)]
    if plain:
        text += table(plain, name="parameters-general")
    for name, section in summary["parameters"].items():
        if isinstance(section, dict):
            text += f"<h3>{escape(name)}</h3>" + table([list(row) for row in _flat(section)])
    return collapsed("All parameters as they were used", text)


def files(directory):
    rows = [[name, meaning] for name, meaning in FILES.items() if os.path.exists(os.path.join(directory, name))]
    return table(rows)


def footer(summary):
    versions = ", ".join(f"{escape(name)} {escape(version)}" for name, version in summary.get("versions", {}).items())
    source = f"Parameter file: {escape(summary['parameter_file'])}. " if "parameter_file" in summary else ""
    return f"{source}Written by fuga report. {versions}"
