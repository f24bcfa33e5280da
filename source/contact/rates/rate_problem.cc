// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/rates/rate_problem.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fuga
{
  namespace
  {
    /** Number of mechanisms that one attempt to switch states one by one may pass through. */
    constexpr std::size_t most_mechanisms = 12;
  } // namespace

  RateProblem::RateProblem(const std::vector<ContactElement> &contact_elements,
                           const LayeredSystem &layered_system,
                           WorkingScheme &working_scheme)
    : elements(contact_elements)
    , system(layered_system)
    , scheme(working_scheme)
    , off_boundary(contact_elements, layered_system)
    , in_space(have_two_tangents(contact_elements))
    , reduced(contact_elements, layered_system)
  {
  }

  Continuation
  RateProblem::solve(const JointState &state,
                     const std::vector<BoundaryElement> &set,
                     const Drive &drive,
                     const std::vector<std::size_t> &resticking,
                     const double widening)
  {
    resting       = resticking;
    noise_at_rest = widening;
    Continuation result;
    if (!in_space)
      for (const RateMethod method : {RateMethod::block_switching, RateMethod::single_switching})
        {
          result.method = method;
          if (switch_states(state, set, drive, result))
            return result;
        }
    solve_reduced(state, set, drive, result);
    return result;
  }

  void
  RateProblem::take_background(const JointState &state, const std::vector<BoundaryElement> &set)
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        off_boundary.set_strength(k, state.strengths[k]);
        off_boundary.set_state(k, state.states[k]);
      }
    for (const BoundaryElement &candidate : set)
      off_boundary.set_state(candidate.element, ContactState::stick);
    off_boundary.linearise(state);
  }

  // The return value tells whether any element opens.
  bool
  RateProblem::take_states(const std::vector<BoundaryElement> &set, const ConeContinuation &found)
  {
    bool any_open = false;
    for (std::size_t i = 0; i < set.size(); ++i)
      {
        any_open |= found.states[i] == ContactState::open;
        scheme.set_state(set[i].element, found.states[i], found.directions[i]);
      }
    return any_open;
  }

  ConeRateProblem::Accept
  RateProblem::acceptance(const JointState &state,
                          const std::vector<BoundaryElement> &set,
                          const Drive &drive,
                          Continuation &checked)
  {
    if (in_space)
      return {};
    return [&](const ConeContinuation &states, const bool as_they_are) {
      take_states(set, states);
      checked.method = as_they_are ? RateMethod::search : RateMethod::single_switching;
      return switch_states(state, set, drive, checked);
    };
  }

  void
  RateProblem::note_active(const std::vector<BoundaryElement> &set, const JointRates &rates)
  {
    for (const BoundaryElement &member : set)
      for (std::size_t a = 0; a < elements[member.element].n_bars(); ++a)
        if (const std::size_t bar = elements[member.element].bar(a); rates.dislocations[bar] != 0.)
          scheme.note_active(bar);
  }

  void
  RateProblem::solve_reduced(const JointState &state,
                             const std::vector<BoundaryElement> &set,
                             const Drive &drive,
                             Continuation &result)
  {
    take_background(state, set);
    Continuation checked;
    const ConeContinuation found = reduced.solve(state,
                                                 set,
                                                 off_boundary,
                                                 drive,
                                                 resting,
                                                 noise_at_rest,
                                                 acceptance(state, set, drive, checked));
    result.exists                = found.exists;
    result.rates                 = in_space ? found.rates : checked.rates;
    result.has_mechanism         = found.has_mechanism;
    result.mechanism             = found.mechanism;
    result.is_ruled_out          = found.is_ruled_out;
    result.barrier               = found.barrier;
    result.n_schemes += found.n_schemes + checked.n_schemes;
    result.met_negative_determinant |=
      in_space ? found.exists && found.determinant_sign < 0 : checked.met_negative_determinant;
    result.method = found.by_search ? RateMethod::search : RateMethod::newton;
    if (!found.exists || !in_space)
      return;
    note_active(set, found.rates);
    if (!take_states(set, found))
      return;
    // An element that opens may leave bodies without support.
    for (std::size_t i = 0; i < set.size(); ++i)
      if (found.states[i] == ContactState::open)
        off_boundary.set_state(set[i].element, ContactState::open);
    const std::optional<WorkingScheme::FreeMotion> motion = off_boundary.motion(drive);
    if (motion && !motion->is_driven && !(motion->rests && scheme.is_nonlinear()))
      return; // what rests would have to be held at every point of a curve
    result.exists        = false;
    result.has_mechanism = true;
    result.mechanism     = off_boundary.mechanism(drive);
  }

  std::vector<RateProblem::Switch>
  RateProblem::violations(const JointState &state,
                          const std::vector<BoundaryElement> &set,
                          const Drive &drive,
                          const JointRates &rates) const
  {
    std::vector<Switch> switches;
    const ContactBoundary::RateNoise noise(system, rates, drive);
    for (const BoundaryElement &member : set)
      {
        const std::size_t k           = member.element;
        const ContactElement &element = elements[k];
        const std::size_t n           = element.normal_bar;
        const RateAnswer now{scheme.state(k), scheme.slip_direction_of(k)};
        LocalRates local;
        local.force            = rates.forces[n];
        local.opening          = lip_opening_rate(element, state, rates);
        local.no_force         = noise.force(n);
        local.no_opening       = noise.jump();
        local.normal_stiffness = system.scale(n) * system.scale(n);
        if (element.has_tangential_bar())
          {
            const std::size_t t = element.tangential_bar;
            local.shear         = tangential(element, rates.forces);
            local.velocity      = tangential(element, rates.dislocations);
            local.slip          = dot(now.direction, slip_rate(element, state, k, rates));
            local.no_slip       = noise.jump();
            local.no_shear      = noise.force(t) + state.strengths[k].friction * local.no_force;
            if (now.state == ContactState::stick &&
                std::find(resting.begin(), resting.end(), k) != resting.end())
              local.no_shear *= noise_at_rest;
            local.shear_stiffness = system.scale(t) * system.scale(t);
          }
        const DemandedAnswer wanted = RateLaw(member, element, state, drive).demand(now, local);
        if (state_of(wanted, element) != now.state)
          switches.push_back({k, state_of(wanted, element)});
      }
    return switches;
  }

  // Violating elements are switched until none is left. A scheme that comes back, or a mechanism
  // that violates nothing as it moves, ends the attempt; the next method then has to decide.
  bool
  RateProblem::switch_states(const JointState &state,
                             const std::vector<BoundaryElement> &set,
                             const Drive &drive,
                             Continuation &result)
  {
    const bool all_at_once = result.method == RateMethod::block_switching;
    std::set<std::vector<ContactState>> visited;
    const std::size_t max_schemes = result.method == RateMethod::search ? 1
                                    : all_at_once                       ? 60
                                                                        : 20 + 4 * set.size();
    std::size_t n_mechanisms      = 0;
    for (std::size_t count = 0; count < max_schemes; ++count)
      {
        ++result.n_schemes;
        if (!visited.insert(states_of(set)).second)
          return false;
        std::optional<WorkingScheme::FreeMotion> motion = scheme.motion(drive);
        // Every point of a curve is a solution of its own, in which a motion that rests has to be
        // held.
        if (motion)
          motion->is_driven |= motion->rests && scheme.is_nonlinear();
        if (!motion || (motion->is_driven && (all_at_once || n_mechanisms++ == most_mechanisms)))
          return false;
        result.met_negative_determinant |= !motion->is_driven && scheme.determinant_sign() < 0;
        const std::vector<Switch> switches = violations(state, set, drive, motion->rates);
        if (switches.empty() && motion->is_driven)
          return false;
        if (switches.empty())
          {
            result.exists = true;
            result.rates  = motion->rates;
            return true;
          }
        const std::size_t n = all_at_once ? switches.size() : 1;
        for (std::size_t i = 0; i < n; ++i)
          scheme.set_state(switches[i].element, switches[i].to);
      }
    return false;
  }

  std::vector<ContactState>
  RateProblem::states_of(const std::vector<BoundaryElement> &set) const
  {
    std::vector<ContactState> states;
    for (const BoundaryElement &candidate : set)
      states.push_back(scheme.state(candidate.element));
    return states;
  }
} // namespace fuga
