# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Scenes in the plane: one description from which fuga's parameter file and the peers' decks are made."""
import copy
import functools
import json

import meshes
from process import relative_error

REFERENCES = meshes.REPOSITORY / "tests" / "scenes" / "reference"


class Scene:
    """A structure on a foundation with one joint 'base'; stages are dictionaries {load: factor at the end}."""

    dim = 2
    boundaries = {"foundation_bottom": "all", "foundation_sides": "x", "downstream": "free", "crest": "free",
                  "foundation_top": "free"}
    beside_base = ("foundation_top",)  # boundaries that carry on the lower lip
    limit = None  # factor of the push that the scene bears, if its stages go beyond

    def __init__(self, name, n, make_mesh, bodies, joint, pressure, stages):
        self.name, self.n, self.make_mesh = name, n, make_mesh
        self.bodies = bodies      # {name: (E, nu, weight density)}; first the structure, then the foundation
        self.joint = joint        # {"kn", "kt", "f"}; kn = None: rigid; "thickness": law (9)
        self.pressure = pressure  # (value at the base, gradient upwards), on the boundary 'upstream'
        self.stages = stages
        self.bonded = False
        self.solver = {}          # entries of fuga's section Solver

    def altered(self, **changes):
        other = copy.copy(self)
        for key, value in changes.items():
            setattr(other, key, value)
        return other

    @property
    def mesh(self):
        mesh = self.make_mesh(self.n)
        return mesh.without("base") if self.bonded else mesh

    @property
    def structure(self):
        return next(iter(self.bodies))

    @property
    def foundation(self):
        return list(self.bodies)[1]

    @property
    def supports(self):
        """[(boundary, components held)]"""
        return [(name, "xyz"[:self.dim] if held == "all" else held)
                for name, held in self.boundaries.items() if held != "free"]

    @property
    def dofs(self):
        return self.dim * (len(self.mesh.nodes) + (0 if self.bonded else self.n))

    def joint_section(self):
        joint = self.joint
        section = {"Line": "base", "Plus body": self.structure, "Minus body": self.foundation,
                   "Friction coefficient": joint["f"]}
        if joint["kn"] is None:
            return {**section, "Normal law": "rigid", "Shear law": "rigid"}
        if "thickness" in joint:
            section.update({"Normal law": "cubic root", "Thickness": joint["thickness"]})
        return {**section, "Normal stiffness": joint["kn"], "Shear stiffness": joint["kt"]}

    def sections(self, mesh_file):
        """The parameter file as nested dictionaries."""
        at_zero, gradient = self.pressure
        last, stages = {}, {}
        for number, stage in enumerate(self.stages, 1):
            factors = "; ".join("%s: %r+(%r)*t" % (load, last.get(load, 0.), end - last.get(load, 0.))
                                for load, end in stage.items())
            stages["stage_%d" % number] = {"Loads": factors}
            last.update(stage)
        sections = {
            "Dimension": self.dim, "Mesh": {"File": mesh_file},
            "Bodies": {name: {"Young modulus": E, "Poisson ratio": nu, "Weight density": weight}
                       for name, (E, nu, weight) in self.bodies.items()},
            "Joints": {"base": self.joint_section()},
            "Boundaries": {name: {"Fixed": held} for name, held in self.boundaries.items()},
            "Loads": {"weight": {"Type": "weight", "Bodies": self.structure},
                      "push": {"Type": "pressure", "Boundaries": "upstream",
                               "Value": "%r+(%r)*%s" % (at_zero, gradient, "xyz"[self.dim - 1])}},
            "Stages": stages, "Solver": self.solver}
        if self.bonded:
            del sections["Joints"]
            sections["Stages"] = {"stage": {"Loads": "; ".join("%s: %r*t" % pair for pair in last.items())}}
        return sections

    def nodal_loads(self, mesh):
        """{load: {node: (Fx, Fy)}} of bilinear elements, exact; for the decks of the peers."""
        weight, push = {}, {}

        def add(target, v, fx, fy):
            old = target.get(v, (0., 0.))
            target[v] = (old[0] + fx, old[1] + fy)

        for cell in mesh.group(self.structure):
            (x0, y0), (x1, y1) = mesh.nodes[cell[0] - 1], mesh.nodes[cell[2] - 1]
            quarter = (x1 - x0) * (y1 - y0) * self.bodies[self.structure][2] / 4.
            for v in cell:
                add(weight, v, 0., -quarter)
        for v, w in mesh.group("upstream"):
            yv, yw = mesh.nodes[v - 1][1], mesh.nodes[w - 1][1]
            pv, pw = (self.pressure[0] + self.pressure[1] * y for y in (yv, yw))
            length = abs(yw - yv)
            add(push, v, length * (2 * pv + pw) / 6., 0.)
            add(push, w, length * (2 * pw + pv) / 6., 0.)
        return {"weight": weight, "push": push}

    def reference(self):
        """[jumps: normal, tangential] at the ends of the stages, from the repository's independent solutions."""
        if self.name != "scene_g" or len(self.stages) != 2 or "thickness" in self.joint:
            return None
        law = {1e6: "lin", None: "rigid"}.get(self.joint["kn"])
        path = REFERENCES / ("%s_f%.1f_n%d.json" % (law, self.joint["f"], self.n))
        if not path.exists():
            return None
        return [(stage["g_n"], stage["g_t"]) for stage in json.loads(path.read_text())["stages"]]

    def error(self, jumps, reference):
        """Of all jumps together at the end; with reversals, the largest of those at the ends of all stages."""
        errors = [relative_error(sum(j, []), sum(r, [])) for j, r in zip(jumps, reference, strict=True)]
        return (max(errors) if len(self.stages) > 2 else errors[-1]), errors


@functools.lru_cache(maxsize=4)
def _scene_g_mesh(n):
    return meshes.scene_g(n)


@functools.lru_cache(maxsize=2)
def _s0_mesh(n):
    return meshes.s0(n)


def scene_g(n, f, kn=1e6, reversal=False):
    """Units kN, m, kPa. kn None: a rigid joint."""
    level = 0.45 if f == 0.2 else 1.
    pushes = [level, -level, level] if reversal else [level]
    return Scene("scene_g_reversal" if reversal else "scene_g", n, _scene_g_mesh,
                 {"block": (3.06e6, 0.2, 24.), "foundation": (1e7, 0.25, 0.)},
                 {"kn": kn, "kt": None if kn is None else kn / 2., "f": f}, (9.81 * 40., -9.81),
                 [{"weight": 1.}] + [{"push": push} for push in pushes])


def s0(n, variant="linear"):
    """Units MN, m, MPa. Variants: linear, law9, rigid, bonded."""
    joint = {"kn": None if variant == "rigid" else 8000., "kt": 8000., "f": 0.2}
    if variant == "law9":
        joint["thickness"] = 0.002
    scene = Scene("s0", n, _s0_mesh,
                  {"structure": (3060., 0.2, 0.024), "foundation": (30600., 0.2, 0.)}, joint, (0.0144, 0.),
                  [{"weight": 1.}, {"push": 1.}])
    return scene.altered(bonded=variant == "bonded")
