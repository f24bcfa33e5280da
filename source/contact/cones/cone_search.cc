// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

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
      DenseMatrix K(n, n), answers(n, P.cols());
      Vector x(n);
      const DenseMatrix lost = multiply(W, P);
      for (std::size_t i = 0; i < n; ++i)
        {
          for (std::size_t j = 0; j < n; ++j)
            K(i, j) = W(rows[i], rows[j]);
          for (Eigen::Index j = 0; j < P.cols(); ++j)
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
          for (Eigen::Index j = 0; j < P.cols(); ++j)
            P(rows[i], j) = -answers(i, j);
        }
      return true;
    }
  } // namespace

  // With friction a solution may exist beside a motion that nothing resists. The combinations that
  // cannot all be tried are divided, unless a virtual motion shows at once that there is nothing to
  // be found.
  bool
  ConeRateProblem::find_another_way(WorkingScheme &background,
                                    const Drive &drive,
                                    ConeContinuation &result)
  {
    const auto one_is_enough = [] { return true; };
    if (is_small() && search(result, one_is_enough))
      return true;
    const bool is_driven = find_mechanism(background, result);
    const bool any_apex  = std::any_of(candidates.begin(),
                                      candidates.end(),
                                      [](const Candidate &candidate) { return candidate.at_apex; });
    if (is_driven && !(accept && any_apex))
      return false;
    if (!result.has_mechanism)
      result.barrier = find_barrier(background, drive);
    if (is_small() || (result.barrier && !accept))
      return false;
    if (pivot_from_many(result, one_is_enough) || search_with_proof(result) ||
        (!result.is_ruled_out && search(result, one_is_enough, most_combinations_at_last)))
      {
        result.has_mechanism = false;
        return true;
      }
    return false;
  }

  // At the apex a slip along one tangent may go either way, and the lips may part.
  std::vector<ConeUnknown>
  ConeRateProblem::unknowns_of(const std::vector<bool> &opened, const bool all_may_part) const
  {
    std::vector<ConeUnknown> result;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      {
        const Candidate &candidate = candidates[k];
        if (opened[k])
          continue;
        if (candidate.n_tangents > 0)
          {
            const double scale = 1. / std::sqrt(shear_stiffness(candidate));
            if (candidate.at_apex)
              for (const double sign : {1., -1.})
                result.push_back({k, scale, true, {{sign, 0.}}});
            else
              result.push_back({k, scale, true, candidate.direction});
          }
        if (candidate.grazing && (candidate.at_apex || all_may_part))
          result.push_back({k, 1. / std::sqrt(diagonal[candidate.row]), false, {{0., 0.}}});
      }
    return result;
  }

  // How the rates grow with the unknowns is not known here.
  LcpNoise
  ConeRateProblem::noise_of(const std::vector<ConeUnknown> &unknowns) const
  {
    LcpNoise result;
    double largest_drive = 0.;
    for (const ConeUnknown &unknown : unknowns)
      {
        const Candidate &candidate = candidates[unknown.candidate];
        const auto size_of         = [&](const Vector &sizes) {
          if (!unknown.slips)
            return std::abs(sizes[candidate.row]);
          const TangentVector shear = tangential_rows(candidate, sizes);
          return std::max(std::abs(shear[0]), std::abs(shear[1])) +
                 candidate.friction * std::abs(sizes[candidate.row]);
        };
        const double stiffness = size_of(diagonal), load = size_of(r);
        const double widening = candidate.resting && unknown.slips ? noise_at_rest : 1.;
        const double share    = widening * rate_tolerance * unknown.scale * stiffness;
        // As forces, in units of the stiffness; to the working scheme any jump counts alike.
        result.unknowns.push_back(accept ? rate_tolerance / unknown.scale : share);
        result.shares.push_back(accept ? 0. : share);
        result.reserves.push_back(
          accept ? unknown.scale * (unknown.slips ? candidate.no_shear : candidate.no_force) : 0.);
        result.at_rest = std::max(result.at_rest, load / stiffness);
        largest_drive =
          std::max(largest_drive, unknown.scale * (load + std::abs(candidate.strength_rate)));
      }
    result.largest_unknown = largest_motion * largest_drive;
    return result;
  }

  // Eq. 31 is then a linear complementarity problem: with v = P z and the forces Fᵀq to which the
  // unknowns respond, 0 ≤ z ⟂ ρ̇ - Fᵀr + FᵀW P z ≥ 0, scaled to a unit diagonal before bars were
  // released. The rows after these have no unknown: an element that may open does not pull, or does
  // not close.
  std::optional<ConeLcp>
  ConeRateProblem::problem_of(const std::vector<ConeUnknown> &unknowns,
                              const std::vector<std::size_t> &may_open,
                              const std::vector<bool> &opened) const
  {
    const std::size_t n = unknowns.size(), n_rows = n + may_open.size();
    DenseMatrix P(bars.size(), n_rows), F(bars.size(), n_rows);
    Vector reserves(n_rows, 0.), at_rest(bars.size(), 0.), released;
    std::vector<std::size_t> rows;
    LcpNoise noise = noise_of(unknowns);
    for (std::size_t j = 0; j < n; ++j)
      {
        const auto &[k, scale, slips, direction] = unknowns[j];
        const Candidate &candidate               = candidates[k];
        P(candidate.row, j)                      = scale * (slips ? candidate.rise : 1.);
        F(candidate.row, j)                      = scale * (slips ? candidate.friction : 1.);
        for (std::size_t i = 0; i < candidate.n_tangents && slips; ++i)
          P(candidate.row + 1 + i, j) = F(candidate.row + 1 + i, j) = scale * direction[i];
        reserves[j] = scale * (!slips              ? candidate.tension_rate
                               : candidate.at_apex ? 0.
                                                   : candidate.strength_rate);
      }
    for (std::size_t i = 0; i < may_open.size(); ++i)
      {
        const Candidate &candidate = candidates[may_open[i]];
        const double scale         = 1. / std::sqrt(diagonal[candidate.row]);
        const bool by_scheme       = accept && !opened[may_open[i]];
        noise.shares.push_back(by_scheme ? 0. : rate_tolerance / scale);
        noise.reserves.push_back(by_scheme ? scale * candidate.no_force : 0.);
        noise.unknowns.push_back(0.);
        if (!opened[may_open[i]])
          {
            F(candidate.row, n + i) = scale;
            reserves[n + i]         = scale * candidate.tension_rate;
            continue;
          }
        for (std::size_t a = 0; a <= candidate.n_tangents; ++a)
          {
            rows.push_back(candidate.row + a);
            released.push_back(a == 0 ? candidate.tension_rate : candidate.shear_release[a - 1]);
          }
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
    noise.at_rest += max_abs(at_rest);
    for (std::size_t j = 0; j < n_rows; ++j)
      noise.growth.push_back(max_abs(P.col(j)));
    return ConeLcp{std::move(M), std::move(reserves), std::move(noise)};
  }

  // Where several unknowns of a candidate do not vanish it opens.
  void
  ConeRateProblem::take_answers(const std::vector<ConeUnknown> &unknowns,
                                const Vector &z,
                                const double share_of_nothing,
                                const std::vector<bool> &opened)
  {
    for (std::size_t k = 0; k < candidates.size(); ++k)
      take({opened[k] ? ContactState::open : ContactState::stick, candidates[k].direction},
           candidates[k]);
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      if (z[j] > share_of_nothing * max_abs(z))
        take(unknowns[j].slips ? Choice{ContactState::slip_forward, unknowns[j].direction}
                               : Choice{ContactState::open, {{1., 0.}}},
             candidates[unknowns[j].candidate]);
  }

  // Elements that slip and may open as well respond in a way of their own in each of the two.
  bool
  ConeRateProblem::search_with_proof(ConeContinuation &result)
  {
    std::vector<std::size_t> may_open;
    bool is_ruled_out = true;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      {
        const Candidate &candidate = candidates[k];
        if (candidate.at_apex && candidate.n_tangents == 2)
          return false;
        // An element that breaks its bond as it opens also loses the shear that it held.
        is_ruled_out &=
          candidate.n_tangents > 0 || !elements[candidate.element].has_tangential_bar();
        if (!candidate.at_apex && candidate.grazing)
          may_open.push_back(k);
      }
    if (may_open.size() > most_openings)
      return false;
    for (std::size_t chosen = 0; chosen < (std::size_t(1) << may_open.size()); ++chosen)
      {
        std::vector<bool> opened(candidates.size(), false);
        for (std::size_t i = 0; i < may_open.size(); ++i)
          opened[may_open[i]] = (chosen >> i) % 2 == 1;
        const std::vector<ConeUnknown> unknowns = unknowns_of(opened, false);
        const std::optional<ConeLcp> problem    = problem_of(unknowns, may_open, opened);
        if (!problem)
          {
            is_ruled_out = false;
            continue;
          }
        const LcpSearch found = search_lcp(problem->M, problem->q, problem->noise);
        is_ruled_out &= found.end == SearchEnd::none;
        if (found.end != SearchEnd::found)
          continue;
        take_answers(unknowns, found.z, 0., opened);
        if (settles(result))
          return true;
      }
    result.is_ruled_out = is_ruled_out;
    return false;
  }
} // namespace fuga
