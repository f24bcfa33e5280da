// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_ground_beside_h
#define fuga_bodies_dynamics_ground_beside_h

#include <fuga/bodies/condensed/body_model.h>
#include <fuga/bodies/dynamics/free_column.h>

namespace fuga
{
  /** Vertical boundary faces in one plane, with one side of it. */
  template <int dim>
  using SideOfGround = std::vector<typename Discretization<dim>::BoundaryFace>;

  /** The sides that the boundaries of a free field consist of. */
  template <int dim>
  std::vector<SideOfGround<dim>>
  sides_of_ground(const BodyModel<dim> &model);

  /** Lowest and highest point of a side or of one of its faces [m]. */
  struct Heights
  {
    double foot = 0., top = 0.;

    double
    length() const
    {
      return top - foot;
    }
  };

  template <int dim>
  Heights
  heights_of(const BodyModel<dim> &model, const SideOfGround<dim> &side);

  /**
   * Cells of a column of the ground beside a side, from below: its layers, and in each of them the
   * rows in which the faces stand, or as many equal cells where they stand in none.
   * @throws InputError for a side that is no rectangle, or whose layers are not horizontal.
   */
  template <int dim>
  std::vector<typename FreeColumn<dim>::Cell>
  ground_beside(const BodyModel<dim> &model, const SideOfGround<dim> &side);
} // namespace fuga

#endif
