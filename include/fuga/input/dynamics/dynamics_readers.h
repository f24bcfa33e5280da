// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_dynamics_dynamics_readers_h
#define fuga_input_dynamics_dynamics_readers_h

#include <fuga/input/parameters.h>
#include <fuga/input/values/parameter_values.h>

namespace fuga
{
  /** More steps of a motion than anybody waits for: a slip of units. */
  constexpr double largest_number_of_steps = 1e6;

  /**
   * Sections Dynamics and Earthquake, the velocities with which bodies begin, and what stages with
   * a duration ask of everything else, which must have been read. @throws InputError
   */
  void
  read_dynamics(const ParameterValues &values, Parameters &parameters);

  /** Section Earthquake. @throws InputError */
  void
  read_earthquake(const ParameterValues &values, Parameters &parameters);

  /** What cannot be done together with stages with a duration. @throws InputError */
  void
  check_dynamic_stages(const ParameterValues &values, const Parameters &parameters);

  /** What Solver/Beyond limit load = dynamic needs, and what cannot be done together with it.
   * @throws InputError */
  void
  check_continuation(const ParameterValues &values, const Parameters &parameters);

  /** Fails at an entry that has no default. */
  void
  refuse_without_motion(const ParameterSection &section);
} // namespace fuga

#endif
