// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_verdict_text_h
#define fuga_run_journal_verdict_text_h

#include <fuga/output/results/motion_beyond_limit.h>
#include <fuga/run/journal/run_journal.h>

namespace fuga
{
  /** Return the position of a path, such as "0.25 of stage 'filling' (t = 1.25@p more)". */
  std::string
  place_text(const double t,
             const std::vector<std::string> &stage_names,
             const std::string &more = {});

  /**
   * Describe friction beyond its critical value: the number of continuations in @p result and the
   * elements that decide.
   */
  template <int dim>
  std::string
  critical_friction_text(const PhaseRun<dim> &phase, const PathResult &result);

  /**
   * Describe the nearby equilibrium to which the path does not lead continuously; empty if none is
   * known.
   */
  std::string
  jump_text(const Jump &jump, const Units &units);

  /**
   * Return the reason why a path lost its equilibrium: its mechanism, or the elements that decide.
   */
  template <int dim>
  std::string
  reason_text(const PhaseRun<dim> &phase, const PathResult &result);

  /** Describe the motion of bodies that lost their equilibrium. */
  std::string
  continuation_text(const MotionBeyondLimit &continuation, const Units &units);
} // namespace fuga

#endif
