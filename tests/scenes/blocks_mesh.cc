// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/blocks_mesh.h"

#include <algorithm>
#include <map>

namespace fuga::tests
{
  namespace
  {
    /** Every interval in n parts. */
    Axis
    refined(const Axis &axis, const std::size_t n)
    {
      Axis result;
      for (std::size_t i = 0; i + 1 < axis.size(); ++i)
        for (std::size_t k = 0; k < n; ++k)
          result.push_back(axis[i] + (axis[i + 1] - axis[i]) * double(k) / double(n));
      result.push_back(axis.back());
      return result;
    }

    class Builder
    {
    public:
      Builder(const Axis &xs, const Axis &ys) : n_x(xs.size() - 1), n_y(ys.size() - 1)
      {
        mesh.dimension = 2;
        for (const double y : ys)
          for (const double x : xs)
            mesh.vertices.push_back({{x, y, 0.}});
      }

      void
      cell(const std::string &body, const std::size_t i, const std::size_t j)
      {
        add(mesh.cells,
            CellShape::quadrilateral,
            group(2, body),
            {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }

      void
      row(const std::string &name,
          const std::size_t j,
          const std::size_t begin,
          const std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
          add(mesh.faces, CellShape::line, group(1, name), {vertex(i, j), vertex(i + 1, j)});
      }

      void
      column(const std::string &name,
             const std::size_t i,
             const std::size_t begin,
             const std::size_t end)
      {
        for (std::size_t j = begin; j < end; ++j)
          add(mesh.faces, CellShape::line, group(1, name), {vertex(i, j), vertex(i, j + 1)});
      }

      const std::size_t n_x, n_y;
      GmshMesh mesh;

    private:
      unsigned int
      vertex(const std::size_t i, const std::size_t j) const
      {
        return static_cast<unsigned int>(i + (n_x + 1) * j);
      }

      int
      group(const unsigned int dimension, const std::string &name)
      {
        const auto [entry, is_new] = groups.try_emplace(name, static_cast<int>(groups.size()) + 1);
        if (is_new)
          mesh.physical_names[{dimension, entry->second}] = name;
        return entry->second;
      }

      static void
      add(std::vector<MeshEntity> &list,
          const CellShape shape,
          const int tag,
          const std::vector<unsigned int> &vertices)
      {
        MeshEntity entity;
        entity.shape        = shape;
        entity.physical_tag = tag;
        std::copy(vertices.begin(), vertices.end(), entity.vertices.begin());
        list.push_back(entity);
      }

      std::map<std::string, int> groups;
    };
  } // namespace

  GmshMesh
  blocks_mesh(const Axis &xs,
              const Axis &ys,
              const std::size_t n,
              const std::vector<std::vector<std::string>> &bodies,
              const std::vector<InnerLine> &lines)
  {
    Builder builder(refined(xs, n), refined(ys, n));
    for (std::size_t j = 0; j < builder.n_y; ++j)
      for (std::size_t i = 0; i < builder.n_x; ++i)
        builder.cell(bodies[j / n][i / n], i, j);
    builder.row("bottom", 0, 0, builder.n_x);
    builder.row("top", builder.n_y, 0, builder.n_x);
    builder.column("left", 0, 0, builder.n_y);
    builder.column("right", builder.n_x, 0, builder.n_y);
    for (const InnerLine &line : lines)
      if (line.horizontal)
        builder.row(line.name, line.border * n, line.begin * n, line.end * n);
      else
        builder.column(line.name, line.border * n, line.begin * n, line.end * n);
    return builder.mesh;
  }
} // namespace fuga::tests
