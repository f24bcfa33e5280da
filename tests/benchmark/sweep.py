# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Cost of one further variant of a sweep, if this fuga knows the section Sweep.

How a sweep is written is the business of `sections()` alone: change it with the product.
"""
import fuga_runs

COUNTS = (1, 101)  # the difference of their times is the cost of a hundred further variants


def available():
    return fuga_runs.knows("subsection Sweep")


def sections(scene, count):
    """A sweep over the friction coefficient: `count` values around 0.6, that of the separate run."""
    values = ", ".join("%.4f" % (0.6 + 0.002 * (k - (count - 1) / 2)) for k in range(count))
    return {**scene.sections(fuga_runs.scene_mesh(scene)), "Sweep": {"Joints/*/Friction coefficient": values}}


def run(scene, count):
    result, _ = fuga_runs.run("sweep_%d_%d" % (scene.n, count), sections(scene, count), result_file="sweep.csv")
    result.elements, result.dofs = scene.n, scene.dofs
    return result
