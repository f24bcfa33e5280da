// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/rate_reduction.h"

#include "judges/linear_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga::stress
{
  using namespace judges;

  ReducedProblem
  reduce(const JudgeProblem &problem,
         const std::vector<RateElement> &elements,
         const Vector &load_rate,
         const double stiffness_error)
  {
    ReducedProblem reduced;
    const DislocationForm form = dislocation_form(problem, {load_rate});
    if (!form.regular)
      return reduced;
    std::vector<std::size_t> free_bars, bars;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const JudgeElement &element = problem.elements[k];
        const RateStatus status     = elements[k].status;
        if (status == RateStatus::open)
          free_bars.push_back(element.normal_bar);
        if (element.has_tangential_bar() &&
            (status == RateStatus::open || status == RateStatus::frictionless))
          free_bars.push_back(element.tangential_bar);
        if (status != RateStatus::slip_limit && status != RateStatus::grazing)
          continue;
        Candidate candidate{status, elements[k].sign, element.friction};
        candidate.n = bars.size();
        bars.push_back(element.normal_bar);
        candidate.has_shear      = element.has_tangential_bar();
        candidate.cohesive       = element.cohesion > 0.;
        candidate.t              = bars.size();
        candidate.normal_bar     = element.normal_bar;
        candidate.tangential_bar = element.tangential_bar;
        if (candidate.has_shear)
          bars.push_back(element.tangential_bar);
        reduced.candidates.push_back(candidate);
      }

    const std::size_t n = bars.size(), m = free_bars.size();
    DenseMatrix W(m, m), right(m, n + 1);
    for (std::size_t i = 0; i < m; ++i)
      {
        for (std::size_t j = 0; j < m; ++j)
          W(i, j) = form.W(free_bars[i], free_bars[j]);
        for (std::size_t j = 0; j < n; ++j)
          right(i, j) = form.W(free_bars[i], bars[j]);
        right(i, n) = form.R[0][free_bars[i]];
      }
    DenseMatrix answer(m, n + 1);
    if (m > 0)
      {
        LinearSolution solution = solve_linear(std::move(W), std::move(right));
        if (!solution.regular)
          return reduced;
        answer = std::move(solution.X);
      }
    const Vector stiffness = stiffness_scales(form.W);
    Vector scale(n);
    for (std::size_t i = 0; i < n; ++i)
      scale[i] = 1. / std::sqrt(stiffness[bars[i]]);
    reduced.M                = DenseMatrix(n, n);
    reduced.q                = Vector(n);
    reduced.normal_per_shear = Vector(n, 1.);
    for (std::size_t i = 0; i < n; ++i)
      {
        reduced.q[i] = form.R[0][bars[i]];
        for (std::size_t a = 0; a < m; ++a)
          reduced.q[i] -= form.W(bars[i], free_bars[a]) * answer(a, n);
        reduced.q[i] *= scale[i];
        for (std::size_t j = 0; j < n; ++j)
          {
            double entry = form.W(bars[i], bars[j]);
            for (std::size_t a = 0; a < m; ++a)
              entry -= form.W(bars[i], free_bars[a]) * answer(a, j);
            reduced.M(i, j) = entry * scale[i] * scale[j];
          }
      }
    for (const Candidate &candidate : reduced.candidates)
      if (candidate.has_shear)
        reduced.normal_per_shear[candidate.t] = scale[candidate.t] / scale[candidate.n];
    for (std::size_t a = 0; a < m; ++a)
      {
        const double root = std::sqrt(stiffness[free_bars[a]]);
        for (std::size_t j = 0; j <= n; ++j)
          answer(a, j) *= root * (j < n ? scale[j] : 1.);
        reduced.size = std::max(reduced.size, std::abs(form.R[0][free_bars[a]]) / root);
      }
    reduced.follow    = std::move(answer);
    reduced.form      = form;
    reduced.free_bars = std::move(free_bars);
    reduced.regular   = true;
    // W is a difference of numbers S D times as large; a hundredth of what that leaves is trusted.
    double stiffest = 0., softest = 0.;
    for (Eigen::Index i = 0; i < problem.S.rows(); ++i)
      stiffest = std::max(stiffest, problem.S(i, i));
    for (const JudgeElement &element : problem.elements)
      softest = std::max({softest,
                          element.normal_compliance / element.area,
                          element.shear_compliance / element.area});
    const double noise =
      std::max(std::numeric_limits<double>::epsilon() * stiffest, stiffness_error) * softest;
    if (noise > 0.)
      reduced.unbounded_rate = std::min(reduced.unbounded_rate, 1e-2 / noise);
    return reduced;
  }

  double
  friction(const ReducedProblem &problem, const Candidate &candidate)
  {
    return candidate.has_shear ? candidate.friction * problem.normal_per_shear[candidate.t] : 0.;
  }

  namespace
  {
    /** Gauss' elimination with complete choice of the row in extended precision, for a matrix of
     * unit scale; false where a pivot is but rounding of double precision. */
    bool
    eliminate(std::vector<std::vector<long double>> &A, std::vector<long double> &b)
    {
      const std::size_t n        = b.size();
      const long double no_pivot = 1e-13L;
      for (std::size_t k = 0; k < n; ++k)
        {
          std::size_t best = k;
          for (std::size_t i = k + 1; i < n; ++i)
            if (std::abs(A[i][k]) > std::abs(A[best][k]))
              best = i;
          if (std::abs(A[best][k]) <= no_pivot)
            return false;
          std::swap(A[k], A[best]);
          std::swap(b[k], b[best]);
          for (std::size_t i = k + 1; i < n; ++i)
            if (const long double factor = A[i][k] / A[k][k]; factor != 0.L)
              {
                for (std::size_t j = k; j < n; ++j)
                  A[i][j] -= factor * A[k][j];
                b[i] -= factor * b[k];
              }
        }
      for (std::size_t k = n; k-- > 0;)
        {
          for (std::size_t j = k + 1; j < n; ++j)
            b[k] -= A[k][j] * b[j];
          b[k] /= A[k][k];
        }
      return true;
    }
  } // namespace

  double
  exact_rate(const ReducedProblem &problem, const std::vector<ContactState> &states)
  {
    struct Row
    {
      std::size_t bar, other;
      double weight;
    };
    std::vector<Row> rows;
    for (const std::size_t bar : problem.free_bars)
      rows.push_back({bar, bar, 0.});
    for (std::size_t c = 0; c < states.size(); ++c)
      {
        const Candidate &candidate = problem.candidates[c];
        if (states[c] == ContactState::open)
          rows.push_back({candidate.normal_bar, candidate.normal_bar, 0.});
        if (candidate.has_shear && states[c] != ContactState::stick)
          rows.push_back({candidate.tangential_bar,
                          candidate.normal_bar,
                          slip_sign(states[c]) * candidate.friction});
      }
    const DenseMatrix &W   = problem.form.W;
    const Vector stiffness = stiffness_scales(W);
    const Vector &R        = problem.form.R[0];
    const std::size_t n    = rows.size();
    std::vector<std::vector<long double>> A(n, std::vector<long double>(n));
    std::vector<long double> b(n);
    for (std::size_t i = 0; i < n; ++i)
      {
        const Row &row          = rows[i];
        const long double scale = 1.L / std::sqrt(static_cast<long double>(stiffness[row.bar]));
        b[i] = scale * (R[row.bar] + static_cast<long double>(row.weight) * R[row.other]);
        for (std::size_t j = 0; j < n; ++j)
          {
            const std::size_t bar = rows[j].bar;
            A[i][j]               = scale *
                      (W(row.bar, bar) + static_cast<long double>(row.weight) * W(row.other, bar)) /
                      std::sqrt(static_cast<long double>(stiffness[bar]));
          }
      }
    if (!eliminate(A, b))
      return std::numeric_limits<double>::infinity();
    long double rate = 0.L, size = 0.L;
    for (const long double x : b)
      rate = std::max(rate, std::abs(x));
    for (std::size_t i = 0; i < R.size(); ++i)
      size = std::max(size, std::abs(R[i]) / std::sqrt(static_cast<long double>(stiffness[i])));
    return static_cast<double>(size > 0.L ? rate / size : rate);
  }
} // namespace fuga::stress
