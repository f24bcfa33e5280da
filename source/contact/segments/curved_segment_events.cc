// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>

#include <algorithm>
#include <limits>

// Finds where a curve meets the first boundary of the contact conditions.
namespace fuga
{
  // A load that is an unknown must not leave its range.
  void
  CurvedSegment::note_functions(Station &station) const
  {
    const PathPoint &point = station.point;
    station.functions =
      curve.empty() ? reserves.at_start() : reserves.at(station.tau, point, drive_of(station));
    if (course.yielding)
      {
        constexpr double rounding = 1e-14;
        const YieldingLoad &load  = *course.yielding;
        const double tolerance    = rounding * std::max(1., load.last_t);
        station.functions.push_back({point.state.t - load.first_t, *point.load_rate, tolerance});
        station.functions.push_back({load.last_t - point.state.t, -*point.load_rate, tolerance});
      }
    const double slow = slip_rate_tolerance * max_abs(point.rates.dislocations);
    for (std::size_t i = 0; i < slipping.size(); ++i)
      station.functions.push_back({station.slip_rates[i], 0., slow, slipping[i]});
  }

  // Where nothing turns a curve has no memory, and the step begins @p near its end. @p guess is that
  // of the dislocations there, if there is a better one than along the rates.
  std::optional<CurvedSegment::Station>
  CurvedSegment::step_from(const Station &from,
                           const Station &near,
                           const double tau,
                           Vector &&guess)
  {
    const Station &first = turns() ? from : near;
    Station to;
    to.point.state.dislocations = std::move(guess);
    if (!step(first, tau - first.tau, to))
      return {};
    to.length = tau - from.tau;
    return to;
  }

  namespace
  {
    /** Return the dislocations at the share @p x of the way between two points, @p length apart. */
    Vector
    dislocations_between(const PathPoint &a,
                         const PathPoint &b,
                         const double length,
                         const double x)
    {
      Vector result;
      for (std::size_t i = 0; i < a.state.dislocations.size(); ++i)
        result.push_back(CubicOnUnitInterval(a.state.dislocations[i],
                                             a.rates.dislocations[i] * length,
                                             b.state.dislocations[i],
                                             b.rates.dislocations[i] * length)
                           .value(x));
      return result;
    }
  } // namespace

  // The return value tells whether there is an event. Where all forces vanish together nothing is
  // left there to tell which elements are on a boundary, and the station stays where it is.
  bool
  CurvedSegment::meet(const Station &from, const Station &before, Station &reached)
  {
    return meet_event(from, before, reached, course.length, [&](const double tau) {
      std::optional<Station> nearer = step_from(from, reached, tau, {});
      if (!nearer)
        return nearer;
      const std::vector<std::size_t> met   = elements_on_boundary(reached),
                                     there = elements_on_boundary(*nearer);
      if (there.empty() || !std::includes(there.begin(), there.end(), met.begin(), met.end()))
        nearer.reset();
      return nearer;
    });
  }

  std::vector<std::size_t>
  CurvedSegment::elements_on_boundary(const Station &station) const
  {
    const JointState &state = station.point.state;
    std::vector<std::size_t> result;
    for (const BoundaryElement &candidate :
         boundary_at(context, course, station.tau, state).elements_on_boundary(state))
      result.push_back(candidate.element);
    return result;
  }

  // Shorter and longer steps are tried from the same point, until one ends at the event. Beyond a
  // limit load nothing is in equilibrium: a point that cannot be reached lies beyond the event.
  // Where its place is not resolved, what it changes is seen beyond it.
  std::optional<CurvedSegment::Station>
  CurvedSegment::locate(const Station &from, const Station &passed)
  {
    const double narrowest = 2. * std::numeric_limits<double>::epsilon() * course.length;
    std::optional<EventBracket<Station>> bracket = locate_event(
      from, passed, narrowest, [&](const EventBracket<Station> &within, const double tau) {
        const Station &low  = within.before.back();
        const double length = within.high.tau - low.tau;
        return step_from(
          from,
          low,
          tau,
          turns()
            ? Vector()
            : dislocations_between(low.point, within.high.point, length, (tau - low.tau) / length));
      });
    if (!bracket)
      return {};
    if (bracket->is_narrow && !bracket->is_open)
      bracket->before.push_back(std::move(bracket->high));
    Station &last = bracket->before.back();
    lost_slip     = slips_at_rest(bracket->last_but_one().functions, last.functions);
    meet(from, bracket->last_but_one(), last);
    return std::move(last);
  }
} // namespace fuga
