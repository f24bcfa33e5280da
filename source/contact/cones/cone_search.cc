// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/lcp_search.h>
#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/element/mechanism.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Largest number of elements that may open for which all combinations of open and closed are
     * tried. */
    constexpr std::size_t most_openings = 4;
    /** Reciprocal condition number below which the elements that open are without support. */
    constexpr double no_support = 1e-13;

    /** Add to the motions, i.e. the columns of P, and to @p v, which is zero initially, the motion
     * of those @p rows whose forces are given. */
    bool
    release(const DenseMatrix &W,
            const Vector &r,
            const std::vector<std::size_t> &rows,
            const Vector &forces,
            DenseMatrix &P,
            Vector &v)
    {
      const std::size_t n = rows.size();
      DenseMatrix K(n, n), answers(n, P.n_columns());
      Vector x(n);
      const DenseMatrix lost = multiply(W, P);
      for (std::size_t i = 0; i < n; ++i)
        {
          for (std::size_t j = 0; j < n; ++j)
            K(i, j) = W(rows[i], rows[j]);
          for (std::size_t j = 0; j < P.n_columns(); ++j)
            answers(i, j) = lost(rows[i], j);
          x[i] = r[rows[i]] - forces[i];
        }
      const LuFactors factors(std::move(K));
      if (n > 0 && !(factors.reciprocal_condition() > no_support))
        return false;
      factors.solve(x);
      factors.solve(answers);
      for (std::size_t i = 0; i < n; ++i)
        {
          v[rows[i]] = x[i];
          for (std::size_t j = 0; j < P.n_columns(); ++j)
            P(rows[i], j) = -answers(i, j);
        }
      return true;
    }
  } // namespace

  // A search is made where the combinations cannot all be tried, unless a virtual motion shows at
  // once that there is nothing to be found.
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

  // The noise is that of the rows of the slips; how the rates grow with the slips is not known
  // here.
  LcpNoise
  ConeRateProblem::noise_of_slips() const
  {
    LcpNoise result;
    double largest_drive = 0.;
    for (const Candidate &candidate : candidates)
      {
        const double scale  = 1. / std::sqrt(shear_stiffness(candidate));
        const auto of_shear = [&](const Vector &sizes) {
          const TangentVector shear = tangential_rows(candidate, sizes);
          return std::max(std::abs(shear[0]), std::abs(shear[1])) +
                 candidate.friction * std::abs(sizes[candidate.row]);
        };
        const double stiffness = of_shear(diagonal), load = of_shear(r);
        result.shares.push_back((candidate.resting ? noise_at_rest : 1.) * rate_tolerance * scale *
                                stiffness);
        result.at_rest = std::max(result.at_rest, load / stiffness);
        largest_drive = std::max(largest_drive, scale * (load + std::abs(candidate.strength_rate)));
      }
    result.unknowns        = result.shares; // both are forces, in units of the stiffness
    result.largest_unknown = largest_motion * largest_drive;
    return result;
  }

  // Eq. 31 is then a linear complementarity problem: with v = P z and the forces Fᵀq to which slip
  // responds, 0 ≤ z ⟂ ρ̇ - Fᵀr + FᵀW P z ≥ 0, scaled to a unit diagonal before bars were released.
  // The rows after these have no unknown: an element that may open does not pull, or does not
  // close.
  std::optional<LcpSearch>
  ConeRateProblem::search_slips(const std::vector<std::size_t> &may_open,
                                const std::vector<bool> &opened) const
  {
    const std::size_t n = candidates.size(), n_rows = n + may_open.size();
    DenseMatrix P(bars.size(), n_rows), F(bars.size(), n_rows);
    Vector reserves(n_rows, 0.), at_rest(bars.size(), 0.), released;
    std::vector<std::size_t> rows;
    LcpNoise noise = noise_of_slips();
    for (std::size_t k = 0; k < n; ++k)
      {
        const Candidate &candidate = candidates[k];
        const double scale         = 1. / std::sqrt(shear_stiffness(candidate));
        for (std::size_t i = 0; i <= candidate.n_tangents && opened[k]; ++i)
          {
            rows.push_back(candidate.row + i);
            released.push_back(i == 0 ? candidate.tension_rate : candidate.shear_release[i - 1]);
          }
        if (opened[k])
          continue;
        P(candidate.row, k) = scale * candidate.rise;
        F(candidate.row, k) = scale * candidate.friction;
        for (std::size_t i = 0; i < candidate.n_tangents; ++i)
          P(candidate.row + 1 + i, k) = F(candidate.row + 1 + i, k) =
            scale * candidate.direction[i];
        reserves[k] = scale * candidate.strength_rate;
      }
    for (std::size_t i = 0; i < may_open.size(); ++i)
      {
        const Candidate &candidate = candidates[may_open[i]];
        const double scale         = 1. / std::sqrt(diagonal[candidate.row]);
        noise.shares.push_back(rate_tolerance / scale);
        noise.unknowns.push_back(0.);
        if (opened[may_open[i]])
          continue;
        F(candidate.row, n + i) = scale;
        reserves[n + i]         = scale * candidate.tension_rate;
      }
    if (!release(W, r, rows, released, P, at_rest))
      return {};
    Vector forces = r;
    add_multiple(-1., multiply(W, at_rest), forces);
    add_multiple(-1., multiply_transposed(F, forces), reserves);
    DenseMatrix M = multiply_transposed(F, multiply(W, P));
    for (std::size_t i = 0; i < may_open.size(); ++i)
      if (opened[may_open[i]])
        {
          const std::size_t row = candidates[may_open[i]].row;
          reserves[n + i]       = std::sqrt(diagonal[row]) * at_rest[row];
          for (std::size_t j = 0; j < n_rows; ++j)
            M(n + i, j) = std::sqrt(diagonal[row]) * P(row, j);
        }
    noise.reserves.assign(n_rows, 0.);
    noise.at_rest += max_abs(at_rest);
    for (std::size_t j = 0; j < n_rows; ++j)
      noise.growth.push_back(max_abs(Vector(P.column(j), P.column(j) + bars.size())));
    return search_lcp(M, reserves, noise);
  }

  bool
  ConeRateProblem::search_with_proof(ConeContinuation &result)
  {
    std::vector<std::size_t> may_open;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      {
        if (candidates[k].at_apex || candidates[k].n_tangents == 0)
          return false;
        if (candidates[k].grazing)
          may_open.push_back(k);
      }
    if (may_open.size() > most_openings)
      return false;
    bool is_ruled_out = true;
    for (std::size_t chosen = 0; chosen < (std::size_t(1) << may_open.size()); ++chosen)
      {
        std::vector<bool> opened(candidates.size(), false);
        for (std::size_t i = 0; i < may_open.size(); ++i)
          opened[may_open[i]] = (chosen >> i) % 2 == 1;
        const std::optional<LcpSearch> found = search_slips(may_open, opened);
        is_ruled_out &= found && found->end == SearchEnd::none;
        if (!found || found->end != SearchEnd::found)
          continue;
        for (std::size_t k = 0; k < candidates.size(); ++k)
          take({opened[k]          ? ContactState::open
                : found->z[k] > 0. ? ContactState::slip_forward
                                   : ContactState::stick,
                candidates[k].direction},
               candidates[k]);
        if (iterate(n_iterations, result) == Outcome::solved)
          return true;
      }
    result.is_ruled_out = is_ruled_out;
    return false;
  }
} // namespace fuga
