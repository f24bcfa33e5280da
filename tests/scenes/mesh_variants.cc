// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/mesh_variants.h"

#include "scenes/scene_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <random>

namespace fuga::tests
{
  GmshMesh
  renumbered(GmshMesh mesh, const unsigned int seed)
  {
    std::mt19937 random(seed);
    std::vector<unsigned int> number(mesh.vertices.size());
    std::iota(number.begin(), number.end(), 0u);
    std::shuffle(number.begin(), number.end(), random);
    const auto old_vertices = mesh.vertices;
    for (std::size_t v = 0; v < number.size(); ++v)
      mesh.vertices[number[v]] = old_vertices[v];
    for (auto *entities : {&mesh.cells, &mesh.faces, &mesh.points})
      {
        for (MeshEntity &entity : *entities)
          {
            const unsigned int n = n_vertices(entity.shape);
            for (unsigned int i = 0; i < n; ++i)
              entity.vertices[i] = number[entity.vertices[i]];
            const auto first = entity.vertices.begin();
            std::rotate(first, first + random() % n, first + n);
          }
        std::shuffle(entities->begin(), entities->end(), random);
      }
    return mesh;
  }

  GmshMesh
  mirrored(GmshMesh mesh)
  {
    for (auto &vertex : mesh.vertices)
      vertex[0] = -vertex[0];
    for (auto *entities : {&mesh.cells, &mesh.faces})
      for (MeshEntity &entity : *entities)
        std::reverse(entity.vertices.begin(), entity.vertices.begin() + n_vertices(entity.shape));
    return mesh;
  }

  GmshMesh
  scaled(GmshMesh mesh, const double factor)
  {
    for (auto &vertex : mesh.vertices)
      for (double &x : vertex)
        x *= factor;
    return mesh;
  }

  std::string
  write_mesh(const GmshMesh &mesh)
  {
    const std::string name = temporary_directory() + "/mesh.msh";
    std::ofstream file(name);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
         << mesh.physical_names.size() << '\n';
    for (const auto &[key, text] : mesh.physical_names)
      file << fmt::format("{} {} \"{}\"\n", key.first, key.second, text);
    file << "$EndPhysicalNames\n$Nodes\n" << mesh.vertices.size() << '\n';
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      file << fmt::format(
        "{} {} {} {}\n", v + 1, mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]);
    file << "$EndNodes\n$Elements\n"
         << mesh.cells.size() + mesh.faces.size() + mesh.points.size() << '\n';
    std::size_t n = 0;
    for (const auto *entities : {&mesh.points, &mesh.faces, &mesh.cells})
      for (const MeshEntity &entity : *entities)
        {
          const int type = entity.shape == CellShape::point           ? 15
                           : entity.shape == CellShape::line          ? 1
                           : entity.shape == CellShape::triangle      ? 2
                           : entity.shape == CellShape::quadrilateral ? 3
                           : entity.shape == CellShape::tetrahedron   ? 4
                                                                      : 5;
          file << fmt::format("{} {} 2 {} {}", ++n, type, entity.physical_tag, entity.physical_tag);
          for (unsigned int i = 0; i < n_vertices(entity.shape); ++i)
            file << ' ' << entity.vertices[i] + 1;
          file << '\n';
        }
    file << "$EndElements\n";
    return name;
  }
} // namespace fuga::tests
