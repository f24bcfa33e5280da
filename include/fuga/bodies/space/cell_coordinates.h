// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_cell_coordinates_h
#define fuga_bodies_space_cell_coordinates_h

#include <deal.II/grid/tria.h>

#include <fuga/bodies/space/discretization.h>

#include <optional>

namespace fuga
{
  /**
   * A point outside of a cell by less than this fraction of its size, i.e. by rounding, counts as
   * inside.
   */
  constexpr double inside_tolerance = 1e-8;

  /** Return the coordinates in the reference cell, if the point lies in the cell. */
  template <int dim>
  std::optional<dealii::Point<dim>>
  coordinates_in(const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
                 const dealii::Mapping<dim, dim> &mapping,
                 const dealii::Point<dim> &point);

  /**
   * A single cell of the tables at a time, in the form in which deal.II's functions for single
   * cells need it: a process has the tables of all cells, but deal.II's objects only of its own
   * cells.
   */
  template <int dim>
  class LoneCell
  {
  public:
    explicit LoneCell(const Discretization<dim> &space);

    /** Go to a cell and return the coordinates of a point there, if it lies in the cell. */
    std::optional<dealii::Point<dim>>
    coordinates(const std::size_t cell, const dealii::Point<dim> &point);

    /** Return the gradients of the shape functions at a point of the reference cell. */
    std::vector<dealii::Tensor<1, dim>>
    gradients(const dealii::Point<dim> &in_reference_cell) const;

  private:
    const Discretization<dim> &discretization;
    dealii::Triangulation<dim> mesh;
  };
} // namespace fuga

#endif
