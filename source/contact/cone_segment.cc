// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/cone_segment.h>
#include <fuga/contact/joint_water.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Force rate across the slip, relative to the largest force rate, that turns no direction. */
    constexpr double no_turn = 1e-11;

    std::vector<SlippingElement>
    slipping_elements(const std::vector<ContactElement> &elements, const JointState &state)
    {
      std::vector<SlippingElement> result;
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (is_slipping(state.states[k]) && carries_shear(elements[k], state.strengths[k]))
          result.push_back({k, elements[k].friction.coefficient});
      return result;
    }

    void
    set_tangential(const ContactElement &element, const TangentVector &value, Vector &of_bars)
    {
      of_bars[element.tangential_bar] = value[0];
      if (element.has_second_tangential_bar())
        of_bars[element.second_tangential_bar] = value[1];
    }

    /** Dislocations without those of the slipping elements and of the released bars. */
    Vector
    fixed_dislocations(const ConeContext &context,
                       const std::vector<SlippingElement> &slipping,
                       Vector dislocations)
    {
      for (const std::size_t bar : context.released.released_bars())
        dislocations[bar] = 0.;
      for (const SlippingElement &slip : slipping)
        set_tangential(context.elements[slip.element], {{0., 0.}}, dislocations);
      return dislocations;
    }
  } // namespace

  ConeSegment::ConeSegment(const ConeContext &cone_context,
                           const Course &path_course,
                           const PathPoint &path_start,
                           const std::vector<TangentVector> &directions,
                           IterationCount &count)
    : context(cone_context)
    , course(path_course)
    , start(path_start)
    , slipping(slipping_elements(context.elements, start.state))
    , solver(context.elements,
             slipping,
             context.released,
             context.system.forces(course.factors,
                                   fixed_dislocations(context, slipping, start.state.dislocations),
                                   start.state.water),
             course.drive.reactions,
             count)
    , fixed(fixed_dislocations(context, slipping, start.state.dislocations))
    , end(course.length)
  {
    Station first;
    first.point = start;
    for (const SlippingElement &slip : slipping)
      {
        const ContactElement &element = context.elements[slip.element];
        const TangentVector s         = tangential(element, start.state.dislocations);
        first.stage.slips.insert(first.stage.slips.end(), s.begin(), s.end());
        first.stage.directions.push_back(directions[slip.element]);
        first.stage.forces.push_back(start.state.forces[element.normal_bar]);
        for (const double T : tangential(element, start.state.forces))
          first.stage.forces.push_back(T);
        first.slip_rates.push_back(
          dot(directions[slip.element], tangential(element, start.rates.dislocations)));
      }
    first.reserves = context.boundary.reserves(start.state, start.rates, course.drive);
    curve.push_back(std::move(first));

    const Vector jumps      = context.system.jumps(start.state.dislocations, start.state.forces);
    const Vector jump_rates = context.system.jumps(start.rates.dislocations, start.rates.forces);
    force_scale =
      std::max(max_abs(start.state.forces), course.length * max_abs(start.rates.forces));
    jump_scale = std::max(max_abs(jumps), course.length * max_abs(jump_rates));
    straight   = is_straight();
  }

  bool
  ConeSegment::is_straight() const
  {
    const double size = max_abs(start.rates.forces);
    for (std::size_t i = 0; i < slipping.size(); ++i)
      {
        const TangentVector across = normal_to(curve.front().stage.directions[i]);
        if (std::abs(
              dot(across, tangential(context.elements[slipping[i].element], start.rates.forces))) >
            no_turn * size)
          return false;
      }
    return true;
  }

  double
  ConeSegment::find_end()
  {
    if (straight)
      {
        // A rest of the course below this share of it is rounding.
        constexpr double rounding = 1e-14;
        const double distance = context.boundary.distance(start.state, start.rates, course.drive);
        end = distance < course.length * (1. - rounding) ? distance : course.length;
      }
    else
      find_end_of_curve();
    return end;
  }

  // A level inside a step is a shorter step from the same point.
  PathPoint
  ConeSegment::at(const double tau)
  {
    if (tau == 0.)
      return start;
    Station result;
    result.tau = tau;
    if (straight)
      {
        Vector xi;
        for (const double rate : curve.front().slip_rates)
          xi.push_back(tau * rate);
        result.stage      = curve.front().stage;
        result.slip_rates = curve.front().slip_rates;
        if (!solver.solve(
              ConeStageSolver::Demand::cone, tau, tau, curve.front().stage.slips, xi, result.stage))
          for (std::size_t i = 0; i < slipping.size(); ++i)
            for (std::size_t a = 0; a < 2; ++a)
              result.stage.slips[2 * i + a] =
                curve.front().stage.slips[2 * i + a] +
                tau * curve.front().slip_rates[i] * curve.front().stage.directions[i][a];
        complete(result);
        result.point.rates = start.rates;
        return result.point;
      }
    std::size_t i = 0;
    while (i + 1 < curve.size() && curve[i + 1].tau <= tau)
      ++i;
    if (curve[i].tau == tau)
      return curve[i].point;
    double error;
    if (!step(curve[i], tau - curve[i].tau, result, error))
      throw NumericalFailure("A level inside a step of the path could not be computed.");
    return result.point;
  }

  std::vector<double>
  ConeSegment::stations() const
  {
    if (straight)
      return {0., end};
    std::vector<double> result;
    for (const Station &station : curve)
      result.push_back(station.tau);
    if (result.size() == 1)
      result.push_back(end);
    return result;
  }

  // What closed layers still deform is no part of the mechanism.
  JointRates
  ConeSegment::motion_at_limit()
  {
    JointRates motion = curve.back().point.rates;
    motion.forces.assign(context.system.n_bars(), 0.);
    return motion;
  }

  std::vector<std::size_t>
  ConeSegment::resticking() const
  {
    return lost_slip;
  }

  void
  ConeSegment::set_dislocations(const ConeStage &stage, Vector &dislocations) const
  {
    dislocations = fixed;
    for (std::size_t i = 0; i < slipping.size(); ++i)
      set_tangential(
        context.elements[slipping[i].element],
        {{static_cast<double>(stage.slips[2 * i]), static_cast<double>(stage.slips[2 * i + 1])}},
        dislocations);
  }

  // State and rates from the slips and the load alone: nothing accumulates from step to step.
  bool
  ConeSegment::complete(Station &station) const
  {
    const double tau  = station.tau;
    JointState &state = station.point.state;
    state             = start.state;
    state.t           = tau == course.length ? course.t_end
                                             : course.t + tau * (course.t_end - course.t) / course.length;
    Vector factors    = course.factors;
    for (std::size_t j = 0; j < factors.size(); ++j)
      factors[j] += tau * course.factor_rates[j];
    set_dislocations(station.stage, state.dislocations);
    release(course.drive, tau, state);
    set_water(context.system, factors, state);
    const Vector reactions =
      context.system.forces(factors, Vector(state.dislocations.size(), 0.), state.water);
    context.released.complete(reactions, state.dislocations);
    state.forces = reactions;
    context.system.subtract_response(state.dislocations, state.forces);
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (context.elements[k].has_tangential_bar())
        state.slips[k] = tangential(context.elements[k], state.dislocations);

    if (straight)
      return true;
    const std::optional<Vector> slip_rates = solver.slip_rates(station.stage.directions);
    if (!slip_rates)
      return false;
    station.slip_rates = *slip_rates;
    JointRates &rates  = station.point.rates;
    rates.dislocations.assign(context.system.n_bars(), 0.);
    for (std::size_t i = 0; i < slipping.size(); ++i)
      set_tangential(context.elements[slipping[i].element],
                     {{station.slip_rates[i] * station.stage.directions[i][0],
                       station.slip_rates[i] * station.stage.directions[i][1]}},
                     rates.dislocations);
    context.released.complete(course.drive.reactions, rates.dislocations);
    rates.forces = course.drive.reactions;
    context.system.subtract_response(rates.dislocations, rates.forces);
    station.reserves =
      context.boundary.reserves(station.point.state, station.point.rates, course.drive);
    return true;
  }
} // namespace fuga
