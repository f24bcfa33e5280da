// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/disc_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fuga::tests
{
  namespace
  {
    MeshEntity
    entity(const CellShape shape, const int group, const std::vector<unsigned int> &vertices)
    {
      MeshEntity result;
      result.shape        = shape;
      result.physical_tag = group;
      std::copy(vertices.begin(), vertices.end(), result.vertices.begin());
      return result;
    }

    /** Numbers of the vertices around the core, counter-clockwise from its corner (-1, -1). */
    std::vector<unsigned int>
    border(const unsigned int m)
    {
      std::vector<unsigned int> result;
      const auto vertex = [m](const unsigned int i, const unsigned int j) {
        return i + (m + 1) * j;
      };
      for (unsigned int i = 0; i < m; ++i)
        result.push_back(vertex(i, 0));
      for (unsigned int j = 0; j < m; ++j)
        result.push_back(vertex(m, j));
      for (unsigned int i = m; i > 0; --i)
        result.push_back(vertex(i, m));
      for (unsigned int j = m; j > 0; --j)
        result.push_back(vertex(0, j));
      return result;
    }
  } // namespace

  GmshMesh
  disc_mesh(const double radius, const unsigned int n)
  {
    constexpr double pi   = 3.14159265358979323846;
    constexpr double core = 0.45, bulge = 0.15; // shape of the core
    const unsigned int m = 2 * n;
    GmshMesh mesh;
    mesh.dimension              = 2;
    mesh.physical_names[{2, 1}] = "stamp";
    mesh.physical_names[{1, 2}] = "side";
    for (unsigned int j = 0; j <= m; ++j)
      for (unsigned int i = 0; i <= m; ++i)
        {
          const double s = 2. * i / m - 1., t = 2. * j / m - 1.;
          mesh.vertices.push_back({{core * radius * s * (1. + bulge * (1. - t * t)),
                                    core * radius * t * (1. + bulge * (1. - s * s)),
                                    0.}});
        }
    for (unsigned int j = 0; j < m; ++j)
      for (unsigned int i = 0; i < m; ++i)
        {
          const unsigned int v = i + (m + 1) * j;
          mesh.cells.push_back(
            entity(CellShape::quadrilateral, 1, {v, v + 1, v + m + 2, v + m + 1}));
        }
    std::vector<unsigned int> inner       = border(m);
    const std::size_t n_around            = inner.size();
    const auto core_vertices              = mesh.vertices;
    const std::vector<unsigned int> first = inner;
    for (unsigned int ring = 1; ring <= n; ++ring)
      {
        std::vector<unsigned int> outer;
        const double share = static_cast<double>(ring) / n;
        for (std::size_t k = 0; k < n_around; ++k)
          {
            const double angle =
              -0.75 * pi + 2. * pi * static_cast<double>(k) / static_cast<double>(n_around);
            const auto &from = core_vertices[first[k]];
            outer.push_back(static_cast<unsigned int>(mesh.vertices.size()));
            mesh.vertices.push_back({{(1. - share) * from[0] + share * radius * std::cos(angle),
                                      (1. - share) * from[1] + share * radius * std::sin(angle),
                                      0.}});
          }
        for (std::size_t k = 0; k < n_around; ++k)
          {
            const std::size_t next = (k + 1) % n_around;
            mesh.cells.push_back(
              entity(CellShape::quadrilateral, 1, {inner[k], outer[k], outer[next], inner[next]}));
            if (ring == n)
              mesh.faces.push_back(entity(CellShape::line, 2, {outer[k], outer[next]}));
          }
        inner = outer;
      }
    return mesh;
  }

  void
  part_above(GmshMesh &mesh, const std::string &name, const std::string &part)
  {
    int new_tag = 1, old_tag = 0;
    for (const auto &[key, group] : mesh.physical_names)
      {
        new_tag = std::max(new_tag, key.second + 1);
        if (key.first == mesh.dimension - 1 && group == name)
          old_tag = key.second;
      }
    mesh.physical_names[{mesh.dimension - 1, new_tag}] = part;
    for (MeshEntity &face : mesh.faces)
      if (face.physical_tag == old_tag &&
          std::all_of(face.vertices.begin(),
                      face.vertices.begin() + n_vertices(face.shape),
                      [&](const unsigned int v) { return mesh.vertices[v][1] >= 0.; }))
        face.physical_tag = new_tag;
  }
} // namespace fuga::tests
