// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>

// Finds where a curve meets the first boundary of the contact conditions, and estimates the errors
// of its steps.
namespace fuga
{
  EventFunctions
  CurvedSegment::functions_at(const double tau, const PathPoint &point) const
  {
    const JointState &state = point.state;
    EventFunctions result   = tau == 0.
                                ? reserves.at_start()
                                : reserves.at(tau, point, drive_at(context.elements, course, state));
    const double slow       = slip_rate_tolerance *
                        max_abs(context.system.jumps(point.rates.dislocations, point.rates.forces));
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(state.states[k]) && carries_shear(context.elements[k], state.strengths[k]))
        result.push_back({slip_speed(context, point, k), 0., slow, k});
    return result;
  }

  // The return value tells whether there is an event between station @p a and @p passed. Nothing
  // after it is a state of the path. Where its place is not resolved, what it changes is seen
  // beyond it.
  bool
  CurvedSegment::ends_before(const std::size_t a, const Station &passed)
  {
    const Station &from = curve[a];
    if (first_event(from.functions, passed.functions, passed.tau - from.tau) > 1.)
      return false;
    std::optional<EventBracket<Station>> bracket =
      locate_event(from,
                   passed,
                   1e-14 * course.length,
                   [this](const EventBracket<Station> &within, const double tau) {
                     return solve_between(within.before.back(), within.high, tau);
                   });
    if (!bracket)
      return false;
    if (bracket->is_narrow && bracket->is_open)
      throw PathFailure(fmt::format("An event could not be located after load time {}.",
                                    bracket->before.back().point.state.t));
    if (bracket->is_narrow)
      bracket->before.push_back(std::move(bracket->high));
    Station &end = bracket->before.back();
    lost_slip    = slips_at_rest(bracket->last_but_one().functions, end.functions);
    meet(from, bracket->last_but_one(), end);
    curve.resize(a);
    std::move(bracket->before.begin(), bracket->before.end(), std::back_inserter(curve));
    return true;
  }

  // Where all forces vanish together nothing is left there to tell which elements are on a
  // boundary, and the station stays where it is.
  void
  CurvedSegment::meet(const Station &from, const Station &before, Station &reached)
  {
    meet_event(from, before, reached, course.length, [&](const double tau) {
      std::optional<Station> nearer = solve(tau, reached.point.state.dislocations);
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

  namespace
  {
    /** Error, relative to the largest force, that the cubics between two points may make in the
     * strength of sliding elements. The cubics only tell where to look for events. */
    constexpr double largest_miss = 1e-9;
  } // namespace

  // On the way from strength to strength the determinant of a scheme passes zero only where its
  // equations have no solution; beyond that place they have another solution, to which no path
  // leads.
  bool
  CurvedSegment::has_crossed_pole() const
  {
    return is_reduction() && context.scheme.determinant_sign() != determinant_sign;
  }

  // The defect is at most 1 for a step that is short enough.
  double
  CurvedSegment::step_defect(const Station &from, Station &to) const
  {
    const StepEnergy energy = energy_between(from, to);
    to.energy_lost          = energy.lost;
    const double defect     = energy_defect(energy, options.least_energy_loss, count);
    return is_reduction()
             ? std::max(defect, reduction_defect(from.point, to.point, to.tau - from.tau))
             : defect;
  }

  // The cubics between two points satisfy p = R a - W d, as both ends do, so that in the middle
  // only the equations of sliding elements tell how far the cubics are from the curve. A slip that
  // turns back between the points, and again before the second, must not be missed.
  double
  CurvedSegment::reduction_defect(const PathPoint &from,
                                  const PathPoint &to,
                                  const double length) const
  {
    const auto cubic =
      [length](
        const Vector &a, const Vector &da, const Vector &b, const Vector &db, const std::size_t i) {
        return CubicOnUnitInterval(a[i], da[i] * length, b[i], db[i] * length);
      };
    const double slowest =
      -slip_rate_tolerance * length *
      std::max(max_abs(from.rates.dislocations), max_abs(to.rates.dislocations));
    double miss = 0.;
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
        const Strength &a     = from.state.strengths[k];
        const Strength &b     = to.state.strengths[k];
        const double strength = 0.5 * (a.cohesion + b.cohesion) -
                                0.5 * (a.friction + b.friction) * force(element.normal_bar);
        double slope = 0.;
        for (std::size_t i = 1; i < element.n_bars(); ++i)
          {
            const std::size_t bar = element.bar(i);
            miss                  = std::max(miss, std::abs(force(bar) - e[i - 1] * strength));
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
