// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/lcp_search.h>
#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/rates/boundary_lcp.h>
#include <fuga/contact/rates/lemke.h>
#include <fuga/contact/rates/rate_problem.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return whether the solutions of eq. 7 are all that there are. An element that opens may slip
     * in both directions; eq. 7 contains this only if it could slip already, or has no tangential
     * bar. */
    bool
    has_all_states(const BoundaryElement &candidate, const ContactElement &element)
    {
      return !candidate.grazing || candidate.shear == ShearPosition::at_apex ||
             !element.has_tangential_bar();
    }

    /** Return the noise that RateProblem may take for zero: that of forces in the largest motion
     * that does not belong to a mechanism, and that of jumps in any motion, which is not more than
     * the sum of what its parts leave. */
    LcpNoise
    noise_of(const BoundaryLcp &lcp,
             const JointState &state,
             const std::vector<ContactElement> &elements,
             const LayeredSystem &system,
             const Drive &drive)
    {
      double driving_force = 0.;
      for (std::size_t i = 0; i < drive.reactions.size(); ++i)
        driving_force =
          std::max({driving_force,
                    std::abs(drive.reactions[i]) / system.scale(i),
                    drive.strength.empty() ? 0. : std::abs(drive.strength[i]) / system.scale(i)});
      LcpNoise result;
      result.largest_unknown = largest_motion * driving_force;
      JointRates largest;
      largest.forces.assign(system.n_bars(), 0.);
      for (std::size_t i = 0; i < system.n_bars(); ++i)
        largest.dislocations.push_back(result.largest_unknown / system.scale(i));
      const ContactBoundary::RateNoise noise(system, largest, drive);
      result.at_rest = ContactBoundary::RateNoise(system, lcp.stuck, drive).jump();
      Drive no_drive;
      no_drive.reactions.assign(system.n_bars(), 0.);
      for (std::size_t j = 0; j < lcp.size(); ++j)
        {
          const BoundaryLcp::Unknown &unknown = lcp.unknowns[j];
          const ContactElement &element       = elements[unknown.element];
          const double normal                 = noise.force(element.normal_bar);
          const double reserve =
            unknown.state == ContactState::open
              ? normal
              : noise.force(unknown.bar) + state.strengths[unknown.element].friction * normal;
          result.reserves.push_back(lcp.scale[j] * reserve);
          result.unknowns.push_back(1. / lcp.scale[j]);
          result.shares.push_back(0.);
          result.growth.push_back(
            lcp.scale[j] * ContactBoundary::RateNoise(system, lcp.responses[j], no_drive).jump());
        }
      return result;
    }
  } // namespace

  // Where all rates are resisted, as by a viscous layer, no motion is free, and Lemke's method
  // finds a solution; the weaker the resistance, the closer it is to a solution without resistance.
  void
  RateProblem::guess_by_resistance(const BoundaryLcp &lcp,
                                   const std::vector<BoundaryElement> &set,
                                   const Guess &guess)
  {
    for (const double resistance : {1e-8, 1e-6, 1e-4, 1e-2, 1.})
      {
        DenseMatrix M = lcp.M;
        for (std::size_t i = 0; i < lcp.size(); ++i)
          M(i, i) += resistance;
        const LcpSolution solution = solve_lcp(M, lcp.q, lcp.covering);
        if (!solution.solved())
          continue;
        take_states(lcp, set, solution.z);
        if (guess())
          return;
      }
  }

  // Newton's method for cones begins from a softer layer or with associated slip.
  void
  RateProblem::guess_by_cones(const JointState &state,
                              const std::vector<BoundaryElement> &set,
                              const Drive &drive,
                              const std::vector<std::size_t> &resticking,
                              const Guess &guess)
  {
    try
      {
        if (solve_cones(state, set, drive, resticking, 1.).exists)
          guess();
      }
    catch (const NumericalFailure &)
      {
        // The rates of rigid bodies may be as large as numbers can be; nothing was found then.
      }
  }

  // Every method ends in a scheme to switch from; a motion may rest only if all of them fail.
  void
  RateProblem::search_all(const JointState &state,
                          const std::vector<BoundaryElement> &set,
                          const Drive &drive,
                          const std::vector<std::size_t> &resticking,
                          Continuation &result)
  {
    const std::optional<BoundaryLcp> lcp = boundary_lcp(state, set, drive, result);
    if (!lcp)
      return;
    std::vector<std::vector<ContactState>> guesses;
    const Guess guess = [&] {
      guesses.push_back(states_of(set));
      return switch_states(state, set, drive, Stride::one_at_a_time, result);
    };
    guess_by_resistance(*lcp, set, guess);
    if (result.exists)
      return;
    const LcpSearch found =
      search_lcp(lcp->M, lcp->q, noise_of(*lcp, state, elements, system, drive));
    result.is_ruled_out =
      found.end == SearchEnd::none &&
      std::all_of(set.begin(), set.end(), [&](const BoundaryElement &candidate) {
        return has_all_states(candidate, elements[candidate.element]);
      });
    if (result.is_ruled_out)
      return;
    if (found.end == SearchEnd::found)
      {
        take_states(*lcp, set, found.z);
        if (guess())
          return;
      }
    guess_by_cones(state, set, drive, resticking, guess);
    for (std::size_t i = 0; i < guesses.size() && !result.exists; ++i)
      {
        set_states(set, guesses[i]);
        switch_states(state, set, drive, Stride::last_resort, result);
      }
  }
} // namespace fuga
