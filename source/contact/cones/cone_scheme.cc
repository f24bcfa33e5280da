// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_rate_problem.h>
#include <fuga/contact/element/mechanism.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fuga
{
  namespace
  {
    /** One unknown of a scheme: its column v = x c and the functional of its equation, both with up
     * to three rows beginning with `row`, and the term that the unknown adds to its own
     * equation. */
    struct SchemeUnknown
    {
      std::size_t candidate;
      std::size_t row;
      std::array<double, 3> column;
      std::array<double, 3> functional;
      double own;
      double right_hand_side = 0.;
    };

    /** Remove from x, where M x = @p rhs, what @p nearby leaves of the right-hand side, if it can
     * be removed: if nothing drives what moves freely. */
    void
    let_rest(const DenseMatrix &M, const Vector &rhs, const LuFactors &nearby, Vector &x)
    {
      constexpr int max_sweeps = 20;
      constexpr double at_rest = 1e-12;
      Vector refined           = x;
      double left = max_abs(rhs), last = 3. * left; // the first sweep is made
      for (int sweep = 0; sweep < max_sweeps && left < 0.5 * last; ++sweep)
        {
          last        = left;
          Vector rest = rhs;
          add_multiple(-1., multiply(M, refined), rest);
          left = max_abs(rest);
          nearby.solve(rest);
          add_multiple(1., rest, refined);
        }
      if (left <= at_rest * max_abs(rhs))
        x = std::move(refined);
    }

    /**
     * Solve M x = rhs in place, where rows and columns of M are scaled to a unit diagonal of W
     * before bars were released, so that a matrix which is small as a whole also counts as
     * singular, as does one whose answer is above @p largest. If it is singular, @p note_motion
     * gets its null vector, and weak springs to the ground hold what moves freely: it then moves
     * far, in the direction in which the load drives it, so that the next scheme closes the
     * elements that it runs into; what nothing drives rests. Return the sign of the determinant.
     */
    int
    solve_or_regularise(const DenseMatrix &M,
                        Vector &x,
                        const double largest,
                        const std::function<void(const Vector &)> &note_motion)
    {
      constexpr double smallest_condition = 1e-13, ground = 1e-6;
      const std::size_t n = M.rows();
      double norm         = 0.;
      for (std::size_t j = 0; j < n; ++j)
        {
          double sum = 0.;
          for (std::size_t i = 0; i < n; ++i)
            sum += std::abs(M(i, j));
          norm = std::max(norm, sum);
        }
      const auto with_springs = [&M, n](const double stiffness) {
        DenseMatrix sum = M;
        for (std::size_t j = 0; j < n; ++j)
          sum(j, j) += stiffness;
        return sum;
      };
      const LuFactors factors(with_springs(0.), LuFactors::Scaling::as_given);
      const Vector rhs = x;
      bool regular =
        n == 0 || !(factors.reciprocal_condition() * std::min(1., norm) < smallest_condition);
      if (regular)
        {
          factors.solve(x);
          regular = max_abs(x) <= largest;
        }
      if (!regular)
        {
          note_motion(null_vector(with_springs(smallest_condition)));
          x = rhs;
          const LuFactors held(with_springs(ground));
          held.solve(x);
          let_rest(M, rhs, held, x);
        }
      return regular ? factors.determinant_sign() : 0;
    }
  } // namespace

  // Newton's step at the apex: with the direction turned by η/s, v_t = ξ e + (ξ/s) η e⊥, and
  // q_t + f q_n e + f q_n (η/s) e⊥ = 0.
  bool
  ConeRateProblem::solve_scheme()
  {
    std::vector<SchemeUnknown> unknowns;
    std::vector<double> turn_scales(candidates.size(), 0.);
    for (std::size_t c = 0; c < candidates.size(); ++c)
      {
        const Candidate &candidate = candidates[c];
        const std::size_t row      = candidate.row;
        const double f             = candidate.friction;
        const TangentVector e = candidate.direction, side = normal_to(e);
        if (candidate.state == ContactState::open)
          for (std::size_t i = 0; i <= candidate.n_tangents; ++i)
            {
              std::array<double, 3> unit = {{0., 0., 0.}};
              unit[i]                    = 1. / std::sqrt(diagonal[row + i]);
              const double release =
                i == 0 ? candidate.tension_rate : candidate.shear_release[i - 1];
              unknowns.push_back({c, row, unit, unit, 0., unit[i] * release});
            }
        else if (is_slipping(candidate.state))
          {
            const double stiffness = shear_stiffness(candidate);
            const double scale     = 1. / std::sqrt(stiffness);
            unknowns.push_back({c,
                                row,
                                {{scale * candidate.rise, scale * e[0], scale * e[1]}},
                                {{scale * f, scale * e[0], scale * e[1]}},
                                0.,
                                candidate.at_apex ? 0. : scale * candidate.strength_rate});
            if (!candidate.at_apex || candidate.n_tangents < 2)
              continue;
            const double slip  = std::max(candidate.slip, 0.);
            const double s     = slip + candidate.strength / stiffness;
            turn_scales[c]     = s;
            const double ratio = s > 0. ? slip / s : 1.;
            const double own   = s > 0. ? candidate.strength / (s * stiffness) : 0.;
            unknowns.push_back({c,
                                row,
                                {{0., scale * ratio * side[0], scale * ratio * side[1]}},
                                {{0., scale * side[0], scale * side[1]}},
                                own});
          }
      }

    const std::size_t n = unknowns.size();
    DenseMatrix M(n, n);
    Vector x(n, 0.);
    const auto n_rows = [&](const SchemeUnknown &unknown) {
      return candidates[unknown.candidate].n_tangents + 1;
    };
    for (std::size_t j = 0; j < n; ++j)
      {
        Vector image(bars.size(), 0.);
        for (std::size_t i = 0; i < n_rows(unknowns[j]); ++i)
          if (unknowns[j].column[i] != 0.)
            view(image) += unknowns[j].column[i] * W.col(unknowns[j].row + i);
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t a = 0; a < n_rows(unknowns[i]); ++a)
            M(i, j) += unknowns[i].functional[a] * image[unknowns[i].row + a];
        M(j, j) += unknowns[j].own;
        for (std::size_t a = 0; a < n_rows(unknowns[j]); ++a)
          x[j] += unknowns[j].functional[a] * r[unknowns[j].row + a];
        x[j] -= unknowns[j].right_hand_side;
      }
    const auto take = [&](const Vector &solution, Vector &rates) {
      rates.assign(bars.size(), 0.);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t a = 0; a < n_rows(unknowns[j]); ++a)
          rates[unknowns[j].row + a] += solution[j] * unknowns[j].column[a];
    };

    double drive = 0.;
    for (std::size_t row = 0; row < r.size(); ++row)
      drive = std::max(drive, std::abs(r[row]) / std::sqrt(diagonal[row]));
    determinant_sign = solve_or_regularise(
      M, x, largest_motion * std::max(drive, max_abs(x)), [&](const Vector &solution) {
        take(solution, free_motion);
      });
    take(x, v);

    // Largest turn for which Newton's step can be trusted.
    constexpr double largest_turn = 0.7;
    for (std::size_t j = 0; j < n; ++j)
      {
        Candidate &candidate = candidates[unknowns[j].candidate];
        if (!is_slipping(candidate.state))
          continue;
        const TangentVector e = candidate.direction;
        const double scale    = length({{unknowns[j].column[1], unknowns[j].column[2]}});
        candidate.slip        = x[j] * scale;
        if (!candidate.at_apex || candidate.n_tangents < 2)
          continue;
        ++j;
        const double s         = turn_scales[unknowns[j].candidate];
        const double stiffness = shear_stiffness(candidate);
        const double eta       = x[j] / std::sqrt(stiffness);
        const double turn      = std::clamp(
          s > 0. ? eta / s : std::atan2(eta, candidate.slip), -largest_turn, largest_turn);
        const TangentVector side = normal_to(e);
        for (int i = 0; i < 2; ++i)
          candidate.direction[i] = std::cos(turn) * e[i] + std::sin(turn) * side[i];
        for (int i = 0; i < 2; ++i)
          v[candidate.row + 1 + i] = candidate.slip * candidate.direction[i];
      }
    refresh_forces();
    for (Candidate &candidate : candidates)
      if (candidate.at_apex && is_slipping(candidate.state))
        candidate.strength = candidate.friction * std::max(-q[candidate.row], 0.);
    return determinant_sign != 0;
  }

  DemandedAnswer
  ConeRateProblem::demand(const Candidate &candidate) const
  {
    const std::size_t n = candidate.row;
    LocalRates rates;
    rates.force            = q[n];
    rates.opening          = v[n];
    rates.no_force         = noise(n);
    rates.normal_stiffness = diagonal[n];
    rates.no_opening       = rates.no_force / diagonal[n];
    if (candidate.n_tangents > 0)
      {
        rates.shear           = tangential_rows(candidate, q);
        rates.velocity        = tangential_rows(candidate, v);
        rates.slip            = candidate.slip;
        rates.no_shear        = shear_noise(candidate);
        rates.shear_stiffness = shear_stiffness(candidate);
        rates.no_slip         = rates.no_shear / rates.shear_stiffness;
      }
    return candidate.RateLaw::demand(candidate, rates);
  }

  bool
  ConeRateProblem::update_scheme(const bool one_by_one)
  {
    RateAnswer worst;
    double largest          = 0.;
    Candidate *worst_of_all = nullptr;
    bool changed            = false;
    for (Candidate &candidate : candidates)
      {
        const DemandedAnswer wanted = demand(candidate);
        if (wanted.state == candidate.state)
          continue;
        changed = true;
        if (!one_by_one)
          static_cast<RateAnswer &>(candidate) = wanted;
        else if (worst_of_all == nullptr || wanted.violation > largest)
          {
            worst        = wanted;
            largest      = wanted.violation;
            worst_of_all = &candidate;
          }
      }
    if (worst_of_all != nullptr)
      static_cast<RateAnswer &>(*worst_of_all) = worst;
    return changed;
  }

  // Directions at the apex must have come to rest as well.
  bool
  ConeRateProblem::is_settled() const
  {
    for (const Candidate &candidate : candidates)
      if (candidate.at_apex && is_slipping(candidate.state))
        {
          const std::size_t n = candidate.row;
          for (std::size_t i = 0; i < candidate.n_tangents; ++i)
            if (std::abs(q[n + 1 + i] + candidate.friction * q[n] * candidate.direction[i]) >
                noise(n + 1 + i) + candidate.friction * noise(n))
              return false;
        }
    return true;
  }
} // namespace fuga
