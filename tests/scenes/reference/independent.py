#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Known answers for problem S0, the block of Raous, Chabrand and Lebon, a bar pulled out and the flat punch, from a code that
shares nothing with the program: numpy only, regular grids, small load steps.

usage: independent.py [--check]

Writes independent.json beside this file; --check computes it again and compares, and solves scene G as well, for which solutions of a
third code are stored.

Bodies are grids of bilinear rectangles, eliminated row of nodes by row of nodes down to the joint (S0, Raous, scene G), or a half-plane
(punch). A joint is a pair of springs per node. A step finds its states by switching all elements that violate their conditions,
or one at a time when that does not end; a step ends where every condition holds. Events are bisected. README.md says what is
kept with how many digits.
"""
import json
import math
import pathlib
import sys

import numpy

FILE = pathlib.Path(__file__).with_suffix(".json")
# Of scene G: loads of events are bisected to 1e-12 and joints are solved with condition numbers up to 1e4; the rigid joint is nearly
# rigid here, with a share of 1e-7 in the flexibility.
BOUND, BOUND_RIGID = 1e-8, 1e-5
OPEN, STICK, FORWARD, BACKWARD = 0, 1, 2, 3  # FORWARD: slip > 0


def stiffness(a, b, young, poisson):
    """Bilinear rectangle a x b in plane strain, 2 x 2 Gauss points; nodes (0,0), (a,0), (0,b), (a,b)."""
    c = young / (1 + poisson) / (1 - 2 * poisson)
    d = c * numpy.array([[1 - poisson, poisson, 0], [poisson, 1 - poisson, 0], [0, 0, 0.5 - poisson]])
    k = numpy.zeros((8, 8))
    for x in (0.5 - 0.5 / math.sqrt(3), 0.5 + 0.5 / math.sqrt(3)):
        for y in (0.5 - 0.5 / math.sqrt(3), 0.5 + 0.5 / math.sqrt(3)):
            dx, dy = numpy.array([y - 1, 1 - y, -y, y]) / a, numpy.array([x - 1, -x, 1 - x, x]) / b
            m = numpy.zeros((3, 8))
            m[0, 0::2], m[1, 1::2], m[2, 0::2], m[2, 1::2] = dx, dy, dy, dx
            k += 0.25 * a * b * m.T @ d @ m
    return k


def condense(widths, heights, material, loads, fixed, upwards=False):
    """(S, F) on the last row of nodes of a grid of rectangles with the given widths and, row by row, heights. Row 0 is the far one,
    the last row the joint; `loads` has one array per row, a column per load case, `fixed(row)` the indices of held unknowns.
    Upwards: row 0 is the lowest."""
    n = len(widths)
    size = 2 * (n + 1)
    near, far = (list(range(4, 8)), list(range(4))) if upwards else (list(range(4)), list(range(4, 8)))
    s, f = numpy.zeros((size, size)), loads[0].copy()
    for row, height in enumerate(heights):
        blocks = [numpy.zeros((size, size)) for _ in range(3)]
        for i, width in enumerate(widths):
            at = numpy.arange(2 * i, 2 * i + 4)
            k = stiffness(width, height, *material)
            for block, a, b in zip(blocks, (far, far, near), (far, near, near)):
                block[numpy.ix_(at, at)] += k[numpy.ix_(a, b)]
        free = numpy.setdiff1d(numpy.arange(size), fixed(row))
        couple = blocks[1][free]
        solved = numpy.linalg.solve((s + blocks[0])[numpy.ix_(free, free)], numpy.column_stack([couple, f[free]]))
        s = blocks[2] - couple.T @ solved[:, :size]
        f = loads[row + 1] - couple.T @ solved[:, size:]
    return s, f


def nodal(sizes):
    """Lengths that belong to the nodes of a line."""
    sizes = numpy.asarray(sizes, dtype=float)
    return 0.5 * (numpy.append(sizes, 0) + numpy.append(0, sizes))


class Layer:
    """Force per area of a closure w and its slope; law (9) of the paper: w = ρ0 p (1 - (w/ζ)^(1/3))."""

    def __init__(self, compliance, thickness=None):
        self.compliance, self.thickness = compliance, thickness

    def pressure(self, w):
        if self.thickness is None:
            return w / self.compliance, numpy.full_like(w, 1 / self.compliance)
        q = numpy.cbrt(numpy.clip(w / self.thickness, 0, 0.97))
        return w / self.compliance / (1 - q), (1 - 2 * q / 3) / (1 - q)**2 / self.compliance


class Joint:
    """S u = F a(t) with springs at `pairs` (normal, tangential unknowns; a jump is B u). State between steps: slip."""

    def __init__(self, s, b_normal, b_tangent, area, normal, shear_compliance, friction):
        self.s, self.bn, self.bt, self.area, self.normal, self.f = s, b_normal, b_tangent, area, normal, friction
        self.kt = area / shear_compliance
        self.slip = numpy.zeros(len(area))
        self.states = numpy.full(len(area), STICK)

    def solve(self, load, states, u):
        """Newton for given states; (u, normal force >= 0, shear on the plus side's jump)."""
        for _ in range(100):
            w = numpy.where(states == OPEN, 0, -(self.bn @ u))
            p, slope = self.normal.pressure(w)
            n, dn = numpy.where(states == OPEN, 0, self.area * p), numpy.where(states == OPEN, 0, self.area * slope)
            sign = numpy.select([states == FORWARD, states == BACKWARD], [1., -1.], 0.)
            stuck = numpy.where(states == STICK, self.kt, 0.)
            t = stuck * (self.bt @ u - self.slip) + sign * self.f * n
            residual = load - self.s @ u + self.bn.T @ n - self.bt.T @ t
            matrix = self.s + self.bn.T @ (dn[:, None] * self.bn) + self.bt.T @ (stuck[:, None] * self.bt)
            matrix -= self.bt.T @ ((sign * self.f * dn)[:, None] * self.bn)
            step = numpy.linalg.solve(matrix, residual)
            u = u + step
            if self.normal.thickness is None or numpy.abs(step).max() < 1e-13 * numpy.abs(u).max():
                break
        w = numpy.where(states == OPEN, 0, -(self.bn @ u))
        n = numpy.where(states == OPEN, 0, self.area * self.normal.pressure(w)[0])
        return u, n, stuck * (self.bt @ u - self.slip) + sign * self.f * n

    def wanted(self, states, u, n, t, size):
        """The states that the conditions ask for."""
        gap, jump = self.bn @ u, self.bt @ u
        elastic = self.bt @ u - numpy.where(self.kt > 0, t / self.kt, 0) - self.slip  # increment of slip
        new = states.copy()
        forward, backward = t > self.f * n, t < -self.f * n
        new[(states == STICK) & forward & (n > 0)] = FORWARD
        new[(states == STICK) & backward & (n > 0)] = BACKWARD
        new[(states == FORWARD) & (elastic < -size)] = STICK
        new[(states == BACKWARD) & (elastic > size)] = STICK
        new[(states != OPEN) & (gap > size)] = OPEN
        closing = (states == OPEN) & (gap < -size)
        moved = jump - self.slip
        new[closing] = numpy.where(numpy.abs(moved[closing]) > self.f * -gap[closing],
                                   numpy.where(moved[closing] > 0, FORWARD, BACKWARD), STICK)
        return new

    def step(self, load, u):
        """One implicit step to a load; (u, n, t, states), nothing is kept."""
        states, seen = self.states.copy(), set()
        for _ in range(2000):
            u, n, t = self.solve(load, states, u)
            new = self.wanted(states, u, n, t, 1e-13 * numpy.abs(u).max())
            if (new == states).all():
                return u, n, t, states
            if states.tobytes() in seen:  # all at once went round in circles: the first one only
                first = numpy.flatnonzero(new != states)[len(seen) % numpy.count_nonzero(new != states)]
                states[first] = new[first]
                seen.add(states.tobytes() + bytes([len(seen) % 256]))
            else:
                seen.add(states.tobytes())
                states = new
        sys.exit("a step did not end")

    def keep(self, u, t, states):
        self.slip = numpy.where(states == OPEN, self.bt @ u, self.bt @ u - t / self.kt)
        self.states = states


def block_on_foundation(widths, heights, side, depths, materials, weight, pressure, layers, friction):
    """A joint between a block and a foundation whose widths go on by `side` on both sides; (joint, loads: weight, pressure).
    Sizes are listed away from the joint; `pressure(y)` acts on the left face, linear between nodes. The bottom is fixed, the sides are
    on rollers."""
    n, rows = len(widths), len(heights)
    y = numpy.append(0, numpy.cumsum(heights))[::-1]
    upper = [numpy.zeros((2 * (n + 1), 2)) for _ in y]
    for row, (load, share) in enumerate(zip(upper, nodal(heights[::-1]))):
        load[1::2, 0] = -weight * share * nodal(widths)
        for other in (row - 1, row + 1):
            if 0 <= other <= rows:
                load[0, 1] += abs(y[row] - y[other]) * (pressure(y[row]) / 3 + pressure(y[other]) / 6)
    s_top, f_top = condense(widths, heights[::-1], materials[0], upper, lambda row: [])
    wide = [*side[::-1], *widths, *side]
    size = 2 * (len(wide) + 1)
    lower = [numpy.zeros((size, 1)) for _ in range(len(depths) + 1)]
    rollers = [0, size - 2]
    s_all, _ = condense(wide, depths[::-1], materials[1], lower, lambda row: range(size) if row == 0 else rollers, upwards=True)
    contact = numpy.arange(2 * len(side), 2 * len(side) + 2 * (n + 1))
    rest = numpy.setdiff1d(numpy.arange(size), [*rollers, *contact])
    s_low = s_all[numpy.ix_(contact, contact)] - s_all[numpy.ix_(contact, rest)] @ numpy.linalg.solve(
        s_all[numpy.ix_(rest, rest)], s_all[numpy.ix_(rest, contact)])
    # Unknowns: the lower side, then the jumps (upper minus lower).
    s = numpy.block([[s_low + s_top, s_top], [s_top, s_top]])
    b = numpy.hstack([numpy.zeros_like(s_top), numpy.eye(2 * (n + 1))])
    return Joint(s, b[1::2], b[0::2], nodal(widths), *layers, friction), numpy.vstack([f_top, f_top])


def follow(joint, base, stage, u, steps=200):
    """From the load `base` to base + stage; ((u, n, t, states), [(share of the stage, element, new state)]), without what changes at
    the very beginning."""
    events, done = [], 0.
    for end in numpy.arange(1, steps + 1) / steps:
        while True:
            result = joint.step(base + end * stage, u)
            if done == 0. or (result[3] == joint.states).all():
                break
            low, high = done, end
            while high - low > 1e-12:
                middle = 0.5 * (low + high)
                low, high = (low, middle) if (joint.step(base + middle * stage, u)[3] != joint.states).any() else (middle, high)
            result = joint.step(base + high * stage, u)
            events += [(high, int(k), int(result[3][k])) for k in numpy.flatnonzero(result[3] != joint.states)]
            u, done = result[0], high
            joint.keep(u, result[2], result[3])
        u, done = result[0], end
        joint.keep(u, result[2], result[3])
    return result, events


def s0(compliance, thickness):
    """The stand-in for the paper's test; README.md has its data."""
    joint, f = block_on_foundation([0.5] * 8, [0.5] * 24, [0.5] * 16, [0.5] * 12, ((3060., 0.2), (30600., 0.2)), 0.024,
                                   lambda y: 0.0144, (Layer(compliance, thickness), compliance), 0.2)
    result, _ = follow(joint, 0 * f[:, 0], f[:, 0], numpy.zeros(len(f)))
    before = joint.bt @ result[0]
    (u, n, _, states), events = follow(joint, f[:, 0], f[:, 1], result[0])
    jump, normal = joint.bt @ u, joint.bn @ u
    return {"open": int((states == OPEN).sum()), "stick": int((states == STICK).sum()), "slip": int((states > STICK).sum()),
            "largest pressure [MPa]": round(float((n / joint.area).max()), 4),
            "largest closure [mm]": round(1e3 * float((-normal).max()), 4),
            "mean jump added [mm]": round(1e3 * float(numpy.abs(jump - before).mean()), 4),
            "largest jump [mm]": round(1e3 * float(numpy.abs(jump).max()), 4),
            "largest gap [mm]": round(1e3 * float(normal.max()), 4)}, [round(event[0], 6) for event in events]


def graded(h, length):
    """The sizes of meshes/scene_g.py."""
    sizes = []
    while sum(sizes) < length * (1 - 1e-12):
        sizes.append(min(1.2 * sizes[-1], 2.5) if sizes else h)
    return [size * length / sum(sizes) for size in sizes]


def scene_g(path):
    """Largest deviation of a stored reference solution (forces over the weight, jumps over their largest, loads of events) from what
    comes out here; the two codes have nothing in common."""
    known = json.loads(path.read_text(encoding="utf-8"))
    h, law = 20. / (known["n"] - 1), known["law"] or {"Cn": 1e13, "Ct": 1e13}
    layers = (Layer(1 / law["Cn"]) if "Cn" in law else Layer(law["rho0"], law["zeta0"]), 1 / law["Ct"])
    joint, f = block_on_foundation([h] * (known["n"] - 1), graded(h, 40.), graded(h, 40.), graded(h, 50.), ((3.06e6, 0.2), (1e7, 0.25)),
                                   24., lambda y: 9.81 * (40. - y) * known["L"], layers, known["f"])
    u, base, worst = numpy.zeros(len(f)), 0 * f[:, 0], 0.
    for number, stage in enumerate(known["stages"]):
        (u, n, t, _), events = follow(joint, base, f[:, number], u)
        base = base + f[:, number]
        size = max(numpy.abs(stage["g_n"]).max(), numpy.abs(stage["g_t"]).max())
        pairs = [(n, stage["N"], 19200.), (-t, stage["T"], 19200.)]
        if known["law"]:  # a rigid joint has no closure, a nearly rigid one has
            pairs += [(joint.bn @ u, stage["g_n"], size), (joint.bt @ u, stage["g_t"], size)]
        worst = max([worst, *(numpy.abs(ours - numpy.array(theirs)).max() / scale for ours, theirs, scale in pairs)])
        theirs = [event[1] / known["L"] for event in known["events"] if event[0] == number for _ in event[2]]
        if len(theirs) != len(events):
            return math.inf
        worst = max([worst, *(abs(event[0] - load) for event, load in zip(events, theirs))])
    return worst


def raous_joint(n, stiffness, held):
    """Half of the block, n x n squares, on a plane; loads: side, top."""
    h = 40. / n
    loads = [numpy.zeros((2 * (n + 1), 2)) for _ in range(n + 1)]
    for row, load in enumerate(loads):
        load[0, 0] = 150. * h * (0.5 if row in (0, n) else 1.)
    loads[0][1::2, 1] = -50. * h
    loads[0][[1, -1], 1] *= 0.5
    s, f = condense([h] * n, [h] * n, (130000., 0.2), loads, lambda row: [2 * n])
    kept = numpy.setdiff1d(numpy.arange(2 * (n + 1)), [2 * n, 2 * n + 1] if held else [2 * n])
    n_contacts = n if held else n + 1
    b_normal, b_tangent = numpy.zeros((n_contacts, len(kept))), numpy.zeros((n_contacts, len(kept)))
    for i in range(n_contacts):
        b_normal[i, numpy.flatnonzero(kept == 2 * i + 1)] = 1
        b_tangent[i, numpy.flatnonzero(kept == 2 * i)] = 1
    area = numpy.full(n_contacts, h)
    area[[0] if held else [0, -1]] = h / 2
    return Joint(s[numpy.ix_(kept, kept)], b_normal, b_tangent, area, Layer(1 / stiffness), 1 / stiffness, 1.), f[kept]


def raous(n):
    """Nearly rigid; the states are found with softer layers first. The response to a load from zero is proportional."""
    states = None
    for power in range(6):
        joint, f = raous_joint(n, 3250. * 10.**power, True)
        if states is not None:
            joint.states = states
        u, _, t, states = joint.step(f.sum(axis=1), numpy.zeros(len(f)))
    places = [round(x / 40. * n) for x in (0., 1.25, 5., 7.5, 11.25)]
    return {"n": n, "u [um]": [round(1e3 * float((joint.bt @ u)[k]), 3) for k in places], "open": int((states == OPEN).sum()),
            "slip": int((states > STICK).sum()), "stick": int((states == STICK).sum()), "T [N/mm]": round(float(t.sum()), 2)}


def raous_losses():
    """Friction's work with k = E/L, the corner not held: both loads together; top before side."""
    losses = []
    for ways in (((1, 1),), ((0, 1), (1, 0))):
        joint, f = raous_joint(32, 3250., False)
        u, t, loss, base, steps = numpy.zeros(len(f)), numpy.zeros(33), 0., numpy.zeros(len(f)), 1000
        for way in ways:
            for i in range(1, steps + 1):
                result = joint.step(base + i / steps * (f @ way), u)
                slip = joint.slip.copy()
                u, new = result[0], result[2]
                joint.keep(u, new, result[3])
                loss += float((0.5 * (t + new) * (joint.slip - slip))[result[3] != OPEN].sum())
                t = new
            base = base + f @ way
        losses.append(round(loss, 2))
    return losses


def pull_out(n, length=200., ea=1000., k=4., q=2.):
    """Relative error of the loss per cycle ±3 P_e of a bar on a frictional base, cut into n elements, against the closed form
    2(P0-P_e)²(P0+2P_e)/(3 EA q). A node loses its friction times its slip; loads are monotone between reversals, so one
    implicit step each will do."""
    h = length / n
    first = q * math.sqrt(ea / k)
    p0 = 3 * first
    s = ea / h * (2 * numpy.eye(n + 1) - numpy.eye(n + 1, k=1) - numpy.eye(n + 1, k=-1))
    s[0, 0] = s[-1, -1] = ea / h
    share = numpy.full(n + 1, h)
    share[[0, -1]] = h / 2
    slip, loss = numpy.zeros(n + 1), []
    for load in (p0, -p0, p0, -p0, p0):
        state = numpy.zeros(n + 1)  # 0 stick, else the direction of slip; a reversal lets all stick
        for _ in range(10 * n):
            stuck = state == 0
            u = numpy.linalg.solve(s + numpy.diag(numpy.where(stuck, k * share, 0)),
                                   numpy.eye(n + 1)[0] * load + numpy.where(stuck, k * share * slip, -state * q * share))
            force = k * share * (u - slip)
            over = stuck & (numpy.abs(force) > q * share * (1 + 1e-12))
            if not over.any():
                break
            state = numpy.where(over, numpy.sign(force), state)
        new = numpy.where(stuck, slip, u - state * q / k)
        loss.append(float((q * share * numpy.abs(new - slip)).sum()))
        slip = new
    return (loss[-1] + loss[-2]) / (2 * (p0 - first)**2 * (p0 + 2 * first) / (3 * ea * q)) - 1


def punch(friction, poisson=0.3, n=800):
    """c/a of a flat punch on a half-plane. Constant pressure p and shear q on n elements of (0, 1), finer at the edge, mirrored.
    With E/(2(1-ν²)) π = 1 (Johnson, Contact Mechanics, section 2.6) the surface moves by u_z = -∫p ln|x-s| + γ/2 ∫q sign(x-s) and
    u_x = -∫q ln|x-s| - γ/2 ∫p sign(x-s), γ = π (1-2ν)/(2(1-ν)). Under the punch u_z is constant; where it sticks u_x = 0;
    elsewhere it moves inwards against q = f p. The zones do not depend on the load."""
    ends = numpy.sin(numpy.linspace(0, math.pi / 2, n + 1))
    x, width = 0.5 * (ends[1:] + ends[:-1]), ends[1:] - ends[:-1]

    def minus_log(sign):
        a = x[:, None] - sign * ends[None, :]
        primitive = sign * a * (numpy.log(numpy.abs(a) + 1e-300) - 1)
        return primitive[:, 1:] - primitive[:, :-1]
    before = numpy.clip(x[:, None] - ends[None, :], 0, None)
    left = before[:, :-1] - before[:, 1:]  # of every element, the length that lies to the left of x
    gamma = math.pi * (1 - 2 * poisson) / (2 * (1 - poisson))
    uz_p, ux_q = minus_log(1) + minus_log(-1), minus_log(1) - minus_log(-1)  # p is even, q is odd
    uz_q, ux_p = gamma * (left - width), -gamma * left
    stuck = x < 0.5
    for _ in range(100):
        a, right = numpy.zeros((2 * n, 2 * n)), numpy.zeros(2 * n)
        a[:n - 1, :n], a[:n - 1, n:] = uz_p[1:] - uz_p[:-1], uz_q[1:] - uz_q[:-1]
        a[n - 1, :n], right[n - 1] = width, 1.
        a[n:, :n] = numpy.where(stuck[:, None], ux_p, -friction * numpy.eye(n))
        a[n:, n:] = numpy.where(stuck[:, None], ux_q, numpy.eye(n))
        p, q = numpy.split(numpy.linalg.solve(a, right), 2)
        new = numpy.where(stuck, q <= friction * p, ux_p @ p + ux_q @ q > 0)
        if (new == stuck).all():
            return ends[numpy.flatnonzero(stuck)[-1] + 1]
        stuck = new
    sys.exit("the zones of the punch were not found")


def main():
    table = [{"law": law, "compliance": rho, **s0(rho, thickness)[0]}
             for law, thickness, values in (("linear", None, (1e-11, 1.25e-7, 1.25e-4, 1.25e-3)),
                                            ("cubic root", 0.002, (1.25e-7, 1.25e-4, 1.25e-3))) for rho in values]
    answers = {"S0": table, "S0 events of stage 2, law (9), 1.25e-4": s0(1.25e-4, 0.002)[1],
               "Raous": [raous(n) for n in (32, 64, 128)], "Raous losses [N mm/mm]": raous_losses(),
               "pull-out": {str(n): float(f"{pull_out(n):.1e}") for n in (100, 200, 400, 800)},
               "punch": {str(f): round(float(punch(f)), 3) for f in (0.2, 0.3, 0.5)}}
    text = json.dumps(answers, indent=1) + "\n"
    if "--check" in sys.argv:
        same = text == FILE.read_text(encoding="utf-8")
        print("the same answers" if same else f"{FILE.name} differs from\n{text}")
        for path in sorted(FILE.parent.glob("*_n9.json")) + sorted(FILE.parent.glob("*_n33.json")):
            deviation, bound = scene_g(path), BOUND_RIGID if path.name.startswith("rigid") else BOUND
            print(f"{path.name}: {deviation:.1e} (bound {bound:.0e})")
            same = same and deviation <= bound
        sys.exit(0 if same else 1)
    FILE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
