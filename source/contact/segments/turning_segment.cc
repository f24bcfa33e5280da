// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/turning_segment.h>

#include <algorithm>
#include <fmt/format.h>

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

    JointState
    with_stuck(const std::vector<std::size_t> &elements, JointState state)
    {
      for (const std::size_t k : elements)
        state.states[k] = ContactState::stick;
      return state;
    }

    /** Means of both tangents. */
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
                                 IterationCount &iteration_count)
    : context(path_context)
    , course(path_course)
    , start(path_start)
    , turning(turning_elements(context.elements, start.state))
    , slipping(turning)
    , stuck(with_stuck(turning, start.state))
    , linear(!context.scheme.is_nonlinear() && course.share_rate == 0.)
    , count(iteration_count)
    , solver(shear_stiffnesses(context, turning), count)
    , equilibrium(context, course, PathOptions(), count)
    , end(course.length)
  {
    take_background();
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(start.state.states[k]) && !context.elements[k].has_second_tangential_bar())
        slipping.push_back(k);

    const Vector jumps      = context.system.jumps(start.state.dislocations, start.state.forces);
    const Vector jump_rates = context.system.jumps(start.rates.dislocations, start.rates.forces);
    force_scale =
      std::max(max_abs(start.state.forces), course.length * max_abs(start.rates.forces));
    jump_scale = std::max(max_abs(jumps), course.length * max_abs(jump_rates));

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
    note_reserves(first);
    take_strengths(0., stuck);
    if (!take_response(0., first.stage, stuck))
      throw NumericalFailure(fmt::format(
        "Nothing holds the elements that do not slip at load time {:.9g}.", start.state.t));
    curve.push_back(std::move(first));
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

  // A level inside a step is a shorter step from the same point.
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
    Station result;
    double error;
    if (!step(curve[i], tau - curve[i].tau, result, error))
      throw NumericalFailure("A level inside a step of the path could not be computed.");
    return result.point;
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

  // What closed layers still deform is no part of the mechanism.
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
