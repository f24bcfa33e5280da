// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_confirm_in_space_h
#define fuga_tests_stress_confirm_in_space_h

#include "stress/confirm.h"
#include "stress/scene_data.h"

namespace fuga::stress
{
  /**
   * What is known of a path in space from elsewhere. An extruded scene is compared with its plane
   * section, which another path solves: the end and its verdict, and forces per area and
   * dislocations of all elements at all load levels. Of other scenes steps are solved again by
   * judges::ConeNewton, which must find none beyond the end of a path that is no mechanism.
   * @p directory: for the files of the section. @p seconds: as in confirm().
   */
  Confirmation
  confirm_in_space(const SceneData &scene,
                   const Model<3> &model,
                   const JointModel &joint,
                   const PathResult &result,
                   const PieceSample &sample,
                   const std::string &directory,
                   const double seconds);

  /** Where a path in space failed: how the plane section of an extruded scene ends, or whether
   * ConeNewton finds a step beyond; in words that follow others. */
  std::string
  what_others_find(const SceneData &scene,
                   const Model<3> &model,
                   const JointModel &joint,
                   const PieceSample &sample,
                   const std::string &directory);
} // namespace fuga::stress

#endif
