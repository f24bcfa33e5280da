// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/interruption.h>
#include <fuga/base/numerics/lcp_search.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Entries of the tableau below this value count as zero, relative to the largest of their row
     * and to one. */
    constexpr double zero_entry = 1e-9;
    /** Values that count as zero, relative to the largest of q; those of w also relative to its
     * noise. */
    constexpr double zero_value = 1e-11, zero_of_noise = 1e-2;
    /** Reciprocal condition number below which a basis counts as singular. */
    constexpr double singular = 1e-14;
    /** Relative uncertainty of the entries of M, which result from a linear solution. */
    constexpr double rounding_of_matrix = 1e-12;

    /** The search below one division, with all its data. Variables are w_0..w_n-1, z_0..z_n-1. */
    class Search
    {
    public:
      Search(const DenseMatrix &matrix,
             const Vector &right_hand_side,
             const LcpNoise &lcp_noise,
             const double most_work)
        : M(matrix)
        , q(right_hand_side)
        , noise(lcp_noise)
        , n(q.size())
        , most_pivots(static_cast<std::size_t>(most_work / static_cast<double>(n * (n + 1))))
        , table(n, n + 1)
        , basic(n)
        , other(n)
        , is_zero(2 * n, false)
        , zero(2 * n, zero_value * max_abs(q))
      {
        begin();
        for (std::size_t j = 0; j < n; ++j)
          zero[j] = std::max(zero[j],
                             zero_of_noise * (noise.reserves[j] + noise.shares[j] * noise.at_rest));
      }

      LcpSearch
      run()
      {
        result.end = divide();
        return result;
      }

    private:
      /** Begin with the basis w. */
      void
      begin()
      {
        for (std::size_t j = 0; j < n; ++j)
          {
            basic[j] = j;
            other[j] = n + j;
          }
        table.leftCols(n) = M;
        table.col(n)      = view(q);
        is_fresh          = true;
      }

      /** Search the part that is given by the variables held at zero. */
      SearchEnd
      divide()
      {
        const SearchEnd relaxed = relax();
        if (relaxed != SearchEnd::found)
          return relaxed;
        const Vector x    = values();
        std::size_t worst = 0;
        for (std::size_t i = 1; i < n; ++i)
          if (std::min(x[i], x[n + i]) > std::min(x[worst], x[n + worst]))
            worst = i;
        if (x[worst] <= zero[worst] || x[n + worst] <= zero[n + worst])
          {
            result.z.assign(x.begin() + static_cast<std::ptrdiff_t>(n), x.end());
            return SearchEnd::found;
          }
        // Any basis is a valid beginning for any part, so only the division is undone.
        const std::size_t first = x[worst] < x[n + worst] ? worst : n + worst;
        SearchEnd end           = SearchEnd::none;
        for (const std::size_t held : {first, first == worst ? n + worst : worst})
          {
            is_zero[held]       = true;
            const SearchEnd one = divide();
            is_zero[held]       = false;
            if (one != SearchEnd::none)
              end = one;
            if (one == SearchEnd::found)
              break;
          }
        return end;
      }

      /**
       * Apply the simplex method without an objective: a basic variable that is not admissible
       * leaves for one that moves it. Choose the worst one and the largest entry at first; choose
       * by lowest indices, which is finite, where that takes long.
       */
      SearchEnd
      relax()
      {
        for (std::size_t count = 0; result.n_pivots < most_pivots; ++count)
          {
            const bool by_index   = count > 10 * n;
            const std::size_t row = leaving(by_index);
            if (row == n)
              return SearchEnd::found;
            const std::size_t column = entering(row, by_index);
            if (column == n && is_proof(row))
              return SearchEnd::none;
            if (column == n && is_fresh)
              return SearchEnd::undecided;
            if (column == n)
              {
                refresh();
                continue;
              }
            if (++result.n_pivots % 64 == 0)
              interruption::check("while the next states of the joints were looked for");
            pivot(row, column);
          }
        return SearchEnd::undecided;
      }

      std::size_t
      leaving(const bool by_index) const
      {
        std::size_t row = n;
        double worst    = 0.;
        for (std::size_t i = 0; i < n; ++i)
          {
            const double value     = table(i, n);
            const double violation = is_zero[basic[i]] ? std::abs(value) : -value;
            if (violation > zero[basic[i]] &&
                (by_index ? row == n || basic[i] < basic[row] : violation > worst))
              {
                row   = i;
                worst = violation;
              }
          }
        return row;
      }

      std::size_t
      entering(const std::size_t row, const bool by_index) const
      {
        const double sign = table(row, n) < 0. ? 1. : -1.;
        double none       = zero_entry;
        for (std::size_t j = 0; j < n; ++j)
          none = std::max(none, zero_entry * std::abs(table(row, j)));
        std::size_t column = n;
        double largest     = none;
        for (std::size_t j = 0; j < n; ++j)
          {
            const double entry = sign * table(row, j);
            if (!is_zero[other[j]] &&
                (by_index ? entry > none && (column == n || other[j] < other[column])
                          : entry > largest))
              {
                column  = j;
                largest = entry;
              }
          }
        return column;
      }

      // Solve a row, basic = Σ entries × others + value, for the variable that enters.
      void
      pivot(const std::size_t row, const std::size_t column)
      {
        const double entry       = table(row, column);
        Eigen::VectorXd entering = table.col(column);
        entering(row)            = 0.;
        for (std::size_t j = 0; j <= n; ++j)
          if (j != column)
            {
              const double share = -table(row, j) / entry;
              table(row, j)      = share;
              table.col(j) += share * entering;
            }
        table.col(column)  = entering / entry;
        table(row, column) = 1. / entry;
        std::swap(basic[row], other[column]);
        is_fresh = false;
      }

      /** Compute the tableau of the present basis without the rounding errors of the pivots that
       * led to it; if these have made the basis singular, compute that of the first one. */
      void
      refresh()
      {
        DenseMatrix basis(n, n);
        for (std::size_t i = 0; i < n; ++i)
          take_column(basic[i], basis.col(i).data());
        result.n_pivots += n;
        const LuFactors factors(std::move(basis));
        if (!(factors.reciprocal_condition() > singular))
          {
            begin();
            return;
          }
        Vector column(n);
        for (std::size_t j = 0; j <= n; ++j)
          {
            if (j == n)
              column = q;
            else
              take_column(other[j], column.data());
            factors.solve(column);
            for (std::size_t i = 0; i < n; ++i)
              table(i, j) = j == n ? column[i] : -column[i];
          }
        is_fresh = true;
      }

      /** Set @p column to the column of a variable in w - M z = q. */
      void
      take_column(const std::size_t variable, double *column) const
      {
        for (std::size_t i = 0; i < n; ++i)
          column[i] = variable >= n ? -M(i, variable - n) : i == variable ? 1. : 0.;
      }

      Vector
      values() const
      {
        Vector x(2 * n, 0.);
        for (std::size_t i = 0; i < n; ++i)
          x[basic[i]] = table(i, n);
        return x;
      }

      /** Return whether the row of a basic variable that nothing moves rules the part out. Basic
       * unknowns have no factor in it, and any noise of theirs would grow with them beyond bounds:
       * adding a small multiple of their own rows gives them factors that are larger than the
       * noise. */
      bool
      is_proof(const std::size_t row) const
      {
        constexpr double more_than_noise = 2.;
        Vector of_rows(n, 0.), noise_of_unknowns(n);
        of_rows[row] = table(row, n) < 0. ? 1. : -1.;
        if (rules_out(multipliers(of_rows), noise_of_unknowns))
          return true;
        for (std::size_t i = 0; i < n; ++i)
          if (i != row && basic[i] >= n && !is_zero[basic[i]])
            of_rows[i] = more_than_noise * noise_of_unknowns[basic[i] - n];
        return rules_out(multipliers(of_rows), noise_of_unknowns);
      }

      /** Return the multipliers y of a sum of rows of the tableau. */
      Vector
      multipliers(const Vector &of_rows) const
      {
        Vector y(n, 0.);
        for (std::size_t i = 0; i < n; ++i)
          if (basic[i] < n)
            y[basic[i]] = of_rows[i];
        for (std::size_t j = 0; j < n; ++j)
          if (other[j] < n)
            {
              const double sum = -view(of_rows).dot(table.col(j));
              y[other[j]]      = is_zero[other[j]] ? sum : std::max(0., sum);
            }
        return y;
      }

      /** Return whether y is a proof. The amount by which a large unknown may reduce the left side
       * due to its noise is compensated by the unknown itself, if it has a factor. */
      bool
      rules_out(const Vector &y, Vector &noise_of_unknowns) const
      {
        double right = 0., uncertain = 0., noisy = 0.;
        for (std::size_t i = 0; i < n; ++i)
          {
            right += y[i] * q[i];
            uncertain += std::abs(y[i]) * (noise.reserves[i] + rounding_of_matrix * std::abs(q[i]));
            noisy += std::abs(y[i]) * noise.shares[i];
          }
        Vector factors(n, 0.), terms(n, 0.);
        for (std::size_t j = 0; j < n; ++j)
          {
            for (std::size_t i = 0; i < n; ++i)
              {
                factors[j] -= y[i] * M(i, j);
                terms[j] += std::abs(y[i] * M(i, j));
              }
            noisy += std::abs(factors[j]) * noise.unknowns[j];
          }
        uncertain += noisy * noise.at_rest;
        for (std::size_t j = 0; j < n; ++j)
          {
            noise_of_unknowns[j] = rounding_of_matrix * terms[j] + noisy * noise.growth[j];
            if (!is_zero[n + j])
              uncertain += std::max(0., noise_of_unknowns[j] - factors[j]) * noise.largest_unknown;
          }
        return right < -uncertain;
      }

      const DenseMatrix &M;
      const Vector &q;
      const LcpNoise &noise;
      const std::size_t n, most_pivots;
      DenseMatrix table;
      bool is_fresh = true;
      /** Variables of the rows and of the columns. */
      std::vector<std::size_t> basic, other;
      std::vector<bool> is_zero;
      /** Value below which each variable counts as zero. */
      Vector zero;
      LcpSearch result;
    };
  } // namespace

  LcpSearch
  search_lcp(const DenseMatrix &M, const Vector &q, const LcpNoise &noise, const double most_work)
  {
    return Search(M, q, noise, most_work).run();
  }
} // namespace fuga
