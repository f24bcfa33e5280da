// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_run_scene_h
#define fuga_tests_stress_run_scene_h

#include "stress/scene_kinds.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fuga::stress
{
  /** Names of the columns of scenes.csv. */
  const std::vector<std::string> &
  scene_columns();

  /** Writes NAME.prm and NAME.msh into @p directory; the path of the former. */
  std::string
  write_scene(const SceneData &scene, const std::string &directory, const std::string &name);

  /**
   * Writes parameter file and mesh of a scene into @p directory, runs the program on them in this
   * process and has the outcome confirmed. @p write gets one line "COLUMN=VALUE" for everything as
   * soon as it is known, so that a crash leaves the rest.
   */
  void
  run_scene(const std::string &kind,
            const std::uint64_t seed,
            const std::string &directory,
            const std::function<void(const std::string &)> &write);
} // namespace fuga::stress

#endif
