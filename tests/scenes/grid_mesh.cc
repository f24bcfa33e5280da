// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/grid_mesh.h"

#include "scenes/mesh_variants.h"
#include "scenes/scene_run.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace fuga::tests
{
  Axis
  uniform(const double begin, const double end, const std::size_t n)
  {
    Axis axis;
    for (std::size_t i = 0; i <= n; ++i)
      axis.push_back(begin + (end - begin) * static_cast<double>(i) / static_cast<double>(n));
    return axis;
  }

  Axis
  growing(const double begin, const double end, const double h, const double growth)
  {
    std::vector<double> sizes = {h};
    double sum                = h;
    while (sum < end - begin)
      {
        sizes.push_back(sizes.back() * growth);
        sum += sizes.back();
      }
    Axis axis = {begin};
    for (const double size : sizes)
      axis.push_back(axis.back() + size * (end - begin) / sum);
    axis.back() = end;
    return axis;
  }

  Axis
  joined(Axis first, const Axis &second)
  {
    first.insert(first.end(), second.begin() + 1, second.end());
    return first;
  }

  Axis
  both_sides(const Axis &axis)
  {
    Axis result;
    for (std::size_t i = axis.size(); i-- > 1;)
      result.push_back(-axis[i]);
    result.insert(result.end(), axis.begin(), axis.end());
    return result;
  }

  namespace
  {
    /** The vertices of a grid, and its pieces under names. */
    class Grid
    {
    public:
      Grid(const Axis &xs, const Axis &ys) : n_x(xs.size() - 1), n_y(ys.size() - 1)
      {
        mesh.dimension = 2;
        for (const double y : ys)
          for (const double x : xs)
            mesh.vertices.push_back({{x, y, 0.}});
      }

      void
      cells(const char *name, const std::size_t first_row, const std::size_t end_row)
      {
        const int group = new_group(2, name);
        for (std::size_t j = first_row; j < end_row; ++j)
          for (std::size_t i = 0; i < n_x; ++i)
            add(mesh.cells,
                CellShape::quadrilateral,
                group,
                {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }

      void
      row(const char *name, const std::size_t j, const std::size_t begin, const std::size_t end)
      {
        const int group = new_group(1, name);
        for (std::size_t i = begin; i < end; ++i)
          add(mesh.faces, CellShape::line, group, {vertex(i, j), vertex(i + 1, j)});
      }

      void
      column(const char *name, const std::size_t i)
      {
        const int group = new_group(1, name);
        for (std::size_t j = 0; j < n_y; ++j)
          add(mesh.faces, CellShape::line, group, {vertex(i, j), vertex(i, j + 1)});
      }

      void
      point(const char *name, const std::size_t i, const std::size_t j)
      {
        add(mesh.points, CellShape::point, new_group(0, name), {vertex(i, j)});
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
      new_group(const unsigned int dimension, const char *name)
      {
        const int tag                         = ++n_groups;
        mesh.physical_names[{dimension, tag}] = name;
        return tag;
      }

      static void
      add(std::vector<MeshEntity> &list,
          const CellShape shape,
          const int group,
          const std::vector<unsigned int> &vertices)
      {
        MeshEntity entity;
        entity.shape        = shape;
        entity.physical_tag = group;
        std::copy(vertices.begin(), vertices.end(), entity.vertices.begin());
        list.push_back(entity);
      }

      int n_groups = 0;
    };
  } // namespace

  GmshMesh
  block_mesh(const Axis &xs, const Axis &ys, const double contact_end)
  {
    Grid grid(xs, ys);
    std::size_t end = 0;
    for (std::size_t i = 0; i < xs.size(); ++i)
      if (std::abs(xs[i] - contact_end) < std::abs(xs[end] - contact_end))
        end = i;
    grid.cells("block", 0, grid.n_y);
    grid.row("contact", 0, 0, end);
    if (end < grid.n_x)
      grid.row("bottom_free", 0, end, grid.n_x);
    grid.row("top", grid.n_y, 0, grid.n_x);
    grid.column("left", 0);
    grid.column("right", grid.n_x);
    grid.point("corner", grid.n_x, 0);
    return grid.mesh;
  }

  GmshMesh
  two_blocks_mesh(const Axis &xs, const Axis &ys)
  {
    Grid grid(xs, both_sides(ys));
    const std::size_t middle = ys.size() - 1;
    grid.cells("lower", 0, middle);
    grid.cells("upper", middle, grid.n_y);
    grid.row("joint", middle, 0, grid.n_x);
    grid.row("bottom", 0, 0, grid.n_x);
    grid.row("top", grid.n_y, 0, grid.n_x);
    grid.column("left", 0);
    grid.column("right", grid.n_x);
    return grid.mesh;
  }

  GmshMesh
  extruded(const GmshMesh &plane, const Axis &zs)
  {
    GmshMesh mesh;
    mesh.dimension    = 3;
    const auto n      = static_cast<unsigned int>(plane.vertices.size());
    const auto last   = static_cast<unsigned int>(zs.size() - 1);
    int largest_group = 0;
    for (const double z : zs)
      for (const auto &vertex : plane.vertices)
        mesh.vertices.push_back({{vertex[0], vertex[1], z}});
    for (const auto &[key, name] : plane.physical_names)
      if (key.first > 0)
        {
          mesh.physical_names[{key.first + 1, key.second}] = name;
          largest_group                                    = std::max(largest_group, key.second);
        }
    const auto add = [](std::vector<MeshEntity> &list,
                        const CellShape shape,
                        const int group,
                        const std::vector<unsigned int> &vertices) {
      MeshEntity entity;
      entity.shape        = shape;
      entity.physical_tag = group;
      std::copy(vertices.begin(), vertices.end(), entity.vertices.begin());
      list.push_back(entity);
    };
    mesh.physical_names[{2, largest_group + 1}] = "front";
    mesh.physical_names[{2, largest_group + 2}] = "back";
    for (const MeshEntity &cell : plane.cells)
      {
        const auto &v  = cell.vertices;
        const auto end = [&](const unsigned int k) {
          return std::vector<unsigned int>{v[0] + k * n, v[1] + k * n, v[2] + k * n, v[3] + k * n};
        };
        for (unsigned int k = 0; k < last; ++k)
          {
            std::vector<unsigned int> vertices = end(k), behind = end(k + 1);
            vertices.insert(vertices.end(), behind.begin(), behind.end());
            add(mesh.cells, CellShape::hexahedron, cell.physical_tag, vertices);
          }
        add(mesh.faces, CellShape::quadrilateral, largest_group + 1, end(0));
        add(mesh.faces, CellShape::quadrilateral, largest_group + 2, end(last));
      }
    for (const MeshEntity &face : plane.faces)
      for (unsigned int k = 0; k < last; ++k)
        add(mesh.faces,
            CellShape::quadrilateral,
            face.physical_tag,
            {face.vertices[0] + k * n,
             face.vertices[1] + k * n,
             face.vertices[1] + (k + 1) * n,
             face.vertices[0] + (k + 1) * n});
    return mesh;
  }

  std::string
  write_scene(const GmshMesh &mesh, nlohmann::ordered_json parameters)
  {
    parameters["Mesh"]["File"] = write_mesh(mesh);
    const std::string name     = temporary_directory() + "/scene.json";
    std::ofstream(name) << parameters.dump(1);
    return name;
  }
} // namespace fuga::tests
