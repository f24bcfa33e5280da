// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/files/table.h>
#include <fuga/output/tables/boundary_table.h>

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace fuga
{
  namespace
  {
    /** Return for each face the body that it is a face of, i.e. the body of the cell that has all
     * of its vertices. */
    std::vector<unsigned int>
    bodies_of_faces(const JointedMesh &mesh)
    {
      std::vector<std::vector<unsigned int>> cells(mesh.vertices.size());
      for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
        for (unsigned int k = 0; k < n_vertices(mesh.cells[cell].shape); ++k)
          cells[mesh.cells[cell].vertices[k]].push_back(cell);
      std::vector<unsigned int> bodies;
      for (const JointedMesh::Face &face : mesh.faces)
        {
          const auto has_all = [&](const unsigned int cell) {
            const auto &found = mesh.cells[cell].vertices;
            const auto end    = found.begin() + n_vertices(mesh.cells[cell].shape);
            return std::all_of(face.vertices.begin(),
                               face.vertices.begin() + n_vertices(face.shape),
                               [&](const unsigned int vertex) {
                                 return std::find(found.begin(), end, vertex) != end;
                               });
          };
          const auto &around = cells[face.vertices[0]];
          bodies.push_back(mesh.cells[*std::find_if(around.begin(), around.end(), has_all)].body);
        }
      return bodies;
    }

    struct Row
    {
      const std::string &boundary, &joint, &body;
      const JointedMesh::Face &face;
    };

    Columns<Row>
    boundary_columns(const JointedMesh &mesh, const Units &units)
    {
      Columns<Row> columns = {{"boundary", "", [](const Row &row) { return row.boundary; }},
                              {"joint", "", [](const Row &row) { return row.joint; }},
                              {"body", "", [](const Row &row) { return row.body; }}};
      for (unsigned int k = 0; k < (mesh.dimension == 2 ? 2 : 4); ++k)
        for (unsigned int c = 0; c < 3; ++c)
          append(
            columns,
            {{fmt::format("{}{}", "xyz"[c], k + 1), units.length, [&mesh, k, c](const Row &row) {
                const unsigned int corner = std::min(k, n_vertices(row.face.shape) - 1);
                return mesh.vertices[row.face.vertices[corner]][c];
              }}});
      return columns;
    }
  } // namespace

  void
  write_boundary_table(const std::string &directory, const JointedMesh &mesh, const Units &units)
  {
    std::vector<std::string> joints(mesh.label_names.size());
    for (const JointedMesh::Joint &joint : mesh.joints)
      for (const unsigned int label : {joint.plus_label, joint.minus_label})
        if (label != JointedMesh::no_label)
          joints[label] = joint.name;
    const std::vector<unsigned int> bodies = bodies_of_faces(mesh);
    Table<Row> table(directory + "/boundaries.csv", boundary_columns(mesh, units));
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
      {
        const JointedMesh::Face &face = mesh.faces[i];
        table.add(
          {mesh.label_names[face.label], joints[face.label], mesh.body_names[bodies[i]], face});
      }
    table.publish(true);
  }
} // namespace fuga
