// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_ground_beside_h
#define fuga_bodies_dynamics_ground_beside_h

#include <fuga/bodies/condensed/body_model.h>
#include <fuga/bodies/dynamics/free_column.h>

namespace fuga
{
  /** Vertical boundary faces in one plane that face the same way. */
  template <int dim>
  using SideOfGround = std::vector<typename Discretization<dim>::BoundaryFace>;

  /** Return the sides of which the boundaries of a free field consist. */
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
   * Return the cells of a column of the ground beside a side, from below: its layers, and in each
   * of them the rows in which the faces are arranged, or as many equal cells if they are not
   * arranged in rows.
   * @throws InputError for a side that is not a rectangle, or whose layers are not horizontal.
   */
  template <int dim>
  std::vector<typename FreeColumn<dim>::Cell>
  ground_beside(const BodyModel<dim> &model, const SideOfGround<dim> &side);
} // namespace fuga

#endif
