#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Records of tools/synthetic_record.py: the closed forms that they follow, and that the program reads them without a word.

usage: synthetic_record.py FUGA
"""
import cmath
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def text_of(*arguments):
    return subprocess.run([sys.executable, str(ROOT / "tools/synthetic_record.py"), *map(str, arguments)], check=True,
                          capture_output=True, text=True, timeout=60).stdout


def record(*arguments):
    rows = [[float(word) for word in line.split()] for line in text_of(*arguments).splitlines() if not line.startswith("#")]
    return [row[0] for row in rows], [row[1] for row in rows]


def ends(times, a):
    """Velocity and displacement at the end, relative to the largest ones; exact for linear accelerations."""
    h, v, u, largest_v, largest_u = times[1], 0., 0., 0., 0.
    for before, now in zip(a, a[1:]):
        u += h * v + h * h * (before / 3 + now / 6)
        v += h * (before + now) / 2
        largest_v, largest_u = max(largest_v, abs(v)), max(largest_u, abs(u))
    return abs(v) / largest_v, abs(u) / largest_u


def ricker():
    times, a = record("ricker", "--frequency", 3, "--peak", 0.4, "--step", 0.002)
    middle = 1.8 / 3  # it is symmetric about its peak
    for t, value in zip(times, a):
        x = (math.pi * 3 * (t - middle)) ** 2
        check(abs(value - 0.4 * (1 - 2 * x) * math.exp(-x)) < 1e-9, f"ricker at {t}: {value}")
    check(max(ends(times, a)) < 1e-8, f"ricker: {ends(times, a)}")


def pulses():
    times, a = record("pulses", "--number", 1, "--duration", 0.5, "--peak", 0.5, "--step", 0.01)
    check(times[-1] == 0.5 and set(a) == {0.5}, "one pulse")
    times, a = record("pulses", "--number", 4, "--duration", 0.25)
    check(abs(times[-1] - 1) < 1e-12 and ends(times, a)[0] < 1e-8, f"four pulses: {times[-1]}, {ends(times, a)}")


def noise():
    """It ends at rest; its power is that of the filters (K. Kanai, H. Tajimi; R. W. Clough, J. Penzien, Dynamics of
    Structures, section 28-1) and of white noise that is linear between samples, (sin(pi f h)/(pi f h))^4, within what
    600 exponential numbers leave: 4 % in either band, so that a quarter is more than four deviations."""
    text = text_of("noise", "--seed", 3)
    check(text == text_of("noise", "--seed", 3), "the same seed gives another record")
    check(text.splitlines()[5:] != text_of("noise", "--seed", 4).splitlines()[5:], "another seed gives the same record")
    step, power = 0.02, {2.5: 0., 8.: 0.}
    offsets = [0.05 * i for i in range(-10, 10)]
    for seed in range(30):
        times, a = record("noise", "--seed", seed, "--step", step, "--strong", 20, "--low-cut", 0.4,
                          "--envelope", ("trapezoid", "jennings")[seed % 2])
        check(abs(max(map(abs, a)) - 0.3) < 1e-12, f"seed {seed}: the peak is {max(map(abs, a))}")
        check(max(ends(times, a)) < 1e-5, f"seed {seed}: it ends with {ends(times, a)}")
        for centre in power:
            for offset in offsets:
                turn, sum_of = cmath.exp(-2j * math.pi * (centre + offset) * step), 0.
                for value in reversed(a):
                    sum_of = sum_of * turn + value
                power[centre] += abs(sum_of) ** 2

    def expected(f):
        r, s, x = f / 2.5, f / 0.4, math.pi * f * step
        soil = (1 + 4 * 0.36 * r**2) / ((1 - r**2) ** 2 + 4 * 0.36 * r**2)
        return soil * s**4 / ((1 - s**2) ** 2 + 2 * s**2) * (math.sin(x) / x) ** 4

    ratio = power[2.5] / power[8.]
    wanted = sum(expected(2.5 + o) for o in offsets) / sum(expected(8 + o) for o in offsets)
    check(abs(ratio / wanted - 1) < 0.25, f"noise: power at 2.5 Hz to that at 8 Hz is {ratio:.3g}, not {wanted:.3g}")


def program(fuga):
    """A dam with an earthquake: no error, no warning, and the table of the motion."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        text = (ROOT / "parameters/dam.prm").read_text(encoding="utf-8").replace("../meshes", str(ROOT / "meshes"))
        text = text.replace("subsection Solver", """subsection Dynamics
  set Massless bodies = rock
end
subsection Earthquake
  set Record x = x.txt
  set Record y = y.txt
end
subsection Solver""").replace("    set Levels = 14  # every two metres\n  end\n", """  end
  subsection quake
    set Loads    = water: 1; uplift: 1
    set Duration = 12
  end
""")
        (folder / "dam.prm").write_text(text, encoding="utf-8")
        (folder / "x.txt").write_text(text_of("noise", "--rise", 1, "--strong", 6, "--decay", 3), encoding="utf-8")
        (folder / "y.txt").write_text(text_of("ricker", "--peak", 0.1, "--step", 0.01), encoding="utf-8")
        run = subprocess.run([fuga, "--check", str(folder / "dam.prm")], capture_output=True, text=True, timeout=300)
        lines = run.stdout.splitlines()
        check(run.returncode == 0 and lines[-1].endswith("no errors found."), f"{run.stderr} {lines[-3:]}")
        at = lines.index("Motion of the ground from the beginning of stage 'quake'")
        rows = [line.split() for line in lines[at + 2:at + 4]]
        check(rows[0][0] == "x" and rows[0][2] == "0.005" and rows[0][5] == "0.3", f"x: {rows[0]}")
        # The wavelet with 2 Hz: 2 * 1.8 / 2 s; the largest displacement is that of its Gaussian, a/(2 pi^2 f^2).
        wanted = 0.1 * 9.81 / (2 * math.pi**2 * 4)
        check(rows[1][1] == "181" and abs(float(rows[1][7]) / wanted - 1) < 1e-3, f"y: {rows[1]}, not {wanted}")


ricker()
pulses()
noise()
program(sys.argv[1])
print("\n".join(complaints) or "records are as they should be")
sys.exit(1 if complaints else 0)
