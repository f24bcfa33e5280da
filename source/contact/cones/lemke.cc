// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cones/lemke.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr double pivot_tolerance = 1e-11;
    /** Rounding error of an entry of the tableau, relative to the larger of one and the entry. */
    constexpr double entry_noise = 1e-13;

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

      /**
       * Return the row with the most negative q/d, which is the first to leave; the last one on
       * ties: its unit row is the lexicographically smallest, so that all others become
       * lexicographically positive.
       */
      std::size_t
      first_row(const Vector &d) const
      {
        std::size_t row = 0;
        for (std::size_t i = 1; i < n; ++i)
          if (compare(q(i), d[i], q(row), d[row]) <= 0)
            row = i;
        return row;
      }

      /** Apply the lexicographic ratio test; return n if no row limits the entering variable. */
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
        // Among several limiting rows the covering variable leaves first, since that ends the
        // method.
        if (covering_row != n &&
            compare(
              q(covering_row), table(covering_row, entering), q(best), table(best, entering)) <= 0)
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
        const Eigen::VectorXd pivot_column = table.col(entering);
        for (std::size_t j = 0; j < 2 * n + 2; ++j)
          if (table(row, j) != 0.)
            {
              const double factor = table(row, j) / pivot_column(row);
              table.col(j) -= factor * pivot_column;
              table(row, j) = factor;
            }
        basis[row] = entering;
      }

      double
      q(const std::size_t row) const
      {
        return table(row, 2 * n + 1);
      }

      /** Return the z part of the present basic solution, times @p size. */
      Vector
      vertex(const double size) const
      {
        Vector z(n, 0.);
        for (std::size_t i = 0; i < n; ++i)
          if (basis[i] >= n && basis[i] != covering_variable())
            z[basis[i] - n] = size * std::max(0., q(i));
        return z;
      }

      /** Set @p z to the z part of the ray along which @p entering grows without being limited. */
      void
      direction_of(const std::size_t entering, Vector &z) const
      {
        if (entering >= n && entering != covering_variable())
          z[entering - n] = 1.;
        for (std::size_t i = 0; i < n; ++i)
          if (basis[i] >= n && basis[i] != covering_variable())
            z[basis[i] - n] = std::max(0., -table(i, entering));
      }

      const std::size_t n;

    private:
      /** Return the sign of x/a - y/b for a, b > 0; 0 if it is within rounding. */
      static int
      compare(const double x, const double a, const double y, const double b)
      {
        const double difference = x / a - y / b;
        const double noise =
          entry_noise * (std::max(1., std::abs(x)) / a + std::max(1., std::abs(y)) / b);
        return std::abs(difference) <= noise ? 0 : difference < 0. ? -1 : 1;
      }

      /** Return whether row i is before row k in the lexicographic order of (q, basis
       * inverse)/entering. */
      bool
      is_before(const std::size_t i, const std::size_t k, const std::size_t entering) const
      {
        const double a = table(i, entering), b = table(k, entering);
        int order = compare(q(i), a, q(k), b);
        for (std::size_t j = 0; j < n && order == 0; ++j)
          order = compare(table(i, j), a, table(k, j), b);
        return order < 0;
      }

      DenseMatrix table;
      std::vector<std::size_t> basis;
    };
  } // namespace

  LcpSolution
  solve_lcp(const DenseMatrix &M, const Vector &right_hand_side, const Vector &covering)
  {
    LcpSolution result;
    const std::size_t n = right_hand_side.size();
    result.z.assign(n, 0.);
    const double size = max_abs(right_hand_side);
    if (std::all_of(right_hand_side.begin(), right_hand_side.end(), [](const double value) {
          return value >= 0.;
        }))
      {
        result.status = LcpStatus::solved;
        return result;
      }

    // q is scaled to a largest entry of one.
    Vector q = right_hand_side;
    for (double &value : q)
      value /= size;
    Tableau tableau(M, q, covering);
    std::size_t row              = tableau.first_row(covering);
    std::size_t leaving          = tableau.basic_variable(row);
    std::size_t entering         = tableau.covering_variable();
    const std::size_t max_pivots = 50 * n + 1000;
    for (std::size_t count = 0; count < max_pivots; ++count)
      {
        tableau.pivot(row, entering);
        if (leaving == tableau.covering_variable())
          {
            result.z      = tableau.vertex(size);
            result.status = LcpStatus::solved;
            return result;
          }
        entering = tableau.complement(leaving);
        row      = tableau.leaving_row(entering);
        if (row == n)
          {
            tableau.direction_of(entering, result.z);
            result.vertex = tableau.vertex(size);
            result.status = LcpStatus::ray;
            return result;
          }
        leaving = tableau.basic_variable(row);
      }
    return result;
  }
} // namespace fuga
