#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Writes the mesh of scene G: a block 20 m x 40 m on a foundation, graded away from the contact.

usage: scene_g.py N [FILE]        N contact nodes on y = 0, 0 <= x <= 20 (default FILE: scene_g_N.msh)

The rule of the grid: uniform size h = 20/(N-1) along the contact; away from it (to both sides of the
block, upwards and downwards) the first interval is h, every next one 1.2 times as long but at most 2.5,
until the length is reached or passed; then all intervals of the row are scaled to end exactly there.
The lips are one line, "base"; both count when the degrees of freedom are: 2028 for N = 9, 5036 for 33,
18936 for 129, 81228 for 513.
"""
import sys

GROWTH, CAP = 1.2, 2.5
WIDTH, HEIGHT, SIDE, DEPTH = 20.0, 40.0, 40.0, 50.0


def graded(h, length):
    """Distances from the contact: 0 ... length."""
    sizes, size = [], h
    while sum(sizes) < length * (1 - 1e-12):
        sizes.append(size)
        size = min(size * GROWTH, CAP)
    scale, places = length / sum(sizes), [0.0]
    for size in sizes:
        places.append(places[-1] + size * scale)
    places[-1] = length
    return places


class Mesh:
    """Vertices by grid position, cells and named faces."""

    def __init__(self, xs, ys):
        self.xs, self.ys, self.number, self.nodes = xs, ys, {}, []

    def node(self, i, j):
        if (i, j) not in self.number:
            self.nodes.append((self.xs[i], self.ys[j]))
            self.number[i, j] = len(self.nodes)
        return self.number[i, j]

    def cells(self, i_range, j_range):
        return [(self.node(i, j), self.node(i + 1, j), self.node(i + 1, j + 1), self.node(i, j + 1))
                for j in range(*j_range) for i in range(*i_range)]

    def row(self, j, i_range):
        return [(self.node(i, j), self.node(i + 1, j)) for i in range(*i_range)]

    def column(self, i, j_range):
        return [(self.node(i, j), self.node(i, j + 1)) for j in range(*j_range)]


def build(n):
    h = WIDTH / (n - 1)
    side, up, down = graded(h, SIDE), graded(h, HEIGHT), graded(h, DEPTH)
    xs = [-x for x in reversed(side[1:])] + [WIDTH * i / (n - 1) for i in range(n)] + [WIDTH + x for x in side[1:]]
    ys = [-y for y in reversed(down[1:])] + up
    i0, i1, j0 = len(side) - 1, len(side) + n - 2, len(down) - 1
    last_i, last_j = len(xs) - 1, len(ys) - 1
    mesh = Mesh(xs, ys)
    # (dimension, name, elements): every group is an entity of its own
    groups = [
        (2, "foundation", mesh.cells((0, last_i), (0, j0))),
        (2, "block", mesh.cells((i0, i1), (j0, last_j))),
        (1, "base", mesh.row(j0, (i0, i1))),
        (1, "upstream", mesh.column(i0, (j0, last_j))),
        (1, "downstream", mesh.column(i1, (j0, last_j))),
        (1, "crest", mesh.row(last_j, (i0, i1))),
        (1, "foundation_top", mesh.row(j0, (0, i0)) + mesh.row(j0, (i1, last_i))),
        (1, "foundation_bottom", mesh.row(0, (0, last_i))),
        (1, "foundation_sides", mesh.column(0, (0, j0)) + mesh.column(last_i, (0, j0))),
    ]
    return mesh.nodes, groups


def write(file, nodes, groups):
    groups = sorted(groups, key=lambda g: g[0])
    tagged = [(dim, tag, name, elements) for tag, (dim, name, elements) in enumerate(groups, start=1)]
    n_of = [sum(1 for g in groups if g[0] == dim) for dim in range(4)]
    n_elements = sum(len(g[2]) for g in groups)
    file.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n%d\n" % len(groups))
    for dim, tag, name, _ in tagged:
        file.write('%d %d "%s"\n' % (dim, tag, name))
    file.write("$EndPhysicalNames\n$Entities\n%d %d %d %d\n" % tuple(n_of))
    for dim, tag, _, elements in tagged:
        points = [nodes[v - 1] for element in elements for v in element]
        bounds = [f(p[d] for p in points) for f in (min, max) for d in (0, 1)]
        file.write("%d %r %r 0 %r %r 0 1 %d 0 \n" % (tag, *bounds, tag))
    file.write("$EndEntities\n$Nodes\n1 %d 1 %d\n2 %d 0 %d\n"
               % (len(nodes), len(nodes), tagged[-1][1], len(nodes)))
    file.writelines("%d\n" % (i + 1) for i in range(len(nodes)))
    file.writelines("%r %r 0\n" % node for node in nodes)
    file.write("$EndNodes\n$Elements\n%d %d 1 %d\n" % (len(groups), n_elements, n_elements))
    number = 0
    for dim, tag, _, elements in tagged:
        file.write("%d %d %d %d\n" % (dim, tag, 1 if dim == 1 else 3, len(elements)))
        for element in elements:
            number += 1
            file.write("%d %s \n" % (number, " ".join(map(str, element))))
    file.write("$EndElements\n")


def main():
    if len(sys.argv) not in (2, 3) or not sys.argv[1].isdigit() or int(sys.argv[1]) < 9:
        sys.exit(__doc__)
    n = int(sys.argv[1])
    nodes, groups = build(n)
    with open(sys.argv[2] if len(sys.argv) == 3 else "scene_g_%d.msh" % n, "w") as file:
        write(file, nodes, groups)
    print("scene G, %d contact nodes: %d degrees of freedom with both lips" % (n, 2 * (len(nodes) + n)))


if __name__ == "__main__":
    main()
