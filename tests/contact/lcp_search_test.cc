// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/linear_solve.h"

#include <fuga/base/numerics/lcp_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace fuga;

namespace
{
  constexpr double rounding = 1e-12;

  LcpNoise
  noise(const std::size_t n, const double of_reserves = rounding)
  {
    return {Vector(n, of_reserves), Vector(n, 1.), Vector(n, 0.), rounding, Vector(n, 0.), 1e3};
  }

  /** Whether one of the 2ⁿ complementary bases is admissible: columns of w - M z = q. */
  bool
  has_solution(const DenseMatrix &M, const Vector &q)
  {
    const std::size_t n = q.size();
    for (std::size_t chosen = 0; chosen < (std::size_t(1) << n); ++chosen)
      {
        DenseMatrix basis(n, n);
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t i = 0; i < n; ++i)
            basis(i, j) = (chosen >> j) % 2 == 1 ? -M(i, j) : i == j ? 1. : 0.;
        const judges::LinearSolution x = judges::solve_linear(basis, q);
        if (x.regular && std::all_of(x.X.col(0).data(),
                                     x.X.col(0).data() + n,
                                     [](const double value) { return value >= 0.; }))
          return true;
      }
    return false;
  }

  /** n/2 times M = (-1 2; 0 1), q = (-1, 1). By hand: w2 = 1 + z2 is positive, so that z2 = 0, and
   * then w1 = -1 - z1 is negative; without complementarity z = (0, 1) were admissible. */
  DenseMatrix
  blocks_without_solution(const std::size_t n)
  {
    DenseMatrix M(n, n);
    for (std::size_t i = 0; i < n; i += 2)
      {
        M(i, i)         = -1.;
        M(i, i + 1)     = 2.;
        M(i + 1, i + 1) = 1.;
      }
    return M;
  }
} // namespace

// Random matrices, of which many leave some q without a solution, against all combinations.
TEST(LcpSearch, AgreesWithAllCombinations)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> number(-1., 1.);
  std::size_t n_solved = 0, n_ruled_out = 0;
  for (int problem = 0; problem < 2000; ++problem)
    {
      SCOPED_TRACE(problem);
      const std::size_t n = 2 + static_cast<std::size_t>(problem) % 6;
      DenseMatrix M(n, n);
      Vector q(n);
      for (std::size_t j = 0; j < n; ++j)
        {
          q[j] = number(generator);
          for (std::size_t i = 0; i < n; ++i)
            M(i, j) = number(generator) + (i == j ? 0.5 : 0.);
        }
      const LcpSearch search = search_lcp(M, q, noise(n));
      ASSERT_EQ(search.end, has_solution(M, q) ? SearchEnd::found : SearchEnd::none);
      if (search.end == SearchEnd::none)
        {
          ++n_ruled_out;
          continue;
        }
      ++n_solved;
      for (std::size_t i = 0; i < n; ++i)
        {
          double w = q[i];
          for (std::size_t j = 0; j < n; ++j)
            w += M(i, j) * search.z[j];
          EXPECT_GE(w, -1e-9);
          EXPECT_GE(search.z[i], -1e-9);
          EXPECT_NEAR(std::min(w, search.z[i]), 0., 1e-9);
        }
    }
  EXPECT_GT(n_solved, 500u);
  EXPECT_GT(n_ruled_out, 200u);
}

// 2⁴⁰ combinations, ruled out by one division.
TEST(LcpSearch, RulesOutMoreThanCanBeEnumerated)
{
  Vector q(40);
  for (std::size_t i = 0; i < q.size(); ++i)
    q[i] = i % 2 == 0 ? -1. : 1.;
  const LcpSearch search = search_lcp(blocks_without_solution(40), q, noise(40));
  EXPECT_EQ(search.end, SearchEnd::none);
  EXPECT_LT(search.n_pivots, 100u);
}

// w = -1e-9 is no solution unless noise is as large: then nothing may be ruled out.
TEST(LcpSearch, WhatNoiseAllowsIsNotRuledOut)
{
  const DenseMatrix M(1, 1);
  EXPECT_EQ(search_lcp(M, {-1e-9}, noise(1)).end, SearchEnd::none);
  EXPECT_NE(search_lcp(M, {-1e-9}, noise(1, 1e-8)).end, SearchEnd::none);
}

// The same where the noise is that of a large unknown: w = -1e-9 + 1e-14 z with z up to 1e6.
TEST(LcpSearch, ALargeUnknownMakesUpForASmallEntry)
{
  DenseMatrix M(1, 1);
  M(0, 0)         = 1e-14;
  LcpNoise limits = noise(1);
  EXPECT_EQ(search_lcp(M, {-1e-9}, limits).end, SearchEnd::none);
  limits.largest_unknown = 1e6;
  EXPECT_NE(search_lcp(M, {-1e-9}, limits).end, SearchEnd::none);
}

// w1 = -1 - z1 and w2 = 1 - z2/4, both to be zero but for noise: with z1 = -1 a solution where a
// large z2 makes the noise of z1 as large as one. It does with 4 ∙ 0.3, not with 4 ∙ 0.2.
TEST(LcpSearch, NoiseGrowsWithTheLargestUnknown)
{
  DenseMatrix M(2, 2);
  M(0, 0)                = -1.;
  M(1, 1)                = -0.25;
  LcpNoise limits        = noise(2);
  limits.largest_unknown = 4.;
  limits.growth[1]       = 0.2;
  EXPECT_EQ(search_lcp(M, {-1., 1.}, limits).end, SearchEnd::none);
  limits.growth[1] = 0.3;
  EXPECT_NE(search_lcp(M, {-1., 1.}, limits).end, SearchEnd::none);
}

// w = -1 - z is nowhere zero but for a noise of 0.3 z, and it is for one of 1.3 z from z = 10/3 on.
TEST(LcpSearch, NoiseOfReservesGrowsWithTheUnknowns)
{
  DenseMatrix M(1, 1);
  M(0, 0)                = -1.;
  LcpNoise limits        = noise(1);
  limits.largest_unknown = 4.;
  limits.unknowns        = {0.};
  limits.shares          = {1.};
  limits.growth          = {0.3};
  EXPECT_EQ(search_lcp(M, {-1.}, limits).end, SearchEnd::none);
  limits.growth = {1.3};
  EXPECT_NE(search_lcp(M, {-1.}, limits).end, SearchEnd::none);
}

// w1 = -1 - z1 + z2 and w2 = 1/2 - z2: z2 would be at least 1 + z1 and at most 1/2, and a millionth
// of z1 + z2 more or less for each makes no difference, however large they are; half of it does,
// with z = (0, 1). The sum of both is a proof in which z2 has no factor.
TEST(LcpSearch, NoiseOfAnUnknownWithoutFactorHasALimit)
{
  DenseMatrix M(2, 2);
  M(0, 0)                = -1.;
  M(0, 1)                = 1.;
  M(1, 1)                = -1.;
  LcpNoise limits        = noise(2);
  limits.largest_unknown = 1e8;
  limits.growth          = {1., 1.};
  limits.unknowns        = {0., 0.};
  limits.shares          = {1e-6, 1e-6};
  EXPECT_EQ(search_lcp(M, {-1., 0.5}, limits).end, SearchEnd::none);
  limits.shares = {0.5, 0.5};
  EXPECT_NE(search_lcp(M, {-1., 0.5}, limits).end, SearchEnd::none);
}

TEST(LcpSearch, SaysWhenItsBudgetIsUsedUp)
{
  Vector q(40, 1.);
  for (std::size_t i = 0; i < q.size(); i += 2)
    q[i] = -1.;
  EXPECT_EQ(search_lcp(blocks_without_solution(40), q, noise(40), 1e3).end, SearchEnd::undecided);
}
