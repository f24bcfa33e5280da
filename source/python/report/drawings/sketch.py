# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""A sketch of the model: bodies, supports, joints, loads with arrows, levels of the water."""

import itertools
import os
import textwrap

import matplotlib
import numpy
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from report.drawings.boundaries import Boundaries, centre_of, supports
from report.drawings.figures import WIDTH, new_figure, short, to_figure
from report.drawings.load_arrows import LONGEST, LoadArrows
from report.drawings.stress_diagram import WATER, water_pressure
from report.text.page import Text
from report.text.words import describe, end_of_loads

BODIES = ("#dfe3e8", "#ece4d6", "#dcead9", "#ead9e3", "#d8e7ea", "#eee9c8")
LOADS = ("#b00020", "#1f6fb2", "#6a3d9a", "#2e7d32", "#b25d00", "#444444")
JOINT = "#d81b60"
# In inches: the drawing, the room beside it
TALLEST, LOWEST, LEGEND, LEFT, BOTTOM = 3.3, 1.6, 2.2, 0.6, 0.45
TICKS = 24  # on the boundary of a support
NAMED = 12  # more names would cover the drawing


class _Sketch:
    """The drawing; `project` takes points of the model to the picture."""

    def __init__(self, results, fields):
        self.results, self.fields = results, fields
        self.parameters = results.summary["parameters"]
        self.faces = Boundaries(results.directory)
        self.loads = LoadArrows(results, self.faces)
        self.size = self.loads.size
        self.handles = []
        self.letters = 8.0 if len(self.faces.bodies) + len(results.joints) < 8 else 5.5
        if self.faces.in_space:
            import space_rendering
            self.project = lambda points: space_rendering.projected(points)[..., :2]
            self.towards = space_rendering.FROM
        else:
            self.project = lambda points: numpy.asarray(points)[..., :2]
            self.towards = None

    def seen(self, normals):
        """Which faces look towards the eye; in the plane all are seen from their side."""
        return numpy.ones(len(normals), dtype=bool) if self.towards is None else normals @ self.towards > 1e-6

    def prepare(self):
        corners = self.project(self.faces.outer)
        low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
        margin = (0.4 if self.faces.in_space else 1.1) * LONGEST * self.size
        low, high = low - margin, high + margin
        shape = (high - low)[1] / (high - low)[0]
        width = min(WIDTH - LEGEND - LEFT, TALLEST / shape)
        height = max(width * shape, LOWEST)
        self.figure = new_figure(height + BOTTOM + 0.1)
        size = self.figure.get_size_inches()
        self.axes = self.figure.add_axes((LEFT / size[0], BOTTOM / size[1], width / size[0], height / size[1]))
        self.axes.set_xlim(low[0], high[0])
        self.axes.set_ylim(low[1], high[1])
        self.axes.set_aspect("equal")
        self.axes.grid(False)
        if self.faces.in_space:
            self.axes.set_axis_off()
        else:
            self.axes.set_xlabel(f"x [{self.results.unit('x')}]")
            self.axes.set_ylabel(f"y [{self.results.unit('y')}]")
            for side in self.axes.spines.values():
                side.set_visible(False)

    def draw_bodies(self):
        """Filled where the run wrote fields, else their outlines."""
        if not isinstance(self.fields, str):
            import field_rendering
            colours = numpy.array([matplotlib.colors.to_rgb(colour) for colour in BODIES])
            points, body = (field_rendering.points_of(self.fields.bodies),
                            field_rendering.array_of(self.fields.bodies, "body").round().astype(int))
            if self.faces.in_space:
                import space_rendering
                faces = space_rendering.outer_faces(self.fields.bodies)
                space_rendering.draw_faces(self.axes, points, faces, [colours[body[some[:, 0]] % len(BODIES)] for some in faces])
            else:
                for cells in field_rendering.cells_of(self.fields.bodies.GetCells()):
                    filled = colours[body[cells[:, 0]] % len(BODIES)]
                    self.axes.add_collection(PolyCollection(points[cells][:, :, :2], facecolors=filled, edgecolors=filled,
                                                            linewidths=0.3, rasterized=True, zorder=2))
        if not self.faces.in_space:
            self.axes.add_collection(LineCollection(self.faces.outer[:, :, :2], colors="#333333", linewidths=0.9, zorder=3))
        for name in self.faces.bodies[:NAMED]:
            place = self.project(centre_of(self.faces, name))
            self.axes.annotate(short(name), place, xytext=(0, 6), textcoords="offset points", ha="center", zorder=8,
                               fontsize=self.letters, style="italic")

    def draw_joints(self):
        n_named = 0
        for name in self.results.joints:
            faces = self.faces.joint(name)
            if len(faces) == 0:
                continue
            n_named += 1
            lines = _rim(faces) if self.faces.in_space else faces
            self.axes.add_collection(LineCollection(self.project(lines), colors=JOINT, linewidths=1.8, zorder=6))
            if n_named > NAMED:
                continue
            centre = faces.mean(axis=1)
            place = self.project(centre[numpy.linalg.norm(centre - centre.mean(axis=0), axis=1).argmin()])
            self.axes.annotate(short(name), place, xytext=(0, -10), textcoords="offset points", ha="center",
                               fontsize=self.letters, color=JOINT, zorder=8)
        if self.results.joints:
            self.handles.append(Line2D([], [], color=JOINT, linewidth=1.8, label="joint"))

    def draw_supports(self):
        length = 0.022 * self.size
        kinds = set()
        for name, fixed in supports(self.parameters):
            faces = self.faces.boundary(name)
            normals = self.faces.normals(faces)
            faces, normals = faces[self.seen(normals)], normals[self.seen(normals)]
            step = max(1, -(-len(faces) // TICKS))
            centres, normals = faces.mean(axis=1)[::step], normals[::step]
            whole = fixed.strip() == "all"
            kinds.add("held in all directions" if whole else f"held in {fixed.strip()} only")
            if whole:
                ends = centres + length * (normals + numpy.roll(normals, 1, axis=1) * [1, 1, 0])
                ticks = numpy.stack([centres, ends], axis=1)
                self.axes.add_collection(LineCollection(self.project(ticks), colors="black", linewidths=0.9, zorder=4))
            else:
                self.axes.plot(*self.project(centres + 0.6 * length * normals).T, "o", markersize=3.5, markerfacecolor="white",
                               markeredgecolor="black", markeredgewidth=0.8, zorder=4)
        if "held in all directions" in kinds:
            self.handles.append(Line2D([], [], color="black", marker=(2, 0, -45), linestyle="", label="held in all directions"))
        for words in sorted(kinds - {"held in all directions"}):
            self.handles.append(Line2D([], [], linestyle="", marker="o", markersize=3.5, markerfacecolor="white",
                                       markeredgecolor="black", label=words))

    def draw_water(self, load):
        """Still water in front of the faces in the plane."""
        normals = self.faces.normals(load.wet)
        beds = (normals[:, 1] > numpy.abs(normals[:, 0])) & (load.wet[:, :, 1].max(axis=1) < load.level)
        walls = (numpy.abs(normals[:, 0]) >= numpy.abs(normals[:, 1])) & (load.wet[:, :, 1].min(axis=1) < load.level)
        shapes, reach = [], []
        for (x0, y0), (x1, y1) in load.wet[beds][:, :, :2]:
            shapes.append([(x0, y0), (x1, y1), (x1, load.level), (x0, load.level)])
        side = numpy.sign(normals[walls, 0].sum()) if walls.any() else 0.0
        wall_x = load.wet[walls][:, :, 0]
        if walls.any():
            end = (wall_x.max() if side > 0.0 else wall_x.min()) + (0.0 if beds.any() else side * LONGEST * self.size)
        for (x0, y0), (x1, y1) in load.wet[walls][:, :, :2]:
            if max(y0, y1) > load.level:
                share = (load.level - min(y0, y1)) / abs(y1 - y0)
                (xa, ya), (xb, yb) = ((x0, y0), (x1, y1)) if y0 < y1 else ((x1, y1), (x0, y0))
                x0, y0, x1, y1 = xa, ya, xa + share * (xb - xa), load.level
            shapes.append([(x0, y0), (x1, y1), (end, y1), (end, y0)])
        if not shapes:
            return
        reach = [x for shape in shapes for x, _ in shape]
        self.axes.add_collection(PolyCollection(shapes, facecolor=WATER, edgecolor=WATER, linewidth=0.3, alpha=0.55, zorder=1))
        self.axes.plot([min(reach), max(reach)], [load.level] * 2, color="#1f6fb2", linewidth=1.2, zorder=3)
        middle = 0.5 * (min(reach) + max(reach))
        self.axes.plot([middle], [load.level], marker=7, markersize=7, color="#1f6fb2", zorder=3)

    def draw_uplift(self):
        """The pressure of the water in the joints, below them."""
        for name in self.results.joints:
            profile = self.results.profile(name, end_of_loads(self.results))
            water = water_pressure(profile)
            if not water.any():
                continue
            line = numpy.column_stack([profile["x"], profile["y"]])
            along = numpy.gradient(line, axis=0)
            normal = numpy.column_stack([-along[:, 1], along[:, 0]]) / numpy.linalg.norm(along, axis=1)[:, None]
            below = line - normal * (LONGEST * self.size * water / water.max())[:, None]
            self.axes.add_collection(PolyCollection([numpy.concatenate([line, below[::-1]])], facecolor=WATER,
                                                    edgecolor="#1f6fb2", linewidth=0.8, zorder=5))

    def draw_loads(self):
        for load, colour in zip(self.loads.all(), itertools.cycle(LOADS)):
            if load.level is not None and not self.faces.in_space:
                self.draw_water(load)
            words = textwrap.fill(load.words, 34)
            if not load.arrows:
                in_joint = load.kind == "uplift" and not self.faces.in_space
                self.handles.append(Patch(facecolor=WATER if in_joint else "none", edgecolor="#1f6fb2" if in_joint else "none",
                                          label=words))
                continue
            self.handles.append(Line2D([], [], color=colour, marker=">", markersize=5, label=words))
            tails, tips, normals = load.arrows
            seen = self.seen(normals) | ~normals.any(axis=1)
            for tail, tip in zip(self.project(tails[seen]), self.project(tips[seen])):
                self.axes.annotate("", tip, tail, zorder=7,
                                   arrowprops={"arrowstyle": "-|>,head_length=0.35,head_width=0.15", "color": colour,
                                               "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0})


def _rim(faces):
    """The edges of a surface that belong to one face only."""
    edges = numpy.concatenate([faces[:, [k, (k + 1) % 4]] for k in range(4)])
    edges = edges[numpy.linalg.norm(edges[:, 1] - edges[:, 0], axis=1) > 0.0]
    middles = (edges.mean(axis=1) / numpy.abs(faces).max()).round(7)
    _, place, count = numpy.unique(middles, axis=0, return_inverse=True, return_counts=True)
    return edges[count[place] == 1]


def model_sketch(results, fields):
    """The sketch, as parts of a section; `fields` or the words why there are none."""
    if not os.path.exists(os.path.join(results.directory, "boundaries.csv")):
        return [Text("The results are of an earlier version, without boundaries.csv: the model cannot be drawn.")]
    sketch = _Sketch(results, fields)
    sketch.prepare()
    sketch.draw_bodies()
    sketch.draw_joints()
    sketch.draw_supports()
    if not sketch.faces.in_space:
        sketch.draw_uplift()
    sketch.draw_loads()
    box = sketch.axes.get_position()
    sketch.figure.legend(handles=sketch.handles, loc="upper left", bbox_to_anchor=(box.x1 + 0.01, 1.0), fontsize=7.5)
    return [to_figure(sketch.figure, "The model and its loads, "
                                     f"{describe(results, end_of_loads(results))}. The arrows of a load are in proportion to "
                                     "each other, not to those of another load"
                                     + (". " if sketch.faces.in_space else "; the pressure of water in a joint is drawn on its "
                                        "minus side. ") + "Loads without arrows are named only.")]
