// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/fe/fe.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <fuga/bodies/processes.h>
#include <fuga/bodies/program/refinement_indicator.h>
#include <fuga/bodies/space/serial_cell_id.h>

#include <algorithm>
#include <numeric>

namespace fuga
{
  template <int dim>
  Vector
  refinement_indicator(const CondensedSystem<dim> &coarse,
                       const dealii::Vector<double> &u_coarse,
                       const CondensedSystem<dim> &fine,
                       const dealii::Vector<double> &u_fine)
  {
    // Children follow each other in the tables, in the order of their parents.
    constexpr std::size_t n_children   = 1u << dim;
    const Discretization<dim> &parents = coarse.discretization(), &children = fine.discretization();
    const auto &element    = parents.reference_element().scalar_element();
    Vector difference      = children.by_nodes(u_fine);
    const Vector u_parents = parents.by_nodes(u_coarse);
    std::vector<bool> is_done(children.n_nodes(), false);
    for (std::size_t cell = 0; cell < children.n_cells(); ++cell)
      {
        const unsigned int *nodes  = children.cell_nodes(cell),
                           *around = parents.cell_nodes(cell / n_children);
        const auto &values =
          element.get_prolongation_matrix(static_cast<unsigned int>(cell % n_children));
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          if (!is_done[nodes[i]])
            {
              is_done[nodes[i]] = true;
              for (unsigned int k = 0; k < element.n_dofs_per_cell(); ++k)
                for (unsigned int c = 0; c < dim; ++c)
                  difference[nodes[i] * dim + c] -= values(i, k) * u_parents[around[k] * dim + c];
            }
      }

    const Vector energies = fine.cell_energies(difference);
    Vector result(parents.n_cells(), 0.);
    for (std::size_t cell = 0; cell < children.n_cells(); ++cell)
      // Where only rigid motions differ, the rounding error may have either sign.
      result[cell / n_children] += std::max(0., energies[cell]);
    return result;
  }


  template <int dim>
  std::vector<CellKey>
  mark_cells(const CondensedSystem<dim> &system, const Vector &indicator, const double share)
  {
    const Discretization<dim> &space = system.discretization();
    std::vector<std::size_t> order(indicator.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
      return indicator[a] > indicator[b] || (indicator[a] == indicator[b] && a < b);
    });
    const double total = std::accumulate(indicator.begin(), indicator.end(), 0.);
    std::vector<bool> marked(indicator.size(), false);
    double sum = 0.;
    for (const std::size_t cell : order)
      {
        if (sum >= share * total)
          break;
        marked[cell] = true;
        sum += indicator[cell];
      }
    std::vector<CellKey> keys;
    for (const auto &cell : space.triangulation().active_cell_iterators())
      if (const unsigned int number = space.cell_number(cell->active_cell_index());
          number != Discretization<dim>::no_cell && marked[number])
        keys.push_back(serial_cell_id(cell).template to_binary<dim>());
    return processes::gather(std::move(keys));
  }


  template Vector
  refinement_indicator(const CondensedSystem<2> &,
                       const dealii::Vector<double> &,
                       const CondensedSystem<2> &,
                       const dealii::Vector<double> &);
  template Vector
  refinement_indicator(const CondensedSystem<3> &,
                       const dealii::Vector<double> &,
                       const CondensedSystem<3> &,
                       const dealii::Vector<double> &);
  template std::vector<CellKey>
  mark_cells(const CondensedSystem<2> &, const Vector &, const double);
  template std::vector<CellKey>
  mark_cells(const CondensedSystem<3> &, const Vector &, const double);
} // namespace fuga
