// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <fuga/bodies/cell_coordinates.h>

#include <numeric>

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


  namespace
  {
    template <int dim>
    std::vector<dealii::Point<dim>>
    corners_of(const Discretization<dim> &space, const std::size_t cell)
    {
      std::vector<dealii::Point<dim>> corners;
      for (std::size_t v = 0; v < space.reference_element().n_corners(); ++v)
        corners.push_back(space.position(space.cell_nodes(cell)[v]));
      return corners;
    }
  } // namespace


  template <int dim>
  LoneCell<dim>::LoneCell(const Discretization<dim> &space, const std::size_t cell)
    : discretization(space)
  {
    const std::vector<dealii::Point<dim>> corners = corners_of(space, cell);
    const unsigned int n                          = static_cast<unsigned int>(corners.size());
    std::vector<dealii::CellData<dim>> data(1, dealii::CellData<dim>(n));
    std::iota(data[0].vertices.begin(), data[0].vertices.end(), 0);
    mesh.create_triangulation(corners, data, {});
  }


  template <int dim>
  bool
  LoneCell<dim>::is_near(const Discretization<dim> &space,
                         const std::size_t cell,
                         const dealii::Point<dim> &point)
  {
    return dealii::BoundingBox<dim>(corners_of(space, cell)).point_inside(point, inside_tolerance);
  }


  template <int dim>
  std::optional<dealii::Point<dim>>
  LoneCell<dim>::coordinates(const dealii::Point<dim> &point) const
  {
    return coordinates_in<dim>(mesh.begin_active(), discretization.mapping(), point);
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
