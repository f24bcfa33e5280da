// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_time_steps_h
#define fuga_bodies_dynamics_time_steps_h

#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** The number of the first dynamic stage; that of all stages if there is none. */
  unsigned int
  first_dynamic_stage(const ModelDefinition &model);

  bool
  has_dynamic_stage(const ModelDefinition &model);

  /** The number of equal steps of a dynamic stage: so many that none is longer than the time step
   * and that every level is the end of one. */
  double
  number_of_time_steps(const DynamicsDefinition &dynamics, const StageDefinition &stage);
} // namespace fuga

#endif
