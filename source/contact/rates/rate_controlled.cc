// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/rates/rate_problem.h>

#include <cmath>

namespace fuga
{
  namespace
  {
    /** Share of the reaction of the stiffness of the bars below which a load rate is zero, judging
     * by its forces. */
    constexpr double no_load_rate = 1e-10;
  } // namespace

  void
  RateProblem::measure_by_largest_jump(const Drive &unit_load, ControlledContinuation &motion) const
  {
    const double size =
      largest_jump(elements, system.jumps(motion.rates.dislocations, motion.rates.forces));
    for (std::size_t i = 0; i < system.n_bars(); ++i)
      {
        motion.rates.forces[i] /= size;
        motion.rates.dislocations[i] /= size;
      }
    motion.load_rate /= size;
    if (std::abs(motion.load_rate) * max_abs(unit_load.reactions) <=
        no_load_rate * system.largest_stiffness())
      motion.load_rate = 0.;
  }

  ControlledContinuation
  RateProblem::solve_yielding(const JointState &state,
                              const std::vector<BoundaryElement> &set,
                              const Drive &drive,
                              const Drive &unit_load,
                              const ConeRateProblem::Control control)
  {
    take_background(state, set);
    const ConeContinuation found =
      reduced.solve_yielding(state, set, off_boundary, drive, unit_load, control);
    ControlledContinuation result;
    result.exists    = found.exists;
    result.rates     = found.rates;
    result.load_rate = found.load_rate;
    if (found.exists)
      {
        take_states(set, found);
        note_active(set, found.rates);
      }
    return result;
  }

  ControlledContinuation
  RateProblem::solve_controlled(const JointState &state,
                                const std::vector<BoundaryElement> &set,
                                const Drive &unit_load)
  {
    Drive at_rest;
    at_rest.reactions.assign(system.n_bars(), 0.);
    ControlledContinuation result =
      solve_yielding(state, set, at_rest, unit_load, ConeRateProblem::Control::motion);
    if (result.exists)
      measure_by_largest_jump(unit_load, result);
    return result;
  }

  ControlledContinuation
  RateProblem::solve_release(const JointState &state,
                             const std::vector<BoundaryElement> &set,
                             const Drive &release,
                             const Drive &unit_load)
  {
    return solve_yielding(state, set, release, unit_load, ConeRateProblem::Control::displacement);
  }
} // namespace fuga
