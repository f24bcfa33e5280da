// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/curved_segment.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

// Follows a curve to its end: to its first event, to a limit or maximum of the load, or to the end
// of the course.
namespace fuga
{
  double
  CurvedSegment::find_end()
  {
    end = 0.; // as far as the curve is known, if a step fails
    // Parts of a stage by which the path may end below a limit, or a maximum of the load, if it can
    // be followed.
    constexpr double near_limit = 1e-8, near_maximum = 1e-9;
    StepControl length(first_step(context, course, start, steps.least_first));
    while (curve.back().tau < course.length)
      {
        const Station &from = curve.back();
        check_number_of_steps(curve.size(), from.point.state.t);
        if (turns() && (is_below_end_of_path(near_limit, near_maximum) || loses_control(from)))
          break;
        std::optional<Station> to = take_step(from, length);
        if (!to)
          break;
        if (first_event(from.functions, to->functions, to->tau - from.tau) <= 1.)
          if (std::optional<Station> event = locate(from, *to))
            {
              const double part = event->tau - from.tau;
              if (!is_resolved(from, *event) && part > steps.shortest_part)
                {
                  lost_slip.clear();
                  length.divide(part);
                  continue;
                }
              if (part > 0.)
                append(std::move(*event));
              break;
            }
        const bool is_event = meet(from, from, *to);
        if (to->error <= 1.)
          length.accept(steps.margin * to->error, turns());
        append(std::move(*to));
        if (is_event)
          break;
      }
    // An event may come just before the maximum.
    at_turning_point =
      at_turning_point || (turns() && !course.yielding && !at_limit && turns_back(near_maximum));
    return end = curve.back().tau;
  }

  // An error that a shorter step has left unchanged is rounding. Where nothing turns the shortest
  // step is taken whatever its error.
  std::optional<CurvedSegment::Station>
  CurvedSegment::take_step(const Station &from, StepControl &length)
  {
    const double rest = course.length - from.tau;
    double allowed    = 1.; // error, as far as it is rounding
    bool is_known     = !turns() || course.length <= 2. * steps.shortest;
    double rejected   = no_boundary; // error of a longer step
    while (true)
      {
        length.limit(rest);
        const double taken     = rest < steps.stretch * length() ? rest : length();
        const bool is_shortest = taken <= steps.shortest;
        const bool is_tried    = !turns() || !is_shortest || rest <= steps.shortest;
        Station to;
        const bool is_found = is_tried && step(from, taken, to);
        if (!is_found && is_shortest)
          break;
        const double error = is_found ? error_of_step(from, to) : no_boundary;
        if (!is_shortest && (!std::isfinite(error) || slips_back(from.point.state, to.point.state)))
          {
            length.fail();
            continue;
          }
        if (error > allowed && !is_known && (taken < steps.shortest_part || error > 0.5 * rejected))
          {
            allowed  = error_of_rounding(from);
            is_known = true;
          }
        to.error = error / allowed;
        if (to.error <= 1. || is_shortest)
          return to;
        rejected = to.error;
        length.reject(to.error);
      }
    expect_end(from.point);
    return {};
  }

  void
  CurvedSegment::append(Station &&station)
  {
    const JointState &state = station.point.state;
    if (!turns())
      jump_scale = std::max(jump_scale, size_of_jumps(state.dislocations, state.forces));
    curve.push_back(std::move(station));
  }

  // Only a part is left of a step that was found to be short enough, without the part beyond the
  // event that compensated for its errors. A slip that goes back and forth within a step, or comes
  // to rest in it, is seen once an event divides the step. A part may lose twice as much as a step
  // before its event is located again.
  bool
  CurvedSegment::is_resolved(const Station &from, Station &event) const
  {
    constexpr double largest = 2.;
    return defect_of_cubics(from, event) <= largest && rise_defect(from, event) <= 1. &&
           !slips_back(from.point.state, event.point.state);
  }

  // While slip directions turn into those of a mechanism, the load approaches its limit as slips
  // grow without bounds, exponentially: at the limit the jumps would double within a negligible
  // load, hardly any force responds, and the rates of slip grow like 1/(τ* - τ). Where they do not,
  // something soft moves far, but stands.
  bool
  CurvedSegment::grows_beyond_bounds(const double negligible_load, const double bend) const
  {
    constexpr double weak_answer = 1e-3;
    const JointRates &rates      = curve.back().point.rates;
    const JointState &state      = curve.back().point.state;
    const double growth          = max_abs(rates.dislocations);
    const double jump            = size_of_jumps(state.dislocations, state.forces);
    const double load            = negligible_load * std::max(1., course.t_end);
    // In the virgin state any growth is large.
    return jump > 0. && load * growth >= jump &&
           max_abs(rates.forces) <= weak_answer * context.system.largest_stiffness() * growth &&
           rates_diverge(points_of_curve(), 1, load, bend);
  }

  std::vector<CurvePoint>
  CurvedSegment::points_of_curve() const
  {
    std::vector<CurvePoint> result;
    for (const Station &station : curve)
      result.push_back({station.tau, &station.point});
    return result;
  }

  // Before a maximum of the load at τ* the rates of slip grow like (τ* - τ)^(-1/2).
  bool
  CurvedSegment::turns_back(const double negligible_load) const
  {
    return rates_diverge(
      points_of_curve(), 2, negligible_load * std::max(1., course.t_end), bend_of_maximum);
  }

  // A load that gives way to the motion has no end.
  bool
  CurvedSegment::is_below_end_of_path(const double near_limit, const double near_maximum)
  {
    at_limit         = !course.yielding && grows_beyond_bounds(near_limit, bend_of_limit);
    at_turning_point = !course.yielding && !at_limit && turns_back(near_maximum);
    return at_limit || at_turning_point;
  }

  // A boundary that is a few shortest steps ahead is met where the curve ends: of elements that
  // reach it together one may be a rounding error after the others. Slips that grow beyond bounds
  // although something resists them go on after a jump. Where nothing turns the equations of a
  // reduction have no solution beyond a limit.
  void
  CurvedSegment::expect_end(const PathPoint &point)
  {
    constexpr double just_ahead = 10., bend_at_last = 2. * bend_of_limit;
    if (!turns())
      {
        at_limit         = is_reduction();
        at_turning_point = !at_limit && turns_back(near_enough);
        if (!at_limit && !at_turning_point)
          give_up();
        return;
      }
    if (is_below_end_of_path(near_enough, near_enough))
      return;
    at_limit = !course.yielding && grows_beyond_bounds(near_enough, bend_at_last);
    at_turning_point =
      !course.yielding && !at_limit &&
      rates_diverge(points_of_curve(), 1, near_enough * std::max(1., course.t_end), bend_at_last);
    if (!at_limit && !at_turning_point &&
        context.boundary.distance(point.state, point.rates, course.drive) >=
          just_ahead * steps.shortest)
      give_up();
  }

  void
  CurvedSegment::give_up() const
  {
    const JointState &last = curve.back().point.state;
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (const ContactElement &element = context.elements[k];
          is_at_closure_limit(element, last, k))
        throw LawExhausted(
          fmt::format(
            "A layer has reached the limit of its law, a closure of {:.6g} m, at load time {:.9g}: "
            "under a pressure of {:.4g} MPa its closure differs from that by {:.1e} of it. "
            "Check thickness (or closure limit) and compliance of the joint.",
            closure_limit(element),
            last.t,
            -last.forces[element.normal_bar] / element.area,
            1. + gap(element, last, k) / closure_limit(element)),
          last);
    if (turns())
      throw PathFailure(fmt::format(
        "The path cannot be followed beyond load time {}: even the shortest step fails.", last.t));
    if (iteration == PathOptions::Iteration::newton)
      throw PathFailure(fmt::format(
        "No equilibrium of the nonlinear layer was found after load time {:.9g}.", last.t));
    double largest_ratio = 0.;
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (const ContactElement &element = context.elements[k];
          has_nonlinear_closure(element) && last.states[k] != ContactState::open)
        largest_ratio =
          std::max(largest_ratio,
                   layer_tangent(element, last, k).normal / initial_layer_tangent(element).normal);
    throw NumericalFailure(fmt::format(
      "The constant-stiffness iteration (3), (7), (8) diverges after load time {:.9g}, where a "
      "layer is {:.4g} times as stiff as at zero closure: too stiff for the matrix with its first "
      "stiffness. Under given forces 2 is the bound, for law (9) at a closure of 0.0604 of the "
      "thickness. Use Iteration = newton.",
      last.t,
      largest_ratio));
  }

  // Dislocations are rounded, so that forces leave the cones. A step puts them back, whatever its
  // length: the error of the shortest steps is rounding and no reason to shorten another one.
  double
  CurvedSegment::error_of_rounding(const Station &from)
  {
    constexpr double largest = 10., margin = 2.;
    double worst = 0.;
    for (const double multiple : {2., 8., 32.})
      {
        Station to;
        if (!step(from, multiple * steps.shortest, to))
          return 1.;
        const double error = error_of_step(from, to);
        if (!(error <= largest))
          return 1.;
        worst = std::max(worst, error);
      }
    return std::max(1., margin * worst);
  }
} // namespace fuga
