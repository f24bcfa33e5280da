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
  /**
   * Return whether faces with these unit normals meet at a corner, i.e. at more than
   * @p corner_angle degrees.
   */
  template <int dim>
  bool
  is_corner(const dealii::Tensor<1, dim> &a,
            const dealii::Tensor<1, dim> &b,
            const double corner_angle);

  /**
   * Return the straight part to which each of the faces around one node pair belongs, from their
   * unit @p normals. Faces are in one part if a chain of faces leads from one to the other in which
   * no two consecutive faces meet at a corner. Parts are numbered from 0 in the order of their
   * first faces.
   */
  template <int dim>
  std::vector<unsigned int>
  straight_parts(const std::vector<dealii::Tensor<1, dim>> &normals, const double corner_angle);

  /**
   * Return one line for the log per joint with corners: the number of node pairs with several
   * elements, and the positions of the first ones.
   */
  template <int dim>
  std::vector<std::string>
  corner_report(const std::vector<NodePair<dim>> &pairs, const JointedMesh &mesh);
} // namespace fuga

#endif
