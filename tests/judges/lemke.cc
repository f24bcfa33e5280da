// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/lemke.h"

#include "judges/linear_solve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fuga::judges
{
  namespace
  {
    /**
     * The tableau of  I w - M z - d z0 = q. Variables are numbered w: 0..n-1, z: n..2n-1, z0: 2n.
     * The columns of w are the basis inverse. Stored by rows: a pivot works on rows.
     */
    class Tableau
    {
    public:
      Tableau(const DenseMatrix &M, const Vector &q, const Vector &d)
        : n(q.size()), width(2 * n + 2), values(n * width, 0.), basis(n)
      {
        for (std::size_t i = 0; i < n; ++i)
          {
            basis[i] = i;
            at(i, i) = 1.;
            for (std::size_t j = 0; j < n; ++j)
              at(i, n + j) = -M(i, j);
            at(i, 2 * n)     = -d[i];
            at(i, 2 * n + 1) = q[i];
          }
      }

      double &
      at(const std::size_t row, const std::size_t column)
      {
        return values[row * width + column];
      }

      /** Row r before row s in the lexicographic order of (q, basis inverse) / (their pivots)? */
      bool
      precedes(const std::size_t r, const std::size_t s, const double pivot_r, const double pivot_s)
      {
        for (std::size_t k = 0; k <= n; ++k)
          {
            const std::size_t column = k == 0 ? 2 * n + 1 : k - 1;
            const double a           = at(r, column) / pivot_r;
            const double b           = at(s, column) / pivot_s;
            const double noise =
              1e-12 * std::max({std::abs(a), std::abs(b), 1. / pivot_r, 1. / pivot_s});
            if (std::abs(a - b) > noise)
              return a < b;
          }
        return false;
      }

      /** The row that blocks the growth of @p column first; n if none does. */
      std::size_t
      blocking_row(const std::size_t column)
      {
        double largest = 0.;
        for (std::size_t i = 0; i < n; ++i)
          largest = std::max(largest, std::abs(at(i, column)));
        std::size_t best = n;
        for (std::size_t i = 0; i < n; ++i)
          if (at(i, column) > 1e-11 * std::max(largest, 1e-3))
            if (best == n || precedes(i, best, at(i, column), at(best, column)))
              best = i;
        // Let z0 leave whenever it may: a tie with it is a solution.
        if (best != n)
          for (std::size_t i = 0; i < n; ++i)
            if (basis[i] == 2 * n && i != best && at(i, column) > 1e-11 * std::max(largest, 1e-3))
              {
                const double mine  = at(i, 2 * n + 1) / at(i, column);
                const double other = at(best, 2 * n + 1) / at(best, column);
                if (mine - other <= 1e-13 * std::max(std::abs(mine), std::abs(other)))
                  best = i;
              }
        return best;
      }

      /** Returns the variable that left. */
      std::size_t
      pivot(const std::size_t row, const std::size_t column)
      {
        const double factor = 1. / at(row, column);
        for (std::size_t j = 0; j < width; ++j)
          at(row, j) *= factor;
        at(row, column) = 1.;
        for (std::size_t i = 0; i < n; ++i)
          if (i != row && at(i, column) != 0.)
            {
              const double multiple = at(i, column);
              for (std::size_t j = 0; j < width; ++j)
                at(i, j) -= multiple * at(row, j);
              at(i, column) = 0.;
            }
        const std::size_t left = basis[row];
        basis[row]             = column;
        return left;
      }

      /** Values of all variables at the present basis. */
      Vector
      basic_values()
      {
        Vector result(2 * n + 1, 0.);
        for (std::size_t i = 0; i < n; ++i)
          result[basis[i]] = at(i, 2 * n + 1);
        return result;
      }

      const std::size_t n;
      const std::size_t width;
      Vector values;
      std::vector<std::size_t> basis;
    };

    /** Solves the basis again from the data; keeps the tableau's values if that fails. */
    Vector
    recomputed_values(Tableau &tableau, const DenseMatrix &M, const Vector &q, const Vector &d)
    {
      const std::size_t n = q.size();
      DenseMatrix matrix(n, n);
      for (std::size_t j = 0; j < n; ++j)
        {
          const std::size_t variable = tableau.basis[j];
          for (std::size_t i = 0; i < n; ++i)
            matrix(i, j) = variable < n        ? (i == variable ? 1. : 0.)
                           : variable == 2 * n ? -d[i]
                                               : -M(i, variable - n);
        }
      const LinearSolution linear = solve_linear(std::move(matrix), q);
      if (!linear.regular)
        return tableau.basic_values();
      Vector result(2 * n + 1, 0.);
      for (std::size_t i = 0; i < n; ++i)
        result[tableau.basis[i]] = linear.X(i, 0);
      return result;
    }
  } // namespace


  LemkeResult
  lemke(const DenseMatrix &M, const Vector &q, const Vector &d)
  {
    const std::size_t n = q.size();
    if (M.rows() != view(q).size() || M.cols() != M.rows() || (!d.empty() && d.size() != n))
      throw std::invalid_argument("lemke: sizes do not fit");
    const Vector cover = d.empty() ? Vector(n, 1.) : d;

    LemkeResult result;
    const auto read = [&](const Vector &values) {
      result.w.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n));
      result.z.assign(values.begin() + static_cast<std::ptrdiff_t>(n), values.end() - 1);
      result.z0 = values.back();
    };

    Tableau tableau(M, q, cover);
    read(tableau.basic_values());
    if (std::all_of(q.begin(), q.end(), [](const double entry) { return entry >= 0.; }))
      {
        result.status = LemkeStatus::solution;
        return result;
      }

    // z0 enters; the lexicographically most negative row of (q, I)/d leaves.
    std::size_t row = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (tableau.precedes(i, row, cover[i], cover[row]))
        row = i;
    std::size_t left              = tableau.pivot(row, 2 * n);
    const std::size_t pivot_limit = 100 * n + 1000;
    for (result.n_pivots = 1; result.n_pivots < pivot_limit; ++result.n_pivots)
      {
        const std::size_t entering = left < n ? left + n : left - n;
        row                        = tableau.blocking_row(entering);
        if (row == n)
          {
            result.status = LemkeStatus::ray;
            read(recomputed_values(tableau, M, q, cover));
            Vector direction(2 * n + 1, 0.);
            direction[entering] = 1.;
            for (std::size_t i = 0; i < n; ++i)
              direction[tableau.basis[i]] = std::max(0., -tableau.at(i, entering));
            result.ray_w.assign(direction.begin(),
                                direction.begin() + static_cast<std::ptrdiff_t>(n));
            result.ray_z.assign(direction.begin() + static_cast<std::ptrdiff_t>(n),
                                direction.end() - 1);
            result.ray_z0 = direction.back();
            return result;
          }
        left = tableau.pivot(row, entering);
        if (left == 2 * n)
          {
            result.status = LemkeStatus::solution;
            read(recomputed_values(tableau, M, q, cover));
            return result;
          }
      }
    return result;
  }

  double
  lcp_residual(const DenseMatrix &M, const Vector &q, const Vector &w, const Vector &z)
  {
    double worst = 0.;
    for (std::size_t i = 0; i < q.size(); ++i)
      {
        double sum = q[i] - w[i];
        for (std::size_t j = 0; j < q.size(); ++j)
          sum += M(i, j) * z[j];
        worst =
          std::max({worst, std::abs(sum), -w[i], -z[i], std::min(std::abs(w[i]), std::abs(z[i]))});
      }
    return worst;
  }
} // namespace fuga::judges
