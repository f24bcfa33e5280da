// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_contact_products_only_h
#define fuga_tests_contact_products_only_h

#include "contact/toy_system.h"

#include <fuga/contact/system/tangent_solver.h>

#include <algorithm>

namespace fuga::tests
{
  /** Bodies that are known by their products alone. */
  class ProductsOnly : public ToySystem, public TangentSolver
  {
  public:
    /** @p least_of_lips: for bodies without stiffness. */
    explicit ProductsOnly(const ToySystem &system, const double least_of_lips = 0.)
      : ToySystem(system), least(least_of_lips)
    {
    }

    Vector
    stiffness_of_lips() const override
    {
      const DenseMatrix jumps = all_jumps();
      Vector result;
      for (Eigen::Index bar = 0; bar < jumps.rows(); ++bar)
        {
          double work = 0., square = 0.;
          for (Eigen::Index i = 0; i < S.rows(); ++i)
            {
              work += jumps(bar, i) * jumps(bar, i) * S(i, i);
              square += jumps(bar, i) * jumps(bar, i);
            }
          result.push_back(std::max(least, work / (square * square)));
        }
      return result;
    }

    Vector
    resistance(const Vector &x) const override
    {
      return multiply(S, x);
    }

    void
    refine(Solution &solution) const override
    {
      solution.resistance = resistance(solution.x);
    }

    Solution
    solve_with_bars(const std::vector<ElementStiffness> &bars,
                    const Vector &r,
                    const Solution &,
                    const double) const override
    {
      const DenseMatrix jumps     = all_jumps();
      const std::size_t n_of_each = jumps.rows() / bars.size();
      DenseMatrix C(jumps.rows(), jumps.rows());
      for (std::size_t k = 0; k < bars.size(); ++k)
        for (std::size_t i = 0; i < n_of_each; ++i)
          for (std::size_t j = 0; j < n_of_each; ++j)
            C(k * n_of_each + i, k * n_of_each + j) = bars[k][i][j];
      DenseMatrix K = multiply_transposed(jumps, multiply(C, jumps));
      for (Eigen::Index i = 0; i < S.rows() * S.rows(); ++i)
        K.data()[i] += S.data()[i];
      Solution solution{r, {}, {}};
      LuFactors(std::move(K)).solve(solution.x);
      solution.resistance = resistance(solution.x);
      return solution;
    }

  private:
    DenseMatrix
    all_jumps() const
    {
      if (B.size() > 0)
        return B;
      DenseMatrix identity(S.rows(), S.rows());
      for (Eigen::Index i = 0; i < S.rows(); ++i)
        identity(i, i) = 1.;
      return identity;
    }

    const double least;
  };
} // namespace fuga::tests

#endif
