// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <fuga/bodies/refinement_indicator.h>

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
    const Discretization<dim> &parents = coarse.discretization(), &children = fine.discretization();
    dealii::Vector<double> difference(children.dof_handler().n_dofs());
    dealii::AffineConstraints<double> none;
    none.close();
    dealii::VectorTools::interpolate_to_different_mesh(
      parents.dof_handler(), u_coarse, children.dof_handler(), none, difference);
    difference -= u_fine;

    const Vector energies = fine.cell_energies(difference);
    Vector result(parents.n_cells(), 0.);
    for (const auto &cell : children.triangulation().active_cell_iterators())
      {
        const auto parent = parents.triangulation().create_cell_iterator(cell->parent()->id());
        // Where only rigid motions differ, rounding may have either sign.
        result[parents.cell_number(parent->active_cell_index())] +=
          std::max(0., energies[children.cell_number(cell->active_cell_index())]);
      }
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
        keys.push_back(cell->id().template to_binary<dim>());
    return keys;
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
