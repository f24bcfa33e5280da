// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/base/similar_names.h>
#include <fuga/mesh/cell_geometry.h>
#include <fuga/mesh/joint_resolver.h>

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace fuga
{
  JointResolver::JointResolver(const GmshMesh &gmsh,
                               const JointedMesh &jointed,
                               const FaceTable &faces,
                               const std::vector<JointDefinition> &definitions)
    : mesh(gmsh), open_mesh(jointed), table(faces), joints(definitions)
  {
  }


  ResolvedFaces
  JointResolver::run()
  {
    collect_groups();
    check_names_differ();
    ResolvedFaces result;
    result.openings.resize(joints.size());
    InputErrors errors;
    for (unsigned int j = 0; j < joints.size(); ++j)
      errors.attempt([&]() { claim(j, result.openings[j]); });
    errors.throw_if_any();
    for (const Group &g : groups)
      if (g.joint == FaceTable::none)
        {
          for (const unsigned int half_face : g.half_faces)
            {
              if (table.neighbour(half_face) != FaceTable::none)
                throw InputError(fmt::format("{}: group '{}' lies inside the mesh, at {} between "
                                             "'{}' and '{}', and no joint uses "
                                             "it; groups "
                                             "of faces belong to the outer boundary or to a joint; "
                                             "define a joint with this line "
                                             "or remove "
                                             "the physical group",
                                             mesh.file_name,
                                             g.name,
                                             centre_of(half_face),
                                             body_of(half_face),
                                             body_of(table.neighbour(half_face))));
              result.outer.push_back(
                {half_face, static_cast<unsigned int>(result.group_names.size())});
            }
          result.group_names.push_back(g.name);
        }
    return result;
  }


  void
  JointResolver::collect_groups()
  {
    std::map<int, Group> by_tag;
    std::vector<const Group *> owner(table.n_half_faces(), nullptr);
    for (const MeshEntity &face : mesh.faces)
      {
        Group &g = by_tag[face.physical_tag];
        if (g.name.empty())
          {
            const auto name = mesh.physical_names.find({mesh.dimension - 1, face.physical_tag});
            g.name = name == mesh.physical_names.end() ? fmt::format("{}", face.physical_tag)
                                                       : name->second;
          }
        std::array<unsigned int, 4> vertices{};
        std::copy_n(face.vertices.begin(),
                    n_vertices(face.shape) <= 4 ? n_vertices(face.shape) : 4,
                    vertices.begin());
        const bool fits              = face.shape == face_shape(open_mesh.cells.front().shape);
        const unsigned int half_face = fits ? table.find(vertices) : FaceTable::none;
        if (half_face == FaceTable::none)
          throw InputError(fmt::format(
            "{}: group '{}' has a face at {} that is a face of no cell; boundaries and joint lines "
            "must "
            "consist of faces of the mesh; mesh line and bodies together (Coherence, or "
            "Curve{{..}} In Surface)",
            mesh.file_name,
            g.name,
            face_centre(face.shape, vertices, mesh.vertices)));
        if (owner[half_face] != nullptr)
          throw InputError(fmt::format(
            "{}: the face at {} is in the groups '{}' and '{}'; allowed is one; take it out "
            "of all but one Physical list in the geometry",
            mesh.file_name,
            centre_of(half_face),
            owner[half_face]->name,
            g.name));
        owner[half_face] = &g;
        g.half_faces.push_back(half_face);
        g.drawn.push_back(vertices);
      }
    for (auto &[tag, g] : by_tag)
      groups.push_back(std::move(g));
  }


  JointResolver::Group &
  JointResolver::group(const JointDefinition &joint, const std::string &name)
  {
    for (Group &g : groups)
      if (g.name == name)
        return g;
    std::vector<std::string> names;
    for (const Group &g : groups)
      names.push_back(g.name);
    fail(
      joint,
      fmt::format(
        "there is no group of faces '{}' in {}; the groups there are '{}'; correct the name or add "
        "Physical {}(\"{}\") to the geometry{}",
        name,
        mesh.file_name,
        fmt::join(names, "', '"),
        mesh.dimension == 2 ? "Curve" : "Surface",
        name,
        did_you_mean(name, names, ". ")));
  }


  void
  JointResolver::claim(const unsigned int j, std::vector<ResolvedFaces::Opening> &openings)
  {
    const JointDefinition &joint = joints[j];
    check_definition(joint);
    if (!joint.line.empty())
      {
        claim_line(j);
        const Group &line = group(joint, joint.line);
        for (std::size_t f = 0; f < line.half_faces.size(); ++f)
          openings.push_back(opening(joint, line, f));
        return;
      }
    claim_lip(joint, joint.plus_lip, joint.plus_body);
    if (!joint.against_rigid)
      {
        claim_lip(joint, joint.minus_lip, joint.minus_body);
        check_lengths(joint);
      }
  }


  void
  JointResolver::claim_line(const unsigned int j)
  {
    Group &line = group(joints[j], joints[j].line);
    if (line.joint != FaceTable::none)
      fail(joints[j],
           fmt::format(
             "its line '{}' is already that of joint '{}'; a line belongs to one joint; split the "
             "line into "
             "two groups or remove one joint",
             line.name,
             joints[line.joint].name));
    line.joint = j;
    if (joints[j].plus_body == joints[j].minus_body)
      check_direction(joints[j], line);
  }


  ResolvedFaces::Opening
  JointResolver::opening(const JointDefinition &joint,
                         const Group &line,
                         const std::size_t face) const
  {
    const unsigned int a = line.half_faces[face];
    const unsigned int b = table.neighbour(a);
    if (b == FaceTable::none)
      fail(
        joint,
        fmt::format(
          "its line '{}' is on the outer boundary at {}, only the body '{}' is there; a joint line "
          "must "
          "have a body on either side; if the mesh is already open there, state plus lip and minus "
          "lip "
          "instead",
          line.name,
          centre_of(a),
          body_of(a)));
    if (joint.plus_body == joint.minus_body && body_of(a) == joint.plus_body &&
        body_of(b) == joint.plus_body)
      {
        // In 2D a cell has the same direction as the line if it is to its left, which is plus. In
        // 3D the drawn normal points away from the cell of the same direction, which is therefore
        // minus.
        const bool a_is_plus =
          table.same_direction(vertices_of(a), line.drawn[face]) == (mesh.dimension == 2);
        return a_is_plus ? ResolvedFaces::Opening{a, b} : ResolvedFaces::Opening{b, a};
      }
    if (body_of(a) == joint.plus_body && body_of(b) == joint.minus_body)
      return {a, b};
    if (body_of(b) == joint.plus_body && body_of(a) == joint.minus_body)
      return {b, a};
    fail(
      joint,
      fmt::format(
        "its line '{}' lies at {} between '{}' and '{}', but the joint is between '{}' and '{}'; "
        "correct "
        "the bodies or split the line into one group for each pair of bodies",
        line.name,
        centre_of(a),
        body_of(a),
        body_of(b),
        joint.plus_body,
        joint.minus_body));
  }


  void
  JointResolver::claim_lip(const JointDefinition &joint,
                           const std::string &lip,
                           const std::string &body)
  {
    const Group &g = group(joint, lip);
    if (g.joint != FaceTable::none || std::find(lips.begin(), lips.end(), lip) != lips.end())
      fail(joint,
           fmt::format("its lip '{}' is already part of a joint; a boundary belongs to one lip; "
                       "split it into two "
                       "groups or correct the name",
                       lip));
    lips.push_back(lip);
    for (const unsigned int half_face : g.half_faces)
      {
        if (table.neighbour(half_face) != FaceTable::none)
          fail(joint,
               fmt::format("its lip '{}' lies inside the mesh, at {} between '{}' and '{}': the "
                           "mesh is not open "
                           "there; "
                           "state it as line, with both bodies, and the mesh will be opened",
                           lip,
                           centre_of(half_face),
                           body_of(half_face),
                           body_of(table.neighbour(half_face))));
        if (!body.empty() && body_of(half_face) != body)
          fail(joint,
               fmt::format("its lip '{}' belongs to the body '{}' at {}, not to '{}'; correct the "
                           "body or the lip",
                           lip,
                           body_of(half_face),
                           centre_of(half_face),
                           body));
      }
  }


  std::array<unsigned int, 4>
  JointResolver::vertices_of(const unsigned int half_face) const
  {
    return face_vertices(open_mesh.cells[table.cell(half_face)], table.local_face(half_face));
  }


  const std::string &
  JointResolver::body_of(const unsigned int half_face) const
  {
    return open_mesh.body_names[open_mesh.cells[table.cell(half_face)].body];
  }


  std::string
  JointResolver::centre_of(const unsigned int half_face) const
  {
    return face_centre(
      face_shape(open_mesh.cells.front().shape), vertices_of(half_face), mesh.vertices);
  }


  void
  JointResolver::fail(const JointDefinition &joint, const std::string &message) const
  {
    throw InputError(fmt::format("joint '{}': {}", joint.name, message));
  }
} // namespace fuga
