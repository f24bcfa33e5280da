// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/event_path.h>

namespace fuga
{
  PathResult
  EventPath::resume(const PathCut &from, const std::vector<double> &levels, PathObserver &observer)
  {
    cut = from;
    scheme.restore(cut.scheme);
    next_level      = cut.next_level;
    resticking      = cut.resticking;
    iteration_count = cut.iterations;
    ReportCounter reports(observer, cut.n_reports);
    return follow(levels, reports);
  }

  PathResult
  EventPath::go_on(const PathCut &end, const std::vector<double> &levels, PathObserver &observer)
  {
    PathCut start    = end;
    start.scheme     = scheme.memory();
    start.resticking = {};
    start.n_reports  = 0;
    return resume(start, levels, observer);
  }

  void
  EventPath::make_cut(const JointState &state, const PathResult &result, ReportCounter &observer)
  {
    if (standstill.n_steps() > 0)
      return; // what is known at this load is not kept
    observer.start();
    if (!observer.wants_cuts())
      return;
    cut.state      = state;
    cut.result     = result;
    cut.iterations = iteration_count;
    cut.scheme     = scheme.memory();
    cut.next_level = next_level;
    cut.resticking = resticking;
  }
} // namespace fuga
