// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_keyed_blocks_h
#define fuga_tests_scenes_keyed_blocks_h

#include "scenes/grid_mesh.h"
#include "scenes/rough_blocks.h"

namespace fuga::tests
{
  /** The line of the joint between two blocks 3 wide and together 2.5 high. */
  enum class Profile
  {
    /** At y = 1.5 to x = 1, down to y = 1, and on at y = 1. */
    step,
    /** At y = 1.5, but for 1 < x < 2, where it is at y = 1. */
    key
  };

  /** Squares of 1/(2n), with the names of two_blocks_mesh(). */
  GmshMesh
  keyed_mesh(const Profile profile, const std::size_t n);

  /** Turned about z by @p angle. */
  GmshMesh
  turned(GmshMesh mesh, const double angle);

  /** The weight of the upper one of rough_blocks(), 0.02 per volume, in one stage, a traction on
   * its
   * top in a second one. All is turned about z by @p angle. */
  nlohmann::ordered_json
  keyed_blocks(const std::array<double, 2> &traction, const double angle = 0.);

  /** The same in space, with free ends. */
  nlohmann::ordered_json
  deep_blocks(const std::array<double, 2> &traction);
} // namespace fuga::tests

#endif
