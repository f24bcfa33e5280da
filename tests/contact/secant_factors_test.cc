// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/secant_factors.h>
#include <gtest/gtest.h>

#include <random>

namespace
{
  using namespace fuga;

  DenseMatrix
  random_matrix(const std::size_t n, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> entry(-1., 1.);
    DenseMatrix A(n, n);
    for (std::size_t j = 0; j < n; ++j)
      {
        for (std::size_t i = 0; i < n; ++i)
          A(i, j) = entry(random);
        A(j, j) += static_cast<double>(n);
      }
    return A;
  }

  Vector
  random_vector(const std::size_t n, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> entry(-1., 1.);
    Vector result(n);
    for (double &value : result)
      value = entry(random);
    return result;
  }

  // Weak unknowns enter no equation but their own: the product of A with what comes out is the
  // right hand side, but for rounding of numbers of the size one.
  TEST(NearlyTriangularFactors, SolveATriangularSystemByBlocks)
  {
    std::mt19937 random(1);
    const std::size_t n = 12;
    DenseMatrix A       = random_matrix(n, random);
    std::vector<bool> is_weak(n, false);
    for (const std::size_t weak : {1u, 5u, 6u, 11u})
      {
        is_weak[weak] = true;
        for (std::size_t i = 0; i < n; ++i)
          if (i != weak)
            A(i, weak) = 0.;
      }
    const Vector b = random_vector(n, random);
    const NearlyTriangularFactors factors(A, is_weak);
    EXPECT_TRUE(factors.has_weak_unknowns());
    const Vector product = multiply(A, factors.solve(b));
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(product[i], b[i], 1e-14);
  }

  // D. M. Gay, Some convergence properties of Broyden's method, SIAM J. Numer. Anal. 16 (1979): a
  // linear system of n equations is solved in at most 2n steps; here the first factors are wrong in
  // one direction only, as in a system of one equation. Without corrections the error of a step is
  // a tenth of the one before it.
  TEST(SecantFactors, LearnTheDirectionInWhichTheyAreWrong)
  {
    std::mt19937 random(2);
    const std::size_t n = 20;
    const DenseMatrix A = random_matrix(n, random);
    DenseMatrix nearby  = A;
    const Vector u = random_vector(n, random), v = random_vector(n, random);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        nearby(i, j) += 2. * u[i] * v[j];
    const Vector b = random_vector(n, random);
    SecantFactors factors(nearby, std::vector<bool>(n, false));
    const auto solve_in = [&](const Vector &rhs, const int n_steps) {
      Vector x(n, 0.), step;
      for (int k = 0; k < n_steps; ++k)
        {
          Vector residual = rhs;
          add_multiple(-1., multiply(A, x), residual);
          step = factors.solve(residual, step);
          add_multiple(1., step, x);
        }
      Vector residual = rhs;
      add_multiple(-1., multiply(A, x), residual);
      return max_abs(residual);
    };
    EXPECT_GT(solve_in(b, 1), 1e-3);
    EXPECT_LT(solve_in(b, 3), 1e-13);
    // What was learnt is forgotten on request.
    SecantFactors forgetful = factors.without_corrections();
    std::swap(factors, forgetful);
    const double anew = solve_in(b, 2);
    std::swap(factors, forgetful);
    EXPECT_LT(solve_in(b, 2), 0.1 * anew);
  }
} // namespace
