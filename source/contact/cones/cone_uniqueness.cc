// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/cone_rate_problem.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** An element at the apex: the number of its normal rate, the number of its tangents, and its
     * friction. */
    struct Apex
    {
      std::size_t row;
      std::size_t n_tangents;
      double friction;
    };

    /** An unknown rate: how it moves the bars of its element, from the first @p row on, and how the
     * condition on it weights their forces. */
    struct Unknown
    {
      std::size_t row;
      std::vector<double> motion, condition;
    };

    /**
     * Return whether yᵀA y + Σ weight y_n (A y)_n - Σ f |v_t| |(W v)_n| > 0 for all rates v = D y,
     * where the sums are over the apexes, A is scaled by D on both sides, and 2 |v_t| |(W v)_n| ≤ α
     * |v_t|² + (W v)_n²/α with α = share/(D_n D_t).
     */
    bool
    is_definite(const DenseMatrix &A,
                const Vector &scale,
                const std::vector<Apex> &apexes,
                const double weight,
                const double share)
    {
      const std::size_t n = scale.size();
      DenseMatrix G(n, n); // its lower triangle, twice
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = k; i < n; ++i)
          G(i, k) = A(i, k) + A(k, i);
      DenseMatrix normal_forces(n, apexes.size()); // (W v)_n, each in its share of a square
      for (std::size_t j = 0; j < apexes.size(); ++j)
        {
          const auto [row, n_tangents, friction] = apexes[j];
          for (std::size_t k = 0; k < n; ++k)
            G(std::max(row, k), std::min(row, k)) += (row == k ? 2. : 1.) * weight * A(row, k);
          if (n_tangents == 0)
            continue;
          const double ratio = scale[row + 1] / scale[row];
          for (std::size_t i = row + 1; i <= row + n_tangents; ++i)
            G(i, i) -= friction * share * ratio * std::pow(scale[i] / scale[row + 1], 2);
          normal_forces.col(j) = std::sqrt(friction / share * ratio) * A.row(row).transpose();
        }
      if (!apexes.empty())
        G.selfadjointView<Eigen::Lower>().rankUpdate(normal_forces, -1.);
      DenseMatrix nothing(n, 0);
      return solve_positive_definite(G, nothing);
    }
  } // namespace

  // The difference v of two solutions, by which the forces lose W v, satisfies for each element
  //
  //     on the cone, v = γ e    γ (e + f n)·(W v) ≤ 0,
  //     at the apex             v_n (W v)_n ≤ 0,   v·(W v) - f |v_t| |(W v)_n| ≤ 0.
  //
  // It vanishes if some sum of these expressions with positive weights is positive definite.
  bool
  ConeRateProblem::has_one_solution() const
  {
    std::vector<Apex> apexes;
    std::vector<Unknown> unknowns;
    for (const Candidate &candidate : candidates)
      {
        if (candidate.n_tangents > 0 &&
            (candidate.at_apex ? candidate.rise > 0. : candidate.grazing))
          return false; // other conditions apply
        if (candidate.at_apex)
          {
            apexes.push_back({unknowns.size(), candidate.n_tangents, candidate.friction});
            for (std::size_t i = 0; i <= candidate.n_tangents; ++i)
              unknowns.push_back({candidate.row + i, {1.}, {1.}});
            continue;
          }
        unknowns.push_back({candidate.row, {candidate.rise}, {candidate.friction}});
        for (std::size_t i = 0; i < candidate.n_tangents; ++i)
          for (auto *coefficients : {&unknowns.back().motion, &unknowns.back().condition})
            coefficients->push_back(candidate.direction[i]);
      }
    const std::size_t n = unknowns.size();
    DenseMatrix A(n, n);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t b = 0; b < unknowns[k].motion.size(); ++b)
          for (std::size_t a = 0; a < unknowns[i].condition.size(); ++a)
            A(i, k) += unknowns[i].condition[a] * W(unknowns[i].row + a, unknowns[k].row + b) *
                       unknowns[k].motion[b];
    Vector scale;
    for (std::size_t i = 0; i < n; ++i)
      {
        if (!(A(i, i) > 0.))
          return false;
        scale.push_back(1. / std::sqrt(A(i, i)));
      }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        A(i, k) *= scale[i] * scale[k];
    if (apexes.empty())
      return is_definite(A, scale, apexes, 0., 1.);
    for (const double weight : {0., 1., 4., 16.})
      for (const double share : {0.25, 0.5, 1., 2., 4.})
        if (is_definite(A, scale, apexes, weight, share))
          return true;
    return false;
  }
} // namespace fuga
