// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/dynamics/dynamic_path.h>

#include <algorithm>
#include <cmath>

// The cost of a time step that does not know when something happened within it, and the cost that
// is allowed.
namespace fuga
{
  // In the shortest steps events may have any cost. Costs grow at least fourfold with every
  // doubling of the step; after a step without events any length may be tried.
  std::optional<unsigned int>
  DynamicPath::promising_rung_after(const Attempt &attempt, const unsigned int number) const
  {
    constexpr double growth = 4.;
    if (!attempt.failure.empty())
      return {};
    const double allowed = allowed_cost(attempt.record);
    double cost =
      cost_of_events(attempt.record, number) + cost_of_rest(attempt.record, grid.length_of(number));
    if (number < grid.halvings && cost > allowed)
      return {};
    unsigned int result = number;
    for (cost *= growth; result > 0 && cost <= allowed; cost *= growth)
      --result;
    return result;
  }

  // Hundreds of events may follow an impact. Where the first ones already cost that much, shorter
  // steps will count, and the rest of this step is not followed.
  bool
  DynamicPath::is_hopeless(const StepRecord &record, const unsigned int number) const
  {
    constexpr double far_beyond = 10.;
    return number < grid.halvings &&
           cost_of_events(record, number) > far_beyond * allowed_cost(record);
  }

  double
  DynamicPath::cost_of_events(const StepRecord &record, const unsigned int number) const
  {
    const double length = grid.length_of(number);
    return record.cost_of_events(length, std::max(largest_rate, record.largest_change() / length));
  }

  double
  DynamicPath::allowed_cost(const StepRecord &record) const
  {
    return grid.event_tolerance * std::max(ledger.largest, std::abs(record.joint_work())) +
           ledger.rounding;
  }

  // The rate at the end of the step is extrapolated from the mean rates of this step and the one
  // before; where it points against the slip, the element came to rest in between.
  double
  DynamicPath::cost_of_rest(const StepRecord &record, const double length) const
  {
    double cost = 0.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const TangentVector rate = mean_slip_rate(record, k, length);
        if (fuga::length(rate) == 0. || fuga::length(slip_rates[k]) == 0.)
          continue;
        const TangentVector change = sum(rate, -1., slip_rates[k]);
        const TangentVector at_end = sum(rate, length / (length + length_before), change);
        const double back          = -dot(at_end, direction_of(rate));
        if (back <= 0.)
          continue;
        const double slowing = 2. * fuga::length(change) / (length + length_before);
        cost += fuga::length(tangential(elements[k], record.end().forces)) * 0.5 * back *
                std::min(length, back / slowing);
      }
    return cost;
  }

  TangentVector
  DynamicPath::mean_slip_rate(const StepRecord &record,
                              const std::size_t k,
                              const double length) const
  {
    if (!is_slipping(record.end().states[k]))
      return {};
    const TangentVector slip = sum(record.end().slips[k], -1., record.start().slips[k]);
    return {{slip[0] / length, slip[1] / length}};
  }
} // namespace fuga
