// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/dynamics/step_record.h>

#include <cmath>
#include <numeric>

namespace fuga
{
  StepRecord::StepRecord(const JointState &start_of_step,
                         const double end_of_step,
                         const std::vector<ContactElement> &contact_elements,
                         const LayeredSystem &layered_system)
    : first(start_of_step)
    , end_time(end_of_step)
    , elements(contact_elements)
    , system(layered_system)
    , last(start_of_step)
    , work(layered_system.n_bars(), 0.)
    , impulse(layered_system.n_bars(), 0.)
  {
    last.t = 0.;
  }

  // Forces are linear along a piece and jumps are cubics, as the judge assumes.
  void
  StepRecord::advanced(const PathPoint &from, const PathPoint &to, const double length)
  {
    const Vector jumps       = change_of_jumps(from.state, to.state);
    const Vector rate_before = system.jumps(from.rates.dislocations, from.rates.forces);
    const Vector rate_after  = system.jumps(to.rates.dislocations, to.rates.forces);
    for (std::size_t bar = 0; bar < work.size(); ++bar)
      {
        const double p0 = from.state.forces[bar], p1 = to.state.forces[bar];
        work[bar] += 0.5 * (p0 + p1) * jumps[bar] -
                     (p1 - p0) * length / 12. * (rate_before[bar] - rate_after[bar]);
        impulse[bar] += 0.5 * (p0 + p1) * (to.state.t - from.state.t);
      }
    last = to.state;
    reports.emplace_back([from, to, length](const StepRecord &of, PathObserver &observer) {
      observer.advanced(of.in_motion(from), of.in_motion(to), length);
    });
  }

  // The work is that of the trapezoidal rule, as if there were a path.
  void
  StepRecord::jumped(const JointState &to)
  {
    const Vector jumps  = change_of_jumps(last, to);
    double work_of_jump = 0.;
    for (std::size_t bar = 0; bar < work.size(); ++bar)
      {
        const double mean = 0.5 * (last.forces[bar] + to.forces[bar]);
        work[bar] += mean * jumps[bar];
        work_of_jump += mean * jumps[bar];
        cost_of_jumps += std::abs((mean - last.forces[bar]) * jumps[bar]);
        impulse[bar] += mean * (to.t - last.t);
      }
    last = to;
    reports.emplace_back([to, work_of_jump](const StepRecord &of, PathObserver &observer) {
      observer.jumped_in_motion(of.in_motion(to), work_of_jump);
    });
  }

  void
  StepRecord::changed(const std::vector<ContactEvent> &events, const JointState &state)
  {
    last = state;
    reports.emplace_back([events, state](const StepRecord &of, PathObserver &observer) {
      std::vector<ContactEvent> in_motion = events;
      for (ContactEvent &event : in_motion)
        event.t = of.load_time(event.t);
      observer.changed(in_motion, of.in_motion(state));
    });
  }

  void
  StepRecord::reached(const std::size_t, const JointState &)
  {
    // Levels are handled by the path of all steps.
  }

  void
  StepRecord::replay(PathObserver &observer) const
  {
    for (const Report &report : reports)
      report(*this, observer);
  }

  double
  StepRecord::joint_work() const
  {
    return std::accumulate(work.begin(), work.end(), 0.);
  }

  double
  StepRecord::work_of_means() const
  {
    const Vector changes = change_of_jumps(first, last);
    double result        = 0.;
    for (std::size_t bar = 0; bar < changes.size(); ++bar)
      result += 0.5 * (first.forces[bar] + last.forces[bar]) * changes[bar];
    return result;
  }

  double
  StepRecord::cost_of_events(const double length, const double rate) const
  {
    const Vector changes = change_of_jumps(first, last);
    double result        = cost_of_jumps;
    for (const ContactElement &element : elements)
      {
        double energy = 0.;
        for (std::size_t i = 0; i < element.n_bars(); ++i)
          {
            const unsigned int bar = element.bar(i);
            const double mean      = 0.5 * (first.forces[bar] + last.forces[bar]);
            energy += work[bar] - mean * changes[bar];
            result += std::abs(impulse[bar] - last.t * mean) * length * rate;
          }
        result += std::abs(energy);
      }
    return result;
  }

  double
  StepRecord::largest_change() const
  {
    return max_abs(change_of_jumps(first, last));
  }

  Vector
  StepRecord::change_of_jumps(const JointState &from, const JointState &to) const
  {
    Vector result       = system.jumps(to.dislocations, to.forces);
    const Vector before = system.jumps(from.dislocations, from.forces);
    for (std::size_t bar = 0; bar < result.size(); ++bar)
      result[bar] -= before[bar];
    return result;
  }

  double
  StepRecord::load_time(const double of_path) const
  {
    return of_path == 1. ? end_time : first.t + of_path * (end_time - first.t);
  }

  JointState
  StepRecord::in_motion(JointState state) const
  {
    take_water(first, state);
    state.part_of_step = state.t;
    state.t            = load_time(state.t);
    return state;
  }

  PathPoint
  StepRecord::in_motion(const PathPoint &of_path) const
  {
    return {in_motion(of_path.state), of_path.rates, of_path.load_rate};
  }
} // namespace fuga
