# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Problems with a known answer, for error against time over level, degree and grading of the mesh.

Hertz (V7) and the punch (V8) are made for a half-plane; the meshes end 40 half-widths away. That changes the contact,
to leading order, by a uniform curvature and nothing else, of which each closed form has one parameter (half-width a;
the coefficient of the even solution). The parameter is fitted once, to the finest run, and reported ("domain").
"""
import math

import fuga_runs
import meshes
from fuga_runs import history, resultants
from meshes import falling, growing, joined, uniform
from process import relative_error

LINEAR_ONE_STAGE = {"stage": {"Loads": "press: t"}}


def _weighted_error(rows, exact, end):
    """Relative L2 error of the pressure over 0 <= x <= end; weights: the areas of the contact elements."""
    used = [row for row in rows if row["x"] <= end + 1e-12]
    difference = sum(row["area"] * (row["pressure"] - exact(row["x"])) ** 2 for row in used)
    return math.sqrt(difference / sum(row["area"] * exact(row["x"]) ** 2 for row in used))


def _golden(function, low, high):
    """Where a function with one minimum has it."""
    ratio = (math.sqrt(5.) - 1.) / 2.
    for _ in range(60):
        left, right = high - ratio * (high - low), low + ratio * (high - low)
        low, high = (low, right) if function(left) < function(right) else (left, high)
    return (low + high) / 2.


class Problem:
    """name; levels; kinds of mesh; mesh(level, kind); sections(mesh file, degree); error(directory)."""
    kinds = ("uniform", "graded")
    degrees = (1, 2, 3)
    domain = None  # the fitted parameter, in words
    finest = None  # (level, kind, degree) of the run to which the reference is fitted

    def runs(self, quick):
        for kind in self.kinds:
            for degree in self.degrees:
                for level in self.levels[:2] if quick else self.levels:
                    if self.reasonable(level, degree):
                        yield level, kind, degree

    def reasonable(self, level, degree):
        return True

    def prepare(self, directory):
        """Takes what the error needs from the finest run."""


class HalfPlane(Problem):
    """Half of an elastic block 40 a x 40 a (E = 70000, nu = 0.3) on a rigid plane, without friction."""
    a, size = 1., 40.
    levels = (4, 8, 16)
    finest = (32, "graded", 3)

    def mesh(self, level, kind):
        h = self.a / level
        if kind == "uniform":
            n = round(self.size / h)
            axes = uniform(0., self.size, n), uniform(0., self.size, n)
        else:
            axes = self.graded_axes(h)
        return meshes.block(*axes, contact_end=self.contact_end)

    def graded_axes(self, h):
        return (joined(uniform(0., 1.5 * self.a, round(1.5 * self.a / h)), growing(1.5 * self.a, self.size, h, 1.3)),
                growing(0., self.size, h, 1.3))

    def sections(self, mesh_file, degree):
        sections = {
            "Mesh": {"File": mesh_file, "Polynomial degree": degree},
            "Bodies": {"block": {"Young modulus": 70000., "Poisson ratio": 0.3}},
            "Joints": {"base": {"Plus lip": "contact", "Minus lip": "rigid", "Normal law": "rigid",
                                "Initial gap": self.gap}},
            "Boundaries": {"left": {"Fixed": "x"}, "right": {"Fixed": "free"}, "corner": {"Fixed": "free"}},
            "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": self.load / self.size}},
            "Stages": LINEAR_ONE_STAGE}
        if self.contact_end < self.size:
            sections["Boundaries"]["bottom_free"] = {"Fixed": "free"}
        return sections

    def reasonable(self, level, degree):
        return level * degree <= 32


class Hertz(HalfPlane):
    """V7, line contact with initial gap x^2/2R, R = 50; the load gives a = 1 on a half-plane. Error: pressure, L2."""
    name, radius, modulus = "V7 Hertz", 50., 70000. / (1. - 0.09)
    gap, contact_end = "x^2/100", 4.
    load = math.pi * modulus / (8. * 50.)  # half of P = pi E* a^2/(4R)

    def pressure(self, a):
        p0 = 4. * self.load / (math.pi * a)  # of P = pi a p0/2; load is half of P
        return lambda x: p0 * math.sqrt(max(0., 1. - (x / a) ** 2))

    def prepare(self, directory):
        rows = history(directory)
        self.fitted = _golden(lambda a: _weighted_error(rows, self.pressure(a), 1.5), 0.9, 1.1)
        self.domain = "fitted half-width %.5f; half-plane 1; error of the finest run %.1e with it, %.1e with 1" % (
            self.fitted, _weighted_error(rows, self.pressure(self.fitted), 1.5),
            _weighted_error(rows, self.pressure(1.), 1.5))

    def error(self, directory):
        return _weighted_error(history(directory), self.pressure(self.fitted), 1.5)

    def graded_axes(self, h):
        return (joined(uniform(0., 1.25, round(1.25 / h)), growing(1.25, 4., h, 1.3), growing(4., self.size, 1., 1.3)),
                growing(0., self.size, h, 1.3))


class Punch(HalfPlane):
    """V8, a flat rigid punch 2a wide without friction. Error: pressure on |x| <= 0.8 a, L2; its edge is singular."""
    name, gap, contact_end, load = "V8 punch", "0", 1., 1000.

    def pressure(self, bend):
        return lambda x: (2. * self.load / math.pi + bend * (0.5 - x * x)) / math.sqrt(1. - x * x)

    def prepare(self, directory):
        rows = history(directory)
        self.fitted = _golden(lambda bend: _weighted_error(rows, self.pressure(bend), 0.8), -60., 60.)
        self.domain = "fitted coefficient of (1/2 - x^2)/sqrt(1 - x^2) %.2f of 636.62; error of the finest run %.1e" % (
            self.fitted, _weighted_error(rows, self.pressure(self.fitted), 0.8))

    def error(self, directory):
        return _weighted_error(history(directory), self.pressure(self.fitted), 0.8)

    def graded_axes(self, h):  # towards the edge of the punch, from both sides and from below
        smallest = h / 8.
        return (joined(falling(growing(1., 0., smallest, 1.3)), growing(1., self.size, smallest, 1.3)),
                growing(0., self.size, smallest, 1.3))


class StickZone(Punch):
    """V8 with f = 0.3: half-width c of the stick zone; c/a = 0.689, known to 0.002, decided at once by rates.

    The domain counts to first order here (its lateral strain under the punch): 160 a instead of 40 a, graded only.
    """
    name, kinds, size, levels, degrees = "V8 stick zone", ("graded",), 160., (32, 64, 128, 256, 512), (1, 2)
    finest, exact = None, 0.689

    def sections(self, mesh_file, degree):
        sections = super().sections(mesh_file, degree)
        sections["Joints"]["base"].update({"Shear law": "rigid", "Friction coefficient": 0.3})
        return sections

    def graded_axes(self, h):
        return (joined(uniform(0., 1., round(1. / h)), growing(1., self.size, h / 2., 1.3)),
                growing(0., self.size, h, 1.3))

    def error(self, directory):
        rows = history(directory)
        last = max(k for k, row in enumerate(rows) if row["state"] == "stick")
        return abs((rows[last]["x"] + rows[last + 1]["x"]) / 2. / self.exact - 1.)

    def reasonable(self, level, degree):
        return level * degree <= 512


class Raous(Problem):
    """V9. Error: u_x of the base at the five published abscissae, relative, against the extrapolated values."""
    name, levels = "V9 Raous", (16, 32, 64, 128, 256)
    places = (0., 1.25, 5., 7.5, 11.25)
    finest = (128, "uniform", 3)

    def mesh(self, level, kind):
        if kind == "uniform":
            return meshes.block(uniform(0., 40., level), uniform(0., 40., level))
        # Fine where the states change (x < 25) and near the base, coarse away from it.
        h = 40. / level
        return meshes.block(joined(uniform(0., 25., round(25. / h)), growing(25., 40., h, 1.25)),
                            growing(0., 40., h, 1.25))

    def sections(self, mesh_file, degree):
        return {
            "Mesh": {"File": mesh_file, "Polynomial degree": degree},
            "Bodies": {"block": {"Young modulus": 130000., "Poisson ratio": 0.2}},
            "Joints": {"base": {"Plus lip": "contact", "Minus lip": "rigid", "Normal law": "rigid",
                                "Shear law": "rigid", "Friction coefficient": 1.}},
            "Boundaries": {"right": {"Fixed": "x"}, "corner": {"Fixed": "all"}},
            "Loads": {"side": {"Type": "pressure", "Boundaries": "left", "Value": 150.},
                      "top": {"Type": "pressure", "Boundaries": "top", "Value": 50.}},
            "Stages": {"press": {"Loads": "side: t; top: t"}}}

    def displacements(self, directory, degree):
        """u_x at the places: the polynomial of the face in which a place lies."""
        rows, values = history(directory), []
        for place in self.places:
            first = next(k for k in range(0, len(rows) - 1, degree) if rows[k + degree]["x"] >= place - 1e-12)
            face, value = rows[first:first + degree + 1], 0.
            for row in face:
                weight = math.prod((place - other["x"]) / (row["x"] - other["x"]) for other in face if other is not row)
                value += weight * row["jump_t1"]
            values.append(value)
        return values

    def prepare(self, directory):
        self.reference = self.displacements(directory, self.finest[2])
        self.domain = "reference u_x = %s um (finest run; published 28.6, 27.2, 22.8, 19.8, 15.0)" % ", ".join(
            "%.4f" % (1e3 * value) for value in self.reference)

    def error(self, directory):
        degree = int((directory / "degree").read_text())
        found = self.displacements(directory, degree)
        return relative_error(found, self.reference)

    def reasonable(self, level, degree):
        return level * degree <= 256


class Patch(Problem):
    """V2 as a control: two blocks under uniform pressure; error of the forces, exact on every mesh."""
    name, levels = "V2 patch", (4, 16, 64)

    def mesh(self, level, kind):
        axis = uniform(0., 1., level) if kind == "uniform" else growing(0., 1., 0.3 / level, 1.1)
        return meshes.two_blocks(axis, falling([-y for y in axis]), axis)

    def sections(self, mesh_file, degree):
        return {
            "Mesh": {"File": mesh_file, "Polynomial degree": degree},
            "Bodies": {"lower": {"Young modulus": 1000., "Poisson ratio": 0.},
                       "upper": {"Young modulus": 3000., "Poisson ratio": 0.}},
            "Joints": {"base": {"Line": "joint", "Plus body": "upper", "Minus body": "lower",
                                "Normal compliance": 1e-3, "Shear compliance": 1e-3, "Friction coefficient": 0.5}},
            "Boundaries": {"bottom": {"Fixed": "all"}, "left": {"Fixed": "free"}, "right": {"Fixed": "free"}},
            "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": 2.}},
            "Stages": LINEAR_ONE_STAGE}

    def error(self, directory):
        return max(abs(row["pressure"] / 2. - 1.) for row in history(directory))

    def reasonable(self, level, degree):
        return level * degree <= 64


class PullOut(Problem):
    """V5: a thin bar (length 200, EA = 1000, k = 4, q = 2) pulled by +-P0 = 3 P_e; error of a cycle's dissipation W.

    The bar is one row of cells, 0.02 high (theory: no thickness), pressed on a rigid base by a uniform pressure.
    """
    name, levels, kinds = "V5 pull-out", (100, 200, 400, 800), ("uniform",)
    height, friction = 0.02, 0.5
    exact = 210.8185106778920  # 2 (P0 - Pe)^2 (P0 + 2 Pe)/(3 EA q), Pe = q sqrt(EA/k), P0 = 3 Pe

    def mesh(self, level, kind):
        return meshes.block(uniform(0., 200., level), [0., self.height])

    def sections(self, mesh_file, degree):
        stress = 3. * 2. * math.sqrt(1000. / 4.) / self.height
        return {
            "Mesh": {"File": mesh_file, "Polynomial degree": degree, "Assumption": "plane stress"},
            "Bodies": {"block": {"Young modulus": 1000. / self.height, "Poisson ratio": 0.}},
            "Joints": {"base": {"Plus lip": "contact", "Minus lip": "rigid", "Normal law": "rigid",
                                "Shear stiffness": 4., "Friction coefficient": self.friction}},
            "Boundaries": {"right": {"Fixed": "free"}, "corner": {"Fixed": "free"}},
            "Loads": {"press": {"Type": "pressure", "Boundaries": "top", "Value": 2. / self.friction},
                      "pull": {"Type": "pressure", "Boundaries": "left", "Value": stress}},
            "Stages": {"press": {"Loads": "press: t"}, "pull": {"Loads": "pull: -t"},
                       "back": {"Loads": "pull: 2*t-1"}, "forth": {"Loads": "pull: 1-2*t"}}}

    def error(self, directory):
        rows = resultants(directory)
        dissipated = {round(row["t"]): row["dissipation"] for row in rows}
        return abs((dissipated[4] - dissipated[2]) / self.exact - 1.)

    def reasonable(self, level, degree):
        return level * degree <= 800


PROBLEMS = (Patch, PullOut, Hertz, Punch, StickZone, Raous)


def run(problem, level, kind, degree):
    """One run; the error is left to the caller when the reference is not there yet (problem.prepare)."""
    key = "%s_%s_%d" % (problem.name.replace(" ", "_"), kind, level)
    mesh_file = fuga_runs.mesh_path(key, lambda: problem.mesh(level, kind))
    result, directory = fuga_runs.run("%s_Q%d" % (key, degree), problem.sections(mesh_file, degree))
    (directory / "degree").write_text(str(degree))
    return result, directory
