// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/elasticity/cell_stiffness.h>

namespace fuga
{
  template <int dim>
  CellStiffness<dim>::CellStiffness(const Discretization<dim> &space,
                                    const std::vector<LameConstants> &material_of_body)
    : discretization(space)
    , materials(material_of_body)
    , values(space)
    , n_nodes(space.reference_element().n_nodes())
    , matrix(n_nodes * dim * n_nodes * dim)
  {
  }


  template <int dim>
  const double *
  CellStiffness<dim>::of(const std::size_t cell)
  {
    const unsigned int next = discretization.cell_body(cell);
    const bool is_moved     = values.move_to(cell);
    if (is_moved || next != body)
      {
        body = next;
        compute();
      }
    return matrix.data();
  }


  // Any rotation near that of the cell is suitable, but its effect has to be removed to the last
  // digit of u.
  template <int dim>
  void
  CellStiffness<dim>::take_deformation(const std::size_t cell, const Vector &u, Vector &local) const
  {
    const unsigned int *nodes      = discretization.cell_nodes(cell);
    const unsigned int first_shift = discretization.is_axisymmetric() ? 1 : 0;
    local.resize(n_nodes * dim);
    dealii::Tensor<2, dim> slope;
    for (std::size_t a = 0; a < n_nodes; ++a)
      for (unsigned int c = 0; c < dim; ++c)
        {
          local[a * dim + c] = u[nodes[a] * dim + c];
          if (c >= first_shift)
            local[a * dim + c] -= u[nodes[0] * dim + c];
          slope[c] += local[a * dim + c] * values.gradient(a, 0);
        }
    if (discretization.is_axisymmetric())
      return;
    const dealii::Tensor<2, dim> rotation = 0.5 * (slope - transpose(slope));
    for (std::size_t a = 1; a < n_nodes; ++a)
      for (unsigned int c = 0; c < dim; ++c)
        {
          long double w = u[nodes[a] * dim + c];
          w -= u[nodes[0] * dim + c];
          for (unsigned int d = 0; d < dim; ++d)
            {
              long double arm = discretization.position(nodes[a])[d];
              arm -= discretization.position(nodes[0])[d];
              w -= rotation[c][d] * arm;
            }
          local[a * dim + c] = static_cast<double>(w);
        }
  }


  template <int dim>
  void
  CellStiffness<dim>::compute()
  {
    for (std::size_t a = 0; a < n_nodes; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        {
          dealii::Tensor<2, dim> product;
          for (std::size_t q = 0; q < values.n_points(); ++q)
            product +=
              outer_product(values.volume(q) * values.gradient(a, q), values.gradient(b, q));
          dealii::Tensor<2, dim> block = plane_block(product);
          if (discretization.is_axisymmetric())
            add_hoop(a, b, block);
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              {
                matrix[(a * dim + c) * n_nodes * dim + b * dim + d] = block[c][d];
                matrix[(b * dim + d) * n_nodes * dim + a * dim + c] = block[c][d];
              }
        }
  }


  template <int dim>
  dealii::Tensor<2, dim>
  CellStiffness<dim>::plane_block(const dealii::Tensor<2, dim> &product) const
  {
    const LameConstants &material = materials[body];
    const double diagonal         = material.mu * trace(product);
    dealii::Tensor<2, dim> block;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        block[c][d] =
          material.lambda * product[c][d] + material.mu * product[d][c] + (c == d ? diagonal : 0.);
    return block;
  }


  template <int dim>
  void
  CellStiffness<dim>::add_hoop(const std::size_t a,
                               const std::size_t b,
                               dealii::Tensor<2, dim> &block) const
  {
    const LameConstants &material = materials[body];
    for (std::size_t q = 0; q < values.n_points(); ++q)
      {
        const double radius = values.point(q)[0];
        const double hoop_a = values.value(a, q) / radius, hoop_b = values.value(b, q) / radius;
        for (unsigned int c = 0; c < dim; ++c)
          {
            block[c][0] += material.lambda * values.volume(q) * values.gradient(a, q)[c] * hoop_b;
            block[0][c] += material.lambda * values.volume(q) * hoop_a * values.gradient(b, q)[c];
          }
        block[0][0] += (material.lambda + 2. * material.mu) * values.volume(q) * hoop_a * hoop_b;
      }
  }


  template class CellStiffness<2>;
  template class CellStiffness<3>;
} // namespace fuga
