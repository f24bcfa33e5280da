#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Makes the Debian package, unpacks it into an empty folder and works with what is there and nowhere else.

usage: package.py BUILD_DIR

The dependencies that the package names are installed and bring every library; the program says its version, runs an
example of its documentation and makes a report, in an environment without variables; manual and completion know the
options that the program knows.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

BUILD = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, **options)


def make_package(folder):
    made = run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder)
    packages = list(folder.glob("*.deb"))
    if made.returncode != 0 or len(packages) != 1:
        sys.exit(f"cpack: {made.returncode}\n{made.stdout[-1000:]}{made.stderr[-1000:]}")
    return packages[0]


def check_dependencies(package, program):
    depends = run("dpkg-deb", "--field", package, "Depends").stdout
    check("libdeal.ii" in depends and "libmumps" in depends.lower(), f"dependencies: {depends}")
    for one in depends.split(","):
        names = [re.split(r"[ (]", option.strip())[0] for option in one.split("|")]
        found = [run("dpkg-query", "-W", "-f=${db:Status-Status}", name).stdout == "installed" for name in names]
        check(any(found), f"the package depends on {names}, which the program was built without")
    check("not found" not in run("ldd", program).stdout, "a library of the installed program is missing")
    needed = run("readelf", "-d", program).stdout
    check(not re.search(r"RUNPATH|RPATH", needed), "the program looks for libraries in the folder it was built in")


def options_of(text):
    return set(re.findall(r"--[a-z][a-z-]+", text.replace("\\-", "-")))


def check_manual_and_completion(program, root, work):
    listed = options_of(run(program, "--help").stdout)
    manual = (root / "usr/share/man/man1/fuga.1").read_text()
    check(options_of(manual) == listed, f"options of the manual {options_of(manual) ^ listed}")
    codes = set(re.findall(r"\b\d+\b", run(program, "--help").stdout.split("Exit codes:")[1]))
    check(all(re.search(rf"^\.BR? .*\b{code}\b", manual, re.MULTILINE) for code in codes), f"exit codes {codes}")
    completion = root / "usr/share/bash-completion/completions/fuga"

    def complete(*words):
        quoted = " ".join(f"'{word}'" for word in words)
        script = (f"compopt() {{ :; }}; . {completion}; COMP_WORDS=({program} {quoted}); "
                  f"COMP_CWORD={len(words)}; _fuga; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
        return run("bash", "-O", "extglob", "-c", script, cwd=work).stdout.split("\n")[:-1]

    check(set(complete("--")) == listed, f"completed options {set(complete('--')) ^ listed}")
    check(complete("--set", "Mesh/Ref") == ["Mesh/Refinements="], f"completed entries {complete('--set', 'Mesh/Ref')}")
    (work / "wall.prm").touch()
    check(complete("wa") == ["wall.prm"] and complete("rep") == ["report"], f"completed files {complete('wa')}")
    (work / "wall.prm").unlink()


def check_program(program, root, work):
    version = re.search(r'version = "([\d.]+)"', (ROOT / "include/fuga/output/files/version.h").read_text())[1]
    check(version in run(program, "--version", env={}).stdout, f"--version does not say {version}")
    example = root / "usr/share/doc/fuga/examples/parameters/paper_2_linear.prm"
    done = run(program, example, "--quiet", "--output-dir", "run", "--set", "Output/Fields=end", cwd=work, env={})
    check(done.returncode == 0, f"the example: {done.returncode} {done.stderr[-500:]}")
    summary = json.loads((work / "run/summary.json").read_text())
    check(summary["certificate"]["worst"] < 1e-9, f"certificate {summary['certificate']['worst']}")
    check((root / "usr/share/fuga/make_report.py").exists(), "the script of the report is not installed")
    report = run(program, "report", "run", cwd=work, env={})
    check(report.returncode == 0 and (work / "run/report.html").stat().st_size > 20000, f"the report: {report.stderr[-500:]}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        root, work = folder / "root", folder / "work"
        work.mkdir()
        package = make_package(folder / "made")
        unpacked = run("dpkg-deb", "--extract", package, root)
        check(unpacked.returncode == 0, unpacked.stderr)
        program = root / "usr/bin/fuga"
        check_dependencies(package, program)
        check_manual_and_completion(program, root, work)
        check_program(program, root, work)
        size = package.stat().st_size / 1e6
    print("\n".join(complaints) or f"the package of {size:.1f} MB works from an empty folder")
    sys.exit(1 if complaints else 0)


main()
