# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Meshes of the benchmark: in the plane rows and columns of rectangles with named parts, in space what Gmsh made.

The same object goes as a Gmsh file to fuga and into the decks of the peers.
"""
import importlib.util
import pathlib

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def _load_scene_g():
    spec = importlib.util.spec_from_file_location("scene_g", REPOSITORY / "meshes" / "scene_g.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SCENE_G = _load_scene_g()  # the rule of its mesh is written there and nowhere else


GMSH_TYPES = {1: 15, 2: 1, 4: 3, 8: 5}  # by the number of nodes


class Mesh:
    """Nodes [(x, y)] or [(x, y, z)], numbered from 1, and groups [(dimension, name, [node tuples])]."""

    def __init__(self, nodes, groups):
        self.nodes, self.groups, self.dim = nodes, sorted(groups, key=lambda group: group[0]), len(nodes[0])

    def group(self, name):
        return next(elements for _, group_name, elements in self.groups if group_name == name)

    def without(self, name):
        """The same mesh without a group: a line that is no longer named is no longer a joint."""
        return Mesh(self.nodes, [group for group in self.groups if group[1] != name])

    def bodies(self):
        return [(name, elements) for dim, name, elements in self.groups if dim == self.dim]

    def line_nodes(self, name):
        """Nodes of a line or surface in the order of their coordinates."""
        numbers = {v for element in self.group(name) for v in element}
        return sorted(numbers, key=lambda v: self.nodes[v - 1])

    def opened(self, line, plus_body):
        """(mesh, {node: its double}): the joint opened as fuga does it, with two lips for the peers."""
        double = {v: len(self.nodes) + k + 1 for k, v in enumerate(self.line_nodes(line))}
        nodes = self.nodes + [self.nodes[v - 1] for v in double]
        plus_nodes = {v for cell in self.group(plus_body) for v in cell}
        below = {v for name, cells in self.bodies() if name != plus_body for cell in cells for v in cell}

        def renamed(dim, name, element):
            moves = name == plus_body or (dim == self.dim - 1 and name != line and
                                          set(element) <= plus_nodes and not set(element) <= below)
            return tuple(double.get(v, v) for v in element) if moves else element

        groups = [(dim, name, [renamed(dim, name, e) for e in elements]) for dim, name, elements in self.groups]
        return Mesh(nodes, groups), double

    def write(self, path):
        """Gmsh 2.2, text."""
        n_elements = sum(len(elements) for _, _, elements in self.groups)
        with open(path, "w") as file:
            file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n%d\n" % len(self.groups))
            file.writelines('%d %d "%s"\n' % (dim, tag, name) for tag, (dim, name, _) in enumerate(self.groups, 1))
            file.write("$EndPhysicalNames\n$Nodes\n%d\n" % len(self.nodes))
            file.writelines("%d %r %r %r\n" % (k, *node, *(0,) * (3 - self.dim)) for k, node in enumerate(self.nodes, 1))
            file.write("$EndNodes\n$Elements\n%d\n" % n_elements)
            number = 0
            for tag, (_, _, elements) in enumerate(self.groups, 1):
                for number, element in enumerate(elements, number + 1):
                    file.write("%d %d 2 %d %d %s\n" % (number, GMSH_TYPES[len(element)], tag, tag,
                                                       " ".join(map(str, element))))
            file.write("$EndElements\n")


def read(path):
    """A mesh of hexahedra with its named groups from Gmsh 2.2, text."""
    with open(path) as file:
        lines = file.read().splitlines()

    def section(name):
        first = lines.index("$" + name) + 2
        return [line.split() for line in lines[first:first + int(lines[first - 1])]]

    names = {int(tag): (int(dim), name.strip('"')) for dim, tag, name in section("PhysicalNames")}
    groups = {tag: [] for tag in names}
    for _, kind, n_tags, physical, *rest in section("Elements"):
        if kind in ("3", "5"):
            groups[int(physical)].append(tuple(map(int, rest[int(n_tags) - 1:])))
    return Mesh([tuple(map(float, row[1:])) for row in section("Nodes")],
                [(*names[tag], elements) for tag, elements in groups.items()])


def uniform(begin, end, n):
    return [begin + (end - begin) * i / n for i in range(n + 1)]


def growing(begin, end, h, growth):
    """From begin to end; the first interval is about h, every next one `growth` times as long."""
    length, sizes = abs(end - begin), [h]
    while sum(sizes) < length * (1 - 1e-12):
        sizes.append(sizes[-1] * growth)
    scale, places = (end - begin) / sum(sizes), [begin]
    for size in sizes:
        places.append(places[-1] + size * scale)
    places[-1] = end
    return places


def joined(*pieces):
    """Pieces of an axis, in the order of growing coordinates, one after another."""
    result = list(pieces[0])
    for piece in pieces[1:]:
        result += piece[1:]
    return result


def falling(piece):
    return list(reversed(piece))


def scene_g(n):
    """n contact elements under the block (lips, line 'base')."""
    return Mesh(*SCENE_G.build(n))


def s0(n):
    """Problem S0 with n - 1 contact faces under the structure: uniform squares."""
    m = n - 1
    grid = SCENE_G.Mesh(uniform(-8., 12., 5 * m), uniform(-6., 12., 9 * m // 2))
    i0, i1, last_i, j0, last_j = 2 * m, 3 * m, 5 * m, 3 * m // 2, 9 * m // 2
    return Mesh(grid.nodes, [
        (2, "foundation", grid.cells((0, last_i), (0, j0))),
        (2, "structure", grid.cells((i0, i1), (j0, last_j))),
        (1, "base", grid.row(j0, (i0, i1))),
        (1, "upstream", grid.column(i0, (j0, last_j))),
        (1, "downstream", grid.column(i1, (j0, last_j))),
        (1, "crest", grid.row(last_j, (i0, i1))),
        (1, "foundation_top", grid.row(j0, (0, i0)) + grid.row(j0, (i1, last_i))),
        (1, "foundation_bottom", grid.row(0, (0, last_i))),
        (1, "foundation_sides", grid.column(0, (0, j0)) + grid.column(last_i, (0, j0)))])


def block(xs, ys, contact_end=None):
    """One rectangle; its bottom, up to contact_end, is the lip 'contact', the rest 'bottom_free'."""
    grid, last_i, last_j = SCENE_G.Mesh(xs, ys), len(xs) - 1, len(ys) - 1
    end = last_i if contact_end is None else min(range(len(xs)), key=lambda i: abs(xs[i] - contact_end))
    groups = [(2, "block", grid.cells((0, last_i), (0, last_j))),
              (1, "contact", grid.row(0, (0, end))),
              (1, "right", grid.column(last_i, (0, last_j))),
              (1, "top", grid.row(last_j, (0, last_i))),
              (1, "left", grid.column(0, (0, last_j))),
              (0, "corner", [(grid.node(last_i, 0),)])]
    if end < last_i:
        groups.append((1, "bottom_free", grid.row(0, (end, last_i))))
    return Mesh(grid.nodes, groups)


def two_blocks(xs, ys_lower, ys_upper):
    """Two blocks, one upon the other, joined along the line 'joint' (patch test)."""
    ys = joined(ys_lower, ys_upper)
    grid, last_i, j0, last_j = SCENE_G.Mesh(xs, ys), len(xs) - 1, len(ys_lower) - 1, len(ys) - 1
    return Mesh(grid.nodes, [
        (2, "lower", grid.cells((0, last_i), (0, j0))), (2, "upper", grid.cells((0, last_i), (j0, last_j))),
        (1, "joint", grid.row(j0, (0, last_i))), (1, "bottom", grid.row(0, (0, last_i))),
        (1, "top", grid.row(last_j, (0, last_i))), (1, "left", grid.column(0, (0, last_j))),
        (1, "right", grid.column(last_i, (0, last_j)))])
