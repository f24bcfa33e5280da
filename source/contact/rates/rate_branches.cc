// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/rates/rate_problem.h>
#include <fuga/contact/scheme/combinations.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Share of its neighbour below which a determinant is that of a mechanism, not a negative
     * one. */
    constexpr double smallest_ratio = 1e-10;
    /** Share of the largest rate below which differences of rates do not make another branch. */
    constexpr double same_rates = 1e-7;
  } // namespace

  std::vector<std::size_t>
  RateProblem::critical_elements(const std::vector<BoundaryElement> &set)
  {
    const bool all = scheme.determinant_sign() <= 0;
    std::vector<std::size_t> result;
    for (const BoundaryElement &candidate : set)
      {
        if (candidate.shear != ShearPosition::at_strength)
          continue;
        const std::size_t k    = candidate.element;
        const ContactState now = scheme.state(k);
        if (now == ContactState::open)
          continue;
        const ContactState other = is_slipping(now)              ? ContactState::stick
                                   : candidate.direction[0] > 0. ? ContactState::slip_forward
                                                                 : ContactState::slip_backward;
        if (all || scheme.determinant_ratio(k, other) < -smallest_ratio)
          result.push_back(k);
      }
    return result;
  }

  bool
  RateProblem::may_have_others(const std::vector<BoundaryElement> &set, const Continuation &found)
  {
    if (in_space)
      // The most expensive question is asked last.
      return (reduced.is_small() || found.met_negative_determinant) && !reduced.has_one_solution();
    std::vector<WorkingScheme::SlipDirection> slips;
    for (const BoundaryElement &candidate : set)
      if (candidate.shear == ShearPosition::at_strength)
        slips.push_back({candidate.element, candidate.direction[0]});
    const bool all_slips = std::none_of(
      set.begin(), set.end(), [](const BoundaryElement &candidate) { return candidate.grazing; });
    if (all_slips)
      if (const std::optional<bool> monotone = scheme.is_monotone(slips))
        return !*monotone;
    return found.met_negative_determinant || !critical_elements(set).empty();
  }

  void
  RateProblem::note_dissipation(const JointState &state, Branch &branch) const
  {
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (is_slipping(scheme.state(k)))
        {
          const TangentVector slip = slip_rate(elements[k], state, k, branch.rates);
          branch.dissipation += dot(tangential(elements[k], state.forces), slip);
          branch.dissipation_growth += dot(tangential(elements[k], branch.rates.forces), slip);
        }
  }

  // Schemes may differ where nothing moves; branches differ if forces or dislocations do.
  bool
  RateProblem::is_new(const std::vector<Branch> &known,
                      const JointRates &rates,
                      const Drive &drive) const
  {
    const DenseMatrix &W = system.stiffness();
    for (const Branch &branch : known)
      {
        double size = max_abs(drive.reactions), difference = 0.;
        for (std::size_t i = 0; i < rates.forces.size(); ++i)
          {
            const double d = rates.dislocations[i], d_known = branch.rates.dislocations[i];
            size       = std::max({size,
                                   std::abs(rates.forces[i]),
                                   std::abs(branch.rates.forces[i]),
                                   W(i, i) * std::abs(d),
                                   W(i, i) * std::abs(d_known)});
            difference = std::max({difference,
                                   std::abs(rates.forces[i] - branch.rates.forces[i]),
                                   W(i, i) * std::abs(d - d_known)});
          }
        if (difference <= same_rates * size)
          return false;
      }
    return true;
  }

  bool
  RateProblem::can_be_enumerated(const std::vector<BoundaryElement> &set) const
  {
    double n = 1.;
    for (const BoundaryElement &candidate : set)
      {
        if (candidate.shear == ShearPosition::at_apex &&
            elements[candidate.element].has_second_tangential_bar())
          return false;
        n *= static_cast<double>(n_states(candidate));
      }
    return n <= most_combinations;
  }

  Branch
  RateProblem::present_branch(const std::vector<BoundaryElement> &set) const
  {
    Branch present;
    for (const BoundaryElement &candidate : set)
      {
        present.states.push_back(scheme.state(candidate.element));
        present.directions.push_back(scheme.slip_direction_of(candidate.element));
      }
    return present;
  }

  std::vector<Branch>
  RateProblem::branches(const JointState &state,
                        const std::vector<BoundaryElement> &set,
                        const Drive &drive)
  {
    const Branch present = present_branch(set);
    take_background(state, set);
    std::vector<Branch> found;
    const auto note = [&](Branch branch) {
      if (!is_new(found, branch.rates, drive))
        return;
      take(set, branch);
      note_dissipation(state, branch);
      found.push_back(std::move(branch));
    };
    Continuation checked;
    ConeRateProblem::Accept accept = acceptance(state, set, drive, checked);
    if (accept)
      accept = [&, decides = std::move(accept)](const ConeContinuation &states,
                                                const bool as_they_are) {
        if (!decides(states, as_they_are))
          return false;
        Branch branch           = present_branch(set);
        branch.rates            = checked.rates;
        branch.determinant_sign = scheme.determinant_sign();
        note(std::move(branch));
        return true;
      };
    for (const ConeContinuation &solution : reduced.all_solutions(
           state, set, off_boundary, drive, present.states, present.directions, accept))
      note({solution.states, solution.directions, solution.rates, solution.determinant_sign});
    take(set, present);
    return found;
  }
} // namespace fuga
