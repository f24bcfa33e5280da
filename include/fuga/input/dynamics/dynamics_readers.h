// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_dynamics_dynamics_readers_h
#define fuga_input_dynamics_dynamics_readers_h

#include <fuga/input/parameters.h>
#include <fuga/input/values/parameter_values.h>

namespace fuga
{
  /** A larger number of steps of a motion takes too long and indicates a wrong unit. */
  constexpr double largest_number_of_steps = 1e6;

  /**
   * Read sections Dynamics and Earthquake and the initial velocities of bodies, and check what
   * stages with a duration require of everything else, which must have been read. @throws
   * InputError
   */
  void
  read_dynamics(const ParameterValues &values, Parameters &parameters);

  /** Read section Earthquake. @throws InputError */
  void
  read_earthquake(const ParameterValues &values, Parameters &parameters);

  /**
   * Check that nothing is requested that cannot be combined with stages with a duration. @throws
   * InputError
   */
  void
  check_dynamic_stages(const ParameterValues &values, const Parameters &parameters);

  /**
   * Check the requirements of Solver/Beyond limit load = dynamic, and that nothing is requested
   * that cannot be combined with it.
   * @throws InputError
   */
  void
  check_continuation(const ParameterValues &values, const Parameters &parameters);

  /** Fail at an entry that has no default. */
  void
  refuse_without_motion(const ParameterSection &section);
} // namespace fuga

#endif
