// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_run_journal_verdict_text_h
#define fuga_run_journal_verdict_text_h

#include <fuga/output/results/motion_beyond_limit.h>
#include <fuga/run/journal/run_journal.h>

namespace fuga
{
  /** "0.25 of stage 'filling' (t = 1.25@p more)": where a path is. */
  std::string
  place_text(const double t,
             const std::vector<std::string> &stage_names,
             const std::string &more = {});

  /** Friction beyond its critical value: how many ways to go on @p result knows, and which elements
   * decide. */
  template <int dim>
  std::string
  critical_friction_text(const PhaseRun<dim> &phase, const PathResult &result);

  /** The equilibrium near by to which the path does not go on continuously; empty if none is
   * known. */
  std::string
  jump_text(const Jump &jump, const Units &units);

  /** Why a path that lost its equilibrium did: its mechanism, or what decides. */
  template <int dim>
  std::string
  reason_text(const PhaseRun<dim> &phase, const PathResult &result);

  /** How bodies that lost their equilibrium moved. */
  std::string
  continuation_text(const MotionBeyondLimit &continuation, const Units &units);
} // namespace fuga

#endif
