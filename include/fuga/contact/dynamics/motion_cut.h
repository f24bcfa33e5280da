// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_dynamics_motion_cut_h
#define fuga_contact_dynamics_motion_cut_h

#include <fuga/contact/dynamics/moving_bodies.h>
#include <fuga/contact/path/path_result.h>
#include <fuga/contact/tangent_vector.h>

namespace fuga
{
  /** The data that a motion passes from step to step besides the bodies and the state of the
   * joints. */
  struct MotionProgress
  {
    /** Number of the shortest steps so far. */
    std::size_t tick = 0;
    MotionLedger ledger;
    /** Number of steps of each rung. */
    std::vector<std::size_t> steps_of_rung;
    /** Mean slip rate of each element in the previous step. */
    std::vector<TangentVector> slip_rates;
    /** Length of the previous step [s]. */
    double length_before = 0.;
    /** Largest mean rate of a jump in any step so far [m/s]. */
    double largest_rate = 0.;
    /** Rung of the longest step that is worth an attempt, judging by what the previous step has
     * cost. */
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

  /** A place between two time steps from which a motion can be followed again, bit for bit. It
   * contains what a PathCut does not know. */
  struct MotionCut
  {
    MotionProgress progress;
    MotionMemory bodies;
    /** The numbers of the rungs that have been needed, and the data that the paths through them
     * pass from step to step. */
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
