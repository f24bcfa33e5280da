// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/contact/path/report_counter.h>

namespace fuga
{
  ReportCounter::ReportCounter(PathObserver &path_observer, std::size_t &n_reports)
    : observer(path_observer), n_heard(n_reports), count(n_reports)
  {
    count = 0;
  }

  void
  ReportCounter::start()
  {
    if (count == 0)
      return;
    if (count < n_heard)
      throw NumericalFailure("The path after the checkpoint is not the one that was followed "
                             "before: it was computed with another program or library, or with "
                             "another number of threads. Run without --restart.");
    n_heard = 0;
    count   = 0;
  }

  template <typename Report>
  void
  ReportCounter::hand_on(const Report &report)
  {
    if (++count <= n_heard)
      return;
    report();
    if (!in_step)
      interruption::check("on the way through the loads");
  }

  bool
  ReportCounter::wants_cuts() const
  {
    return observer.wants_cuts();
  }

  bool
  ReportCounter::wants_more() const
  {
    return observer.wants_more();
  }

  void
  ReportCounter::advanced(const PathPoint &from, const PathPoint &to, const double length)
  {
    hand_on([&]() { observer.advanced(from, to, length); });
  }

  void
  ReportCounter::jumped(const JointState &to)
  {
    hand_on([&]() { observer.jumped(to); });
  }

  void
  ReportCounter::jumped_in_motion(const JointState &to, const double work)
  {
    hand_on([&]() { observer.jumped_in_motion(to, work); });
  }

  void
  ReportCounter::changed(const std::vector<ContactEvent> &events, const JointState &state)
  {
    hand_on([&]() { observer.changed(events, state); });
  }

  void
  ReportCounter::reached(const std::size_t index, const JointState &state)
  {
    hand_on([&]() { observer.reached(index, state); });
  }

  void
  ReportCounter::began_motion()
  {
    hand_on([&]() { observer.began_motion(); });
  }

  void
  ReportCounter::began_step(const ContactSystem &system, const LoadHistory &history)
  {
    in_step = true;
    hand_on([&]() { observer.began_step(system, history); });
  }

  void
  ReportCounter::ended_step(const JointState &state)
  {
    in_step = false;
    hand_on([&]() { observer.ended_step(state); });
  }

  void
  ReportCounter::went_beyond(const double length, const JointState &state)
  {
    hand_on([&]() { observer.went_beyond(length, state); });
  }
} // namespace fuga
