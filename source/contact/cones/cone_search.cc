// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/lcp_search.h>
#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/element/mechanism.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  // What cannot be tried as a whole is searched, unless a virtual motion shows at once that there
  // is nothing to be found.
  bool
  ConeRateProblem::search_or_prove(WorkingScheme &background,
                                   const Drive &drive,
                                   ConeContinuation &result)
  {
    if (is_small() && search(result, [] { return true; }))
      return true;
    result.barrier = find_barrier(background, drive);
    return !is_small() && !result.barrier && search_with_proof(result);
  }

  LcpNoise
  ConeRateProblem::noise_of_slips() const
  {
    LcpNoise result;
    result.reserves.assign(candidates.size(), 0.);
    double largest_drive = 0.;
    for (const Candidate &candidate : candidates)
      {
        const std::size_t n    = candidate.row;
        const TangentVector &e = candidate.direction;
        const double scale     = 1. / std::sqrt(shear_stiffness(candidate));
        const auto of_shear    = [&](const Vector &sizes) {
          const TangentVector shear = tangential_rows(candidate, sizes);
          return std::max(std::abs(shear[0]), std::abs(shear[1])) +
                 candidate.friction * std::abs(sizes[n]);
        };
        const double stiffness = of_shear(diagonal), load = of_shear(r);
        result.shares.push_back((candidate.resting ? noise_at_rest : 1.) * rate_tolerance * scale *
                                stiffness);
        result.growth.push_back(
          scale * std::max({std::abs(candidate.rise), std::abs(e[0]), std::abs(e[1])}));
        result.at_rest = std::max(result.at_rest, load / stiffness);
        largest_drive = std::max(largest_drive, scale * (load + std::abs(candidate.strength_rate)));
      }
    result.unknowns        = result.shares; // both are forces, in units of the stiffness
    result.largest_unknown = largest_motion * largest_drive;
    return result;
  }

  // Eq. 31 is a linear complementarity problem then: with v = P z and the forces Fᵀq that slip
  // answers, 0 ≤ z ⟂ ρ̇ - Fᵀr + FᵀW P z ≥ 0, scaled to a unit diagonal before bars were released.
  bool
  ConeRateProblem::search_with_proof(ConeContinuation &result)
  {
    if (std::any_of(candidates.begin(), candidates.end(), [](const Candidate &candidate) {
          return candidate.at_apex || candidate.grazing || candidate.n_tangents == 0;
        }))
      return false;
    DenseMatrix P(bars.size(), candidates.size()), F(bars.size(), candidates.size());
    Vector reserves;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      {
        const Candidate &candidate = candidates[k];
        const double scale         = 1. / std::sqrt(shear_stiffness(candidate));
        P(candidate.row, k)        = scale * candidate.rise;
        F(candidate.row, k)        = scale * candidate.friction;
        for (std::size_t i = 0; i < candidate.n_tangents; ++i)
          P(candidate.row + 1 + i, k) = F(candidate.row + 1 + i, k) =
            scale * candidate.direction[i];
        reserves.push_back(scale * candidate.strength_rate);
      }
    add_multiple(-1., multiply_transposed(F, r), reserves);
    const LcpSearch found =
      search_lcp(multiply_transposed(F, multiply(W, P)), reserves, noise_of_slips());
    result.is_ruled_out = found.end == SearchEnd::none;
    if (found.end != SearchEnd::found)
      return false;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      take({found.z[k] > 0. ? ContactState::slip_forward : ContactState::stick,
            candidates[k].direction},
           candidates[k]);
    return iterate(n_iterations, result) == Outcome::solved;
  }
} // namespace fuga
