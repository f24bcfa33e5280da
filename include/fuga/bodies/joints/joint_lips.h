// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_joint_lips_h
#define fuga_bodies_joints_joint_lips_h

#include <fuga/bodies/space/discretization.h>

#include <string>
#include <vector>

namespace fuga
{
  /**
   * A face of the plus lip of a joint, and the nodes of both lips along it, in the direction of
   * numbering.
   */
  template <int dim>
  struct MatchedFace
  {
    const typename Discretization<dim>::BoundaryFace *plus = nullptr;
    /** Minus nodes are Discretization::no_node for a rigid obstacle. */
    std::vector<unsigned int> plus_nodes, minus_nodes;
    /** Whether the direction of numbering is opposite to that of the face. */
    bool backwards = false;
  };

  /**
   * Return the faces of a joint in the order of JointGeometry::pairs(); none if the bodies along it
   * do not exist. The lips are matched face by face.
   * @throws InputError with coordinates where the lips do not match, and if only parts of the joint
   * have bodies on both sides.
   */
  template <int dim>
  std::vector<MatchedFace<dim>>
  match_lips(const Discretization<dim> &discretization, const JointedMesh::Joint &joint);
} // namespace fuga

#endif
