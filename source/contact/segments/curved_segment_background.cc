// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/segments/course.h>
#include <fuga/contact/segments/curved_segment.h>

#include <algorithm>
#include <cmath>
#include <limits>

// The response of the elements whose direction of slip does not turn to those whose direction does.
namespace fuga
{
  void
  CurvedSegment::take_background()
  {
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        context.scheme.set_state(k, stuck.states[k]);
        context.scheme.set_strength(k, stuck.strengths[k]);
      }
    context.scheme.linearise(stuck);
  }

  // The strengths are the tangents, at given forces of the turning elements, of those at @p tau,
  // where @p state contains what a reduction leaves of them. A broken bond gives up what it still
  // carries in proportion to τ; a state of a linear background still has all of it.
  void
  CurvedSegment::take_strengths(const double tau, const JointState &state, const Vector &forces)
  {
    std::vector<TurningElement> strengths;
    for (std::size_t i = 0; i < turning.size(); ++i)
      {
        const std::size_t k           = turning[i];
        const ContactElement &element = context.elements[k];
        const Strength &strength      = state.strengths[k];
        const StrengthLine line       = strength_line(element, state, k, forces[3 * i]);
        TurningElement own;
        own.element  = k;
        own.friction = line.friction;
        own.rise     = strength.dilatancy;
        // The drive of the course contains no reduction where a bond is released.
        if (!course.drive.release.empty())
          own.cohesion_rate = shear_strength_rate(element, line.friction, course.drive);
        own.cohesion = line.cohesion + (linear ? tau * own.cohesion_rate : 0.);
        if (element.friction.reduced)
          {
            const double rate = course.share_rate / strength.share;
            own.friction_rate = rate * line.friction;
            own.cohesion_rate += rate * line.cohesion;
          }
        strengths.push_back(own);
      }
    solver.set_strengths(strengths);
  }

  Vector
  CurvedSegment::forces_of_turning(const JointState &state) const
  {
    Vector result;
    for (const std::size_t k : turning)
      for (std::size_t i = 0; i < 3; ++i)
        result.push_back(state.forces[context.elements[k].bar(i)]);
    return result;
  }

  // The response of the background is computed at a state in equilibrium. The return value is false
  // if nothing holds it.
  bool
  CurvedSegment::take_response(const double tau, const TurningStage &stage, const JointState &state)
  {
    const std::size_t n = turning.size();
    std::vector<std::size_t> bars, imposed, rises;
    bool any_rises = false;
    for (const std::size_t k : turning)
      {
        const ContactElement &element = context.elements[k];
        any_rises |= state.strengths[k].dilatancy > 0.;
        bars.insert(bars.end(), {element.normal_bar, element.bar(1), element.bar(2)});
        imposed.insert(imposed.end(), {element.bar(1), element.bar(2)});
        rises.push_back(element.normal_bar);
      }
    if (any_rises)
      imposed.insert(imposed.end(), rises.begin(), rises.end());
    const std::optional<JointRates> rates = context.scheme.rates(
      course.yielding ? course.yielding->drive : drive_at(context.elements, course, state));
    const std::optional<DenseMatrix> stiffness = context.scheme.stiffness(bars, imposed);
    if (!rates || !stiffness)
      return false;
    TurningResponse response;
    response.tau       = tau;
    response.slips     = stage.slips;
    response.dilations = stage.dilations;
    response.forces    = forces_of_turning(state);
    for (const std::size_t bar : bars)
      response.rates.push_back(rates->forces[bar]);
    response.against_slip = stiffness->leftCols(2 * n);
    if (any_rises)
      response.against_rise = stiffness->rightCols(n);
    if (course.yielding)
      yield(*course.yielding, response);
    solver.set_response(std::move(response));
    return true;
  }

  // The rates are those for a unit of the load, which grows by ṫ + κ and falls by κ c with the
  // slips.
  void
  CurvedSegment::yield(const YieldingLoad &load, TurningResponse &response) const
  {
    for (std::size_t j = 0; j < turning.size(); ++j)
      for (std::size_t a = 0; a < 2; ++a)
        {
          const double weight = load.weights[context.elements[turning[j]].bar(1 + a)];
          for (std::size_t i = 0; i < response.rates.size(); ++i)
            response.against_slip(i, 2 * j + a) += load.stiffness * weight * response.rates[i];
        }
    for (double &rate : response.rates)
      rate *= load.stiffness + *start.load_rate;
  }

  // Where the layer is rigid or linear the dislocations are the slip and the rise of the lips.
  void
  CurvedSegment::set_slips(const TurningStage &stage, JointState &state) const
  {
    for (std::size_t i = 0; i < turning.size(); ++i)
      {
        const std::size_t k           = turning[i];
        const ContactElement &element = context.elements[k];
        for (std::size_t a = 0; a < 2; ++a)
          {
            state.slips[k][a] = static_cast<double>(stage.slips[2 * i + a]);
            if (!has_nonlinear_shear(element))
              state.dislocations[element.bar(1 + a)] = state.slips[k][a];
          }
        state.dilations[k] = stage.dilations[i];
        if (!has_nonlinear_closure(element))
          state.dislocations[element.normal_bar] = start.state.dislocations[element.normal_bar] +
                                                   (stage.dilations[i] - start.state.dilations[k]);
      }
  }

  // The result is the state of the background with the slips of a stage; the dislocations of
  // @p state are the initial guess.
  bool
  CurvedSegment::settle(const double tau,
                        const TurningStage &stage,
                        JointState &state,
                        const KnownForces *const known)
  {
    const Vector guess = state.dislocations;
    state              = stuck;
    state.dislocations = guess;
    release(course.drive, tau, state);
    set_slips(stage, state);
    complete_state(context, course, tau, state, known);
    if (linear)
      {
        constexpr double rounding = 1e-14;
        polish(context, course, tau, {{rounding, rounding, rounding, rounding}}, state);
        return true;
      }
    // A law is not defined beyond its closure limit, where the prediction may lead.
    if (passes_limit_of_law(context.elements, state))
      {
        state.dislocations = start.state.dislocations;
        set_slips(stage, state);
        complete_state(context, course, tau, state, known);
      }
    if (is_reduction())
      for (std::size_t k = 0; k < context.elements.size(); ++k)
        context.scheme.set_strength(k, state.strengths[k]);
    if (!equilibrium.solve(tau, jump_scale, state, known))
      return false;
    context.scheme.linearise(state);
    return true;
  }

  // A linear background responds in the same way everywhere: @p base has its forces. Newton's
  // method renews the tangents of curved strengths until the square of a change is rounding: the
  // forces then leave them by no more.
  bool
  CurvedSegment::solve_stage_of_linear(const TurningStageSolver::Demand demand,
                                       const double tau,
                                       const double advance,
                                       const TurningStage &base,
                                       Vector &xi,
                                       TurningStage &stage)
  {
    constexpr int max_iterations = 25;
    constexpr double negligible  = 1e-8;
    for (int i = 0; i < max_iterations; ++i)
      {
        const Vector before = stage.forces;
        take_strengths(tau, stuck, before);
        if (!solver.solve(demand, tau, advance, base, xi, stage))
          return false;
        bool is_new = false;
        for (std::size_t j = 0; j < turning.size(); ++j)
          {
            const ContactElement &element    = context.elements[turning[j]];
            const StrengthEnvelope &envelope = element.friction.envelope;
            const double N                   = stage.forces[3 * j];
            is_new |= envelope.is_curved() &&
                      std::abs(N - before[3 * j]) >
                        negligible * (element.area * envelope.pressure + std::abs(N));
          }
        if (!is_new)
          return true;
      }
    return false;
  }

  // Any other background is linearised at the state to which the last response led, until this
  // state does not change, or would not as it has come closer to its end the last time. This is a
  // Newton iteration about the other.
  bool
  CurvedSegment::solve_stage(const TurningStageSolver::Demand demand,
                             const double tau,
                             const double advance,
                             const TurningStage &base,
                             const double slip_noise,
                             const KnownForces &known,
                             Vector &xi,
                             TurningStage &stage,
                             JointState &state)
  {
    if (linear)
      return solve_stage_of_linear(demand, tau, advance, base, xi, stage);
    constexpr int max_iterations = 25;
    constexpr double tolerance = 1e-13, accepted = 1e-11, safety = 10., well_above_rounding = 1e3;
    double last = std::numeric_limits<double>::infinity();
    solver.set_slips(base, xi, stage);
    for (int i = 0; i < max_iterations; ++i)
      {
        if (!settle(tau, stage, state, &known))
          return false;
        take_strengths(tau, state, forces_of_turning(state));
        if (!take_response(tau, stage, state))
          return false;
        const TurningStage before = stage;
        TurningStage from         = base;
        from.forces               = solver.forces_at(tau, base);
        if (!solver.solve(demand, tau, advance, from, xi, stage))
          return false;
        double change = 0.;
        for (std::size_t j = 0; j < stage.slips.size(); ++j)
          change =
            std::max(change, std::abs(static_cast<double>(stage.slips[j] - before.slips[j])));
        for (std::size_t j = 0; j < stage.dilations.size(); ++j)
          change = std::max(change, std::abs(stage.dilations[j] - before.dilations[j]));
        if (std::isfinite(last) && last > well_above_rounding * tolerance * jump_scale)
          contraction = change / last;
        if (std::min(1., safety * contraction) * change <= tolerance * jump_scale ||
            (change >= 0.5 * last && change <= accepted * jump_scale + slip_noise))
          return true;
        last = change;
      }
    return false;
  }

  // State and rates are computed from the slips and the load; the dislocations of the station are
  // an initial guess of those of the background.
  bool
  CurvedSegment::complete(Station &station)
  {
    JointState state   = stuck;
    state.dislocations = station.point.state.dislocations;
    if (!settle(station.tau, station.stage, state, nullptr))
      return false;
    take_strengths(station.tau, state, forces_of_turning(state));
    if (!linear && !take_response(station.tau, station.stage, state))
      return false;
    state.states        = start.state.states;
    station.point.state = std::move(state);
    return find_rates(station);
  }

  bool
  CurvedSegment::find_rates(Station &station)
  {
    std::optional<JointRates> rates =
      turns() ? rates_of_slips(station) : rates_without_turns(station);
    if (!rates)
      return false;
    const JointState &state = station.point.state;
    for (std::size_t i = turning.size(); i < slipping.size(); ++i)
      {
        const std::size_t k = slipping[i];
        station.slip_rates.push_back(dot(context.scheme.slip_direction_of(k),
                                         slip_rate(context.elements[k], state, k, *rates)));
      }
    station.point.rates = std::move(*rates);
    note_functions(station);
    return true;
  }

  std::optional<JointRates>
  CurvedSegment::rates_of_slips(Station &station)
  {
    std::optional<Vector> speeds = solver.slip_rates(station.stage);
    if (!speeds)
      return {};
    const JointState &state = station.point.state;
    Vector imposed(context.system.n_bars(), 0.);
    for (std::size_t i = 0; i < turning.size(); ++i)
      {
        const ContactElement &element = context.elements[turning[i]];
        for (std::size_t a = 0; a < 2; ++a)
          imposed[element.bar(1 + a)] = (*speeds)[i] * station.stage.directions[i][a];
        imposed[element.normal_bar] = (*speeds)[i] * state.strengths[turning[i]].dilatancy;
      }
    if (course.yielding)
      station.point.load_rate = *start.load_rate + course.yielding->stiffness *
                                                     (1. - dot(course.yielding->weights, imposed));
    station.slip_rates = std::move(*speeds);
    return context.scheme.rates(drive_of(station), imposed);
  }

  // On the way from strength to strength the determinant of a scheme passes zero only where its
  // equations have no solution; beyond that place they have another solution, to which no path
  // leads.
  std::optional<JointRates>
  CurvedSegment::rates_without_turns(Station &station)
  {
    station.slip_rates.clear();
    std::optional<WorkingScheme::FreeMotion> motion = context.scheme.motion(drive_of(station));
    if (!motion || motion->is_driven ||
        (is_reduction() && context.scheme.determinant_sign() != determinant_sign))
      return {};
    return std::move(motion->rates);
  }

  Drive
  CurvedSegment::drive_of(const Station &station) const
  {
    if (!course.yielding)
      return drive_at(context.elements, course, station.point.state);
    Drive drive = course.yielding->drive;
    for (double &rate : drive.reactions)
      rate *= *station.point.load_rate;
    return drive;
  }
} // namespace fuga
