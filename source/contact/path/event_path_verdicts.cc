// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/path/event_path.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    bool
    differs(const Branch &a, const Branch &b, const std::size_t i)
    {
      constexpr double same_direction = 1e-6;
      if (a.states[i] != b.states[i])
        return true;
      return is_slipping(a.states[i]) &&
             length(sum(a.directions[i], -1., b.directions[i])) > same_direction;
    }

    /** Return the elements whose state, or direction of slip, is not the same in all branches. */
    std::vector<std::size_t>
    differing_elements(const std::vector<BoundaryElement> &set, const std::vector<Branch> &branches)
    {
      std::vector<std::size_t> result;
      for (std::size_t i = 0; i < set.size(); ++i)
        if (std::any_of(branches.begin(), branches.end(), [&](const Branch &branch) {
              return differs(branch, branches.front(), i);
            }))
          result.push_back(set[i].element);
      return result;
    }

    /** Return the branch that dissipates most; where nothing is dissipated yet, the one whose
     * dissipation grows fastest. Among equal ones it is the first. */
    const Branch &
    most_dissipating(const std::vector<Branch> &branches)
    {
      constexpr double rounding = 1e-9;
      double size               = 0.;
      for (const Branch &branch : branches)
        size = std::max(size, std::abs(branch.dissipation));
      const auto less = [&](const Branch &a, const Branch &b) {
        if (std::abs(a.dissipation - b.dissipation) > rounding * size)
          return a.dissipation < b.dissipation;
        return a.dissipation_growth < b.dissipation_growth;
      };
      return *std::max_element(branches.begin(), branches.end(), less);
    }
  } // namespace

  // Further continuations are looked for only where it is not known that the present one is the
  // only one.
  void
  EventPath::choose_branch(const JointState &state,
                           const std::vector<BoundaryElement> &set,
                           const Drive &drive,
                           Continuation &continuation,
                           PathResult &result)
  {
    if (!options.looks_for_others || !rate_problem.may_have_others(set, continuation))
      return;
    const std::vector<Branch> branches = rate_problem.branches(state, set, drive);
    if (branches.size() < 2)
      return;
    continuation.n_branches = branches.size();
    if (result.n_non_unique++ == 0)
      {
        result.critical             = {};
        result.critical.t           = state.t;
        result.critical.elements    = differing_elements(set, branches);
        result.critical.n_branches  = branches.size();
        result.critical.all_counted = rate_problem.can_be_enumerated(set);
        for (const Branch &branch : branches)
          result.critical.determinant_signs.push_back(branch.determinant_sign);
      }
    if (options.non_unique == PathOptions::NonUnique::stop)
      {
        continuation.exists = false;
        result.verdict      = Verdict::non_unique_continuation;
      }
    else if (options.non_unique == PathOptions::NonUnique::largest_dissipation)
      {
        const Branch &branch = most_dissipating(branches);
        rate_problem.take(set, branch);
        continuation.rates = branch.rates;
      }
  }

  // There is no continuation although nothing moves freely: the critical elements are those whose
  // slip would take the determinant through zero, or all on their strength if none does so alone.
  void
  EventPath::find_critical_elements(JointState &state, PathResult &result)
  {
    const std::vector<BoundaryElement> set = boundary.elements_on_boundary(state);
    take_scheme(state);
    CriticalFriction &critical = result.critical;
    critical                   = {};
    critical.t                 = state.t;
    if (in_space)
      {
        result.t = state.t;
        for (const BoundaryElement &candidate : set)
          if (candidate.shear == ShearPosition::at_strength)
            critical.elements.push_back(candidate.element);
        return;
      }
    critical.elements     = rate_problem.critical_elements(set);
    critical.all_counted  = rate_problem.can_be_enumerated(set);
    const bool none_alone = critical.elements.empty();
    for (const BoundaryElement &candidate : set)
      if (candidate.shear == ShearPosition::at_strength &&
          scheme.state(candidate.element) != ContactState::open)
        {
          scheme.set_state(candidate.element,
                           candidate.direction[0] > 0. ? ContactState::slip_forward
                                                       : ContactState::slip_backward);
          if (none_alone)
            critical.elements.push_back(candidate.element);
        }
    critical.determinant_signs = {scheme.determinant_sign()};
  }

  // All states can be tried where they are few and directions of slip are given.
  void
  EventPath::note_what_was_tried(const Continuation &continuation,
                                 const std::vector<BoundaryElement> &set,
                                 PathResult &result) const
  {
    result.critical.all_counted = continuation.is_ruled_out || rate_problem.can_be_enumerated(set);
    if (result.critical.all_counted)
      return;
    result.tried = fmt::format(
      "Newton's method tried {} sets of states of {} elements on the boundary of their contact "
      "conditions, also from a softer layer, from associated friction, with sweeps from element "
      "to element and from {}",
      continuation.n_schemes,
      set.size(),
      rate_problem.is_small() ? "all combinations of their states" : "their present states alone");
  }

  void
  EventPath::lose_equilibrium(JointState &state,
                              const Continuation &continuation,
                              PathObserver &observer,
                              PathResult &result)
  {
    result.t = state.t;
    if (result.verdict == Verdict::non_unique_continuation)
      return;
    result.verdict = Verdict::no_continuation;
    if (!continuation.has_mechanism || !is_free_motion(continuation.mechanism, system))
      {
        find_critical_elements(state, result);
        note_what_was_tried(continuation, boundary.elements_on_boundary(state), result);
        result.barrier = continuation.barrier.value_or(JointRates());
        return;
      }
    take_limit(state, continuation.mechanism, result);
    result.critical.all_counted =
      continuation.is_ruled_out ||
      rate_problem.can_be_enumerated(boundary.elements_on_boundary(state));

    // The elements that reach their boundary at the limit take the state in which the mechanism
    // moves.
    std::vector<ContactEvent> events;
    for (const BoundaryElement &candidate : boundary.elements_on_boundary(state))
      {
        const std::size_t k = candidate.element;
        const ContactState to =
          state_in_mechanism(candidate, elements[k], state, result.mechanism_jumps);
        if (to != state.states[k])
          events.push_back(change_element(k,
                                          to,
                                          slip_direction(elements[k], to, candidate.direction),
                                          boundary.force_tolerance(elements[k].normal_bar),
                                          state));
      }
    report(events, state, observer, result);
  }
} // namespace fuga
