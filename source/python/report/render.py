# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Renders the pictures of the last load level into a file of arrays. A process of its own: should the
graphics library crash, only the pictures are missing.

usage: python3 -m report.render RESULT_DIR FILE.npz
"""

import sys

import matplotlib
import numpy

from field_rendering import (View, add_array, array_names, array_of, averaged, colour_range, contour_actor,
                             default_view, is_inside, joint_actors, lip_displacements, lookup_table, points_of, read_grid, render,
                             surface_actor, x_display)
from fuga_results import Results

PIXELS = 900
SHOWN_DISPLACEMENT = 0.06  # largest drawn displacement, as share of the size of the model
CELLS_WITH_EDGES = 800  # edges of more would cover a stress
STRESSES = {"von Mises stress": ("von_mises_stress", "viridis"), "principal stress": ("signed_principal", "RdBu_r")}


def round_down(factor):
    """The next smaller number of the sequence 1, 2, 5, 10 ..."""
    power = 10.0 ** numpy.floor(numpy.log10(factor))
    return max(step for step in (1.0, 2.0, 5.0) if step * power <= factor * (1.0 + 1e-12)) * power


def add_signed_principal(bodies):
    """The principal stress in the plane of larger magnitude, with its sign: the sign of the sum of both."""
    first, second = array_of(bodies, "principal_stress_1"), array_of(bodies, "principal_stress_2")
    add_array(bodies, "signed_principal", numpy.where(numpy.abs(first) >= numpy.abs(second), first, second))
    add_array(bodies, "sum_of_principal", averaged(bodies, first + second))


def joint_view(drawn, whole):
    """The surroundings of the joints, neither a strip nor a column, inside the picture of the whole."""
    low, high = drawn.min(axis=0), drawn.max(axis=0)
    size = 1.25 * (high - low).max()
    width, height = numpy.maximum(1.25 * (high - low), [0.7 * size, 0.45 * size])
    x, y = 0.5 * (low + high)
    return View((max(x - width / 2, whole.left), min(x + width / 2, whole.right),
                 max(y - height / 2, whole.bottom), min(y + height / 2, whole.top)))


def main(directory, path):
    results = Results(directory)
    bodies, joints = (read_grid(results.field_file(name)) for name in ("bodies", "joints"))
    whole = default_view(bodies)
    moved = numpy.abs(array_of(bodies, "displacement")).max()
    factor = round_down(SHOWN_DISPLACEMENT * max(whole.width, whole.height) / moved) if moved > 0.0 else 1.0
    arrays = {"factor": factor}
    with x_display():
        def lips(view):
            return joint_actors(bodies, joints, factor, view, PIXELS) if joints.GetNumberOfCells() else []
        if {"principal_stress_1", "principal_stress_2"} <= set(array_names(bodies)):
            add_signed_principal(bodies)
        for name, (array, colours) in STRESSES.items():
            if array not in array_names(bodies):
                continue
            diverging = array == "signed_principal"
            limits = colour_range(array_of(bodies, array)[is_inside(points_of(bodies), whole)], diverging)
            actors = [surface_actor(bodies, array, lookup_table(matplotlib.colormaps[colours], limits), factor,
                                    bodies.GetNumberOfCells() <= CELLS_WITH_EDGES)]
            if diverging:
                actors.append(contour_actor(bodies, "sum_of_principal", 0.0, factor, 0.005 * whole.height))
            arrays[name] = render(actors + lips(whole), whole, PIXELS)
            arrays[name + " limits"] = limits
        arrays["extent"] = whole.extent
        if joints.GetNumberOfCells():
            positions = points_of(joints)
            both = lip_displacements(bodies, joints, 1e-6 * whole.height)
            drawn = [positions[:, :2] + factor * lip for lip in both]
            view = joint_view(numpy.concatenate(drawn), whole)
            arrays["joints"] = render([surface_actor(bodies, None, None, factor)] + lips(view), view, PIXELS)
            arrays["joints extent"] = view.extent
            arrays["lips"], arrays["states"] = numpy.array(drawn), array_of(joints, "state")
    numpy.savez_compressed(path, **arrays)


if __name__ == "__main__":
    main(*sys.argv[1:])
