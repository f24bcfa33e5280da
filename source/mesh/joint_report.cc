// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/mesh/cell_geometry.h>
#include <fuga/mesh/joint_report.h>

#include <fmt/format.h>
#include <set>

namespace fuga
{
  namespace
  {
    struct Lip
    {
      unsigned int n_faces = 0;
      double measure       = 0;
      std::set<unsigned int> vertices;
    };

    /** Collect a lip; vertices are counted as they were in the closed mesh. */
    Lip
    collect(const JointedMesh &mesh, const unsigned int label, const SplitVertices &split_vertices)
    {
      Lip lip;
      for (const JointedMesh::Face &face : mesh.faces)
        if (face.label == label)
          {
            ++lip.n_faces;
            lip.measure += face_measure(face.shape, face.vertices, mesh.vertices);
            for (unsigned int i = 0; i < n_vertices(face.shape); ++i)
              {
                const auto original = split_vertices.originals.find(face.vertices[i]);
                lip.vertices.insert(original == split_vertices.originals.end() ? face.vertices[i]
                                                                               : original->second);
              }
          }
      return lip;
    }

    std::string
    count(const unsigned int n, const char *singular, const char *plural)
    {
      return fmt::format("{} {}", n, n == 1 ? singular : plural);
    }

    /** Return "face" or "faces" of a lip, with its length or area. */
    std::string
    describe_extent(const JointedMesh &mesh, const Lip &lip)
    {
      return fmt::format("{}, {} {:.10g}",
                         count(lip.n_faces, "face", "faces"),
                         mesh.dimension == 2 ? "length" : "area",
                         lip.measure);
    }

    std::string
    describe_normal(const JointedMesh &mesh, const JointDefinition &definition)
    {
      if (definition.plus_body.empty() || definition.minus_body.empty())
        return fmt::format("normal from {} to {}", definition.minus_lip, definition.plus_lip);
      if (definition.plus_body == definition.minus_body && !definition.line.empty())
        return mesh.dimension == 2 ? "normal to the left of the line"
                                   : "normal as that of the drawn surface";
      return fmt::format("normal from {} to {}", definition.minus_body, definition.plus_body);
    }

    std::string
    describe_split(const JointedMesh &mesh, const Lip &lip, const SplitVertices &split_vertices)
    {
      unsigned int tips = 0, doubled = 0, branches = 0;
      for (const unsigned int vertex : lip.vertices)
        {
          const unsigned int n = split_vertices.n_copies.at(vertex);
          ++(n == 1 ? tips : n == 2 ? doubled : branches);
        }
      std::string text = fmt::format(
        "opened {}, {} doubled", describe_extent(mesh, lip), count(doubled, "vertex", "vertices"));
      if (branches > 0)
        text += fmt::format(", {} shared with other joints",
                            count(branches, "branch point", "branch points"));
      return text + fmt::format(", {} inside a body", count(tips, "tip", "tips"));
    }
  } // namespace


  std::string
  describe_joint(const JointedMesh &mesh,
                 const JointDefinition &definition,
                 const unsigned int joint,
                 const SplitVertices &split_vertices)
  {
    const JointedMesh::Joint &j = mesh.joints[joint];
    const Lip plus              = collect(mesh, j.plus_label, split_vertices);
    const std::string name      = fmt::format("joint '{}': ", definition.name);
    if (!definition.line.empty())
      return name + describe_split(mesh, plus, split_vertices) + ", " +
             describe_normal(mesh, definition);
    if (definition.against_rigid)
      return name + fmt::format("lip '{}' against a rigid obstacle, {}, normal into the body",
                                definition.plus_lip,
                                describe_extent(mesh, plus));
    const Lip minus = collect(mesh, j.minus_label, split_vertices);
    return name + fmt::format("open in the mesh between lip '{}' ({}) and lip '{}' ({}), {}",
                              definition.plus_lip,
                              describe_extent(mesh, plus),
                              definition.minus_lip,
                              describe_extent(mesh, minus),
                              describe_normal(mesh, definition));
  }
} // namespace fuga
