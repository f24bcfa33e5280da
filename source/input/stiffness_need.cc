// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>
#include <fuga/input/stiffness_need.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    bool
    is_search(const StageDefinition &stage)
    {
      return stage.purpose != StagePurpose::loading;
    }
  } // namespace

  std::string
  what_needs_stiffness(const Parameters &parameters)
  {
    const ModelDefinition &model = parameters.model;
    if (parameters.solver.follow_events)
      return "following the loads from event to event (Solver/Follow = events) is";
    if (changes_construction(model))
      return "construction in stages is";
    if (parameters.of_sweep)
      return "a sweep is";
    if (parameters.accuracy.quantity != AccuracyTarget::Quantity::none)
      return "a target accuracy is";
    if (may_move(parameters))
      return "inertia is";
    if (std::any_of(model.stages.begin(), model.stages.end(), is_search))
      return "a search for a factor of safety is";
    return {};
  }
} // namespace fuga
