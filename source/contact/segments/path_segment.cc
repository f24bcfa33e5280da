// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/path_segment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace fuga
{
  namespace
  {
    /** Share of the largest force below which residuals are left, and share of a course below which
     * its rest counts as zero. */
    constexpr double rounding = 1e-14;
    /** Share of the largest force below which a residual is not worth a second correction. */
    constexpr double accepted = 1e-12;
    /** Largest number of chords along which the end of a segment is looked for. */
    constexpr int max_chords = 3;
  } // namespace

  double
  first_step(const PathContext &context,
             const Course &course,
             const PathPoint &start,
             const double least)
  {
    const double to_event = 1.1 * context.boundary.distance(start.state, start.rates, course.drive);
    return std::clamp(to_event, least, 0.1 * course.length);
  }

  void
  check_number_of_steps(const std::size_t n_steps, const double t)
  {
    constexpr std::size_t largest_number = 10000;
    interruption::check("on the way along a curve of the path");
    if (n_steps > largest_number)
      throw PathFailure(fmt::format(
        "The steps along a curve have become too short at load time {:.12g}: {} of them "
        "lead to no event.",
        t,
        largest_number));
  }

  // A correction gives its forces as well, unless the load also gives way to it.
  double
  polish(const PathContext &context,
         const Course &course,
         const double tau,
         const std::array<double, 4> &negligible,
         JointState &state)
  {
    // Beyond a limit the scheme is a mechanism, which a correction must not use.
    const SchemeAnswer answer = course.kind == Course::Kind::beyond_limit
                                  ? SchemeAnswer::of_no_mechanism
                                  : SchemeAnswer::of_any_size;
    double moved = 0., before = std::numeric_limits<double>::infinity();
    for (const double left : negligible)
      {
        const Vector residual = context.scheme.residual(state);
        const double worst    = max_abs(residual);
        if (worst <= left * max_abs(state.forces) || worst > 0.5 * before)
          break;
        before                                 = worst;
        const std::optional<JointRates> change = context.scheme.correction(residual, answer);
        if (!change)
          break;
        moved += max_abs(change->dislocations);
        state.dislocations = along(state.dislocations, 1., change->dislocations);
        if (course.yielding)
          complete_state(context, course, tau, state);
        else
          {
            state.forces = along(state.forces, 1., change->forces);
            set_slips(context, course, tau, state);
          }
      }
    return moved;
  }

  StraightSegment::StraightSegment(const PathContext &path_context,
                                   const Course &path_course,
                                   const PathPoint &path_start)
    : context(path_context), course(path_course), start(path_start), end(path_course.length)
  {
  }

  // An event that is at the end of the course up to rounding is met there.
  double
  StraightSegment::distance(const JointRates &rates) const
  {
    const double length = context.boundary.distance(start.state, rates, course.drive);
    return length < course.length * (1. - rounding) ? length : course.length;
  }

  // Where hardly anything holds the bodies, a small correction of forces moves them far enough to
  // meet, or miss, each other: the event is then looked for on the chord to the corrected end. No
  // chord results from a correction larger than the step itself, nor from one that meets a boundary
  // long before its end: that is rounding, where a boundary is near by.
  double
  StraightSegment::find_end()
  {
    end = distance(start.rates);
    for (int chord = 0; end > 0.; ++chord)
      {
        double moved        = 0.;
        end_point           = point(end, moved);
        const bool is_exact = (moved <= context.boundary.gap_tolerance() ||
                               moved >= end * max_abs(start.rates.dislocations)) &&
                              (chord > 0 || has_foreseen_forces(*end_point));
        if (chord == 0 && is_exact)
          break;
        JointRates rates = start.rates;
        for (std::size_t i = 0; i < rates.forces.size(); ++i)
          {
            rates.dislocations[i] =
              (end_point->state.dislocations[i] - start.state.dislocations[i]) / end;
            rates.forces[i] = (end_point->state.forces[i] - start.state.forces[i]) / end;
          }
        const double next  = distance(rates);
        const bool is_near = next < 0.5 * end;
        if (is_near && chord > 0)
          end_point = point(end = distance(start.rates), moved);
        if (is_near || is_exact || chord == max_chords)
          break;
        end = next;
      }
    return end;
  }

  // Where bodies move far compared with their deformation, forces are refined, but their rates are
  // not.
  bool
  StraightSegment::has_foreseen_forces(const PathPoint &point) const
  {
    constexpr double negligible = 1e-10;
    const Vector foreseen       = along(start.state.forces, end, start.rates.forces);
    return max_abs(along(point.state.forces, -1., foreseen)) <=
           negligible * max_abs(point.state.forces);
  }

  PathPoint
  StraightSegment::at(const double tau)
  {
    if (tau == 0.)
      return start;
    if (tau == end && end_point)
      return *end_point;
    double moved = 0.;
    return point(tau, moved);
  }

  // A correction removes what rounding has added to the active rows. Where the scheme is so
  // ill-conditioned that its solution is not accurate, more than one correction is needed.
  PathPoint
  StraightSegment::point(const double tau, double &moved) const
  {
    PathPoint result          = start;
    result.state.dislocations = along(start.state.dislocations, tau, start.rates.dislocations);
    release(course.drive, tau, result.state);
    if (!advance_forces(tau, result.state))
      complete_state(context, course, tau, result.state);
    moved += polish(context, course, tau, {{rounding, accepted, accepted, accepted}}, result.state);
    return result;
  }

  // To compute the forces again from the dislocations and the load costs a product with a large
  // part of W, whereas their rates are known. From time to time, and where the active rows show
  // that rounding has added to them, they are computed again, so that nothing accumulates from
  // event to event. A run that is resumed from a checkpoint repeats this rule.
  bool
  StraightSegment::advance_forces(const double tau, JointState &state) const
  {
    constexpr std::size_t exchanges_between = 8;
    if (course.kind != Course::Kind::loading ||
        context.system.refines_forces(state.dislocations, state.forces) ||
        context.scheme.memory().exchanges.size() % exchanges_between == 0)
      return false;
    set_loads(context, course, tau, state);
    state.forces = along(start.state.forces, tau, start.rates.forces);
    set_slips(context, course, tau, state);
    return max_abs(context.scheme.residual(state)) <= rounding * max_abs(state.forces);
  }

  std::vector<double>
  StraightSegment::stations() const
  {
    return {0., end};
  }

  namespace
  {
    /** Return whether 1/g^n lies on a line that falls to zero @p within the last τ. */
    bool
    diverges(const std::vector<CurvePoint> &curve,
             const Vector &g,
             const int exponent,
             const double within,
             const double bend)
    {
      constexpr double smaller       = 1. / 1.2;
      constexpr std::size_t n_points = 4;
      std::array<double, n_points> place, value;
      std::size_t n = 0;
      double limit  = std::numeric_limits<double>::infinity();
      for (std::size_t i = g.size(); i-- > 0 && n < n_points;)
        if (g[i] > 0. && g[i] <= limit)
          {
            place[n]   = curve[i].tau;
            value[n++] = std::pow(g[i], -exponent);
            limit      = smaller * g[i];
          }
      if (n < n_points)
        return false;
      const auto slope = [&](const std::size_t i) {
        return (value[i] - value[i + 1]) / (place[i] - place[i + 1]);
      };
      const double last = slope(0);
      for (std::size_t i = 1; i + 1 < n_points; ++i)
        if (std::abs(slope(i) - last) > bend * std::abs(last))
          return false;
      return last < 0. && -value[0] / last <= within;
    }
  } // namespace

  // Two bars are examined: the one whose rate g has grown most, and the one whose rate has grown
  // most relative to its former value; everything else moves steadily, or comes along with the
  // others. Either g as a whole or its growth is used, because steady motion may be a part of g.
  // Three slopes of 1/g^n are compared, between the last point and those at which g was smaller by
  // a sixth each time: others that come to rest near τ* cut the path into short pieces. (Two slopes
  // may agree by chance, where a slip turns quickly as its element leaves the cone at the apex.)
  bool
  rates_diverge(const std::vector<CurvePoint> &curve,
                const int exponent,
                const double within,
                const double bend)
  {
    constexpr double no_part = 0.01;
    const Vector &first      = curve.front().point->rates.dislocations,
                 &last       = curve.back().point->rates.dislocations;
    Vector growth(first.size());
    for (std::size_t bar = 0; bar < first.size(); ++bar)
      growth[bar] = std::abs(last[bar]) - std::abs(first[bar]);
    const double most = *std::max_element(growth.begin(), growth.end());
    if (most <= 0.)
      return false;
    const auto share_of_growth = [&](const std::size_t bar) {
      return growth[bar] > no_part * most ? growth[bar] / std::abs(last[bar]) : 0.;
    };
    std::size_t fastest = 0, steepest = 0;
    for (std::size_t bar = 1; bar < first.size(); ++bar)
      {
        if (growth[bar] > growth[fastest])
          fastest = bar;
        if (share_of_growth(bar) > share_of_growth(steepest))
          steepest = bar;
      }
    for (const std::size_t bar : std::set<std::size_t>{fastest, steepest})
      for (const double steady : {0., first[bar]})
        {
          Vector speeds;
          for (const CurvePoint &at : curve)
            speeds.push_back(std::abs(at.point->rates.dislocations[bar] - steady));
          if (diverges(curve, speeds, exponent, within, bend))
            return true;
        }
    return false;
  }
} // namespace fuga
