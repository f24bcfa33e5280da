// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_joint_corners_h
#define fuga_bodies_joints_joint_corners_h

#include <deal.II/base/tensor.h>

#include <fuga/bodies/joints/joint_geometry.h>

#include <string>
#include <vector>

namespace fuga
{
  /** Whether faces with these unit normals meet at a corner: at more than @p corner_angle degrees. */
  template <int dim>
  bool
  is_corner(const dealii::Tensor<1, dim> &a,
            const dealii::Tensor<1, dim> &b,
            const double corner_angle);

  /**
   * The straight part to which each of the faces around one node pair belongs, by their unit
   * @p normals. Faces are in one part if a chain of faces leads from one to the other, each of
   * which meets the next at no corner. Parts are numbered from 0 in the order of their first faces.
   */
  template <int dim>
  std::vector<unsigned int>
  straight_parts(const std::vector<dealii::Tensor<1, dim>> &normals, const double corner_angle);

  /** One line for the log per joint with corners: how many node pairs have several elements, and
   * where the first ones are. */
  template <int dim>
  std::vector<std::string>
  corner_report(const std::vector<NodePair<dim>> &pairs, const JointedMesh &mesh);
} // namespace fuga

#endif
