// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/cell_geometry.h>
#include <fuga/bodies/point_text.h>

namespace fuga
{
  template <int dim>
  CellGeometry<dim>::CellGeometry(const Discretization<dim> &space)
    : discretization(space)
    , reference(space.reference_element())
    , corners(reference.n_corners())
    , volumes(reference.quadrature().weight.size())
    , all_gradients(volumes.size(), std::vector<dealii::Tensor<1, dim>>(reference.n_nodes()))
  {
  }


  template <int dim>
  bool
  CellGeometry<dim>::move_to(const std::size_t cell)
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
  CellGeometry<dim>::is_translated_copy() const
  {
    if (edges.empty() || (discretization.is_axisymmetric() && corners[0][0] != radius))
      return false;
    // Coordinates carry rounding errors; a stiffness that is off by so little does no harm.
    const double tolerance = 1e-13 * edges[1].norm();
    for (std::size_t v = 1; v < corners.size(); ++v)
      for (unsigned int c = 0; c < dim; ++c)
        if (std::abs(corners[v][c] - corners[0][c] - edges[v][c]) > tolerance)
          return false;
    return true;
  }


  template <int dim>
  void
  CellGeometry<dim>::compute()
  {
    const auto &table = reference.quadrature();
    radius            = corners[0][0];
    for (std::size_t q = 0; q < volumes.size(); ++q)
      {
        dealii::Tensor<2, dim> jacobian;
        for (std::size_t v = 0; v < corners.size(); ++v)
          jacobian += outer_product(edges[v], table.geometry_gradients[q][v]);
        const double volume = determinant(jacobian);
        if (!(volume > 0.))
          throw InputError(
            fmt::format("A cell at {} is folded over. Mend the mesh there.", text_of(corners[0])));
        volumes[q]         = table.weight[q] * volume * discretization.extent_across(point(q));
        const auto inverse = transpose(invert(jacobian));
        for (std::size_t i = 0; i < all_gradients[q].size(); ++i)
          all_gradients[q][i] = inverse * table.gradients[q][i];
      }
  }


  template <int dim>
  dealii::Point<dim>
  CellGeometry<dim>::point(const std::size_t q) const
  {
    dealii::Point<dim> result;
    for (std::size_t v = 0; v < corners.size(); ++v)
      result += reference.quadrature().geometry_values[q][v] * corners[v];
    return result;
  }


  template class CellGeometry<2>;
  template class CellGeometry<3>;
} // namespace fuga
