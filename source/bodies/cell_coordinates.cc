// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/fe/mapping.h>

#include <fuga/bodies/cell_coordinates.h>

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

  template std::optional<dealii::Point<2>>
  coordinates_in(const dealii::Triangulation<2>::active_cell_iterator &,
                 const dealii::Mapping<2, 2> &,
                 const dealii::Point<2> &);
  template std::optional<dealii::Point<3>>
  coordinates_in(const dealii::Triangulation<3>::active_cell_iterator &,
                 const dealii::Mapping<3, 3> &,
                 const dealii::Point<3> &);
} // namespace fuga
