// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_motion_cut_h
#define fuga_contact_dynamics_motion_cut_h

#include <fuga/contact/dynamics/moving_bodies.h>
#include <fuga/contact/path/path_result.h>
#include <fuga/contact/tangent_vector.h>

namespace fuga
{
  /** What a motion hands on from step to step besides the bodies and the state of the joints. */
  struct MotionProgress
  {
    /** Shortest steps so far. */
    std::size_t tick = 0;
    MotionLedger ledger;
    /** Steps by rung. */
    std::vector<std::size_t> steps_of_rung;
    /** By element: mean slip rate in the step before. */
    std::vector<TangentVector> slip_rates;
    /** Of the step before [s]. */
    double length_before = 0.;
    /** Largest mean rate of a jump in any step so far [m/s]. */
    double largest_rate = 0.;
    /** Of the longest step that is worth an attempt, by what the step before has cost. */
    unsigned int promising_rung = 0;
  };

  template <typename Progress, typename Visitor, only_for<Progress, MotionProgress> = 0>
  void
  for_each_field(Progress &progress, Visitor &&visit)
  {
    auto &[tick, ledger, steps_of_rung, slip_rates, length_before, largest_rate, promising_rung] =
      progress;
    visit("tick", tick);
    visit("ledger", ledger);
    visit("steps_of_rung", steps_of_rung);
    visit("slip_rates", slip_rates);
    visit("length_before", length_before);
    visit("largest_rate", largest_rate);
    visit("promising_rung", promising_rung);
  }

  /** A place between two steps of time from which a motion can be followed again, bit for bit: what
   * a PathCut does not know. */
  struct MotionCut
  {
    MotionProgress progress;
    MotionMemory bodies;
    /** Of the rungs that have been needed: their numbers, and what the paths through them hand on
     * from step to step. */
    std::vector<std::pair<unsigned int, PathMemory>> rungs;
  };

  template <typename Cut, typename Visitor, only_for<Cut, MotionCut> = 0>
  void
  for_each_field(Cut &cut, Visitor &&visit)
  {
    auto &[progress, bodies, rungs] = cut;
    visit("progress", progress);
    visit("bodies", bodies);
    visit("rungs", rungs);
  }
} // namespace fuga

#endif
