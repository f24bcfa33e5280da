// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/segments/event_location.h>

namespace fuga
{
  ReservesOfCurve::ReservesOfCurve(const PathContext &path_context,
                                   const Course &path_course,
                                   const PathPoint &start,
                                   const Drive &drive)
    : context(path_context)
    , course(path_course)
    , first_boundary(boundary_at(context, course, 0., start.state))
    , first(context.boundary.reserves(start.state, start.rates, drive))
  {
  }

  EventFunctions
  ReservesOfCurve::at_start() const
  {
    EventFunctions result;
    for (const Reserve &reserve : first)
      result.push_back({reserve.value, reserve.rate, reserve.tolerance});
    return result;
  }

  EventFunctions
  ReservesOfCurve::at(const double tau, const PathPoint &point, const Drive &drive) const
  {
    const JointState &state             = point.state;
    const std::vector<Reserve> reserves = boundary_at(context, course, tau, state)
                                            .reserves(state, point.rates, drive),
                               by_start = first_boundary.reserves(state, point.rates, drive);
    EventFunctions result;
    for (std::size_t i = 0; i < reserves.size(); ++i)
      result.push_back({reserves[i].value,
                        reserves[i].rate,
                        std::max(reserves[i].tolerance, by_start[i].tolerance) +
                          first[i].drift(tau, reserves[i].noise)});
    return result;
  }

  namespace
  {
    double
    first_rest(const EventFunction &a, const EventFunction &b)
    {
      const double before = std::max(a.value, 0.);
      return b.value < -b.tolerance ? before / (before - b.value) : no_boundary;
    }

    // A reserve that is on its boundary at the beginning is left there by the rates. One that is
    // zero at both points and grows, or falls, at both has rates of rounding. Where strength has no
    // limit the reserve is infinite.
    double
    first_zero(const EventFunction &a, const EventFunction &b, const double length)
    {
      const bool is_leaving = a.value <= a.tolerance;
      if (!std::isfinite(a.value) || !std::isfinite(b.value))
        return no_boundary;
      if (is_leaving && std::abs(b.value) <= b.tolerance && a.rate * b.rate > 0.)
        return no_boundary;
      const double value = std::max(0., a.value);
      const double rate  = is_leaving ? std::max(0., a.rate) : a.rate;
      const CubicOnUnitInterval cubic(value, rate * length, b.value, b.rate * length);
      const bool is_violated = b.value < -b.tolerance;
      if (!is_violated && cubic.minimum() >= -b.tolerance)
        return no_boundary;
      const double root = cubic.first_descending_root();
      return root < 1. || !is_violated ? root : value / (value - b.value);
    }
  } // namespace

  double
  first_event(const EventFunctions &a, const EventFunctions &b, const double length)
  {
    double first = no_boundary;
    for (std::size_t i = 0; i < a.size(); ++i)
      first =
        std::min(first, a[i].slipping ? first_rest(a[i], b[i]) : first_zero(a[i], b[i], length));
    return first;
  }

  bool
  is_violated(const EventFunctions &functions)
  {
    return std::any_of(functions.begin(), functions.end(), [](const EventFunction &f) {
      return f.value < -f.tolerance;
    });
  }

  double
  way_to_event(const EventFunctions &before, const EventFunctions &at, const double length)
  {
    double way = no_boundary;
    for (std::size_t i = 0; i < at.size(); ++i)
      if (const EventFunction &f = at[i], &g = before[i];
          !f.slipping && f.value <= f.tolerance && f.rate < 0. &&
          (g.value > g.tolerance || g.rate * length > f.tolerance))
        way = std::min(way, -f.value / f.rate);
    return way;
  }

  bool
  is_met(const EventFunctions &before, const EventFunctions &at, const double length)
  {
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i].slipping && at[i].value <= at[i].tolerance && before[i].value > before[i].tolerance)
        return true;
    return way_to_event(before, at, length) < no_boundary;
  }

  std::vector<std::size_t>
  slips_at_rest(const EventFunctions &before, const EventFunctions &at)
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i].slipping && at[i].value <= at[i].tolerance && before[i].value > at[i].value)
        result.push_back(*at[i].slipping);
    return result;
  }
} // namespace fuga
