// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/lemke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>

using namespace fuga;
using namespace fuga::judges;

namespace
{
  /** Written row by row. */
  DenseMatrix
  square(const std::size_t n, const std::initializer_list<double> entries)
  {
    DenseMatrix M(n, n);
    std::size_t position = 0;
    for (const double entry : entries)
      {
        M(position / n, position % n) = entry;
        ++position;
      }
    return M;
  }

  /** A ray must be what it says: ray_w = M ray_z + d ray_z0, nonnegative, complementary, not zero.
   */
  void
  expect_ray(const LemkeResult &result, const DenseMatrix &M)
  {
    ASSERT_EQ(result.status, LemkeStatus::ray);
    const std::size_t n = M.rows();
    double size         = result.ray_z0;
    for (std::size_t i = 0; i < n; ++i)
      {
        double sum = result.ray_z0;
        for (std::size_t j = 0; j < n; ++j)
          sum += M(i, j) * result.ray_z[j];
        EXPECT_NEAR(result.ray_w[i], sum, 1e-12);
        EXPECT_GE(result.ray_w[i], 0.);
        EXPECT_GE(result.ray_z[i], 0.);
        EXPECT_NEAR(result.ray_w[i] * result.ray_z[i], 0., 1e-12);
        size += result.ray_w[i] + result.ray_z[i];
      }
    EXPECT_GT(size, 0.);
    EXPECT_GT(result.z0, 0.);
  }
} // namespace


TEST(Lemke, TrivialQIsTheSolution)
{
  // By inspection: q ≥ 0 gives z = 0, w = q for any M.
  const LemkeResult result = lemke(square(2, {-1., 3., 2., -5.}), {0., 4.});
  ASSERT_EQ(result.status, LemkeStatus::solution);
  EXPECT_EQ(result.z, (Vector{0., 0.}));
  EXPECT_EQ(result.w, (Vector{0., 4.}));
}

TEST(Lemke, MurtysPMatrix)
{
  // K. G. Murty, Linear Complementarity (1988), the triangular P-matrices on which Lemke is
  // exponential; the solution by forward substitution: z = (8, 0, 0), w = (0, 4, 2).
  const DenseMatrix M      = square(3, {1., 0., 0., 2., 1., 0., 2., 2., 1.});
  const LemkeResult result = lemke(M, {-8., -12., -14.});
  ASSERT_EQ(result.status, LemkeStatus::solution);
  EXPECT_NEAR(result.z[0], 8., 1e-14);
  EXPECT_NEAR(result.w[1], 4., 1e-13);
  EXPECT_NEAR(result.w[2], 2., 1e-13);
}

TEST(Lemke, KostrevasCyclingExample)
{
  // M. M. Kostreva, Cycling in linear complementarity problems, Math. Prog. 16 (1979): q = -1 makes
  // every ratio test a tie. By symmetry z = 1/3 for a = 2.
  const DenseMatrix M      = square(3, {1., 2., 0., 0., 1., 2., 2., 0., 1.});
  const LemkeResult result = lemke(M, {-1., -1., -1.});
  ASSERT_EQ(result.status, LemkeStatus::solution);
  for (const double z : result.z)
    EXPECT_NEAR(z, 1. / 3., 1e-14);
}

TEST(Lemke, RaysWhereNothingIsFeasible)
{
  // By inspection: w = -z - 1 and w = 0 z - 1 cannot be nonnegative; nor w2 = -z1 - 1 of a skew M.
  const DenseMatrix negative = square(1, {-1.}), zero = square(1, {0.}),
                    skew = square(2, {0., 1., -1., 0.});
  expect_ray(lemke(negative, {-1.}), negative);
  expect_ray(lemke(zero, {-1.}), zero);
  expect_ray(lemke(skew, {-1., -1.}), skew);
}

TEST(Lemke, DegenerateSemidefinite)
{
  // M = ones(2): w1 = w2 = z1 + z2 - 1, a face of solutions z1 + z2 = 1. Any of them will do.
  const DenseMatrix M      = square(2, {1., 1., 1., 1.});
  const Vector q           = {-1., -1.};
  const LemkeResult result = lemke(M, q);
  ASSERT_EQ(result.status, LemkeStatus::solution);
  EXPECT_LE(lcp_residual(M, q, result.w, result.z), 1e-14);
}

TEST(Lemke, RandomPositiveDefiniteWithTies)
{
  // Positive definite, not symmetric M = AᵀA + I + skew with integer entries and q of few values:
  // one solution exists (Cottle, Pang & Stone, Thm 3.1.6) and ties abound. The residual is the
  // judge.
  std::mt19937 generator(7);
  const auto digit = [&] { return static_cast<double>(generator() % 5) - 2.; };
  for (unsigned int run = 0; run < 200; ++run)
    {
      const std::size_t n = 2 + run % 30;
      DenseMatrix A(n, n), M(n, n);
      Vector q(n), d(n);
      for (std::size_t j = 0; j < n; ++j)
        {
          q[j] = digit();
          d[j] = run % 2 == 0 ? 1. : 3. + digit();
          for (std::size_t i = 0; i < n; ++i)
            A(i, j) = digit();
        }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          {
            M(i, j) = (i == j ? 1. : 0.) + A(i, j) - A(j, i);
            for (std::size_t k = 0; k < n; ++k)
              M(i, j) += A(k, i) * A(k, j);
          }
      const LemkeResult result = lemke(M, q, d);
      ASSERT_EQ(result.status, LemkeStatus::solution) << run;
      EXPECT_LE(lcp_residual(M, q, result.w, result.z), 1e-11) << run;
    }
}
