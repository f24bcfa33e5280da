#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Writes an acceleration of the ground for examples and tests, in two columns: time [s] and acceleration in the unit of the
peak (g, unless the file that reads it says otherwise). The same arguments give the same numbers everywhere.

ricker   a (1 - 2 x) exp(-x) with x = (pi f (t - t0))^2: one wave, whose velocity and displacement come back to zero.
pulses   Newmark's rectangular pulses of alternating sign. A single one leaves the ground in motion (Baseline = keep).
noise    White noise through the filter of Kanai and Tajimi (a soil with one frequency and damping), under an envelope, then
         through a high-pass filter of the second order (Clough and Penzien), so that the ground comes to rest where it began.

Envelopes of noise: trapezoid (linear up, constant, linear down), or that of Jennings, Housner and Tsai (1968):
(t/rise)^2, then 1, then exp(-(t - rise - strong)/decay), cut off after six decay times.

examples:
  synthetic_record.py ricker --frequency 2 --peak 0.3 --output wave.txt
  synthetic_record.py noise --seed 7 --peak 0.25 --rise 2 --strong 8 --decay 3 --output quake.txt
"""
import argparse
import math
import random
import sys


def ricker(options):
    """The wavelet between its points of rest, where it is 1e-12 of the peak and less."""
    centre = 1.8 / options.frequency
    n = math.ceil(2 * centre / options.step)
    x = [(math.pi * options.frequency * (i * options.step - centre)) ** 2 for i in range(n + 1)]
    return [options.peak * (1 - 2 * value) * math.exp(-value) for value in x]


def pulses(options):
    """One pulse ends with its last sample; from one to the next the acceleration passes zero within two steps."""
    n = max(1, round(options.duration / options.step))
    samples = [options.peak]
    for pulse in range(options.number):
        value = options.peak * (-1) ** pulse
        samples += [value] * (n - 1)
        last = pulse + 1 == options.number
        samples.append(value if last else 0.)
    return samples


class Oscillator:
    """x'' + 2 damping omega x' + omega^2 x = -a, for a that is linear within a step: exact (Nigam and Jennings 1969)."""

    def __init__(self, frequency, damping, step):
        self.omega, self.damping, self.step = 2 * math.pi * frequency, damping, step
        self.x = self.v = self.a = 0.

    def advance(self, a):
        w, xi, h, s = self.omega, self.damping, self.step, (a - self.a) / self.step
        wd = w * math.sqrt(1 - xi * xi)
        A = self.x + self.a / w**2 - 2 * xi * s / w**3
        B = (self.v + xi * w * A + s / w**2) / wd
        decay = math.exp(-xi * w * h)
        c, d = decay * math.cos(wd * h), decay * math.sin(wd * h)
        self.x = A * c + B * d - a / w**2 + 2 * xi * s / w**3
        self.v = (wd * B - xi * w * A) * c - (wd * A + xi * w * B) * d - s / w**2
        self.a = a

    def absolute_acceleration(self):
        return -2 * self.damping * self.omega * self.v - self.omega**2 * self.x


def normal_numbers(seed):
    """Box and Muller, from the generator that Python promises not to change."""
    uniform = random.Random(seed)
    while True:
        radius, angle = math.sqrt(-2 * math.log(1 - uniform.random())), 2 * math.pi * uniform.random()
        yield radius * math.cos(angle)
        yield radius * math.sin(angle)


def envelope(options, t):
    fall = t - options.rise - options.strong
    if t < options.rise:
        return t / options.rise if options.envelope == "trapezoid" else (t / options.rise) ** 2
    if fall <= 0:
        return 1.
    return max(0., 1 - fall / options.decay) if options.envelope == "trapezoid" else math.exp(-fall / options.decay)


def noise(options):
    soil = Oscillator(options.ground_frequency, options.ground_damping, options.step)
    ground = Oscillator(options.low_cut, math.sqrt(0.5), options.step)
    numbers = normal_numbers(options.seed)
    shaking = options.rise + options.strong + options.decay * (1 if options.envelope == "trapezoid" else 6)
    rest = 4 / options.low_cut  # after it the ground is at rest but for exp(-17)
    samples = [0.]
    for i in range(1, math.ceil((shaking + rest) / options.step) + 1):
        t = i * options.step
        soil.advance(next(numbers))
        # The displacement of the ground is that of the second oscillator.
        ground.advance(soil.absolute_acceleration() * envelope(options, t) if t < shaking else 0.)
        samples.append(ground.absolute_acceleration() - ground.a)
    factor = options.peak / max(map(abs, samples))
    return [factor * value for value in samples]


def positive(text):
    value = float(text)
    if not (value > 0 and math.isfinite(value)):
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return value


def share(text):
    value = positive(text)
    if value >= 1:
        raise argparse.ArgumentTypeError(f"{text} is not between 0 and 1")
    return value


def whole(text):
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return value


def parser():
    result = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    kinds = result.add_subparsers(dest="kind", required=True, metavar="ricker | pulses | noise")

    def kind(name, function, *arguments):
        one = kinds.add_parser(name, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
        one.set_defaults(function=function)
        for option, form, default, text in arguments + (("--peak", positive, 0.3, "largest acceleration"),
                                                        ("--step", positive, 0.005, "of the samples [s]")):
            one.add_argument(option, type=form, default=default, help=text)
        one.add_argument("--output", help="file; without it the standard output", default=None)
        return one

    kind("ricker", ricker, ("--frequency", positive, 2., "f [Hz]"))
    kind("pulses", pulses, ("--duration", positive, 0.5, "of a pulse [s]"), ("--number", whole, 2, "of pulses"))
    one = kind("noise", noise, ("--seed", int, 1, "another number, another record"),
               ("--ground-frequency", positive, 2.5, "of the soil [Hz]"), ("--ground-damping", share, 0.6, "of the soil"),
               ("--low-cut", positive, 0.2, "frequency below which there is little [Hz]"),
               ("--rise", positive, 2., "time of the envelope [s]"), ("--strong", positive, 8., "time [s]"),
               ("--decay", positive, 4., "time [s]"))
    one.add_argument("--envelope", choices=("trapezoid", "jennings"), default="trapezoid", help=" ")
    return result


def main(arguments):
    options = parser().parse_args(arguments)
    samples = options.function(options)
    said = " ".join(f"--{name.replace('_', '-')} {value}" for name, value in sorted(vars(options).items())
                    if name not in ("kind", "function", "output"))
    lines = [f"# synthetic_record.py {options.kind} {said}", "# time [s], acceleration [unit of the peak]"]
    lines += [f"{i * options.step:.9g} {value:.9e}" for i, value in enumerate(samples)]
    text = "\n".join(lines) + "\n"
    if options.output is None:
        sys.stdout.write(text)
    else:
        with open(options.output, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main(sys.argv[1:])
