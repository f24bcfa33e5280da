// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/mesh/cell_geometry.h>
#include <fuga/mesh/face_table.h>

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace fuga
{
  FaceTable::FaceTable(const JointedMesh &mesh, const std::string &file_name)
  {
    const CellShape shape = mesh.cells.front().shape;
    faces_per_cell        = n_faces(shape);
    vertices_per_face     = n_vertices(face_shape(shape));
    if (mesh.cells.size() >= none / faces_per_cell)
      throw InputError(
        fmt::format("{}: the mesh has {} cells; fewer than {} are allowed; refine less",
                    file_name,
                    mesh.cells.size(),
                    none / faces_per_cell));
    sort_half_faces(mesh);
    connect(mesh, file_name);
  }


  unsigned int
  FaceTable::n_half_faces() const
  {
    return static_cast<unsigned int>(neighbours.size());
  }


  unsigned int
  FaceTable::cell(const unsigned int half_face) const
  {
    return half_face / faces_per_cell;
  }


  unsigned int
  FaceTable::local_face(const unsigned int half_face) const
  {
    return half_face % faces_per_cell;
  }


  unsigned int
  FaceTable::neighbour(const unsigned int half_face) const
  {
    return neighbours[half_face];
  }


  std::array<unsigned int, 4>
  FaceTable::sorted_vertices(std::array<unsigned int, 4> vertices) const
  {
    // by insertion: with at most four vertices nothing is faster
    for (unsigned int i = 1; i < vertices_per_face; ++i)
      for (unsigned int j = i; j > 0 && vertices[j] < vertices[j - 1]; --j)
        std::swap(vertices[j], vertices[j - 1]);
    for (unsigned int i = vertices_per_face; i < vertices.size(); ++i)
      vertices[i] = none;
    return vertices;
  }


  /** This is a counting sort by the smallest vertex, after which only a few half-faces each remain
   * to be sorted. */
  void
  FaceTable::sort_half_faces(const JointedMesh &mesh)
  {
    const std::size_t n = mesh.cells.size() * faces_per_cell;
    begin.assign(mesh.vertices.size() + 1, 0);
    for (const JointedMesh::Cell &c : mesh.cells)
      for (unsigned int f = 0; f < faces_per_cell; ++f)
        ++begin[sorted_vertices(face_vertices(c, f))[0] + 1];
    for (std::size_t v = 1; v < begin.size(); ++v)
      begin[v] += begin[v - 1];

    entries.resize(n);
    std::vector<unsigned int> next(begin.begin(), begin.end() - 1);
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto v          = sorted_vertices(face_vertices(mesh.cells[cell(i)], local_face(i)));
        entries[next[v[0]]++] = {{{v[1], v[2], v[3]}}, i};
      }
    for (std::size_t v = 0; v + 1 < begin.size(); ++v)
      std::sort(entries.begin() + begin[v],
                entries.begin() + begin[v + 1],
                [](const auto &a, const auto &b) {
                  return a.others != b.others ? a.others < b.others : a.half_face < b.half_face;
                });
  }


  void
  FaceTable::connect(const JointedMesh &mesh, const std::string &file_name)
  {
    neighbours.assign(entries.size(), none);
    const auto vertices_of = [&](const Entry &e) {
      return face_vertices(mesh.cells[cell(e.half_face)], local_face(e.half_face));
    };
    for (std::size_t v = 0; v + 1 < begin.size(); ++v)
      for (unsigned int i = begin[v]; i + 1 < begin[v + 1]; ++i)
        {
          const Entry &a = entries[i];
          const Entry &b = entries[i + 1];
          if (a.others != b.others)
            continue;
          // neighbours traverse their face in opposite directions, because all cells are positive
          if (neighbours[a.half_face] != none || same_direction(vertices_of(a), vertices_of(b)))
            throw InputError(fmt::format(
              "{}: cells of '{}' and '{}' overlap at the face at {}; at a face at most two cells "
              "may meet, one on each side; look for surfaces drawn twice or folded",
              file_name,
              mesh.body_names[mesh.cells[cell(a.half_face)].body],
              mesh.body_names[mesh.cells[cell(b.half_face)].body],
              face_centre(face_shape(mesh.cells.front().shape), vertices_of(a), mesh.vertices)));
          neighbours[a.half_face] = b.half_face;
          neighbours[b.half_face] = a.half_face;
        }
  }


  unsigned int
  FaceTable::find(const std::array<unsigned int, 4> &vertices) const
  {
    const auto v = sorted_vertices(vertices);
    if (v[vertices_per_face - 1] + std::size_t(1) >= begin.size())
      return none;
    const std::array<unsigned int, 3> others{{v[1], v[2], v[3]}};
    const auto end   = entries.begin() + begin[v[0] + 1];
    const auto place = std::lower_bound(
      entries.begin() + begin[v[0]], end, others, [](const Entry &e, const auto &key) {
        return e.others < key;
      });
    return place != end && place->others == others ? place->half_face : none;
  }


  bool
  FaceTable::same_direction(const std::array<unsigned int, 4> &a,
                            const std::array<unsigned int, 4> &b) const
  {
    if (vertices_per_face == 2)
      return a[0] == b[0];
    const auto successor = [this](const std::array<unsigned int, 4> &face,
                                  const unsigned int vertex) {
      const auto place = std::find(face.begin(), face.begin() + vertices_per_face, vertex);
      return face[static_cast<std::size_t>(place - face.begin() + 1) % vertices_per_face];
    };
    return successor(b, a[0]) == a[1];
  }
} // namespace fuga
