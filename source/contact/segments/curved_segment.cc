// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/curved_segment.h>

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

    /** Return whether the elements that do not turn respond linearly to those that do: their layers
     * are linear, and no strength along a curve counts. A tension that is being released moves the
     * place on such a curve. */
    bool
    background_is_linear(const std::vector<ContactElement> &elements,
                         const JointState &stuck,
                         const Course &course)
    {
      if (has_curved_envelope(elements) && !course.drive.release.empty())
        return false;
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (has_nonlinear_closure(elements[k]) || has_nonlinear_shear(elements[k]) ||
            (is_slipping(stuck.states[k]) && elements[k].friction.envelope.is_curved()))
          return false;
      return true;
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

  CurvedSegment::CurvedSegment(const PathContext &path_context,
                               const Course &path_course,
                               const PathPoint &path_start,
                               const std::vector<TangentVector> &directions,
                               const PathOptions &options,
                               IterationCount &iteration_count)
    : context(path_context)
    , course(path_course)
    , start(path_start)
    , iteration(options.iteration)
    , turning(directions.empty() ? std::vector<std::size_t>()
                                 : turning_elements(context.elements, start.state))
    , slipping(turning)
    , dilatancies(dilatancies_of(turning, start.state))
    , stuck(with_stuck(turning, start.state))
    , strengths_bend(is_reduction() || has_curved_envelope(context.elements))
    , linear(turns() && !is_reduction() && background_is_linear(context.elements, stuck, course))
    , step_tolerance(options.curve_tolerance)
    , least_energy_loss(options.least_energy_loss)
    , steps(stepping())
    , count(iteration_count)
    , solver(shear_stiffnesses(context, turning), count)
    , equilibrium(context,
                  course,
                  turns() ? PathOptions() : options,
                  count,
                  turns() || context.scheme.rates(drive_at(context.elements, course, start.state))
                    ? SchemeAnswer::of_no_mechanism
                    : SchemeAnswer::of_any_size)
    , reserves(context,
               course,
               start,
               course.yielding ? course.yielding->drive
                               : drive_at(context.elements, course, start.state))
    , determinant_sign(is_reduction() && !turns() ? context.scheme.determinant_sign() : 0)
    , end(course.length)
  {
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(start.state.states[k]) &&
          carries_shear(context.elements[k], start.state.strengths[k]) &&
          std::find(turning.begin(), turning.end(), k) == turning.end())
        slipping.push_back(k);
    if (turns())
      take_background();
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
    if (turns())
      {
        take_strengths(0., stuck, first.stage.forces);
        if (!take_response(0., first.stage, stuck))
          throw PathFailure(fmt::format(
            "Nothing holds the elements that do not slip at load time {:.9g}.", start.state.t));
      }
    curve.push_back(std::move(first));
  }

  // Where nothing turns, a step to the end of the course may be longer by the share that the margin
  // of its error admits, and a part that falls below the margin on the way to an event is not
  // followed again. The constant-stiffness iteration only creeps towards its bound.
  CurvedSegment::Stepping
  CurvedSegment::stepping() const
  {
    if (turns())
      return {1e-6 * course.length, 1e-13 * parameter_scale(), 1e-7 * parameter_scale(), 1., 1.};
    const double shortest =
      (iteration == PathOptions::Iteration::newton ? 1e-9 : 1e-5) * course.length;
    return {1e-3 * course.length, shortest, shortest, 1.5, 8.};
  }

  // For a virgin state its growth gives the scales. Close to a limit, where slips grow without
  // bounds, the scales are limited to the effect of the loads on lips that stick.
  void
  CurvedSegment::take_scales()
  {
    jump_scale = size_of_jumps(start.state.dislocations, start.state.forces);
    if (!turns())
      return;
    double softest = std::numeric_limits<double>::infinity();
    for (std::size_t bar = 0; bar < context.system.n_bars(); ++bar)
      softest = std::min(softest, context.system.stiffness()(bar, bar));
    const double load = course.length * driving_force();
    const double growth =
      course.length * size_of_jumps(start.rates.dislocations, start.rates.forces);
    force_scale = std::max(max_abs(start.state.forces),
                           std::min(load, course.length * max_abs(start.rates.forces)));
    jump_scale  = std::max(jump_scale, growth * softest > load ? load / softest : growth);
  }

  double
  CurvedSegment::size_of_jumps(const Vector &dislocations, const Vector &forces) const
  {
    return max_abs(context.system.jumps(dislocations, forces));
  }

  double
  CurvedSegment::driving_force() const
  {
    if (course.yielding)
      return (course.yielding->stiffness + std::abs(*start.load_rate)) *
             max_abs(course.yielding->drive.reactions);
    const Drive drive = drive_at(context.elements, course, start.state);
    return std::max({max_abs(drive.reactions), max_abs(drive.release), max_abs(drive.strength)});
  }

  double
  CurvedSegment::parameter_scale() const
  {
    return course.yielding ? course.length : std::max(1., course.t_end);
  }

  // The motion has changed so much that its measure no longer controls it; another segment begins.
  bool
  CurvedSegment::loses_control(const Station &station) const
  {
    return course.yielding &&
           std::abs(*station.point.load_rate - *start.load_rate) > 0.5 * course.yielding->stiffness;
  }

  // Forces are differences of terms as large as the stiffness of a rigid joint times the slip.
  // Close to a mechanism their rounding moves the slips.
  double
  CurvedSegment::force_noise(const JointState &state) const
  {
    constexpr double force_rounding = 1e-13, stage_rounding = 1e-14;
    return std::max(force_rounding * force_scale,
                    stage_rounding * context.system.largest_stiffness() *
                      max_abs(state.dislocations));
  }

  // Where nothing drives, nothing slips.
  double
  CurvedSegment::slip_noise(const PathPoint &point) const
  {
    const double drive = driving_force();
    return drive > 0. ? force_noise(point.state) * max_abs(point.rates.dislocations) / drive : 0.;
  }

  TurningStage
  CurvedSegment::stage_at_start(const std::vector<TangentVector> &directions) const
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
  CurvedSegment::at(const double tau)
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
        if (step(curve[from], tau - curve[from].tau, result))
          return result.point;
      }
    throw NumericalFailure("A level inside a step of the path could not be computed.");
  }

  std::vector<double>
  CurvedSegment::stations() const
  {
    std::vector<double> result;
    for (const Station &station : curve)
      result.push_back(station.tau);
    if (result.size() == 1)
      result.push_back(end);
    return result;
  }

  // The deformation that closed layers still undergo is not part of the mechanism.
  JointRates
  CurvedSegment::motion_at_limit()
  {
    JointRates motion = curve.back().point.rates;
    if (turns())
      motion.forces.assign(context.system.n_bars(), 0.);
    return motion;
  }

  std::vector<std::size_t>
  CurvedSegment::resticking() const
  {
    return lost_slip;
  }

  double
  CurvedSegment::energy_lost()
  {
    double sum = 0.;
    for (const Station &station : curve)
      sum += station.energy_lost;
    return sum;
  }
} // namespace fuga
