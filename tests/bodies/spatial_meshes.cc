// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "spatial_meshes.h"

#include "block_mesh.h"

namespace fuga::test
{
  JointedMesh
  extruded(const JointedMesh &plane, const unsigned int n)
  {
    JointedMesh mesh = plane;
    mesh.dimension   = 3;
    mesh.vertices.clear();
    mesh.cells.clear();
    mesh.faces.clear();
    const auto in_layer = [&](const unsigned int vertex, const unsigned int layer) {
      return vertex + layer * static_cast<unsigned int>(plane.vertices.size());
    };
    for (unsigned int layer = 0; layer <= n; ++layer)
      for (const auto &vertex : plane.vertices)
        mesh.vertices.push_back({{vertex[0], vertex[1], 0.5 * layer}});
    for (unsigned int layer = 0; layer < n; ++layer)
      {
        for (JointedMesh::Cell cell : plane.cells)
          {
            cell.shape = CellShape::hexahedron;
            for (unsigned int v = 0; v < 4; ++v)
              {
                cell.vertices[v + 4] = in_layer(cell.vertices[v], layer + 1);
                cell.vertices[v]     = in_layer(cell.vertices[v], layer);
              }
            mesh.cells.push_back(cell);
          }
        for (JointedMesh::Face face : plane.faces)
          {
            const auto line = face.vertices;
            face.shape      = CellShape::quadrilateral;
            face.vertices   = {{in_layer(line[0], layer),
                                in_layer(line[1], layer),
                                in_layer(line[1], layer + 1),
                                in_layer(line[0], layer + 1)}};
            mesh.faces.push_back(face);
          }
      }
    return mesh;
  }

  JointedMesh
  narrow_block()
  {
    BlockMesh mesh;
    mesh.add_block("a", 6, 2, rectangle(-1., 2., -1., 0.), {{"b", "r", "J-", "l"}});
    mesh.add_block("b", 2, 2, rectangle(0., 1., 0., 1.), {{"J+", "r", "t", "l"}});
    mesh.add_joint("J", "J+", "J-");
    const unsigned int free = mesh.label("free"), lower = mesh.label("J-");
    for (auto &face : mesh.mesh.faces)
      if (const double x =
            (mesh.mesh.vertices[face.vertices[0]][0] + mesh.mesh.vertices[face.vertices[1]][0]) /
            2.;
          face.label == lower && (x < 0. || x > 1.))
        face.label = free;
    return extruded(mesh.mesh, 3);
  }
} // namespace fuga::test
