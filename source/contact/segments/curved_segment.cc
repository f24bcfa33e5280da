// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>
#include <fuga/contact/segments/layer_work.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** First step as share of the course, growth of steps, and the shortest one. */
    constexpr double first_step  = 1e-3;
    constexpr double step_growth = 2.;
    /** The energy defect of a step falls with this power of its length. */
    constexpr double order         = 5.;
    constexpr double shortest_step = 1e-9;
    /** The same for the constant-stiffness iteration, which only creeps towards its bound. */
    constexpr double shortest_constant_step = 1e-5;
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
    , equilibrium(context, course, options, count)
    , taus{0.}
    , points{start}
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
    double step           = first_step * course.length;
    while (taus.back() < course.length)
      {
        const std::size_t a = taus.size() - 1;
        const double tau    = course.length - taus[a] < 1.5 * step ? course.length : taus[a] + step;
        Vector predicted    = points[a].state.dislocations;
        for (std::size_t i = 0; i < predicted.size(); ++i)
          predicted[i] += (tau - taus[a]) * points[a].rates.dislocations[i];

        std::optional<PathPoint> next = solve(tau, predicted);
        const double defect           = next && !slips_back(points[a].state, next->state)
                                          ? step_defect(points[a], *next, tau - taus[a])
                                          : no_boundary;
        if (defect > 1. && tau - taus[a] > shortest)
          {
            step = (tau - taus[a]) / (2. * step_growth);
            continue;
          }
        if (!next && is_reduction())
          {
            at_limit = true;
            return taus.back();
          }
        if (!next)
          give_up();
        const std::size_t b = insert(tau, std::move(*next));
        if (first_root(a, b) < no_boundary)
          {
            locate_end(a, b);
            divide_behind(a, shortest);
            return taus.back();
          }
        if (defect < 1. / std::pow(step_growth, order))
          step *= step_growth;
      }
    return taus.back();
  }

  // Behind a rate of slip that is zero the equations of the scheme have solutions that are none, to
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

  void
  CurvedSegment::give_up() const
  {
    const JointState &last = points.back().state;
    if (options.iteration == PathOptions::Iteration::newton)
      throw NumericalFailure(fmt::format(
        "No equilibrium of the nonlinear layer was found behind load time {:.9g}.", last.t));
    double largest_ratio = 0.;
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (const ContactElement &element = context.elements[k];
          has_nonlinear_closure(element) && last.states[k] != ContactState::open)
        largest_ratio =
          std::max(largest_ratio,
                   layer_tangent(element, last, k).normal / initial_layer_tangent(element).normal);
    throw NumericalFailure(fmt::format(
      "The constant-stiffness iteration (3), (7), (8) diverges behind load time {:.9g}, where a "
      "layer is {:.4g} times as stiff as at zero closure: too stiff for the matrix with its first "
      "stiffness. Under given forces 2 is the bound, for law (9) at a closure of 0.0604 of the "
      "thickness. Use Iteration = newton.",
      last.t,
      largest_ratio));
  }

  // Shrinks the bracket [a, b], of which only b lies behind an event, onto the first event.
  void
  CurvedSegment::locate_end(std::size_t a, std::size_t b)
  {
    lost_slip.clear();
    const int max_trials = 200;
    for (int trial = 0; trial < max_trials; ++trial)
      {
        double root        = first_root(a, b);
        const double width = taus[b] - taus[a];
        // The interpolation is trusted as long as it shrinks the bracket; every fourth time it is
        // halved.
        if (trial % 4 == 3 || root == no_boundary)
          root = taus[a] + 0.5 * width;
        root = std::clamp(root, taus[a] + 1e-3 * width, taus[b]);

        if (root < taus[b])
          {
            std::optional<PathPoint> point = solve(root, interpolate(a, root));
            if (!point)
              fail_behind(a, "An event could not be located");
            b = insert(root, std::move(*point));
          }
        const auto &at_root = functions[b];
        const bool violated =
          std::any_of(at_root.begin(), at_root.end(), [](const EventFunction &f) {
            return f.value < -f.tolerance;
          });
        const bool narrow = taus[b] - taus[a] <= 1e-14 * course.length;
        const auto is_met = [&](const std::size_t i) {
          return at_root[i].value <= at_root[i].tolerance &&
                 functions[a][i].value > at_root[i].value;
        };
        bool met = false;
        for (std::size_t i = 0; i < at_root.size(); ++i)
          met |= is_met(i);
        if (narrow || (met && !violated))
          {
            for (std::size_t i = 0; i < at_root.size(); ++i)
              if (!at_root[i].has_rate && is_met(i))
                lost_slip.push_back(at_root[i].element);
            forget_behind(b);
            return;
          }
        if (!violated)
          {
            a = b;
            ++b;
          }
      }
    fail_behind(a, "The location of an event does not converge");
  }

  // Of a step that was found to be short enough only a part is left, without what lies behind the
  // event and made up for its errors.
  void
  CurvedSegment::divide_behind(std::size_t a, const double shortest)
  {
    constexpr int max_divisions = 40;
    for (int i = 0; i < max_divisions && a + 1 < taus.size();)
      {
        const double length = taus[a + 1] - taus[a];
        const double defect =
          energy_defect(context, course, points[a], points[a + 1], length, taus[a + 1], count);
        const double middle = taus[a] + 0.5 * length;
        std::optional<PathPoint> point;
        if (defect > 1. && length > shortest)
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

  // What lies behind an event is no state of the path.
  void
  CurvedSegment::fail_behind(const std::size_t a, const char *what)
  {
    forget_behind(a);
    throw NumericalFailure(fmt::format("{} behind load time {}.", what, points[a].state.t));
  }

  void
  CurvedSegment::forget_behind(const std::size_t a)
  {
    taus.resize(a + 1);
    points.resize(a + 1);
    functions.resize(a + 1);
  }

  std::size_t
  CurvedSegment::insert(const double tau, PathPoint &&point)
  {
    const auto place = std::upper_bound(taus.begin(), taus.end(), tau) - taus.begin();
    largest_jump     = std::max(largest_jump, jump_of(point));
    functions.insert(functions.begin() + place, event_functions(tau, point));
    points.insert(points.begin() + place, std::move(point));
    taus.insert(taus.begin() + place, tau);
    return static_cast<std::size_t>(place);
  }

  // What is zero is told by the forces and jumps at the beginning of the segment, or of the point
  // itself: a segment that begins without any load has no scale for what is to come.
  std::vector<CurvedSegment::EventFunction>
  CurvedSegment::event_functions(const double tau, const PathPoint &point) const
  {
    std::vector<EventFunction> result;
    const JointState &state = point.state;
    Vector factors          = course.factors;
    for (std::size_t i = 0; i < factors.size(); ++i)
      factors[i] += tau * course.factor_rates[i];
    ContactBoundary here(context.elements, context.system);
    here.set_scales(state, factors, 1.);
    const Drive drive                   = drive_at(context.elements, course, state);
    const std::vector<Reserve> reserves = here.reserves(state, point.rates, drive);
    const std::vector<Reserve> at_start = context.boundary.reserves(state, point.rates, drive);
    for (std::size_t i = 0; i < reserves.size(); ++i)
      result.push_back({reserves[i].value,
                        reserves[i].rate,
                        std::max(reserves[i].tolerance, at_start[i].tolerance),
                        true,
                        0});
    const double slip_rate_noise =
      slip_rate_tolerance *
      max_abs(context.system.jumps(point.rates.dislocations, point.rates.forces));
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(state.states[k]) && carries_shear(context.elements[k], state.strengths[k]))
        result.push_back({slip_speed(context, point, k), 0., slip_rate_noise, false, k});
    return result;
  }

  // The first zero, between points a and b, of the interpolated event functions that a does not
  // violate.
  double
  CurvedSegment::first_root(const std::size_t a, const std::size_t b) const
  {
    double nearest      = no_boundary;
    const double length = taus[b] - taus[a];
    for (std::size_t i = 0; i < functions[a].size(); ++i)
      {
        const EventFunction &f = functions[a][i], &g = functions[b][i];
        double share = no_boundary;
        // What is zero at both points and grows, or falls, at both has rates of rounding.
        if (f.has_rate && std::abs(f.value) <= f.tolerance && std::abs(g.value) <= g.tolerance &&
            f.rate * g.rate > 0.)
          continue;
        if (f.has_rate)
          {
            const CubicOnUnitInterval cubic(f.value, f.rate * length, g.value, g.rate * length);
            if (cubic.minimum() < -g.tolerance)
              share = cubic.first_descending_root();
          }
        else if (g.value < -g.tolerance)
          share = std::max(f.value, 0.) / (std::max(f.value, 0.) - g.value);
        nearest = std::min(nearest, taus[a] + share * length);
      }
    return nearest;
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
        fmt::format("No equilibrium was found behind load time {}.", points[b - 1].state.t));
    return *point;
  }

  std::vector<double>
  CurvedSegment::stations() const
  {
    return taus;
  }

  std::vector<std::size_t>
  CurvedSegment::resticking() const
  {
    return lost_slip;
  }
} // namespace fuga
