// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/path/implicit_step.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fuga
{
  namespace
  {
    constexpr std::size_t max_schemes = 200;
  } // namespace

  ImplicitStep::ImplicitStep(const std::vector<ContactElement> &contact_elements,
                             const LayeredSystem &layered_system,
                             WorkingScheme &working_scheme)
    : elements(contact_elements), system(layered_system), scheme(working_scheme)
  {
  }

  std::optional<JointState>
  ImplicitStep::solve(const JointState &from, const double t, const Vector &factors)
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      scheme.set_state(k, from.states[k]);
    std::set<std::vector<ContactState>> visited;
    while (visited.size() < max_schemes && visited.insert(scheme.all_states()).second)
      {
        ++n_schemes;
        JointState state = from;
        state.t          = t;
        if (!satisfy_scheme(from, factors, state))
          return {};
        if (!switch_violating(from, state))
          return state;
      }
    return {};
  }

  // The active rows are linear: one correction from any start solves them.
  bool
  ImplicitStep::satisfy_scheme(const JointState &from, const Vector &factors, JointState &state)
  {
    state.states = scheme.all_states();
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        if (state.states[k] != ContactState::open)
          state.dislocations[element.normal_bar] = -element.initial_gap;
        if (element.has_tangential_bar())
          state.dislocations[element.tangential_bar] = from.slips[k][0];
      }
    state.forces                           = system.forces(factors, state.dislocations);
    const std::optional<JointRates> change = scheme.correction(scheme.residual(state));
    if (!change)
      return false;
    for (std::size_t i = 0; i < state.dislocations.size(); ++i)
      state.dislocations[i] += change->dislocations[i];
    state.forces = system.forces(factors, state.dislocations);
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (elements[k].has_tangential_bar() && state.states[k] != ContactState::stick)
        state.slips[k] = tangential(elements[k], state.dislocations);
    return true;
  }

  bool
  ImplicitStep::switch_violating(const JointState &from, const JointState &state)
  {
    bool any = false;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactState wanted = state_wanted(from, state, k);
        any |= wanted != scheme.state(k);
        scheme.set_state(k, wanted);
      }
    return any;
  }

  // Newton's guess for the augmented Lagrangian: an open element that penetrates, and one that
  // slips backwards, take the state that force and jump, made comparable by the stiffness of the
  // bars, tell.
  ContactState
  ImplicitStep::state_wanted(const JointState &from,
                             const JointState &state,
                             const std::size_t k) const
  {
    const ContactElement &element = elements[k];
    const std::size_t n           = element.normal_bar;
    const ContactState now        = state.states[k];
    const double N                = state.forces[n];
    const double g                = now == ContactState::open ? gap(element, state, k) : 0.;
    // Violations below this share of the largest force or jump are rounding.
    constexpr double rounding = 1e-12;
    const double noise        = rounding * max_abs(state.forces);
    const double W_n          = system.stiffness()(n, n);
    if (now == ContactState::open ? W_n * g >= -noise : N > noise)
      return ContactState::open;
    if (!element.has_tangential_bar())
      return ContactState::stick;

    const std::size_t t   = element.tangential_bar;
    const double W_t      = system.stiffness()(t, t);
    const double pressing = now == ContactState::open ? -W_n * g : std::max(-N, 0.);
    const double strength =
      state.strengths[k].friction * pressing + cohesive_strength(element, state, k);
    const double slipped = state.slips[k][0] - from.slips[k][0];
    if (is_slipping(now) && slip_sign(now) * W_t * slipped >= -noise)
      return now;
    const double trial = (now == ContactState::open ? 0. : state.forces[t]) +
                         (now == ContactState::stick ? 0. : W_t * slipped);
    if (std::abs(trial) <= strength + noise)
      return ContactState::stick;
    return trial > 0. ? ContactState::slip_forward : ContactState::slip_backward;
  }
} // namespace fuga
