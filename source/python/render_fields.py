#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Picture of one load level: the deformed bodies with a stress, the states of the joint elements, and
beside them the stresses along one joint.

usage: render_fields.py RESULT_DIR [-o PICTURE.png] [options]; --help lists them

Needs VTK and, without a screen, xvfb-run, which it starts itself.
"""

import argparse
import math
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy
import vtk
from matplotlib.patches import Patch
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from fuga_results import OPEN, SLIP, STATE_COLOURS, STATES, STICK, Results

STATE_OF_CODE = (OPEN, STICK, SLIP, "bonded")
PIXELS = 1500  # height of the rendered part
SHOWN_DISPLACEMENT = 0.2  # largest drawn displacement at most, as share of the height of the view
RIM, LIP = 17.0, 10.0  # widths of lines, in pixels
# Stresses at corners grow with every refinement: the map covers all but these shares of the nodes.
CLIPPED = (0.5, 99.5)


def read_grid(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def points_of(grid):
    return vtk_to_numpy(grid.GetPoints().GetData()).astype(float)


def array_of(grid, name):
    data = grid.GetPointData().GetArray(name)
    if data is None:
        known = [grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())]
        sys.exit(f"There is no array '{name}'. There are: {', '.join(known)}.")
    return vtk_to_numpy(data).astype(float)


class View:
    """The part of the plane that is shown, in deformed coordinates."""

    def __init__(self, box):
        self.left, self.right, self.bottom, self.top = box
        self.width, self.height = self.right - self.left, self.top - self.bottom

    @property
    def extent(self):
        return self.left, self.right, self.bottom, self.top


def default_view(bodies, joints, displacement_share=0.1):
    """The whole model, with a margin."""
    points = points_of(bodies)
    low, high = points.min(axis=0), points.max(axis=0)
    margin = displacement_share * (high - low)
    return View((low[0] - margin[0], high[0] + margin[0], low[1] - margin[1], high[1] + margin[1]))


def is_inside(points, view):
    return ((points[:, 0] >= view.left) & (points[:, 0] <= view.right)
            & (points[:, 1] >= view.bottom) & (points[:, 1] <= view.top))


def colour_range(values, diverging):
    low, high = numpy.percentile(values, CLIPPED)
    if diverging:
        high = max(abs(low), abs(high))
        low = -high
    return low, high


def lookup_table(colour_map, limits):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, colour in enumerate(colour_map(numpy.linspace(0.0, 1.0, 256))):
        table.SetTableValue(i, *colour)
    table.SetRange(*limits)
    table.Build()
    return table


def surface_actor(bodies, array, table, factor):
    bodies.GetPointData().SetActiveVectors("displacement")
    bodies.GetPointData().SetActiveScalars(array)
    warp = vtk.vtkWarpVector()
    warp.SetInputData(bodies)
    warp.SetScaleFactor(factor)
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(warp.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.25, 0.25, 0.25)
    actor.GetProperty().SetLineWidth(0.4)
    return actor


def line_actor(points, lines, colours, width, depth):
    """Line segments with a colour each. `depth` lifts them above the bodies."""
    poly, cells, vtk_points = vtk.vtkPolyData(), vtk.vtkCellArray(), vtk.vtkPoints()
    for x, y in points:
        vtk_points.InsertNextPoint(x, y, depth)
    for a, b in lines:
        cells.InsertNextCell(2)
        cells.InsertCellPoint(a)
        cells.InsertCellPoint(b)
    poly.SetPoints(vtk_points)
    poly.SetLines(cells)
    rgb = numpy_to_vtk(numpy.array(colours, dtype=numpy.uint8), deep=True)
    poly.GetCellData().SetScalars(rgb)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(poly)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetRenderLinesAsTubes(False)
    return actor


def lip_displacements(bodies, positions, tolerance):
    """Displacements at joint nodes of the two lips; equal at a tip or against a rigid obstacle."""
    points, displacement, body = points_of(bodies), array_of(bodies, "displacement"), array_of(bodies, "body")
    lips = [], []
    for position in positions:
        here = numpy.abs(points - position).max(axis=1) < tolerance
        found = displacement[here][:, :2][numpy.argsort(body[here], kind="stable")]
        lips[0].append(found[0])
        different = numpy.abs(found - found[0]).max(axis=1) > 0.0
        lips[1].append(found[different][0] if different.any() else found[0])
    return [numpy.array(lip) for lip in lips]


def joint_actors(bodies, joints, factor, view):
    """Both lips; each node colours the half of its faces that is next to it. White between and around."""
    positions, state = points_of(joints), array_of(joints, "state")
    colour_of = [[int(255 * c) for c in matplotlib.colors.to_rgb(STATE_COLOURS[name])] for name in STATE_OF_CODE]
    actors = []
    for lip in lip_displacements(bodies, positions, 1e-6 * view.height):
        drawn = positions[:, :2] + factor * lip
        points, lines, colours = [], [], []
        for cell in range(joints.GetNumberOfCells()):
            ids = joints.GetCell(cell).GetPointIds()
            ends = ids.GetId(0), ids.GetId(1)
            centre = 0.5 * (drawn[ends[0]] + drawn[ends[1]])
            for node in ends:
                lines.append((len(points), len(points) + 1))
                points += [drawn[node], centre]
                colours.append(colour_of[int(round(state[node]))])
        white = [[255, 255, 255]] * len(lines)
        actors += [line_actor(points, lines, white, RIM, 0.01 * view.height),
                   line_actor(points, lines, colours, LIP, 0.02 * view.height)]
    return actors


def render(actors, view):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    x, y = 0.5 * (view.left + view.right), 0.5 * (view.bottom + view.top)
    camera.SetFocalPoint(x, y, 0.0)
    camera.SetPosition(x, y, 10.0 * view.height)
    camera.SetParallelScale(0.5 * view.height)
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(int(PIXELS * view.width / view.height), PIXELS)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[::-1]


def draw_bodies(axes, bar_axes, image, view, limits, colour_map, label, factor, units):
    axes.imshow(image, extent=view.extent, interpolation="antialiased", aspect="equal")
    axes.set_xlabel(f"x [{units['length']}]", labelpad=2)
    axes.set_ylabel(f"y [{units['length']}]", labelpad=2)
    axes.set_title(f"deformed shape, displacements drawn {factor:g} times", loc="left", fontsize=9)
    for side in axes.spines.values():
        side.set_visible(False)
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), colour_map)
    bar = axes.figure.colorbar(scale, cax=bar_axes, orientation="horizontal", extend="both")
    bar.set_label(f"{label} [{units['stress']}], tension positive")
    bar.outline.set_visible(False)


def shade_states(axes, profile):
    along = profile["along"]
    edges = [along[0]] + [0.5 * (a + b) for a, b in zip(along, along[1:])] + [along[-1]]
    for left, right, state in zip(edges, edges[1:], profile["state"]):
        axes.axvspan(left, right, color=STATE_COLOURS[state], alpha=0.28, linewidth=0)
    axes.set_xlim(along[0], along[-1])
    axes.axhline(0.0, color="black", linewidth=0.8)


def draw_profile(axes, profile, friction, cohesion, units):
    along = profile["along"]
    strength = [0.0 if state == OPEN else friction * p + cohesion
                for p, state in zip(profile["pressure"], profile["state"])]
    for one in axes:
        shade_states(one, profile)
    axes[0].plot(along, profile["pressure"], color="black", linewidth=1.6)
    axes[0].set_ylabel(f"pressure [{units['stress']}]")
    axes[1].plot(along, profile["shear1"], color="black", linewidth=1.6, label="shear stress")
    axes[1].plot(along, strength, "--", color="black", linewidth=1.0, label="strength f p + c")
    if min(profile["shear1"]) < 0.0:
        axes[1].plot(along, [-value for value in strength], "--", color="black", linewidth=1.0)
    axes[1].set_ylabel(f"shear [{units['stress']}]")
    axes[1].legend(frameon=False, fontsize=8, loc="upper left")
    axes[2].plot(along, [1e3 * value for value in profile["jump_n"]], color="black", linewidth=1.6,
                 label="normal: gap +, closure \u2212")
    axes[2].plot(along, [1e3 * value for value in profile["jump_t1"]], "--", color="black", linewidth=1.6,
                 label="tangential")
    axes[2].set_ylabel(f"jump [{units['length']}/1000]")
    axes[2].legend(frameon=False, fontsize=8)
    axes[2].set_xlabel(f"distance along the joint [{units['length']}]")


def compose(results, options, image, view, limits, colour_map, factor, path):
    profile = results.profile(options.joint, options.t)
    units = {"length": results.unit("x"), "stress": results.unit("pressure")}
    joint = results.summary["parameters"]["Joints"][options.joint or results.joints[0]]
    friction = float(joint.get("Friction coefficient", 0.0))
    if "Friction angle" in joint:
        friction = numpy.tan(numpy.radians(float(joint["Friction angle"])))
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False})
    figure = plt.figure(figsize=(11.0, 6.4))
    left = figure.add_gridspec(2, 1, left=0.065, right=0.505, top=0.885, bottom=0.085, hspace=0.22,
                               height_ratios=(1.0, 0.03))
    right = figure.add_gridspec(3, 1, left=0.585, right=0.985, top=0.885, bottom=0.085, hspace=0.13)
    draw_bodies(figure.add_subplot(left[0]), figure.add_subplot(left[1]), image, view, limits, colour_map,
                options.array.replace("_", " "), factor, units)
    axes = [figure.add_subplot(right[0])]
    axes += [figure.add_subplot(right[i], sharex=axes[0]) for i in (1, 2)]
    for one in axes[:2]:
        one.tick_params(labelbottom=False)
    draw_profile(axes, profile, friction, float(joint.get("Cohesion", 0.0)), units)
    figure.align_ylabels(axes)
    axes[0].legend(handles=[Patch(facecolor=STATE_COLOURS[s], label=s) for s in STATES], ncol=3,
                   frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0), borderaxespad=0.2)
    figure.suptitle(f"{results.title} \u2013 {describe_time(results, profile.t)}", fontsize=12, fontweight="bold",
                    x=0.02, y=0.975, ha="left")
    figure.savefig(path, dpi=140)


def describe_time(results, t):
    """Load time in words: stages are counted from 0, and the end of a stage belongs to it."""
    stages = list(results.summary["parameters"]["Stages"])
    number = min(max(math.ceil(t) - 1, 0), len(stages) - 1)
    fraction = t - number
    return f"end of stage '{stages[number]}'" if fraction == 1.0 else f"{100 * fraction:g} % of stage '{stages[number]}'"


def round_down(factor):
    """The next smaller number of the sequence 1, 2, 5, 10 ..."""
    power = 10.0 ** math.floor(math.log10(factor))
    return max(step for step in (1.0, 2.0, 5.0) if step * power <= factor) * power


def parse(arguments):
    parser = argparse.ArgumentParser(description="Picture of one load level of a run of fuga.")
    parser.add_argument("directory", help="result directory")
    parser.add_argument("-o", "--output", help="picture; default: fields.png in the result directory")
    parser.add_argument("--array", default="principal_stress_2", help="scalar of bodies.pvd; default: %(default)s")
    parser.add_argument("--t", type=float, help="load time; default: the last")
    parser.add_argument("--joint", help="joint of the diagrams; default: the first")
    parser.add_argument("--view", type=float, nargs=4, metavar=("X0", "X1", "Y0", "Y1"), help="part to show")
    parser.add_argument("--factor", type=float, help="magnification of displacements")
    parser.add_argument("--map", default="viridis", help="matplotlib colour map; default: %(default)s")
    parser.add_argument("--diverging", action="store_true", help="centre the colours on zero")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    if not os.environ.get("DISPLAY"):
        os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable, os.path.abspath(__file__)] + arguments)

    results = Results(options.directory)
    bodies = read_grid(results.field_file("bodies", options.t))
    joints = read_grid(results.field_file("joints", options.t))
    view = View(options.view) if options.view else default_view(bodies, joints)

    inside = is_inside(points_of(bodies), view)
    moved = numpy.abs(array_of(bodies, "displacement")[inside]).max()
    factor = options.factor or round_down(SHOWN_DISPLACEMENT * view.height / moved)
    limits = colour_range(array_of(bodies, options.array)[inside], options.diverging)
    colour_map = matplotlib.colormaps[options.map]
    actors = [surface_actor(bodies, options.array, lookup_table(colour_map, limits), factor)]
    actors += joint_actors(bodies, joints, factor, view)
    path = options.output or os.path.join(options.directory, "fields.png")
    compose(results, options, render(actors, view), view, limits, colour_map, factor, path)
    print(path)


if __name__ == "__main__":
    main(sys.argv[1:])
