// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_cell_coordinates_h
#define fuga_bodies_cell_coordinates_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <optional>

namespace dealii
{
  template <int dim, int spacedim>
  class Mapping;
}

namespace fuga
{
  /** A point that lies outside of a cell by less than this part of its size, by rounding, lies
   * inside. */
  constexpr double inside_tolerance = 1e-8;

  /** Coordinates in the reference cell, if the point lies in the cell. */
  template <int dim>
  std::optional<dealii::Point<dim>>
  coordinates_in(const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
                 const dealii::Mapping<dim, dim> &mapping,
                 const dealii::Point<dim> &point);
} // namespace fuga

#endif
