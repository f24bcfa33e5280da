// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/cell_motions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fuga
{
  namespace
  {
    void
    take_out_part(const Vector &unit, Vector &v)
    {
      const double part = std::inner_product(unit.begin(), unit.end(), v.begin(), 0.);
      for (std::size_t i = 0; i < v.size(); ++i)
        v[i] -= part * unit[i];
    }
  } // namespace


  // On an axisymmetric cell a growing radius causes forces, and so does a rotation: it is moved
  // along the axis only.
  template <int dim>
  CellMotions<dim>::CellMotions(const Discretization<dim> &space)
    : discretization(space), n_nodes(space.reference_element().n_nodes())
  {
    for (unsigned int c = space.is_axisymmetric() ? 1 : 0; c < dim; ++c)
      {
        motions.emplace_back(n_nodes * dim, 0.);
        for (std::size_t node = 0; node < n_nodes; ++node)
          motions.back()[node * dim + c] = 1. / std::sqrt(static_cast<double>(n_nodes));
      }
    n_shifts = motions.size();
    motions.resize(n_shifts + (space.is_axisymmetric() ? 0 : dim * (dim - 1) / 2),
                   Vector(n_nodes * dim, 0.));
  }


  template <int dim>
  void
  CellMotions<dim>::move_to(const std::size_t cell)
  {
    const unsigned int *const nodes = discretization.cell_nodes(cell);
    std::size_t rotation            = n_shifts;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < c && rotation < motions.size(); ++d, ++rotation)
        {
          Vector &motion = motions[rotation];
          std::fill(motion.begin(), motion.end(), 0.);
          for (std::size_t node = 0; node < n_nodes; ++node)
            {
              const auto arm =
                discretization.position(nodes[node]) - discretization.position(nodes[0]);
              motion[node * dim + c] = arm[d];
              motion[node * dim + d] = -arm[c];
            }
          orthonormalize(rotation);
        }
  }


  // Twice: of motions that are all but parallel, about the axes of a slender cell, the first
  // subtraction leaves few digits.
  template <int dim>
  void
  CellMotions<dim>::orthonormalize(const std::size_t k)
  {
    Vector &motion = motions[k];
    for (int time = 0; time < 2; ++time)
      {
        for (std::size_t before = 0; before < k; ++before)
          take_out_part(motions[before], motion);
        const double length =
          std::sqrt(std::inner_product(motion.begin(), motion.end(), motion.begin(), 0.));
        for (double &value : motion)
          value /= length;
      }
  }


  template <int dim>
  void
  CellMotions<dim>::take_out(Vector &v) const
  {
    for (const Vector &motion : motions)
      take_out_part(motion, v);
  }


  template class CellMotions<2>;
  template class CellMotions<3>;
} // namespace fuga
