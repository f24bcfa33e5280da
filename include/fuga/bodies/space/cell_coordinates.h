// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_cell_coordinates_h
#define fuga_bodies_space_cell_coordinates_h

#include <deal.II/grid/tria.h>

#include <fuga/bodies/space/discretization.h>

#include <optional>

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

  /**
   * One cell of the tables after the other by itself, as deal.II's functions for single cells take
   * it: a process has the tables of all cells, but deal.II's objects of its own cells only.
   */
  template <int dim>
  class LoneCell
  {
  public:
    explicit LoneCell(const Discretization<dim> &space);

    /** Goes to a cell and returns the coordinates of a point there, if it lies in the cell. */
    std::optional<dealii::Point<dim>>
    coordinates(const std::size_t cell, const dealii::Point<dim> &point);

    /** Of the shape functions, at a point of the reference cell. */
    std::vector<dealii::Tensor<1, dim>>
    gradients(const dealii::Point<dim> &in_reference_cell) const;

  private:
    const Discretization<dim> &discretization;
    dealii::Triangulation<dim> mesh;
  };
} // namespace fuga

#endif
