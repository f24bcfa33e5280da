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
    , taus{0.}
    , points{start}
    , known(known_forces(context, course, 0., start.state))
    , first_reserves(context.boundary.reserves(
        start.state, start.rates, drive_at(context.elements, course, start.state)))
    , first_boundary(boundary_at(context, course, 0., start.state))
    , losses{0.}
    , functions{event_functions(0., start)}
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
    StepControl step(first_step(context, course, points.front(), least_first_step * course.length));
    while (taus.back() < course.length)
      {
        const std::size_t a = taus.size() - 1;
        check_number_of_steps(a, points[a].state.t);
        const double tau =
          course.length - taus[a] < 1.5 * step() ? course.length : taus[a] + step();
        std::optional<PathPoint> next = solve(
          tau, along(points[a].state.dislocations, tau - taus[a], points[a].rates.dislocations));
        double lost         = 0.;
        const double defect = next && !slips_back(points[a].state, next->state)
                                ? step_defect(a, *next, tau - taus[a], lost)
                                : no_boundary;
        if (defect > 1. && tau - taus[a] > shortest)
          {
            step.limit(tau - taus[a]);
            if (std::isfinite(defect))
              step.reject(defect);
            else
              step.fail();
            continue;
          }
        if (!next && is_reduction())
          {
            at_limit = true;
            return taus.back();
          }
        at_turning_point = !next && turns_back();
        if (at_turning_point)
          return taus.back();
        if (!next)
          give_up();
        const std::size_t b = insert(tau, std::move(*next), lost);
        if (first_root(a, b) < no_boundary)
          {
            locate_end(a, b);
            divide_behind(a, shortest);
            if (tau - taus[a] <= shortest || !slips_back_behind(a))
              return taus.back();
            forget_behind(a);
            lost_slip.clear();
            step.limit(tau - taus[a]);
            step.fail();
            continue;
          }
        if (defect <= 1.)
          step.accept(margin * defect, false);
      }
    return taus.back();
  }

  std::optional<PathPoint>
  CurvedSegment::solve(const double tau, const Vector &predicted_dislocations)
  {
    PathPoint point    = {points.front().state, {}};
    JointState &state  = point.state;
    state.dislocations = predicted_dislocations;
    release(course.drive, tau, state);
    complete_state(context, course, tau, state, &known);
    // A law is not defined beyond its closure limit, where the prediction may lead.
    if (passes_limit_of_law(context.elements, state))
      {
        state.dislocations = points.front().state.dislocations;
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
    if (!motion || motion->is_driven || is_behind_pole())
      return {};
    point.rates = std::move(motion->rates);
    return point;
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
  CurvedSegment::slips_back_behind(const std::size_t a) const
  {
    for (std::size_t i = a; i + 1 < points.size(); ++i)
      if (slips_back(points[i].state, points[i + 1].state))
        return true;
    return false;
  }

  // Where the load has a maximum there is no equilibrium beyond it, however short the step.
  bool
  CurvedSegment::turns_back() const
  {
    std::vector<CurvePoint> curve;
    for (std::size_t i = 0; i < points.size(); ++i)
      curve.push_back({taus[i], &points[i]});
    return rates_diverge(curve, 2, near_enough * std::max(1., course.t_end), bend_of_maximum);
  }

  void
  CurvedSegment::give_up() const
  {
    const JointState &last = points.back().state;
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
  CurvedSegment::divide_behind(std::size_t a, const double shortest)
  {
    constexpr int max_divisions = 40;
    for (int i = 0; i < max_divisions && a + 1 < taus.size();)
      {
        const double length     = taus[a + 1] - taus[a];
        const double middle     = taus[a] + 0.5 * length;
        const StepEnergy energy = energy_behind(a);
        losses[a + 1]           = energy.lost;
        std::optional<PathPoint> point;
        if (energy_defect(energy, options.least_energy_loss, count) > 1. && length > shortest)
          {
            point = solve(middle, interpolate(a, middle));
            ++i;
          }
        if (!point)
          ++a;
        else if (const std::size_t b = insert(middle, std::move(*point));
                 first_root(a, b) < no_boundary)
          locate_end(a, b);
      }
  }

  // A point beyond an event is not a state of the path.
  void
  CurvedSegment::fail_behind(const std::size_t a, const char *what)
  {
    forget_behind(a);
    throw PathFailure(fmt::format("{} after load time {}.", what, points[a].state.t));
  }

  void
  CurvedSegment::forget_behind(const std::size_t a)
  {
    taus.resize(a + 1);
    points.resize(a + 1);
    functions.resize(a + 1);
    losses.resize(a + 1);
  }

  std::size_t
  CurvedSegment::insert(const double tau, PathPoint &&point, const std::optional<double> &lost)
  {
    const auto place = std::upper_bound(taus.begin(), taus.end(), tau) - taus.begin();
    largest_jump     = std::max(largest_jump, jump_of(point));
    functions.insert(functions.begin() + place, event_functions(tau, point));
    points.insert(points.begin() + place, std::move(point));
    taus.insert(taus.begin() + place, tau);
    losses.insert(losses.begin() + place, lost);
    if (const auto behind = losses.begin() + place + 1; behind != losses.end())
      behind->reset();
    return static_cast<std::size_t>(place);
  }

  Vector
  CurvedSegment::interpolate(const std::size_t a, const double tau) const
  {
    const double length = taus[a + 1] - taus[a];
    const double share  = (tau - taus[a]) / length;
    Vector result(points[a].state.dislocations.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = CubicOnUnitInterval(points[a].state.dislocations[i],
                                      points[a].rates.dislocations[i] * length,
                                      points[a + 1].state.dislocations[i],
                                      points[a + 1].rates.dislocations[i] * length)
                    .value(share);
    return result;
  }

  PathPoint
  CurvedSegment::at(const double tau)
  {
    const auto place = std::lower_bound(taus.begin(), taus.end(), tau) - taus.begin();
    const auto b     = std::min(static_cast<std::size_t>(place), taus.size() - 1);
    if (taus[b] == tau || b == 0)
      return points[b];
    std::optional<PathPoint> point = solve(tau, interpolate(b - 1, tau));
    if (!point)
      throw NumericalFailure(
        fmt::format("No equilibrium was found after load time {}.", points[b - 1].state.t));
    return *point;
  }

  std::vector<double>
  CurvedSegment::stations() const
  {
    return taus;
  }

  StepEnergy
  CurvedSegment::energy_behind(const std::size_t a) const
  {
    return energy_of_step(
      context, course, points[a], points[a + 1], taus[a + 1] - taus[a], taus[a + 1], count);
  }

  double
  CurvedSegment::energy_lost()
  {
    double sum = 0.;
    for (std::size_t a = 0; a + 1 < points.size(); ++a)
      sum += losses[a + 1] ? *losses[a + 1] : energy_behind(a).lost;
    return sum;
  }

  std::vector<std::size_t>
  CurvedSegment::resticking() const
  {
    return lost_slip;
  }
} // namespace fuga
