# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The faces of boundaries and joints of a model, from boundaries.csv."""

import os

import numpy

from fuga_results import Table


class Boundaries:
    """Faces as arrays of corners (faces, corners, 3), by name of boundary, joint or body."""

    def __init__(self, directory):
        frame = Table(os.path.join(directory, "boundaries.csv")).frame
        self._frame = frame
        self._corners = frame[[name for name in frame.columns if name[0] in "xyz" and name[1:].isdigit()]].to_numpy(float)
        self._corners = self._corners.reshape(len(frame), -1, 3)
        self.in_space = self._corners.shape[1] == 4

    def boundary(self, name):
        return self._corners[(self._frame["boundary"] == name).to_numpy()]

    def joint(self, name):
        """One side of it."""
        frame = self._frame[self._frame["joint"] == name]
        return self._corners[frame.index[frame["boundary"] == frame["boundary"].iloc[0]]] if len(frame) else self._corners[:0]

    def body(self, name):
        return self._corners[(self._frame["body"] == name).to_numpy()]

    @property
    def outer(self):
        """Faces of boundaries, without those of joints."""
        return self._corners[(self._frame["joint"].fillna("") == "").to_numpy()]

    @property
    def bodies(self):
        return list(dict.fromkeys(self._frame["body"]))

    def standing(self, supported):
        """Names of the bodies with no face on a supported boundary: what stands on the others; all if none does."""
        held = set(self._frame["body"][self._frame["boundary"].isin(supported)])
        return [name for name in self.bodies if name not in held] or self.bodies

    def normals(self, faces):
        """Unit normals, outwards."""
        if self.in_space:
            normals = numpy.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])
        else:
            along = faces[:, 1] - faces[:, 0]
            normals = numpy.column_stack([along[:, 1], -along[:, 0], numpy.zeros(len(faces))])
        return normals / numpy.linalg.norm(normals, axis=1)[:, None]


def supports(parameters):
    """(boundary, fixed components) of all that are held."""
    return [(name, entries["Fixed"]) for name, entries in parameters.get("Boundaries", {}).items()
            if entries.get("Fixed", "free") not in ("free", "none", "")]


def centre_of(boundaries, name):
    """The centroid of a body in the plane, if its faces go all round; else, and in space, the middle of its faces."""
    faces = boundaries.body(name)
    if not boundaries.in_space and numpy.abs((faces[:, 1] - faces[:, 0]).sum(axis=0)).max() < 1e-9 * numpy.abs(faces).max():
        (x0, y0), (x1, y1) = faces[:, 0, :2].T, faces[:, 1, :2].T
        twice = x0 * y1 - x1 * y0
        return numpy.array([((x0 + x1) * twice).sum(), ((y0 + y1) * twice).sum(), 0.0]) / (3.0 * twice.sum())
    low, high = faces.min(axis=(0, 1)), faces.max(axis=(0, 1))
    return 0.5 * (low + high)
