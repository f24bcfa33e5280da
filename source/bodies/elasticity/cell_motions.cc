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

    void
    normalize(Vector &v)
    {
      const double length = std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.));
      for (double &value : v)
        value /= length;
    }
  } // namespace


  // On an axisymmetric cell a growing radius causes forces, and so does a rotation: it is moved
  // along the axis only.
  template <int dim>
  CellMotions<dim>::CellMotions(const Discretization<dim> &space)
    : discretization(space)
    , n_nodes(space.reference_element().n_nodes())
    , first_shift(space.is_axisymmetric() ? 1 : 0)
    , arms(n_nodes)
    , rotations(space.is_axisymmetric() ? 0 : dim * (dim - 1) / 2, Vector(n_nodes * dim))
  {
  }


  template <int dim>
  void
  CellMotions<dim>::move_to(const std::size_t cell)
  {
    const unsigned int *const nodes = discretization.cell_nodes(cell);
    bool is_copy                    = !rotations.empty() && is_ready;
    for (std::size_t node = 0; node < n_nodes; ++node)
      {
        const auto arm = discretization.position(nodes[node]) - discretization.position(nodes[0]);
        is_copy        = is_copy && arm == arms[node];
        arms[node]     = arm;
      }
    if (rotations.empty() || is_copy)
      return;
    dealii::Tensor<1, dim> center;
    for (const auto &arm : arms)
      center += arm / static_cast<double>(n_nodes);
    std::size_t k = 0;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < c; ++d, ++k)
        {
          std::fill(rotations[k].begin(), rotations[k].end(), 0.);
          for (std::size_t node = 0; node < n_nodes; ++node)
            {
              rotations[k][node * dim + c] = arms[node][d] - center[d];
              rotations[k][node * dim + d] = center[c] - arms[node][c];
            }
          orthonormalize(k);
        }
    is_ready = true;
  }


  // Twice: of motions that are all but parallel, about the axes of a slender cell, the first
  // subtraction leaves few digits. About the centre they have nothing of the shifts.
  template <int dim>
  void
  CellMotions<dim>::orthonormalize(const std::size_t k)
  {
    for (int time = 0; time < 2; ++time)
      {
        for (std::size_t before = 0; before < k; ++before)
          take_out_part(rotations[before], rotations[k]);
        normalize(rotations[k]);
      }
  }


  template <int dim>
  void
  CellMotions<dim>::take_out(Vector &v) const
  {
    for (unsigned int c = first_shift; c < dim; ++c)
      {
        double mean = 0.;
        for (std::size_t node = 0; node < n_nodes; ++node)
          mean += v[node * dim + c];
        mean /= static_cast<double>(n_nodes);
        for (std::size_t node = 0; node < n_nodes; ++node)
          v[node * dim + c] -= mean;
      }
    for (const Vector &rotation : rotations)
      take_out_part(rotation, v);
  }


  template class CellMotions<2>;
  template class CellMotions<3>;
} // namespace fuga
