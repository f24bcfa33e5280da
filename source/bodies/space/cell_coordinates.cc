// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/grid_generator.h>

#include <fuga/bodies/space/cell_coordinates.h>

namespace fuga
{
  template <int dim>
  std::optional<dealii::Point<dim>>
  coordinates_in(const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
                 const dealii::Mapping<dim, dim> &mapping,
                 const dealii::Point<dim> &point)
  {
    if (!cell->bounding_box().point_inside(point, inside_tolerance))
      return {};
    try
      {
        const dealii::Point<dim> inside = mapping.transform_real_to_unit_cell(cell, point);
        if (cell->reference_cell().contains_point(inside, inside_tolerance))
          return inside;
      }
    catch (const typename dealii::Mapping<dim, dim>::ExcTransformationFailed &)
      {
        // outside, near a cell that is not a parallelogram
      }
    return {};
  }


  template <int dim>
  LoneCell<dim>::LoneCell(const Discretization<dim> &space) : discretization(space)
  {
    dealii::GridGenerator::reference_cell(
      mesh, space.reference_element().scalar_element().reference_cell());
  }


  template <int dim>
  std::optional<dealii::Point<dim>>
  LoneCell<dim>::coordinates(const std::size_t number, const dealii::Point<dim> &point)
  {
    const auto cell = mesh.begin_active();
    for (const unsigned int v : cell->vertex_indices())
      cell->vertex(v) = discretization.position(discretization.cell_nodes(number)[v]);
    return coordinates_in<dim>(cell, discretization.mapping(), point);
  }


  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  LoneCell<dim>::gradients(const dealii::Point<dim> &in_reference_cell) const
  {
    const auto &element = discretization.reference_element().scalar_element();
    dealii::FEValues<dim> values(discretization.mapping(),
                                 element,
                                 dealii::Quadrature<dim>(in_reference_cell),
                                 dealii::update_gradients);
    values.reinit(mesh.begin_active());
    std::vector<dealii::Tensor<1, dim>> result;
    for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
      result.push_back(values.shape_grad(i, 0));
    return result;
  }


  template std::optional<dealii::Point<2>>
  coordinates_in(const dealii::Triangulation<2>::active_cell_iterator &,
                 const dealii::Mapping<2, 2> &,
                 const dealii::Point<2> &);
  template std::optional<dealii::Point<3>>
  coordinates_in(const dealii::Triangulation<3>::active_cell_iterator &,
                 const dealii::Mapping<3, 3> &,
                 const dealii::Point<3> &);
  template class LoneCell<2>;
  template class LoneCell<3>;
} // namespace fuga
