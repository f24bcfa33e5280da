// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/cell_owners.h>
#include <fuga/bodies/processes.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Which cells share faces. */
    template <int dim>
    dealii::SparsityPattern
    neighbours(const Discretization<dim> &space)
    {
      const auto n = static_cast<dealii::types::global_dof_index>(space.n_cells());
      dealii::DynamicSparsityPattern pattern(n, n);
      for (const auto &cell : space.triangulation().active_cell_iterators())
        if (const unsigned int one = space.cell_number(cell->active_cell_index());
            one != Discretization<dim>::no_cell)
          {
            pattern.add(one, one);
            for (const unsigned int f : cell->face_indices())
              if (!cell->at_boundary(f) && cell->neighbor(f)->is_active())
                if (const unsigned int other =
                      space.cell_number(cell->neighbor(f)->active_cell_index());
                    other != Discretization<dim>::no_cell)
                  {
                    pattern.add(one, other);
                    pattern.add(other, one);
                  }
          }
      dealii::SparsityPattern result;
      result.copy_from(pattern);
      return result;
    }
  } // namespace


  template <int dim>
  std::vector<unsigned int>
  cell_owners(const Discretization<dim> &space, const unsigned int n_processes)
  {
    std::vector<unsigned int> owners(space.n_cells(), 0);
    const auto n_parts =
      static_cast<unsigned int>(std::min<std::size_t>(n_processes, space.n_cells()));
    if (processes::is_first() && n_parts > 1)
      dealii::SparsityTools::partition(neighbours(space), n_parts, owners);
    processes::broadcast(owners);
    return owners;
  }


  template std::vector<unsigned int>
  cell_owners(const Discretization<2> &, const unsigned int);
  template std::vector<unsigned int>
  cell_owners(const Discretization<3> &, const unsigned int);
} // namespace fuga
