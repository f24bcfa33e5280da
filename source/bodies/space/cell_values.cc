// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/cell_values.h>

namespace fuga
{
  template <int dim>
  CellValues<dim>::CellValues(const Discretization<dim> &space)
    : discretization(space)
    , tables(space.reference_element().quadrature().size())
    , corners(space.reference_element().n_corners())
    , volumes(tables.size())
  {
    const auto &element = space.reference_element().scalar_element();
    const auto &rule    = space.reference_element().quadrature();
    const auto shape    = element.reference_cell();
    for (unsigned int q = 0; q < tables.size(); ++q)
      {
        tables[q].weight = rule.weight(q);
        for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
          {
            tables[q].values.push_back(element.shape_value(i, rule.point(q)));
            tables[q].gradients.push_back(element.shape_grad(i, rule.point(q)));
          }
        for (unsigned int v = 0; v < corners.size(); ++v)
          {
            tables[q].corner_values.push_back(shape.d_linear_shape_function(rule.point(q), v));
            // The function is linear in every coordinate; deal.II 9.4 provides no gradients on a
            // tetrahedron.
            dealii::Tensor<1, dim> gradient;
            for (unsigned int c = 0; c < dim; ++c)
              {
                dealii::Point<dim> from = rule.point(q), to = rule.point(q);
                from[c] = 0.;
                to[c]   = 1.;
                gradient[c] =
                  shape.d_linear_shape_function(to, v) - shape.d_linear_shape_function(from, v);
              }
            tables[q].corner_gradients.push_back(gradient);
          }
        gradients.push_back(tables[q].gradients);
      }
  }


  template <int dim>
  bool
  CellValues<dim>::move_to(const std::size_t cell)
  {
    const unsigned int *nodes = discretization.cell_nodes(cell);
    for (std::size_t v = 0; v < corners.size(); ++v)
      corners[v] = discretization.position(nodes[v]);
    if (is_translated_copy())
      return false;
    edges.resize(corners.size());
    for (std::size_t v = 0; v < corners.size(); ++v)
      edges[v] = corners[v] - corners[0];
    compute();
    return true;
  }


  template <int dim>
  bool
  CellValues<dim>::is_translated_copy() const
  {
    if (edges.empty() || (discretization.is_axisymmetric() && corners[0][0] != radius))
      return false;
    // Coordinates carry rounding errors; an error of this size in a stiffness does no harm.
    const double tolerance = 1e-13 * edges[1].norm();
    for (std::size_t v = 1; v < corners.size(); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        if (std::abs(corners[v][c] - corners[0][c] - edges[v][c]) > tolerance)
          return false;
    return true;
  }


  template <int dim>
  void
  CellValues<dim>::compute()
  {
    radius = corners[0][0];
    for (std::size_t q = 0; q < volumes.size(); ++q)
      {
        dealii::Tensor<2, dim> jacobian;
        for (std::size_t v = 0; v < corners.size(); ++v)
          jacobian += outer_product(edges[v], tables[q].corner_gradients[v]);
        const double volume = determinant(jacobian);
        if (!(volume > 0.))
          throw InputError(fmt::format("A cell at {} is folded over. Correct the mesh there.",
                                       text_of(corners[0])));
        volumes[q]         = tables[q].weight * volume * discretization.extent_across(point(q));
        const auto inverse = transpose(invert(jacobian));
        for (std::size_t i = 0; i < gradients[q].size(); ++i)
          gradients[q][i] = inverse * tables[q].gradients[i];
      }
  }


  template <int dim>
  dealii::Point<dim>
  CellValues<dim>::point(const std::size_t q) const
  {
    dealii::Point<dim> result;
    for (std::size_t v = 0; v < corners.size(); ++v)
      result += tables[q].corner_values[v] * corners[v];
    return result;
  }


  template class CellValues<2>;
  template class CellValues<3>;
} // namespace fuga
