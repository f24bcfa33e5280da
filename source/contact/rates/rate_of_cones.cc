// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/rates/rate_problem.h>

#include <algorithm>

// The rate problem where elements have two tangential bars.
namespace fuga
{
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
  RateProblem::take_cones(const std::vector<BoundaryElement> &set, const ConeContinuation &found)
  {
    bool any_open = false;
    for (std::size_t i = 0; i < set.size(); ++i)
      {
        const ContactElement &element = elements[set[i].element];
        any_open |= found.states[i] == ContactState::open;
        scheme.set_state(set[i].element, found.states[i], found.directions[i]);
        for (std::size_t a = 0; a < element.n_bars(); ++a)
          if (found.rates.dislocations[element.bar(a)] != 0.)
            scheme.note_active(element.bar(a));
      }
    return any_open;
  }

  Continuation
  RateProblem::solve_cones(const JointState &state,
                           const std::vector<BoundaryElement> &set,
                           const Drive &drive,
                           const std::vector<std::size_t> &resticking,
                           const double widening)
  {
    take_background(state, set);
    const ConeContinuation found =
      cones.solve(state, set, off_boundary, drive, resticking, widening);
    Continuation result;
    result.exists                   = found.exists;
    result.rates                    = found.rates;
    result.n_schemes                = found.n_schemes;
    result.has_mechanism            = found.has_mechanism;
    result.mechanism                = found.mechanism;
    result.is_ruled_out             = found.is_ruled_out;
    result.barrier                  = found.barrier;
    result.met_negative_determinant = found.exists && found.determinant_sign < 0;
    if (found.by_search)
      result.method = RateMethod::search;
    if (!found.exists || !take_cones(set, found))
      return result;
    // An element that opens may leave bodies without support.
    for (std::size_t i = 0; i < set.size(); ++i)
      if (found.states[i] == ContactState::open)
        off_boundary.set_state(set[i].element, ContactState::open);
    if (!off_boundary.rates(drive))
      {
        result.exists        = false;
        result.has_mechanism = true;
        result.mechanism     = off_boundary.mechanism();
      }
    return result;
  }

  // The set is the one that was decided last.
  std::vector<Branch>
  RateProblem::branches_of_cones(const JointState &state,
                                 const std::vector<BoundaryElement> &set,
                                 const Drive &drive)
  {
    take_background(state, set);
    std::vector<Branch> found;
    for (const ConeContinuation &solution : cones.all_solutions(off_boundary, drive))
      if (is_new(found, solution.rates, drive))
        {
          Branch branch;
          branch.states           = solution.states;
          branch.directions       = solution.directions;
          branch.rates            = solution.rates;
          branch.determinant_sign = solution.determinant_sign;
          found.push_back(branch);
        }
    for (std::size_t i = found.size(); i-- > 0;)
      {
        take(set, found[i]);
        note_dissipation(state, found[i]);
      }
    return found;
  }

  ControlledContinuation
  RateProblem::solve_yielding_cones(const JointState &state,
                                    const std::vector<BoundaryElement> &set,
                                    const Drive &drive,
                                    const Drive &unit_load,
                                    const ConeRateProblem::Control control)
  {
    take_background(state, set);
    const ConeContinuation found =
      cones.solve_yielding(state, set, off_boundary, drive, unit_load, control);
    ControlledContinuation result;
    result.exists    = found.exists;
    result.rates     = found.rates;
    result.load_rate = found.load_rate;
    if (found.exists)
      take_cones(set, found);
    return result;
  }
} // namespace fuga
