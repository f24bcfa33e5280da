// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_refined_run_h
#define fuga_tests_scenes_refined_run_h

#include "scenes/scene_run.h"
#include "spatial_patch.h"

#include <fuga/input/parameters.h>

namespace fuga::tests
{
  /** run_scene() after the parameters were read; output goes to a directory of its own. */
  SceneRun
  run_parameters(Parameters parameters);

  /** run_scene() on the mesh of @p patch. */
  SceneRun
  run_patch(const std::string &file, const Patch &patch);
} // namespace fuga::tests

#endif
