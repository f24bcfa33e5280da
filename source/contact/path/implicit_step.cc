// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/change_of_state.h>
#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/joint_water.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/path/implicit_step.h>
#include <fuga/contact/segments/scheme_equilibrium.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace fuga
{
  namespace
  {
    /** Share of the largest force below which violations are rounding. */
    constexpr double violation_rounding = 1e-12;
    /** Number of schemes tried for one load, and how often the states of one may return. */
    constexpr int max_iterations = 100, max_returns = 4;
    /** Correction, relative to the largest jump, that ends the iteration. */
    constexpr double negligible_change = 1e-13;
    /** Number of loads tried on the way, and the shortest piece of it. */
    constexpr int max_loads         = 100;
    constexpr double shortest_piece = 1. / 256.;
  } // namespace

  ImplicitStep::ImplicitStep(const PathContext &path_context, const Course &path_course)
    : context(path_context), course(path_course)
  {
  }

  // Each load on the way is a step from the beginning; but strength that is lost on the way stays
  // lost.
  std::optional<JointState>
  ImplicitStep::solve(const JointState &from)
  {
    start              = from;
    start.strengths    = strengths_in_step(from);
    JointState reached = from;
    double done = 0., piece = 1.;
    std::optional<JointState> end;
    for (int i = 0; i < max_loads && !end && piece >= shortest_piece; ++i)
      {
        const double share = done + piece < 1. - 0.5 * shortest_piece ? done + piece : 1.;
        const std::vector<Strength> strengths = start.strengths;
        std::optional<JointState> next        = solve(from, share * course.length, reached);
        if (!next)
          {
            start.strengths = strengths;
            piece *= 0.25;
            continue;
          }
        if (share == 1.)
          end = std::move(next);
        else
          reached = std::move(*next);
        done = share;
        piece *= 2.;
      }
    context.scheme.let_turn({});
    // Lips that have met may rise from now on.
    for (std::size_t k = 0; end && k < context.elements.size(); ++k)
      if (start.strengths[k].dilatancy < from.strengths[k].dilatancy)
        end->strengths[k].dilatancy = from.strengths[k].dilatancy;
    return end;
  }

  std::optional<JointState>
  ImplicitStep::solve(const JointState &from, const double tau, const JointState &guess)
  {
    JointState state = guess;
    state.slips      = from.slips;
    state.dilations  = from.dilations;
    state.unreleased = from.unreleased;
    release(course.drive, tau, state);
    reduce_strengths(context.elements, course, tau, start.strengths);
    take_demands(state);
    do
      if (!find_equilibrium(tau, state))
        return {};
    while (lose_strength(state));
    correct_forces(state);
    return finished(std::move(state));
  }

  // Forces that are computed from jumps lack digits where these are large beside deformations, as
  // after a fall. A correction gives its forces as well.
  void
  ImplicitStep::correct_forces(JointState &state) const
  {
    constexpr double rounding     = 1e-15;
    constexpr int max_corrections = 3;
    double before                 = std::numeric_limits<double>::infinity();
    for (int i = 0; i < max_corrections; ++i)
      {
        const Vector residual = context.scheme.residual(state);
        const double worst    = max_abs(residual);
        if (worst <= rounding * max_abs(state.forces) || worst > 0.5 * before)
          return;
        before = worst;
        context.scheme.linearise(finished(state));
        const std::optional<JointRates> change = context.scheme.correction(residual);
        if (!change)
          return;
        state.dislocations = along(std::move(state.dislocations), 1., change->dislocations);
        state.forces       = along(std::move(state.forces), 1., change->forces);
      }
  }

  // In Newton's method every solution gives new demands. It has ended when they do not change, and
  // the correction is rounding.
  bool
  ImplicitStep::find_equilibrium(const double tau, JointState &state)
  {
    std::map<std::vector<ContactState>, int> visits;
    double last = std::numeric_limits<double>::infinity();
    complete(tau, state);
    for (int i = 0; i < max_iterations && !passes_limit_of_law(context.elements, state); ++i)
      {
        ++schemes;
        context.scheme.linearise(finished(state));
        const std::optional<JointRates> change =
          context.scheme.correction(context.scheme.residual(state));
        if (!change)
          return false;
        const Vector growth = context.system.jumps(change->dislocations, change->forces);
        const double share =
          limit_safeguard(context.elements, state, growth, OpenLips::stay_short_of_limit);
        for (std::size_t bar = 0; bar < state.dislocations.size(); ++bar)
          state.dislocations[bar] += share * change->dislocations[bar];
        complete(tau, state);

        const double size  = max_abs(growth);
        const double total = max_abs(context.system.jumps(state.dislocations, state.forces));
        const std::vector<ContactState> states_before = state.states;
        if (take_demands(state))
          {
            const int n_visits = ++visits[state.states];
            if (n_visits > max_returns)
              return false;
            if (n_visits > 1)
              unload_slips(states_before, state);
            complete(tau, state);
          }
        else if (size <= negligible_change * total ||
                 (size > 0.3 * last && size <= 1e3 * negligible_change * total))
          return true;
        last = size;
      }
    return false;
  }

  // A decrease of the shear may loosen a layer faster than the strength falls. Lips that let go
  // then slide farther than Newton's method finds, which is based on how they begin to slide; it
  // therefore continues from where nothing shears them.
  void
  ImplicitStep::unload_slips(const std::vector<ContactState> &before, JointState &state) const
  {
    const DenseMatrix &W = context.system.stiffness();
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(state.states[k]) && !is_slipping(before[k]))
        for (std::size_t i = 1; i < context.elements[k].n_bars(); ++i)
          {
            const std::size_t bar = context.elements[k].bar(i);
            state.dislocations[bar] += state.forces[bar] / W(bar, bar);
          }
  }

  // The return value tells whether any state changes.
  bool
  ImplicitStep::take_demands(JointState &state)
  {
    bool any = false;
    Vector turning(context.elements.size(), 0.);
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        const ContactElement &element = context.elements[k];
        const Demand demand           = demand_on(state, k);
        const double rise =
          start.dilations[k] + start.strengths[k].dilatancy * length(slip_of_step(state, k));
        Strength strength = start.strengths[k];
        if (is_slipping(demand.state) && rise >= element.friction.dilation_limit)
          strength.dilatancy = 0.;
        any |= demand.state != state.states[k] || !(strength == state.strengths[k]);
        state.states[k]    = demand.state;
        state.strengths[k] = strength;
        turning[k]         = demand.turning;
        context.scheme.set_state(k, demand.state, demand.direction);
        context.scheme.set_strength(k, strength);
      }
    context.scheme.let_turn(turning);
    return any;
  }

  // This is Newton's guess for the augmented Lagrangian, which follows from force and jump
  // together. An open element presses by its stiffness times the penetration. A bond that holds
  // does not open here; whether it holds is tested by lose_strength() when equilibrium is found.
  ImplicitStep::Demand
  ImplicitStep::demand_on(const JointState &state, const std::size_t k) const
  {
    const ContactElement &element = context.elements[k];
    const Strength &left          = start.strengths[k];
    const std::size_t n           = element.normal_bar;
    const double noise            = violation_rounding * max_abs(state.forces);
    const bool is_open            = state.states[k] == ContactState::open;
    const double penetration      = is_open ? std::max(-lip_opening(element, state, k), 0.) : 0.;
    const double pressure         = is_open ? context.system.stiffness()(n, n) * penetration : 0.;
    if (!left.has_bond() &&
        (is_open ? pressure <= noise
                 : state.forces[n] > tensile_strength(element, state, k) + noise))
      return {};
    if (!carries_shear(element, left))
      return {ContactState::stick};
    return demand_on_shear(state,
                           k,
                           is_open ? left.friction *
                                       resisting_force(element.friction, element.area, pressure)
                                   : shear_strength(element, state, k),
                           noise);
  }

  ImplicitStep::Demand
  ImplicitStep::demand_on_shear(const JointState &state,
                                const std::size_t k,
                                const double strength,
                                const double noise) const
  {
    const ContactElement &element = context.elements[k];
    const ContactState now        = state.states[k];
    const DenseMatrix &W          = context.system.stiffness();
    double stiffness              = W(element.tangential_bar, element.tangential_bar);
    if (const std::size_t bar = element.second_tangential_bar; element.has_second_tangential_bar())
      stiffness = 0.5 * (stiffness + W(bar, bar));
    const TangentVector slip = slip_of_step(state, k);
    const TangentVector T =
      now == ContactState::open ? TangentVector{} : tangential(element, state.forces);
    const TangentVector trial = sum(T, stiffness, slip);
    const bool keeps_slipping =
      is_slipping(now) && stiffness * dot(context.scheme.slip_direction_of(k), slip) >= -noise;
    if (!keeps_slipping && length(trial) <= strength + noise)
      return {ContactState::stick};
    Demand result;
    if (!element.has_second_tangential_bar())
      {
        const double sign = keeps_slipping ? slip_sign(now) : trial[0];
        result.state      = sign > 0. ? ContactState::slip_forward : ContactState::slip_backward;
        return result;
      }
    constexpr double free = 1e100; // without strength slip turns without any force
    result.state          = ContactState::slip_forward;
    result.direction      = direction_of(trial);
    const double slipped  = std::max(0., length(trial) - strength);
    result.turning =
      slipped < free * stiffness * strength ? slipped / (stiffness * strength) : free;
    return result;
  }

  // Everything that follows from the dislocations is set; those of the bars that no equation of the
  // scheme gives are what they were. Slips stay those of the beginning, which the layers of stuck
  // elements and the rows of the scheme refer to.
  void
  ImplicitStep::complete(const double tau, JointState &state) const
  {
    state.t = course.time_at(tau);
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      {
        const ContactElement &element = context.elements[k];
        const Strength &strength      = state.strengths[k];
        const bool slips              = is_slipping(state.states[k]);
        const bool rises              = slips && start.strengths[k].dilatancy > 0.;
        if (!rises)
          state.dilations[k] = start.dilations[k];
        else if (strength.dilatancy == 0.)
          state.dilations[k] = element.friction.dilation_limit;
        if (state.states[k] == ContactState::open)
          continue;
        if (!has_nonlinear_closure(element) && !(rises && strength.dilatancy > 0.))
          state.dislocations[element.normal_bar] = state.dilations[k] - element.initial_gap;
        if (slips || has_nonlinear_shear(element) || !carries_shear(element, strength))
          continue;
        for (std::size_t i = 1; i < element.n_bars(); ++i)
          state.dislocations[element.bar(i)] = start.slips[k][i - 1];
      }
    const Vector factors = course.factors_at(tau);
    set_water(context.system, factors, state);
    state.forces = context.system.forces(factors, state.dislocations, state.water);
    // The slip is the part of the jump that forces and dislocations of the same state leave, on
    // layers whose closure includes the last rise.
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (is_slipping(state.states[k]) && state.strengths[k].dilatancy > 0.)
        state.dilations[k] =
          start.dilations[k] + state.strengths[k].dilatancy * length(slip_of_step(state, k));
  }

  TangentVector
  ImplicitStep::slip_of_step(const JointState &state, const std::size_t k) const
  {
    const ContactElement &element = context.elements[k];
    if (!element.has_tangential_bar() || state.states[k] == ContactState::stick)
      return {};
    return sum(present_slip(element, state, k), -1., start.slips[k]);
  }

  // The caller then looks for equilibrium again.
  bool
  ImplicitStep::lose_strength(JointState &state)
  {
    const bool any = lose_strength_in_step(
      context.elements,
      state,
      [this](const std::size_t k) { return context.scheme.slip_direction_of(k); },
      violation_rounding * max_abs(state.forces),
      start);
    if (any)
      take_demands(state);
    return any;
  }

  JointState
  ImplicitStep::finished(JointState state) const
  {
    for (std::size_t k = 0; k < context.elements.size(); ++k)
      if (const ContactElement &element = context.elements[k];
          element.has_tangential_bar() &&
          (state.states[k] != ContactState::stick || !carries_shear(element, state.strengths[k])))
        state.slips[k] = present_slip(element, state, k);
    return state;
  }
} // namespace fuga
