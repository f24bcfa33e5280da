// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/curved_segment.h>
#include <fuga/contact/segments/layer_work.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Estimates the errors that an observer of the ends of a step makes.
namespace fuga
{
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
    /** Return a state with the strengths, and with what is not yet released, in the middle between
     * two. */
    JointState
    in_the_middle(const JointState &from, JointState to)
    {
      for (std::size_t bar = 0; bar < to.unreleased.size(); ++bar)
        to.unreleased[bar] = 0.5 * (from.unreleased[bar] + to.unreleased[bar]);
      for (std::size_t k = 0; k < to.strengths.size(); ++k)
        {
          const Strength &start = from.strengths[k];
          Strength &strength    = to.strengths[k];
          strength.friction     = 0.5 * (start.friction + strength.friction);
          strength.cohesion     = 0.5 * (start.cohesion + strength.cohesion);
        }
      return to;
    }
  } // namespace

  // The defect is the error that an observer who takes forces and slips for cubics between the ends
  // of a step makes in the work of friction, relative to the share that is allowed.
  double
  CurvedSegment::work_defect(const Station &from, const Station &to) const
  {
    constexpr double allowed_share = 5e-11;
    constexpr double least_share   = 1e-13;
    double of_cubics               = 0.;
    const PathPoint &a = from.point, &b = to.point;
    for (const std::size_t k : turning)
      {
        const ContactElement &element = context.elements[k];
        const auto slip               = slip_between(element, k, a, b, to.length);
        const auto force              = shear_between(element, a, b, to.length);
        for (std::size_t i = 0; i < 2; ++i)
          of_cubics += work_of(force[i], slip[i]);
      }
    return std::abs(of_cubics - last_stages.work) /
           (allowed_share * std::abs(last_stages.work) + least_share * force_scale * jump_scale);
  }

  // The defect measures how far such an observer sees an element slip across its force, as work,
  // relative to the share of the work of the bars that is allowed, or to rounding: in the virgin
  // state bars have done no work yet. After an event directions may turn quickly into others, and
  // close to a limit slips bend more and more; the method's own error shows neither.
  double
  CurvedSegment::turn_defect(const Station &from, const Station &to) const
  {
    constexpr double allowed_share = 1e-10;
    const PathPoint &a = from.point, &b = to.point;
    double worst = 0.;
    for (const std::size_t k : turning)
      {
        const ContactElement &element = context.elements[k];
        const auto slip               = slip_between(element, k, a, b, to.length);
        const auto force              = shear_between(element, a, b, to.length);
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
  CurvedSegment::rise_defect(const Station &from, const Station &to) const
  {
    constexpr double allowed_share = 2e-10;
    double worst                   = 0.;
    for (const std::size_t k : slipping)
      {
        const PathPoint &a = from.point, &b = to.point;
        const double rise = a.state.strengths[k].dilatancy;
        if (rise == 0.)
          continue;
        const auto slip = slip_between(context.elements[k], k, a, b, to.length);
        const double way =
          length(sum(b.state.slips[k], -1., a.state.slips[k])) + detour(slip[0], slip[1]);
        worst = std::max(worst, std::abs(b.state.dilations[k] - a.state.dilations[k] - rise * way));
      }
    if (worst == 0.)
      return 0.;
    const JointState &state = to.point.state;
    return worst / (allowed_share * size_of_jumps(state.dislocations, state.forces));
  }

  // What nonlinear layers store is compared with the work of the cubics between the ends of a step.
  double
  CurvedSegment::defect_of_cubics(const Station &from, Station &to) const
  {
    const bool follows_strength = strengths_bend && !turns();
    if (!context.scheme.is_nonlinear() && !follows_strength)
      return 0.;
    double defect              = 0.;
    const ContactBoundary here = boundary_at(context, course, to.tau, to.point.state);
    if (context.scheme.is_nonlinear())
      {
        const StepEnergy energy =
          energy_of_step(context, course, here, from.point, to.point, to.length, to.tau, count);
        to.energy_lost = energy.lost;
        defect         = energy_defect(energy, least_energy_loss, count);
      }
    return follows_strength ? std::max(defect, strength_defect(from, to, here)) : defect;
  }

  // Beyond a point with zero rate of slip the equations of the scheme have spurious solutions, to
  // which a long step may lead: slips that have gone back.
  bool
  CurvedSegment::slips_back(const JointState &from, const JointState &to) const
  {
    const double noise =
      slip_rate_tolerance * std::max(jump_scale, size_of_jumps(to.dislocations, to.forces));
    return std::any_of(slipping.begin() + static_cast<std::ptrdiff_t>(turning.size()),
                       slipping.end(),
                       [&](const std::size_t k) {
                         return dot(context.scheme.slip_direction_of(k),
                                    sum(to.slips[k], -1., from.slips[k])) < -noise;
                       });
  }

  // The cubics between two points satisfy p = R a - W d, as both ends do, so that in the middle
  // only the equations of sliding elements tell how far the cubics are from the curve. A slip that
  // turns back between the points, and again before the second, must not be missed.
  double
  CurvedSegment::strength_defect(const Station &before,
                                 const Station &after,
                                 const ContactBoundary &here) const
  {
    // Error, relative to the largest force, that the cubics may make in the strength of sliding
    // elements. The cubics only tell where to look for events.
    constexpr double largest_miss = 1e-9;
    // Rounding of the largest dislocation.
    constexpr double rounding = 1e-13;
    const PathPoint &from = before.point, &to = after.point;
    const double length = after.length;
    const auto cubic =
      [length](
        const Vector &a, const Vector &da, const Vector &b, const Vector &db, const std::size_t i) {
        return CubicOnUnitInterval(a[i], da[i] * length, b[i], db[i] * length);
      };
    const double slowest =
      -slip_rate_tolerance * length *
        std::max(max_abs(from.rates.dislocations), max_abs(to.rates.dislocations)) -
      rounding * max_abs(to.state.dislocations);
    const JointState middle = in_the_middle(from.state, to.state);
    double miss             = 0.;
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        const ContactElement &element = context.elements[k];
        if (!is_slipping(to.state.states[k]))
          continue;
        const auto force = [&](const std::size_t bar) {
          return cubic(from.state.forces, from.rates.forces, to.state.forces, to.rates.forces, bar)
            .value(0.5);
        };
        const TangentVector e = context.scheme.slip_direction_of(k);
        const double strength = shear_strength(element, middle, k, force(element.normal_bar));
        const double noise    = here.strength_tolerance(k, to.state.strengths[k]);
        double slope          = 0.;
        for (std::size_t i = 1; i < element.n_bars(); ++i)
          {
            const std::size_t bar = element.bar(i);
            miss = std::max(miss, std::abs(force(bar) - e[i - 1] * strength) - noise);
            slope += e[i - 1] * cubic(from.state.dislocations,
                                      from.rates.dislocations,
                                      to.state.dislocations,
                                      to.rates.dislocations,
                                      bar)
                                  .slope(0.5);
          }
        if (!has_nonlinear_shear(element) && slope < slowest &&
            dot(e, tangential(element, from.rates.dislocations)) >= 0. &&
            dot(e, tangential(element, to.rates.dislocations)) >= 0.)
          return std::numeric_limits<double>::infinity();
      }
    const double largest = std::max(max_abs(from.state.forces), max_abs(to.state.forces));
    return largest > 0. ? miss / (largest_miss * largest) : 0.;
  }
} // namespace fuga
