// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/input_errors.h>
#include <fuga/bodies/elasticity/boundary_conditions.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/discretization.h>

#include <algorithm>

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
                  const ModelDefinition &model)
  {
    std::vector<bool> fixed(discretization.n_dofs(), false);
    for (const auto &condition : model.boundary_conditions)
      if (!condition.named_free)
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
  template std::vector<unsigned int>
  nodes_of_target(const Discretization<2> &, const JointedMesh &, const std::string &);
  template std::vector<unsigned int>
  nodes_of_target(const Discretization<3> &, const JointedMesh &, const std::string &);
  template std::vector<bool>
  find_fixed_dofs(const Discretization<2> &, const JointedMesh &, const ModelDefinition &);
  template std::vector<bool>
  find_fixed_dofs(const Discretization<3> &, const JointedMesh &, const ModelDefinition &);
} // namespace fuga
