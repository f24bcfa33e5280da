# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Runs of fuga: parameter files, measurement, reading of the results."""
import collections
import csv
import functools
import json
import os
import statistics
import subprocess

import meshes
from process import Result, measure

PROGRAM = os.environ.get("FUGA", str(meshes.REPOSITORY / "build" / "release" / "fuga"))
JUMPS = ("jump_n", "jump_t1", "jump_t2")
WORK = meshes.REPOSITORY / "results" / "benchmark"
STARTS = collections.deque(maxlen=5)
LOSS_OF_EQUILIBRIUM = 3  # exit code


def commit():
    """The last one that changed the program; -dirty where its sources differ from it."""
    git, sources = ["git", "-C", str(meshes.REPOSITORY)], ["--", "source", "include", "CMakeLists.txt"]
    name = subprocess.run([*git, "log", "-1", "--format=%h", *sources], capture_output=True, text=True).stdout.strip()
    return name if subprocess.run([*git, "diff", "--quiet", "HEAD", *sources]).returncode == 0 else name + "-dirty"


def prm_text(sections, indent=""):
    lines = []
    for name, value in sections.items():
        if isinstance(value, dict):
            lines += [indent + "subsection " + name, prm_text(value, indent + "  "), indent + "end"]
        else:
            lines.append("%sset %s = %s" % (indent, name, repr(value) if isinstance(value, float) else value))
    return "\n".join(lines)


def write_parameters(path, sections, fields="never"):
    output = {"Output": {"Fields": fields, "Log": "quiet"}}
    path.write_text(prm_text({**sections, **output}) + "\n")


def mesh_path(name, make_mesh):
    """Writes the mesh when it is wanted for the first time."""
    path = WORK / "meshes" / (name + ".msh")
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        make_mesh().write(str(path) + ".part")
        os.replace(str(path) + ".part", path)
    return str(path)


@functools.lru_cache(maxsize=None)
def knows(text):
    """Whether this fuga knows an entry or a choice of the parameter file."""
    answer = subprocess.run([PROGRAM, "--print-parameters"], capture_output=True, text=True, check=True)
    return text in " ".join(answer.stdout.replace("#", "").split())


def start_seconds(measurements=3):
    """CPU seconds of a program that only says its version: what loading the libraries costs. Median of the last five
    measurements, so many of them now."""
    directory = WORK / "runs"
    directory.mkdir(parents=True, exist_ok=True)
    STARTS.extend(measure([PROGRAM, "--version"], str(directory)).cpu for _ in range(measurements))
    return statistics.median(STARTS)


def run(tag, sections, fields="never", cpu_limit=900, result_file="summary.json", threads=1,
        expected_codes=(0,)):
    """(Result without error, directory). Two totals: CPU time of the process, and this less the start."""
    directory = WORK / "runs" / tag
    directory.mkdir(parents=True, exist_ok=True)
    write_parameters(directory / "run.prm", sections, fields)
    for old in ("summary.json", "joint_history.csv", "resultants.csv", "sweep.csv"):
        (directory / "out" / old).unlink(missing_ok=True)
    start = start_seconds(1 if STARTS else 3)
    command = [PROGRAM, "run.prm", "--output-dir", "out", "--quiet", "--threads", str(threads)]
    process = measure(command, str(directory), cpu_limit, threads)
    phases = {"total": process.cpu, "total_after_start": process.cpu - start, "wall": process.wall}
    result = Result(phases, process.memory_MB, 0, 0)
    summary_file = directory / "out" / "summary.json"
    summary = json.loads(summary_file.read_text()) if summary_file.exists() else None
    if process.code not in expected_codes or not (directory / "out" / result_file).exists():
        words = ["exit code %d" % process.code, summary["verdict"] if summary else "",
                 "CPU time limit" if process.timed_out else " ".join(process.output.strip().splitlines()[-1:])]
        result.failure = ": ".join(word for word in words if word)
    if summary:
        phases.update(summary["seconds"])
        result.elements = summary["sizes"].get("contact_elements", 0)
        result.dofs = summary["sizes"]["degrees_of_freedom"]
        result.info = {"events": summary["events"]["total"], "steps": summary["events"]["steps"],
                       "certificate": summary["certificate"]["worst"], "fuga": summary["versions"]["fuga"],
                       "deal.II": summary["versions"]["deal.II"]}
    return result, directory


def _number(text):
    try:
        return float(text)
    except ValueError:
        return text


def _table(directory, name):
    """Rows as dictionaries, without the units in the names; numbers as numbers."""
    with open(directory / "out" / name, newline="") as file:
        return [{key.split("[")[0]: _number(value) for key, value in row.items()} for row in csv.DictReader(file)]


def history(directory):
    """Rows of the last level in the order of x."""
    rows = _table(directory, "joint_history.csv")
    return sorted((row for row in rows if row["t"] == rows[-1]["t"]), key=lambda row: row["x"])


def resultants(directory):
    return _table(directory, "resultants.csv")


def stage_jumps(directory, dim):
    """[lists of jumps: normal, tangential, in space also along y] at the ends of the stages; elements in order."""
    stages = {}
    for row in _table(directory, "joint_history.csv"):
        place = tuple(round(row[name], 6) for name in "xyz")
        stages.setdefault(row["t"], []).append((place, [row[name] for name in JUMPS[:dim]]))
    return [list(map(list, zip(*(jumps for _, jumps in sorted(rows))))) for _, rows in sorted(stages.items())]


def tag_of(scene, variant):
    return "%s_%d_%s" % (scene.name, scene.n, variant)


def scene_mesh(scene):
    name = "scene_g" if scene.name.startswith("scene_g") else scene.name
    return mesh_path("%s_%d%s" % (name, scene.n, "_bonded" if scene.bonded else ""), lambda: scene.mesh)


def run_scene(scene, variant, fields="never", threads=1):
    """A scene; the error is that of the jumps at the end against the independent solution, or that of its limit."""
    tag = "fuga_" + tag_of(scene, variant)
    codes = (LOSS_OF_EQUILIBRIUM,) if scene.limit else (0,)
    result, directory = run(tag, scene.sections(scene_mesh(scene)), fields, threads=threads, expected_codes=codes)
    reference = None if scene.bonded else scene.reference()
    if scene.limit and not result.failure:
        summary = json.loads((directory / "out" / "summary.json").read_text())
        result.error = abs(summary["limit_load"]["load_factors"]["push"] / scene.limit - 1.)
    elif reference and not result.failure:
        result.error, result.info["stage errors"] = scene.error(stage_jumps(directory, scene.dim), reference)
    result.elements = scene.n  # the bonded control, too, belongs to this row of the table
    return result


def end_jumps(scene):
    """Jumps at the ends of the stages by fuga itself: the reference where the repository has no independent one."""
    result, directory = run("reference_" + tag_of(scene, "%r_%r" % (scene.joint["kn"], scene.joint["f"])),
                            scene.sections(scene_mesh(scene)))
    if result.failure:
        raise RuntimeError("the reference run failed: " + result.failure)
    return stage_jumps(directory, scene.dim)


def reference_of(scene):
    """(jumps at the ends of the stages, who computed them)"""
    independent = scene.reference()
    return (independent, "independent") if independent else (end_jumps(scene), "fuga")
