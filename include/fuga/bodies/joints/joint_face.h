// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_joints_joint_face_h
#define fuga_bodies_joints_joint_face_h

#include <array>
#include <utility>
#include <vector>

namespace fuga
{
  /** One face of a joint, for output; nodes in the order of JointGeometry::Face. */
  struct JointFace
  {
    unsigned int joint = 0;
    /**
     * Contact element of each node with the weight 1; at a hanging node those of its masters; none
     * where the lips are bonded.
     */
    std::vector<std::vector<std::pair<unsigned int, double>>> shares;
    std::vector<std::array<double, 3>> positions;
    /**
     * Cell and face number of the plus lip, and whether the nodes are numbered against those of
     * this face.
     */
    unsigned int cell = 0, number = 0;
    bool backwards = false;
    /** Area on the plus lip [m²]. */
    double area = 0.;
  };
} // namespace fuga

#endif
