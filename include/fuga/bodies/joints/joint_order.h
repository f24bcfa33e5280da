// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_joint_order_h
#define fuga_bodies_joints_joint_order_h

#include <deal.II/base/point.h>

#include <utility>
#include <vector>

namespace fuga
{
  /**
   * Return the order in which the faces of a joint are numbered, independent of their order in the
   * mesh, from their corners: in the plane along the line, and whether each face is traversed
   * backwards; in space by the x, then y, then z of their centers.
   */
  template <int dim>
  std::vector<std::pair<unsigned int, bool>>
  joint_order(const std::vector<std::vector<dealii::Point<dim>>> &faces);
} // namespace fuga

#endif
