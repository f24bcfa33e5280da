// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_confirm_in_space_h
#define fuga_tests_stress_confirm_in_space_h

#include "stress/confirm.h"
#include "stress/spatial_grid.h"

namespace fuga::stress
{
  /**
   * What is known of a path in space from elsewhere. An extruded scene is compared with its plane
   * section, which another path is taken for: the end and its verdict, and forces per area and
   * dislocations of all elements at all load levels.
   * @p directory: for the files of the section.
   */
  Confirmation
  confirm_in_space(const SpatialGrid &scene,
                   const JointModel &joint,
                   const PathResult &result,
                   const PieceSample &sample,
                   const std::string &directory);

  /** How the plane section of a scene in space ends, in words. */
  std::string
  section_end(const SpatialGrid &scene, const std::string &directory);
} // namespace fuga::stress

#endif
