// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_time_steps_h
#define fuga_bodies_dynamics_time_steps_h

#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** Return the index of the first dynamic stage; the number of stages if there is none. */
  unsigned int
  first_dynamic_stage(const ModelDefinition &model);

  bool
  has_dynamic_stage(const ModelDefinition &model);

  /**
   * Return the number of equal steps of a dynamic stage, chosen such that none is longer than the
   * time step and that every level is the end of a step.
   */
  double
  number_of_time_steps(const DynamicsDefinition &dynamics, const StageDefinition &stage);
} // namespace fuga

#endif
