// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>
#include <fuga/contact/segments/layer_work.h>

#include <algorithm>
#include <cmath>

// Finds where the curve meets the first boundary of the contact conditions.
namespace fuga
{
  // Shrink the bracket [a, b], of which only b lies beyond an event, onto the first event. Beyond
  // an event a law may be followed where Newton's method fails; the event is then looked for before
  // that place.
  void
  CurvedSegment::locate_end(std::size_t a, std::size_t b)
  {
    lost_slip.clear();
    const int max_trials   = 200;
    const double narrowest = 1e-14 * course.length;
    double unsolved        = no_boundary;
    for (int trial = 0; trial < max_trials; ++trial)
      {
        double root        = first_root(a, b);
        const double end   = std::min(taus[b], unsolved);
        const double width = end - taus[a];
        // The interpolation is trusted as long as it shrinks the bracket; every fourth time it is
        // halved.
        if (trial % 4 == 3 || root >= unsolved)
          root = taus[a] + 0.5 * width;
        root = std::clamp(root, taus[a] + 1e-3 * width, end);

        if (root < taus[b])
          {
            std::optional<PathPoint> point = solve(root, interpolate(a, root));
            if (!point && width <= narrowest)
              fail_behind(a, "An event could not be located");
            if (!point)
              {
                unsolved = root;
                continue;
              }
            b = insert(root, std::move(*point));
          }
        const auto &at_root = functions[b];
        const bool violated =
          std::any_of(at_root.begin(), at_root.end(), [](const EventFunction &f) {
            return f.value < -f.tolerance;
          });
        const bool narrow = taus[b] - taus[a] <= narrowest;
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
            meet_event();
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

  // Tolerances are those of the rounding of the largest terms, at the beginning as well. An element
  // that begins to slip must not begin off its cone by as much, nor one that opens with a force:
  // the point is moved to where the reserve is used up. Where all forces vanish together nothing is
  // left there to tell which elements are on a boundary, and the point stays where it is.
  void
  CurvedSegment::meet_event()
  {
    const std::size_t b = taus.size() - 1;
    double way          = no_boundary;
    for (std::size_t i = 0; i < functions[b].size(); ++i)
      if (const EventFunction &f = functions[b][i], &before = functions[b - 1][i];
          f.has_rate && f.value <= f.tolerance && f.rate < 0. && before.value > before.tolerance)
        way = std::min(way, -f.value / f.rate);
    const double tau = taus[b] + way;
    if (way == no_boundary || tau == taus[b] || tau <= taus[b - 1] || tau > course.length)
      return;
    std::optional<PathPoint> point = solve(tau, points[b].state.dislocations);
    if (!point)
      return;
    std::vector<EventFunction> there      = event_functions(tau, *point);
    const std::vector<std::size_t> met    = elements_on_boundary(taus[b], points[b].state),
                                   nearer = elements_on_boundary(tau, point->state);
    if (nearer.empty() || !std::includes(nearer.begin(), nearer.end(), met.begin(), met.end()) ||
        std::any_of(there.begin(), there.end(), [](const EventFunction &f) {
          return f.value < -f.tolerance;
        }))
      return;
    taus[b]   = tau;
    points[b] = std::move(*point);
    losses[b].reset();
    functions[b] = std::move(there);
  }

  std::vector<std::size_t>
  CurvedSegment::elements_on_boundary(const double tau, const JointState &state) const
  {
    std::vector<std::size_t> result;
    for (const BoundaryElement &candidate :
         boundary_at(context, course, tau, state).elements_on_boundary(state))
      result.push_back(candidate.element);
    return result;
  }

  // The values that count as zero are determined by the forces and jumps at the beginning of the
  // segment, or at the point itself: a segment that begins without any load has no scale for what
  // is to come. Reserves that rest at the beginning drift by their noise along the whole segment,
  // and those that are below zero there stay so.
  std::vector<CurvedSegment::EventFunction>
  CurvedSegment::event_functions(const double tau, const PathPoint &point) const
  {
    std::vector<EventFunction> result;
    const JointState &state             = point.state;
    const ContactBoundary here          = boundary_at(context, course, tau, state);
    const Drive drive                   = drive_at(context.elements, course, state);
    const std::vector<Reserve> reserves = here.reserves(state, point.rates, drive);
    const std::vector<Reserve> by_start = first_boundary.reserves(state, point.rates, drive);
    for (std::size_t i = 0; i < reserves.size(); ++i)
      result.push_back({reserves[i].value,
                        reserves[i].rate,
                        std::max(reserves[i].tolerance, by_start[i].tolerance) +
                          first_reserves[i].drift(tau, reserves[i].noise),
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

  // The result is the first zero, between points a and b, of the interpolated event functions that
  // a does not violate.
  double
  CurvedSegment::first_root(const std::size_t a, const std::size_t b) const
  {
    double nearest      = no_boundary;
    const double length = taus[b] - taus[a];
    for (std::size_t i = 0; i < functions[a].size(); ++i)
      {
        const EventFunction &f = functions[a][i], &g = functions[b][i];
        double share = no_boundary;
        // A function that is zero at both points and grows, or falls, at both has rates of
        // rounding.
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
} // namespace fuga
