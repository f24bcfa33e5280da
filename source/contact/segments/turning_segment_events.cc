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
  std::optional<TurningSegment::Station>
  TurningSegment::step_from(const Station &from, const double tau)
  {
    Station to;
    double error;
    return step(from, tau - from.tau, to, error) ? std::optional<Station>(std::move(to))
                                                 : std::nullopt;
  }

  // The return value tells whether there is an event.
  bool
  TurningSegment::meet(const Station &from, Station &reached)
  {
    return meet_event(
      from, from, reached, course.length, [&](const double tau) { return step_from(from, tau); });
  }

  // Shorter and longer steps are tried from the same point, until one ends at the event. Beyond a
  // limit load nothing is in equilibrium: a point that cannot be reached lies beyond the event.
  std::optional<TurningSegment::Station>
  TurningSegment::locate(const Station &from, const Station &passed)
  {
    const double narrowest = 2. * std::numeric_limits<double>::epsilon() * parameter_scale();
    std::optional<EventBracket<Station>> bracket =
      locate_event(from, passed, narrowest, [&](const EventBracket<Station> &, const double tau) {
        return step_from(from, tau);
      });
    if (!bracket)
      return {};
    Station &last = bracket->before.back();
    lost_slip     = slips_at_rest(bracket->last_but_one().functions, last.functions);
    if (bracket->is_narrow && !bracket->is_open)
      for (const std::size_t k : slips_at_rest(last.functions, bracket->high.functions))
        if (std::find(lost_slip.begin(), lost_slip.end(), k) == lost_slip.end())
          lost_slip.push_back(k);
    meet(from, last);
    return std::move(last);
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

  // Dislocations are rounded, so that forces leave the cones. A step puts them back, whatever its
  // length: the error of the shortest steps is rounding and no reason to shorten another one.
  double
  TurningSegment::error_of_rounding(const Station &from, const double shortest)
  {
    constexpr double largest = 10., margin = 2.;
    double worst = 0.;
    for (const double length : {2. * shortest, 8. * shortest, 32. * shortest})
      {
        Station to;
        double error = 0.;
        if (!step(from, length, to, error) || error > largest)
          return 1.;
        worst = std::max(worst, error);
      }
    return std::max(1., margin * worst);
  }
} // namespace fuga
