// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>
#include <fuga/contact/segments/step_control.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Shares of the course: least first step, shortest step, and the latter for the
     * constant-stiffness iteration, which only creeps towards its bound. */
    constexpr double least_first_step = 1e-3, shortest_step = 1e-9, shortest_constant_step = 1e-5;
    /** The next step aims at a defect that is this many times smaller than what is allowed: a part
     * that falls below it on the way to an event is not followed again. */
    constexpr double margin = 8.;
  } // namespace

  CurvedSegment::CurvedSegment(const PathContext &path_context,
                               const Course &path_course,
                               const PathPoint &start,
                               const PathOptions &path_options,
                               IterationCount &iteration_count)
    : context(path_context)
    , course(path_course)
    , options(path_options)
    , count(iteration_count)
    , equilibrium(context,
                  course,
                  options,
                  count,
                  context.scheme.rates(drive_at(context.elements, course, start.state))
                    ? SchemeAnswer::of_no_mechanism
                    : SchemeAnswer::of_any_size)
    , reserves(context, course, start, drive_at(context.elements, course, start.state))
    , curve{{0., start, functions_at(0., start), 0.}}
    , known(known_forces(context, course, 0., start.state))
    , largest_jump(jump_of(start))
    , determinant_sign(is_reduction() ? context.scheme.determinant_sign() : 0)
  {
  }

  double
  CurvedSegment::jump_of(const PathPoint &point) const
  {
    return max_abs(context.system.jumps(point.state.dislocations, point.state.forces));
  }

  double
  CurvedSegment::find_end()
  {
    const double shortest = course.length * (options.iteration == PathOptions::Iteration::newton
                                               ? shortest_step
                                               : shortest_constant_step);
    StepControl step(
      first_step(context, course, curve.front().point, least_first_step * course.length));
    while (curve.back().tau < course.length)
      {
        const std::size_t a = curve.size() - 1;
        const Station &from = curve.back();
        check_number_of_steps(a, from.point.state.t);
        const double tau =
          course.length - from.tau < 1.5 * step() ? course.length : from.tau + step();
        const double length = tau - from.tau;
        std::optional<Station> next =
          solve(tau, along(from.point.state.dislocations, length, from.point.rates.dislocations));
        const double defect = next && !slips_back(from.point.state, next->point.state)
                                ? step_defect(from, *next)
                                : no_boundary;
        if (defect > 1. && length > shortest)
          {
            step.limit(length);
            if (std::isfinite(defect))
              step.reject(defect);
            else
              step.fail();
            continue;
          }
        at_limit         = !next && is_reduction();
        at_turning_point = !next && !at_limit && turns_back();
        if (at_limit || at_turning_point)
          break;
        if (!next)
          give_up();
        if (ends_before(a, *next))
          {
            divide_after(a, shortest);
            if (length <= shortest || !slips_back_after(a))
              break;
            curve.resize(a + 1);
            lost_slip.clear();
            step.limit(length);
            step.fail();
            continue;
          }
        curve.push_back(std::move(*next));
        if (defect <= 1.)
          step.accept(margin * defect, false);
      }
    return curve.back().tau;
  }

  std::optional<CurvedSegment::Station>
  CurvedSegment::solve(const double tau, const Vector &predicted_dislocations)
  {
    PathPoint point    = {curve.front().point.state, {}};
    JointState &state  = point.state;
    state.dislocations = predicted_dislocations;
    release(course.drive, tau, state);
    complete_state(context, course, tau, state, &known);
    // A law is not defined beyond its closure limit, where the prediction may lead.
    if (passes_limit_of_law(context.elements, state))
      {
        state.dislocations = curve.front().point.state.dislocations;
        complete_state(context, course, tau, state, &known);
      }
    if (course.share_rate != 0.)
      for (std::size_t k = 0; k < context.elements.size(); ++k)
        context.scheme.set_strength(k, state.strengths[k]);
    // On the way forces are computed from the first ones, at the end they are not.
    if (!equilibrium.solve(tau, largest_jump, state, &known))
      return {};
    if (context.system.refines_forces(state.dislocations, state.forces))
      {
        complete_state(context, course, tau, state);
        if (!equilibrium.solve(tau, largest_jump, state))
          return {};
      }

    context.scheme.linearise(state);
    std::optional<WorkingScheme::FreeMotion> motion =
      context.scheme.motion(drive_at(context.elements, course, state));
    if (!motion || motion->is_driven || has_crossed_pole())
      return {};
    point.rates              = std::move(motion->rates);
    largest_jump             = std::max(largest_jump, jump_of(point));
    EventFunctions functions = functions_at(tau, point);
    return Station{tau, std::move(point), std::move(functions), {}};
  }

  std::optional<CurvedSegment::Station>
  CurvedSegment::solve_between(const Station &a, const Station &b, const double tau)
  {
    const double length = b.tau - a.tau;
    Vector predicted(a.point.state.dislocations.size());
    for (std::size_t i = 0; i < predicted.size(); ++i)
      predicted[i] = CubicOnUnitInterval(a.point.state.dislocations[i],
                                         a.point.rates.dislocations[i] * length,
                                         b.point.state.dislocations[i],
                                         b.point.rates.dislocations[i] * length)
                       .value((tau - a.tau) / length);
    return solve(tau, predicted);
  }

  // Beyond a point with zero rate of slip the equations of the scheme have spurious solutions, to
  // which a long step may lead: slips that have gone back.
  bool
  CurvedSegment::slips_back(const JointState &from, const JointState &to) const
  {
    const double noise = slip_rate_tolerance * largest_jump;
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(to.states[k]) && carries_shear(context.elements[k], to.strengths[k]) &&
          dot(context.scheme.slip_direction_of(k), sum(to.slips[k], -1., from.slips[k])) < -noise)
        return true;
    return false;
  }

  // A slip that goes back and forth within a step is seen once an event divides the step.
  bool
  CurvedSegment::slips_back_after(const std::size_t a) const
  {
    for (std::size_t i = a; i + 1 < curve.size(); ++i)
      if (slips_back(curve[i].point.state, curve[i + 1].point.state))
        return true;
    return false;
  }

  // Where the load has a maximum there is no equilibrium beyond it, however short the step.
  bool
  CurvedSegment::turns_back() const
  {
    std::vector<CurvePoint> points;
    for (const Station &station : curve)
      points.push_back({station.tau, &station.point});
    return rates_diverge(points, 2, near_enough * std::max(1., course.t_end), bend_of_maximum);
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
    if (options.iteration == PathOptions::Iteration::newton)
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

  // Only a part is left of a step that was found to be short enough, without the part beyond the
  // event that compensated for its errors.
  void
  CurvedSegment::divide_after(std::size_t a, const double shortest)
  {
    constexpr int max_divisions = 40;
    for (int i = 0; i < max_divisions && a + 1 < curve.size();)
      {
        const double length      = curve[a + 1].tau - curve[a].tau;
        const StepEnergy energy  = energy_between(curve[a], curve[a + 1]);
        curve[a + 1].energy_lost = energy.lost;
        std::optional<Station> middle;
        if (energy_defect(energy, options.least_energy_loss, count) > 1. && length > shortest)
          {
            middle = solve_between(curve[a], curve[a + 1], curve[a].tau + 0.5 * length);
            ++i;
          }
        if (!middle)
          ++a;
        else if (!ends_before(a, *middle))
          {
            curve[a + 1].energy_lost.reset();
            curve.insert(curve.begin() + static_cast<std::ptrdiff_t>(a) + 1, std::move(*middle));
          }
      }
  }

  PathPoint
  CurvedSegment::at(const double tau)
  {
    const auto b = std::lower_bound(
      curve.begin(), curve.end() - 1, tau, [](const Station &station, const double place) {
        return station.tau < place;
      });
    if (b->tau == tau || b == curve.begin())
      return b->point;
    std::optional<Station> station = solve_between(*(b - 1), *b, tau);
    if (!station)
      throw NumericalFailure(
        fmt::format("No equilibrium was found after load time {}.", (b - 1)->point.state.t));
    return station->point;
  }

  std::vector<double>
  CurvedSegment::stations() const
  {
    std::vector<double> result;
    for (const Station &station : curve)
      result.push_back(station.tau);
    return result;
  }

  StepEnergy
  CurvedSegment::energy_between(const Station &a, const Station &b) const
  {
    return energy_of_step(context, course, a.point, b.point, b.tau - a.tau, b.tau, count);
  }

  double
  CurvedSegment::energy_lost()
  {
    double sum = 0.;
    for (std::size_t b = 1; b < curve.size(); ++b)
      sum +=
        curve[b].energy_lost ? *curve[b].energy_lost : energy_between(curve[b - 1], curve[b]).lost;
    return sum;
  }

  std::vector<std::size_t>
  CurvedSegment::resticking() const
  {
    return lost_slip;
  }
} // namespace fuga
