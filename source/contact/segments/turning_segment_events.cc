// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/segments/turning_segment.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Finds where a curved piece of the path meets the first boundary of the contact conditions, and
// estimates the errors that an observer of its ends makes.
namespace fuga
{
  // The result is the share of the way from a to b at which the first reserve is used up, by cubics
  // and, for rates of slip, by secants; it is above one if none is.
  double
  TurningSegment::first_event(const Station &a, const Station &b) const
  {
    constexpr double none = 2.;
    const double length   = b.tau - a.tau;
    double first          = none;
    for (std::size_t i = 0; i < a.reserves.size(); ++i)
      {
        const Reserve &before = a.reserves[i], &after = b.reserves[i];
        // A reserve that was on its boundary at the beginning is left there by the rates.
        const bool leaving = before.value <= before.tolerance;
        const double value = std::max(0., before.value);
        const double rate  = leaving ? std::max(0., before.rate) : before.rate;
        const CubicOnUnitInterval course_of(value, rate * length, after.value, after.rate * length);
        if (after.value < -after.tolerance || course_of.minimum() < -before.tolerance)
          {
            const double root = course_of.first_descending_root();
            first             = std::min(
              first,
              root < 1. || after.value >= -after.tolerance ? root : value / (value - after.value));
          }
      }
    for (std::size_t i = 0; i < slipping.size(); ++i)
      if (b.slip_rates[i] < -rate_tolerance(b))
        {
          const double before = std::max(a.slip_rates[i], 0.);
          first               = std::min(first, before / (before - b.slip_rates[i]));
        }
    return first;
  }

  bool
  TurningSegment::is_passed(const Station &station) const
  {
    for (const Reserve &reserve : station.reserves)
      if (reserve.value < -reserve.tolerance)
        return true;
    for (const double rate : station.slip_rates)
      if (rate < -rate_tolerance(station))
        return true;
    return false;
  }

  bool
  TurningSegment::is_reached(const Station &from, const Station &station) const
  {
    if (way_to_event(from, station) < no_boundary)
      return true;
    for (std::size_t i = 0; i < slipping.size(); ++i)
      if (station.slip_rates[i] <= rate_tolerance(station) &&
          curve.back().slip_rates[i] > rate_tolerance(curve.back()))
        return true;
    return false;
  }

  // The result is the distance of the load, ahead or back, at which the first reserve is used up,
  // among those that are used up to within their tolerance.
  double
  TurningSegment::way_to_event(const Station &from, const Station &station) const
  {
    double way = no_boundary;
    for (std::size_t i = 0; i < station.reserves.size(); ++i)
      if (const Reserve &reserve = station.reserves[i];
          reserve.value <= reserve.tolerance && reserve.rate < 0. &&
          from.reserves[i].value > from.reserves[i].tolerance)
        way = std::min(way, -reserve.value / reserve.rate);
    return way;
  }

  // Tolerances are those of the rounding of the largest terms. An element that begins to slip must
  // not begin off its cone by as much, so the step to the event is corrected. The return value
  // tells whether there is an event.
  bool
  TurningSegment::meet_event(const Station &from, Station &reached)
  {
    constexpr double near = 0.01; // of the step
    const double way      = way_to_event(from, reached);
    if (way == no_boundary)
      return false;
    const double tau = reached.tau + way;
    Station nearer;
    double error;
    if (tau != reached.tau && std::abs(way) <= near * (reached.tau - from.tau) &&
        tau <= course.length && step(from, tau - from.tau, nearer, error) && !is_passed(nearer))
      reached = std::move(nearer);
    return true;
  }

  // Shorter and longer steps are tried from the same point, until one ends at the event.
  std::optional<TurningSegment::Station>
  TurningSegment::locate(const Station &from, const Station &passed)
  {
    constexpr int max_steps = 60;
    Station low = from, high = passed;
    const double resolution = std::numeric_limits<double>::epsilon() * parameter_scale();
    double end_of_steps     = high.tau;
    for (int i = 0; i < max_steps; ++i)
      {
        const double share = first_event(low, high);
        if (share > 1.)
          return {};
        double tau = low.tau + share * (high.tau - low.tau);
        // Every second time a bisection is made, in case the interpolation stagnates.
        if ((i > 4 && i % 2 == 0) || tau >= end_of_steps)
          tau = 0.5 * (low.tau + end_of_steps);
        if (tau - low.tau <= resolution || end_of_steps - low.tau <= 2. * resolution)
          {
            if (low.tau > from.tau || share <= 1e-9 || end_of_steps - low.tau <= 2. * resolution)
              break;
            tau = low.tau + 2. * resolution;
          }
        tau = std::min(tau, end_of_steps);
        Station middle;
        double error;
        // Beyond a limit load nothing is in equilibrium: a point that cannot be reached lies beyond
        // the event.
        if (!step(from, tau - from.tau, middle, error))
          {
            end_of_steps = tau;
            continue;
          }
        if (is_passed(middle))
          {
            high         = std::move(middle);
            end_of_steps = std::min(end_of_steps, high.tau);
          }
        else
          {
            low = std::move(middle);
            if (is_reached(from, low))
              break;
          }
      }
    for (std::size_t i = 0; i < slipping.size(); ++i)
      if (low.slip_rates[i] <= std::max(rate_tolerance(low), 0.) ||
          (high.slip_rates[i] < 0. && high.tau - low.tau <= 4. * resolution))
        if (from.slip_rates[i] > low.slip_rates[i] || high.slip_rates[i] < low.slip_rates[i])
          lost_slip.push_back(slipping[i]);
    meet_event(from, low);
    return low;
  }

  namespace
  {
    /** Return the slip of an element along its tangents, as an observer of the ends of a step sees
     * it. */
    std::array<CubicOnUnitInterval, 2>
    slip_between(const ContactElement &element,
                 const std::size_t k,
                 const PathPoint &a,
                 const PathPoint &b,
                 const double length)
    {
      const TangentVector a_rate = slip_rate(element, a.state, k, a.rates),
                          b_rate = slip_rate(element, b.state, k, b.rates);
      const auto along           = [&](const std::size_t i) {
        return CubicOnUnitInterval(
          a.state.slips[k][i], a_rate[i] * length, b.state.slips[k][i], b_rate[i] * length);
      };
      return {{along(0), along(1)}};
    }

    /** Return the shear force in the same way. */
    std::array<CubicOnUnitInterval, 2>
    shear_between(const ContactElement &element,
                  const PathPoint &a,
                  const PathPoint &b,
                  const double length)
    {
      const auto along = [&](const std::size_t bar) {
        return CubicOnUnitInterval(a.state.forces[bar],
                                   a.rates.forces[bar] * length,
                                   b.state.forces[bar],
                                   b.rates.forces[bar] * length);
      };
      return {{along(element.bar(1)), along(element.bar(2))}};
    }
  } // namespace

  // The defect is the error that an observer who takes forces and slips for cubics between the ends
  // of a step makes in the work of friction, relative to the share that is allowed.
  double
  TurningSegment::work_defect(const Station &from,
                              const Station &to,
                              const double length,
                              const double work) const
  {
    constexpr double allowed_share = 5e-11;
    constexpr double least_share   = 1e-13;
    double of_cubics               = 0.;
    const PathPoint &a = from.point, &b = to.point;
    for (const std::size_t k : turning)
      {
        const ContactElement &element = context.elements[k];
        const auto slip               = slip_between(element, k, a, b, length);
        const auto force              = shear_between(element, a, b, length);
        for (std::size_t i = 0; i < 2; ++i)
          of_cubics += work_of(force[i], slip[i]);
      }
    return std::abs(of_cubics - work) /
           (allowed_share * std::abs(work) + least_share * force_scale * jump_scale);
  }

  // The defect measures how far such an observer sees an element slip across its force, as work,
  // relative to the share of the work of the bars that is allowed, or to rounding: in the virgin
  // state bars have done no work yet. After an event directions may turn quickly into others, and
  // close to a limit slips bend more and more; the method's own error shows neither.
  double
  TurningSegment::turn_defect(const Station &from, const Station &to, const double length) const
  {
    constexpr double allowed_share = 1e-10;
    const PathPoint &a = from.point, &b = to.point;
    double worst = 0.;
    for (const std::size_t k : turning)
      {
        const ContactElement &element = context.elements[k];
        const auto slip               = slip_between(element, k, a, b, length);
        const auto force              = shear_between(element, a, b, length);
        for (const double x : {0.25, 0.5, 0.75})
          worst = std::max(worst, work_across(force, slip, x));
      }
    if (worst == 0.)
      return 0.;
    const Vector jumps = context.system.jumps(b.state.dislocations, b.state.forces);
    double of_bars     = 0.;
    for (std::size_t bar = 0; bar < jumps.size(); ++bar)
      of_bars += std::abs(jumps[bar] * b.state.forces[bar]);
    const double rounding = std::numeric_limits<double>::epsilon() * force_scale * jump_scale;
    return worst / (allowed_share * of_bars + rounding);
  }

  // The defect is the error that an observer who takes slips for cubics between the ends of a step
  // makes in the rise of the lips, relative to the share of the jumps reached so far that is
  // allowed.
  double
  TurningSegment::rise_defect(const Station &from, const Station &to, const double length) const
  {
    constexpr double allowed_share = 2e-10;
    double worst                   = 0.;
    for (const std::size_t k : turning)
      {
        const ContactElement &element = context.elements[k];
        const PathPoint &a = from.point, &b = to.point;
        const double rise = a.state.strengths[k].dilatancy;
        if (rise == 0.)
          continue;
        const auto slip = slip_between(element, k, a, b, length);
        const double way =
          fuga::length(sum(b.state.slips[k], -1., a.state.slips[k])) + detour(slip[0], slip[1]);
        worst = std::max(worst, std::abs(b.state.dilations[k] - a.state.dilations[k] - rise * way));
      }
    if (worst == 0.)
      return 0.;
    const JointState &state = to.point.state;
    return worst /
           (allowed_share * max_abs(context.system.jumps(state.dislocations, state.forces)));
  }
} // namespace fuga
