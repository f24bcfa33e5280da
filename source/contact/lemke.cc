// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/blas.h>
#include <fuga/contact/lemke.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr double pivot_tolerance = 1e-11;

    /** The tableau w - M z - d z0 = q with columns w_0..w_n-1, z_0..z_n-1, z0, q, by columns. */
    class Tableau
    {
    public:
      Tableau(const DenseMatrix &M, const Vector &q, const Vector &d)
        : n(q.size()), table(n, 2 * n + 2), basis(n)
      {
        for (std::size_t i = 0; i < n; ++i)
          {
            table(i, i)         = 1.;
            table(i, 2 * n)     = -d[i];
            table(i, 2 * n + 1) = q[i];
            basis[i]            = i;
            for (std::size_t j = 0; j < n; ++j)
              table(i, n + j) = -M(i, j);
          }
      }

      std::size_t
      covering_variable() const
      {
        return 2 * n;
      }

      std::size_t
      complement(const std::size_t variable) const
      {
        return variable < n ? variable + n : variable - n;
      }

      /** Row with the most negative q/d: the first to leave. Lowest index on ties. */
      std::size_t
      first_row(const Vector &d) const
      {
        std::size_t row = 0;
        for (std::size_t i = 1; i < n; ++i)
          if (q(i) / d[i] < q(row) / d[row])
            row = i;
        return row;
      }

      /** Lexicographic ratio test; n if no row limits the entering variable. */
      std::size_t
      leaving_row(const std::size_t entering) const
      {
        double largest = 0.;
        for (std::size_t i = 0; i < n; ++i)
          largest = std::max(largest, std::abs(table(i, entering)));
        std::size_t best         = n;
        std::size_t covering_row = n;
        for (std::size_t i = 0; i < n; ++i)
          if (table(i, entering) > pivot_tolerance * largest)
            {
              if (best == n || is_before(i, best, entering))
                best = i;
              if (basis[i] == covering_variable())
                covering_row = i;
            }
        // Of several limiting rows the covering variable leaves first: that ends the method.
        if (covering_row != n &&
            q(covering_row) / table(covering_row, entering) <=
              q(best) / table(best, entering) + pivot_tolerance * std::abs(q(covering_row)))
          return covering_row;
        return best;
      }

      std::size_t
      basic_variable(const std::size_t row) const
      {
        return basis[row];
      }

      void
      pivot(const std::size_t row, const std::size_t entering)
      {
        const Vector pivot_column(table.column(entering), table.column(entering) + n);
        const double pivot = pivot_column[row];
        for (std::size_t j = 0; j < 2 * n + 2; ++j)
          {
            double *column = table.column(j);
            if (column[row] == 0.)
              continue;
            const double factor = column[row] / pivot;
            blas::axpy(n, -factor, pivot_column.data(), column);
            column[row] = factor;
          }
        basis[row] = entering;
      }

      double
      q(const std::size_t row) const
      {
        return table(row, 2 * n + 1);
      }

      double
      entry(const std::size_t row, const std::size_t variable) const
      {
        return table(row, variable);
      }

      const std::size_t n;

    private:
      bool
      is_before(const std::size_t i, const std::size_t k, const std::size_t entering) const
      {
        const double a = table(i, entering), b = table(k, entering);
        const auto less = [&](const double x, const double y, bool &decided) {
          const double left = x / a, right = y / b;
          decided = std::abs(left - right) > 1e-14 * (std::abs(left) + std::abs(right));
          return left < right;
        };
        bool decided = false;
        bool result  = less(q(i), q(k), decided);
        for (std::size_t j = 0; j < n && !decided; ++j)
          result = less(table(i, j), table(k, j), decided);
        return decided ? result : i < k;
      }

      DenseMatrix table;
      std::vector<std::size_t> basis;
    };
  } // namespace

  LcpSolution
  solve_lcp(const DenseMatrix &M, const Vector &q, const Vector &covering)
  {
    LcpSolution result;
    result.z.assign(q.size(), 0.);
    if (std::all_of(q.begin(), q.end(), [](const double value) { return value >= 0.; }))
      {
        result.solved = true;
        return result;
      }

    Tableau tableau(M, q, covering);
    std::size_t row              = tableau.first_row(covering);
    std::size_t leaving          = tableau.basic_variable(row);
    std::size_t entering         = tableau.covering_variable();
    const std::size_t max_pivots = 50 * tableau.n + 1000;
    for (std::size_t count = 0; count < max_pivots; ++count)
      {
        tableau.pivot(row, entering);
        if (leaving == tableau.covering_variable())
          {
            for (std::size_t i = 0; i < tableau.n; ++i)
              if (tableau.basic_variable(i) >= tableau.n)
                result.z[tableau.basic_variable(i) - tableau.n] = std::max(0., tableau.q(i));
            result.solved = true;
            return result;
          }
        entering = tableau.complement(leaving);
        row      = tableau.leaving_row(entering);
        if (row == tableau.n)
          break;
        leaving = tableau.basic_variable(row);
      }

    if (entering >= tableau.n && entering != tableau.covering_variable())
      result.z[entering - tableau.n] = 1.;
    for (std::size_t i = 0; i < tableau.n; ++i)
      {
        const std::size_t variable = tableau.basic_variable(i);
        if (variable >= tableau.n && variable != tableau.covering_variable())
          result.z[variable - tableau.n] = std::max(0., -tableau.entry(i, entering));
      }
    return result;
  }
} // namespace fuga
