// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/change_of_state.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/path/event_path.h>

namespace fuga
{
  Continuation
  EventPath::decide(JointState &state,
                    const Course &course,
                    PathObserver &observer,
                    PathResult &result)
  {
    take_scheme(state);
    for (const std::size_t k : resticking)
      scheme.set_state(k, ContactState::stick);
    scheme.linearise(state);

    const std::vector<BoundaryElement> set = standstill.unite(boundary.elements_on_boundary(state));
    Continuation continuation =
      rate_problem.solve(state, set, course.drive, resticking, widening_at_rest());
    result.n_schemes += continuation.n_schemes;
    if (continuation.exists)
      choose_branch(state, set, course.drive, continuation, result);
    if (!continuation.exists)
      return continuation;
    ++result.n_decided_by[static_cast<std::size_t>(continuation.method)];

    rest_at_apex(state, set, course.drive, continuation.rates);
    continuation.costs_strength =
      adopt_scheme(state, set, continuation.n_branches, observer, result);
    return continuation;
  }

  void
  EventPath::take_scheme(JointState &state)
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        if (state.dilations[k] >= elements[k].friction.dilation_limit - boundary.gap_tolerance())
          state.strengths[k].dilatancy = 0.;
        scheme.set_state(k, state.states[k]);
        scheme.set_strength(k, state.strengths[k]);
      }
  }

  // Faces may slip apart under the first load and leave some elements where they are, which satisfy
  // the conditions of slip as well as those of stick. Sliding from the apex costs strength, and
  // they do not slide.
  void
  EventPath::rest_at_apex(const JointState &state,
                          const std::vector<BoundaryElement> &set,
                          const Drive &drive,
                          const JointRates &rates)
  {
    std::vector<std::size_t> beginning;
    for (const BoundaryElement &candidate : set)
      {
        const std::size_t k           = candidate.element;
        const ContactElement &element = elements[k];
        if (element.friction.friction_loss != 0. && !is_slipping(state.states[k]) &&
            is_slipping(scheme.state(k)) &&
            state.forces[element.normal_bar] >= -boundary.force_tolerance(element.normal_bar))
          beginning.push_back(k);
      }
    if (beginning.empty())
      return;
    const ContactBoundary::RateNoise noise(system, rates, drive);
    for (const std::size_t k : beginning)
      if (length(slip_rate(elements[k], state, k, rates)) <= noise.jump())
        scheme.set_state(k, ContactState::stick);
  }

  // The boundary elements get the states of the working scheme. The rates that led to it do not
  // know the strength that it costs: neither the forces that have to be given up, nor, where an
  // element has no force to give up, the friction that it loses as it slides from the apex of its
  // cone, or the bond that would hold its shear as it opens.
  bool
  EventPath::adopt_scheme(JointState &state,
                          const std::vector<BoundaryElement> &set,
                          const std::size_t n_branches,
                          PathObserver &observer,
                          PathResult &result) const
  {
    const Vector unreleased = state.unreleased;
    bool costs_strength     = false;
    std::vector<ContactEvent> events;
    for (const BoundaryElement &candidate : set)
      {
        const std::size_t k = candidate.element;
        if (state.states[k] == scheme.state(k))
          continue;
        const Strength strength = state.strengths[k];
        events.push_back(change_element(k,
                                        scheme.state(k),
                                        scheme.slip_direction_of(k),
                                        boundary.force_tolerance(elements[k].normal_bar),
                                        state));
        events.back().n_branches = n_branches;
        costs_strength |= !(state.strengths[k] == strength);
      }
    report(events, state, observer, result);
    return costs_strength || state.unreleased != unreleased;
  }

  // A bond at the end of its strength breaks if it allows no continuation, neither when kept nor
  // when lost by opening.
  bool
  EventPath::break_exhausted_bonds(JointState &state,
                                   PathObserver &observer,
                                   PathResult &result) const
  {
    bool any = false;
    std::vector<ContactEvent> events;
    for (const BoundaryElement &candidate : boundary.elements_on_boundary(state))
      {
        const std::size_t k = candidate.element;
        if (!candidate.grazing || !state.strengths[k].has_bond())
          continue;
        any                     = true;
        const ContactState from = state.states[k];
        const double no_force   = boundary.force_tolerance(elements[k].normal_bar);
        break_bond(elements[k], k, no_force, state);
        if (state.states[k] != from)
          events.push_back({state.t, k, from, state.states[k]});
      }
    report(events, state, observer, result);
    return any;
  }
} // namespace fuga
