// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>

#include <fuga/bodies/processes.h>
#include <fuga/bodies/space/hanging_nodes.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** A term of the sum that gives u of one degree of freedom. */
    struct Term
    {
      unsigned int dof, master;
      double weight;
    };

    /** Return the terms in the first direction. A process knows which nodes hang on its cells and
     * their neighbours; whether the masters themselves hang is known only when all terms are
     * collected. */
    template <int dim>
    std::vector<Term>
    terms_of_all_processes(const dealii::DoFHandler<dim, dim> &dofs,
                           const std::vector<unsigned int> &node_of_dof,
                           const unsigned int n_nodes)
    {
      dealii::IndexSet known;
      dealii::DoFTools::extract_locally_relevant_dofs(dofs, known);
      dealii::AffineConstraints<double> constraints(known);
      dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
      std::vector<Term> terms;
      for (const auto &line : constraints.get_lines())
        if (node_of_dof[line.index] < n_nodes)
          for (const auto &[master, weight] : line.entries)
            terms.push_back({line.index, master, weight});
      return processes::gather(std::move(terms));
    }
  } // namespace


  template <int dim>
  HangingNodes<dim>::HangingNodes(const dealii::DoFHandler<dim, dim> &dofs,
                                  const std::vector<unsigned int> &node_of_dof,
                                  const unsigned int n_nodes)
  {
    dealii::AffineConstraints<double> constraints; // these merge terms that several processes have
    for (const Term &term : terms_of_all_processes(dofs, node_of_dof, n_nodes))
      {
        constraints.add_line(term.dof);
        constraints.add_entry(term.dof, term.master, term.weight);
      }
    constraints.close();
    for (const auto &line : constraints.get_lines())
      for (const auto &[master, weight] : line.entries)
        all_masters[node_of_dof[line.index]].emplace_back(node_of_dof[master], weight);
    for (auto &of_one : all_masters)
      std::sort(of_one.second.begin(), of_one.second.end());
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


  template class HangingNodes<2>;
  template class HangingNodes<3>;
} // namespace fuga
