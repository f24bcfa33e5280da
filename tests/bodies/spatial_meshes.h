// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_bodies_spatial_meshes_h
#define fuga_tests_bodies_spatial_meshes_h

#include <fuga/mesh/joint_splitter.h>

namespace fuga::test
{
  /** The plane mesh as the section through bodies in space, n cells of the depth 1/2 deep. */
  JointedMesh
  extruded(const JointedMesh &plane, const unsigned int n);

  /** A block 1 wide on the middle of one 3 wide, whose cells go on beside the joint. */
  JointedMesh
  narrow_block();
} // namespace fuga::test

#endif
