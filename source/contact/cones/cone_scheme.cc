// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/blas.h>
#include <fuga/contact/cones/cone_rate_problem.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fuga
{
  namespace
  {
    /** One unknown of a scheme: its column v = x c, the functional of its equation, both of up to
     * three rows from `row` on, and what the unknown adds to the equation by itself. */
    struct SchemeUnknown
    {
      std::size_t candidate;
      std::size_t row;
      std::array<double, 3> column;
      std::array<double, 3> functional;
      double own;
      double right_hand_side = 0.;
    };

    /**
     * Solves M x = rhs in place, rows and columns of M scaled to a unit diagonal of W before bars
     * were released, so that a matrix which is small as a whole counts as singular too. If it is
     * singular,
     * @p note_motion gets its null vector, and weak springs to the ground hold what moves freely:
     * it then moves far, in the direction in which the load drives it, so that the next scheme
     * closes the elements that it runs into. Returns the sign of the determinant.
     */
    int
    solve_or_regularise(const DenseMatrix &M,
                        Vector &x,
                        const std::function<void(const Vector &)> &note_motion)
    {
      constexpr double smallest_condition = 1e-13, ground = 1e-6;
      const std::size_t n = M.n_rows();
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
      const bool regular =
        n == 0 || !(factors.reciprocal_condition() * std::min(1., norm) < smallest_condition);
      if (regular)
        factors.solve(x);
      else
        {
          note_motion(null_vector(with_springs(smallest_condition)));
          LuFactors(with_springs(ground)).solve(x);
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
            blas::axpy(
              image.size(), unknowns[j].column[i], W.column(unknowns[j].row + i), image.data());
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

    determinant_sign =
      solve_or_regularise(M, x, [&](const Vector &solution) { take(solution, free_motion); });
    take(x, v);

    // The turn, limited to what Newton's step can be trusted with.
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
} // namespace fuga
