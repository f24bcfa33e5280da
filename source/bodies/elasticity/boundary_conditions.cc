// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/input_errors.h>
#include <fuga/bodies/elasticity/boundary_conditions.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/face_map.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  template <int dim>
  void
  check_outer_faces(const Discretization<dim> &discretization)
  {
    std::size_t count = 0;
    dealii::Point<dim> first;
    for (const auto &face : discretization.boundary_faces())
      if (face.label == JointedMesh::no_label && ++count == 1)
        first = discretization.face_center(face);
    if (count > 0)
      throw InputError(fmt::format(
        "{} faces of the outer boundary are in no physical group, the first at {}. Put "
        "every outer {} into a named group and say what holds there (named free if nothing "
        "does).",
        count,
        text_of(first),
        dim == 2 ? "line" : "surface"));
  }


  template <int dim>
  void
  check_absorbing_faces(const Discretization<dim> &discretization,
                        const JointedMesh &mesh,
                        const ModelDefinition &model)
  {
    const DynamicsDefinition &dynamics = model.dynamics;
    const std::vector<bool> is_base    = selection(mesh.label_names, dynamics.compliant_base.names);
    const std::vector<bool> is_side    = selection(mesh.label_names, dynamics.free_field.names);
    const Vector density               = mass_densities(mesh, model);
    for (const auto &face :
         discretization.boundary_faces(selection(mesh.label_names, dynamics.absorbing.names)))
      {
        const unsigned int body = discretization.cell_body(face.cell);
        if (density[body] == 0.)
          throw InputError(fmt::format(
            "{}: body '{}', which ends at the absorbing boundary '{}', has no mass, so that no "
            "waves arrive there. Give it its weight density, take it out of Dynamics/Massless "
            "bodies, or hold the boundary instead.",
            dynamics.absorbing.origin,
            mesh.body_names[body],
            mesh.label_names[face.label]));
        constexpr double straight = 1e-6;
        const FaceMap<dim> map(discretization, face);
        const auto &points = discretization.reference_element().face(face.number).points;
        const double slope = map.normal(points.front())[dim - 1];
        if (is_base[face.label] && !(std::abs(slope) > 1. - straight))
          throw InputError(fmt::format(
            "{}: waves come up vertically, through horizontal boundaries, but '{}' is inclined at "
            "{}. Let the model end at a horizontal base.",
            dynamics.compliant_base.origin,
            mesh.label_names[face.label],
            text_of(discretization.face_center(face))));
        if (is_side[face.label] && !(std::abs(slope) < straight))
          throw InputError(fmt::format(
            "{}: the free field is a column beside the model, whose side is vertical, but '{}' is "
            "inclined at {}. Let the model end at vertical sides.",
            dynamics.free_field.origin,
            mesh.label_names[face.label],
            text_of(discretization.face_center(face))));
      }
  }


  template <int dim>
  std::vector<unsigned int>
  nodes_of_target(const Discretization<dim> &discretization,
                  const JointedMesh &mesh,
                  const std::string &name)
  {
    std::vector<unsigned int> nodes;
    for (const unsigned int vertex : vertices_of_point(mesh, name))
      if (discretization.node_at_vertex(vertex) != Discretization<dim>::no_node)
        nodes.push_back(discretization.node_at_vertex(vertex));
    const unsigned int label = index_of(mesh.label_names, name);
    if (label < mesh.label_names.size())
      for (const auto &face : discretization.boundary_faces())
        if (face.label == label)
          for (std::size_t k = 0;
               k < discretization.reference_element().face(face.number).nodes.size();
               ++k)
            nodes.push_back(discretization.face_node(face, k));
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }


  template <int dim>
  std::vector<bool>
  find_fixed_dofs(const Discretization<dim> &discretization,
                  const JointedMesh &mesh,
                  const ModelDefinition &model,
                  const std::vector<std::string> &released)
  {
    std::vector<bool> fixed(discretization.n_dofs(), false);
    for (const auto &condition : model.boundary_conditions)
      if (!condition.named_free && index_of(released, condition.boundary) == released.size())
        for (const unsigned int node : nodes_of_target(discretization, mesh, condition.boundary))
          for (unsigned int c = 0; c < dim; ++c)
            if (condition.fixed[c])
              fixed[node * dim + c] = true;
    for (std::size_t node = 0; node < discretization.n_nodes(); ++node)
      if (discretization.is_on_axis(node))
        fixed[node * dim] = true;
    return fixed;
  }


  template void
  check_outer_faces(const Discretization<2> &);
  template void
  check_outer_faces(const Discretization<3> &);
  template void
  check_absorbing_faces(const Discretization<2> &, const JointedMesh &, const ModelDefinition &);
  template void
  check_absorbing_faces(const Discretization<3> &, const JointedMesh &, const ModelDefinition &);
  template std::vector<unsigned int>
  nodes_of_target(const Discretization<2> &, const JointedMesh &, const std::string &);
  template std::vector<unsigned int>
  nodes_of_target(const Discretization<3> &, const JointedMesh &, const std::string &);
  template std::vector<bool>
  find_fixed_dofs(const Discretization<2> &,
                  const JointedMesh &,
                  const ModelDefinition &,
                  const std::vector<std::string> &);
  template std::vector<bool>
  find_fixed_dofs(const Discretization<3> &,
                  const JointedMesh &,
                  const ModelDefinition &,
                  const std::vector<std::string> &);
} // namespace fuga
