// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/turning_segment.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    std::vector<std::size_t>
    turning_elements(const std::vector<ContactElement> &elements, const JointState &state)
    {
      std::vector<std::size_t> result;
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (may_turn(elements[k], state, k))
          result.push_back(k);
      return result;
    }

    Vector
    dilatancies_of(const std::vector<std::size_t> &elements, const JointState &state)
    {
      Vector result;
      for (const std::size_t k : elements)
        result.push_back(state.strengths[k].dilatancy);
      return result;
    }

    JointState
    with_stuck(const std::vector<std::size_t> &elements, JointState state)
    {
      for (const std::size_t k : elements)
        state.states[k] = ContactState::stick;
      return state;
    }

    /** Return the mean stiffness of both tangents for each element. */
    Vector
    shear_stiffnesses(const PathContext &context, const std::vector<std::size_t> &elements)
    {
      const DenseMatrix &W = context.system.stiffness();
      Vector result;
      for (const std::size_t k : elements)
        {
          const std::size_t a = context.elements[k].bar(1), b = context.elements[k].bar(2);
          result.push_back(0.5 * (W(a, a) + W(b, b)));
        }
      return result;
    }
  } // namespace

  TurningSegment::TurningSegment(const PathContext &path_context,
                                 const Course &path_course,
                                 const PathPoint &path_start,
                                 const std::vector<TangentVector> &directions,
                                 const PathOptions &options,
                                 IterationCount &iteration_count)
    : context(path_context)
    , course(path_course)
    , start(path_start)
    , turning(turning_elements(context.elements, start.state))
    , slipping(turning)
    , dilatancies(dilatancies_of(turning, start.state))
    , stuck(with_stuck(turning, start.state))
    , linear(!context.scheme.is_nonlinear() && course.share_rate == 0.)
    , step_tolerance(options.curve_tolerance)
    , least_energy_loss(options.least_energy_loss)
    , count(iteration_count)
    , solver(shear_stiffnesses(context, turning), count)
    , equilibrium(context, course, PathOptions(), count)
    , reserves(context,
               course,
               start,
               course.yielding ? course.yielding->drive
                               : drive_at(context.elements, course, start.state))
    , end(course.length)
  {
    take_background();
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(start.state.states[k]) && !context.elements[k].has_second_tangential_bar())
        slipping.push_back(k);

    take_scales();

    Station first;
    first.point = start;
    first.stage = stage_at_start(directions);
    for (std::size_t i = 0; i < slipping.size(); ++i)
      {
        const std::size_t k = slipping[i];
        const TangentVector e =
          i < turning.size() ? directions[k] : context.scheme.slip_direction_of(k);
        first.slip_rates.push_back(
          dot(e, slip_rate(context.elements[k], start.state, k, start.rates)));
      }
    note_functions(first);
    take_strengths(0., stuck);
    if (!take_response(0., first.stage, stuck))
      throw PathFailure(fmt::format(
        "Nothing holds the elements that do not slip at load time {:.9g}.", start.state.t));
    curve.push_back(std::move(first));
  }

  // For a virgin state its growth gives the scales. Close to a limit, where slips grow without
  // bounds, the scales are limited to the effect of the loads on lips that stick.
  void
  TurningSegment::take_scales()
  {
    const auto size_of_jumps = [this](const Vector &dislocations, const Vector &forces) {
      return max_abs(context.system.jumps(dislocations, forces));
    };
    double softest = std::numeric_limits<double>::infinity();
    for (std::size_t bar = 0; bar < context.system.n_bars(); ++bar)
      softest = std::min(softest, context.system.stiffness()(bar, bar));
    const double load = course.length * driving_force();
    const double growth =
      course.length * size_of_jumps(start.rates.dislocations, start.rates.forces);
    force_scale = std::max(max_abs(start.state.forces),
                           std::min(load, course.length * max_abs(start.rates.forces)));
    jump_scale  = std::max(size_of_jumps(start.state.dislocations, start.state.forces),
                          growth * softest > load ? load / softest : growth);
  }

  double
  TurningSegment::driving_force() const
  {
    if (course.yielding)
      return (course.yielding->stiffness + std::abs(*start.load_rate)) *
             max_abs(course.yielding->drive.reactions);
    const Drive drive = drive_at(context.elements, course, start.state);
    return std::max({max_abs(drive.reactions), max_abs(drive.release), max_abs(drive.strength)});
  }

  double
  TurningSegment::parameter_scale() const
  {
    return course.yielding ? course.length : std::max(1., course.t_end);
  }

  // The motion has changed so much that its measure no longer controls it; another segment begins.
  bool
  TurningSegment::loses_control(const Station &station) const
  {
    return course.yielding &&
           std::abs(*station.point.load_rate - *start.load_rate) > 0.5 * course.yielding->stiffness;
  }

  // Forces are differences of terms as large as the stiffness of a rigid joint times the slip.
  // Close to a mechanism their rounding moves the slips.
  double
  TurningSegment::force_noise(const JointState &state) const
  {
    constexpr double force_rounding = 1e-13, stage_rounding = 1e-14;
    return std::max(force_rounding * force_scale,
                    stage_rounding * context.system.largest_stiffness() *
                      max_abs(state.dislocations));
  }

  TurningStage
  TurningSegment::stage_at_start(const std::vector<TangentVector> &directions) const
  {
    TurningStage stage;
    for (const std::size_t k : turning)
      {
        const ContactElement &element = context.elements[k];
        const TangentVector T         = tangential(element, start.state.forces);
        stage.slips.insert(
          stage.slips.end(), start.state.slips[k].begin(), start.state.slips[k].end());
        stage.dilations.push_back(start.state.dilations[k]);
        stage.directions.push_back(directions[k]);
        for (const double force : {start.state.forces[element.normal_bar], T[0], T[1]})
          stage.forces.push_back(force);
      }
    return stage;
  }

  Vector
  SlipStages::velocity(const std::size_t j) const
  {
    Vector result;
    for (std::size_t i = 0; i < rates[j].size(); ++i)
      for (const double component : directions[j][i])
        result.push_back(rates[j][i] * component);
    return result;
  }

  // A level inside a step is reached by a shorter step from the same point, or by one back from its
  // end.
  PathPoint
  TurningSegment::at(const double tau)
  {
    if (tau == 0.)
      return start;
    std::size_t i = 0;
    while (i + 1 < curve.size() && curve[i + 1].tau <= tau)
      ++i;
    if (curve[i].tau == tau)
      return curve[i].point;
    for (std::size_t from = i; from < std::min(i + 2, curve.size()); ++from)
      {
        Station result;
        double error;
        if (step(curve[from], tau - curve[from].tau, result, error))
          return result.point;
      }
    throw NumericalFailure("A level inside a step of the path could not be computed.");
  }

  std::vector<double>
  TurningSegment::stations() const
  {
    std::vector<double> result;
    for (const Station &station : curve)
      result.push_back(station.tau);
    if (result.size() == 1)
      result.push_back(end);
    return result;
  }

  // While slip directions turn into those of a mechanism, the load approaches its limit as slips
  // grow without bounds, exponentially: at the limit the jumps would double within a negligible
  // load, hardly any force responds, and the rates of slip grow like 1/(τ* - τ). Where they do not,
  // something soft moves far, but stands.
  bool
  TurningSegment::grows_beyond_bounds(const double negligible_load, const double bend) const
  {
    constexpr double weak_answer = 1e-3;
    const JointRates &rates      = curve.back().point.rates;
    const JointState &state      = curve.back().point.state;
    const double growth          = max_abs(rates.dislocations);
    const double jump            = max_abs(context.system.jumps(state.dislocations, state.forces));
    const double load            = negligible_load * std::max(1., course.t_end);
    // In the virgin state any growth is large.
    return jump > 0. && load * growth >= jump &&
           max_abs(rates.forces) <= weak_answer * context.system.largest_stiffness() * growth &&
           rates_diverge(points_of_curve(), 1, load, bend);
  }

  std::vector<CurvePoint>
  TurningSegment::points_of_curve() const
  {
    std::vector<CurvePoint> result;
    for (const Station &station : curve)
      result.push_back({station.tau, &station.point});
    return result;
  }

  // Before a maximum of the load at τ* the rates of slip grow like (τ* - τ)^(-1/2).
  bool
  TurningSegment::turns_back(const double negligible_load) const
  {
    return rates_diverge(
      points_of_curve(), 2, negligible_load * std::max(1., course.t_end), bend_of_maximum);
  }

  // A load that gives way to the motion has no end.
  bool
  TurningSegment::is_below_end_of_path(const double near_limit, const double near_maximum)
  {
    at_limit         = !course.yielding && grows_beyond_bounds(near_limit, bend_of_limit);
    at_turning_point = !course.yielding && !at_limit && turns_back(near_maximum);
    return at_limit || at_turning_point;
  }

  // The deformation that closed layers still undergo is not part of the mechanism.
  JointRates
  TurningSegment::motion_at_limit()
  {
    JointRates motion = curve.back().point.rates;
    motion.forces.assign(context.system.n_bars(), 0.);
    return motion;
  }

  std::vector<std::size_t>
  TurningSegment::resticking() const
  {
    return lost_slip;
  }

  double
  TurningSegment::energy_lost()
  {
    double sum = 0.;
    for (const Station &station : curve)
      sum += station.energy_lost;
    return sum;
  }
} // namespace fuga
