// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/rates/boundary_lcp.h>
#include <fuga/contact/rates/lemke.h>
#include <fuga/contact/rates/rate_problem.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fuga
{
  namespace
  {
    /** Share of its neighbour below which a determinant is that of a mechanism, not a negative
     * one. */
    constexpr double smallest_ratio = 1e-10;
    /** Share of the largest rate below which differences of rates do not make another branch. */
    constexpr double same_rates = 1e-7;
    /** Number of covering vectors with which Lemke's method looks for further branches. */
    constexpr unsigned int n_covering_vectors = 12;
    /** Number of random first guesses. */
    constexpr unsigned int n_random_guesses = 64;

    /** Return the parts of the covering vector that may be chosen, between 0.05 and 1.05, such that
     * they fill the interval evenly: multiples of the golden ratio. */
    Vector
    varied(const BoundaryLcp &lcp, const unsigned int attempt)
    {
      constexpr double golden_ratio = 0.6180339887498949;
      Vector result                 = lcp.covering;
      for (std::size_t i = 0; i < result.size() && attempt > 0; ++i)
        {
          const double position = golden_ratio * static_cast<double>(attempt * result.size() + i);
          result[i]             = lcp.friction_share[i] + 0.05 + position - std::floor(position);
        }
      return result;
    }
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
        const ContactState other = is_slipping(now)      ? ContactState::stick
                                   : candidate.sign > 0. ? ContactState::slip_forward
                                                         : ContactState::slip_backward;
        if (all || scheme.determinant_ratio(k, other) < -smallest_ratio)
          result.push_back(k);
      }
    return result;
  }

  bool
  RateProblem::may_have_others(const std::vector<BoundaryElement> &set, const Continuation &found)
  {
    if (has_cones)
      // The most expensive question is asked last.
      return (cones.is_small() || found.met_negative_determinant) && !cones.has_one_solution();
    std::vector<WorkingScheme::SlipDirection> slips;
    for (const BoundaryElement &candidate : set)
      if (candidate.shear == ShearPosition::at_strength)
        slips.push_back({candidate.element, candidate.sign});
    const bool all_slips = std::none_of(
      set.begin(), set.end(), [](const BoundaryElement &candidate) { return candidate.grazing; });
    if (all_slips)
      if (const std::optional<bool> monotone = scheme.is_monotone(slips))
        return !*monotone;
    return found.met_negative_determinant || !critical_elements(set).empty();
  }

  Branch
  RateProblem::present_branch(const JointState &state,
                              const std::vector<BoundaryElement> &set,
                              const JointRates &rates)
  {
    Branch branch;
    branch.states           = states_of(set);
    branch.rates            = rates;
    branch.determinant_sign = scheme.determinant_sign();
    note_dissipation(state, branch);
    return branch;
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

  // The guesses are: all stuck, all slipping, the present branch with one critical element turned,
  // and random ones.
  std::vector<std::vector<ContactState>>
  RateProblem::first_guesses(const std::vector<BoundaryElement> &set)
  {
    const std::vector<ContactState> present = states_of(set);
    const std::vector<std::size_t> critical = critical_elements(set);
    const auto switched = [&](const BoundaryElement &candidate, const ContactState now) {
      if (candidate.shear != ShearPosition::at_strength || now == ContactState::open)
        return now;
      if (is_slipping(now))
        return ContactState::stick;
      return candidate.sign > 0. ? ContactState::slip_forward : ContactState::slip_backward;
    };
    std::vector<std::vector<ContactState>> guesses(2, present);
    for (std::size_t i = 0; i < set.size(); ++i)
      {
        guesses[0][i] = ContactState::stick;
        guesses[1][i] = switched(set[i], ContactState::stick);
        if (std::find(critical.begin(), critical.end(), set[i].element) != critical.end() &&
            guesses.size() < 2 + max_enumerated)
          {
            guesses.push_back(present);
            guesses.back()[i] = switched(set[i], present[i]);
          }
      }
    std::mt19937 random; // its numbers are the same everywhere
    for (unsigned int i = 0; i < n_random_guesses; ++i)
      {
        guesses.push_back(present);
        for (std::size_t k = 0; k < set.size(); ++k)
          {
            const std::vector<ContactState> admissible = admissible_states(set[k]);
            guesses.back()[k]                          = admissible[random() % admissible.size()];
          }
      }
    return guesses;
  }

  // The search uses Lemke's method with several covering vectors, then switching from several
  // schemes.
  std::vector<Branch>
  RateProblem::search_branches(const JointState &state,
                               const std::vector<BoundaryElement> &set,
                               const Drive &drive,
                               const std::vector<Branch> &known,
                               const std::size_t n_wanted)
  {
    std::vector<Branch> found                            = known;
    const std::vector<std::vector<ContactState>> guesses = first_guesses(set);
    Continuation result;
    const auto note = [&] {
      if (switch_states(state, set, drive, Stride::one_at_a_time, result) &&
          is_new(found, result.rates, drive))
        found.push_back(present_branch(state, set, result.rates));
    };
    const std::optional<BoundaryLcp> lcp = boundary_lcp(state, set, drive, result);
    for (unsigned int attempt = 0; lcp && attempt < n_covering_vectors && found.size() < n_wanted;
         ++attempt)
      {
        const LcpSolution solution = solve_lcp(lcp->M, lcp->q, varied(*lcp, attempt));
        take_states(*lcp, set, solution.solved() ? solution.z : solution.vertex);
        note();
      }
    for (std::size_t i = 0; i < guesses.size() && found.size() < n_wanted; ++i)
      {
        set_states(set, guesses[i]);
        note();
      }
    return found;
  }
} // namespace fuga
