// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>

#include <fuga/bodies/hanging_nodes.h>

namespace fuga
{
  template <int dim>
  HangingNodes<dim>::HangingNodes(const dealii::DoFHandler<dim, dim> &dofs,
                                  const std::vector<unsigned int> &node_dofs)
  {
    dealii::AffineConstraints<double> constraints;
    dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
    constraints.close();
    std::map<dealii::types::global_dof_index, unsigned int> node_of_dof;
    for (unsigned int node = 0; node < node_dofs.size() / dim; ++node)
      node_of_dof[node_dofs[node * dim]] = node;
    for (const auto &[dof, node] : node_of_dof)
      if (const auto *entries = constraints.get_constraint_entries(dof))
        for (const auto &[master, weight] : *entries)
          all_masters[node].emplace_back(node_of_dof.at(master), weight);
  }


  template <int dim>
  void
  HangingNodes<dim>::move_to_masters(Vector &forces) const
  {
    for (const auto &[node, masters] : all_masters)
      for (unsigned int c = 0; c < dim; ++c)
        {
          for (const auto &[master, weight] : masters)
            forces[master * dim + c] += weight * forces[node * dim + c];
          forces[node * dim + c] = 0.;
        }
  }


  template <int dim>
  void
  HangingNodes<dim>::follow_masters(Vector &displacements) const
  {
    for (const auto &[node, masters] : all_masters)
      for (unsigned int c = 0; c < dim; ++c)
        {
          displacements[node * dim + c] = 0.;
          for (const auto &[master, weight] : masters)
            displacements[node * dim + c] += weight * displacements[master * dim + c];
        }
  }


  template class HangingNodes<2>;
  template class HangingNodes<3>;
} // namespace fuga
