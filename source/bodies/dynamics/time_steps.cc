// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/time_steps.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  unsigned int
  first_dynamic_stage(const ModelDefinition &model)
  {
    const auto found = std::find_if(model.stages.begin(),
                                    model.stages.end(),
                                    [](const auto &stage) { return stage.is_dynamic(); });
    return static_cast<unsigned int>(found - model.stages.begin());
  }


  bool
  has_dynamic_stage(const ModelDefinition &model)
  {
    return first_dynamic_stage(model) < model.stages.size();
  }


  double
  number_of_time_steps(const DynamicsDefinition &dynamics, const StageDefinition &stage)
  {
    // 20 s are 4000 steps of 0.005 s, whatever the quotient is rounded to.
    constexpr double rounding = 1e-9;
    const double levels       = stage.levels;
    const double of_a_level   = stage.duration / levels / dynamics.time_step;
    return levels * std::max(1., std::ceil(of_a_level * (1. - rounding)));
  }
} // namespace fuga
