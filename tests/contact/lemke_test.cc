// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/lemke.h"

#include <fuga/contact/cones/lemke.h>

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

using namespace fuga;

namespace
{
  DenseMatrix
  square(const std::size_t n, const std::initializer_list<double> by_rows)
  {
    DenseMatrix M(n, n);
    std::size_t position = 0;
    for (const double entry : by_rows)
      {
        M(position / n, position % n) = entry;
        ++position;
      }
    return M;
  }

  /**
   * Contact of n equal elements, mirror symmetric, all at the apex of the cone, as a
   * complementarity problem in opening, slip forwards and slip backwards of each: W with couplings
   * that decay along the joint, antisymmetric between normal and tangential directions as those of
   * a half-plane.
   */
  struct SymmetricContact
  {
    SymmetricContact(const std::size_t n_elements, const double f)
      : n(n_elements), M(3 * n, 3 * n), covering(3 * n, 1.)
    {
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double r        = static_cast<double>(i) - static_cast<double>(j);
            const double own      = std::pow(-0.4, std::abs(r));
            const double coupling = r == 0. ? 0. : std::copysign(0.1 * own, r);
            M(3 * i, 3 * j)       = own;
            for (const std::size_t to : {1, 2})
              {
                const double sign        = to == 1 ? 1. : -1.;
                M(3 * i, 3 * j + to)     = sign * coupling;
                M(3 * i + to, 3 * j)     = f * own - sign * coupling;
                M(3 * i + to, 3 * j + 1) = f * coupling + sign * own;
                M(3 * i + to, 3 * j + 2) = -f * coupling - sign * own;
              }
          }
      for (std::size_t i = 0; i < n; ++i)
        covering[3 * i + 1] = covering[3 * i + 2] = 1. + f;
    }

    /** q of force rates (normal, tangential) on every element, the tangential ones antisymmetric or
     * equal. */
    Vector
    reserves(const double f,
             const double normal,
             const double tangential,
             const bool mirrored) const
    {
      Vector q(3 * n);
      for (std::size_t i = 0; i < n; ++i)
        {
          const double side = static_cast<double>(2 * i + 1) / static_cast<double>(n) - 1.;
          const double T    = mirrored ? tangential * side : tangential;
          const double N    = normal * (1. - 1.5 * std::abs(side));
          q[3 * i]          = -N;
          q[3 * i + 1]      = -f * N - T;
          q[3 * i + 2]      = -f * N + T;
        }
      return q;
    }

    std::size_t n;
    DenseMatrix M;
    Vector covering;
  };
} // namespace

// Murty's example for n = 3 (lower triangular matrix, q = -1): the unique solution of the P-matrix
// problem is z = (1, 0, ... ) computed by hand: z1 = 1, w2 = -1 + 2 = 1, w3 = -1 + 2 = 1.
TEST(Lemke, LowerTriangularExample)
{
  const DenseMatrix M        = square(3, {1., 0., 0., 2., 1., 0., 2., 2., 1.});
  const LcpSolution solution = solve_lcp(M, {-1., -1., -1.}, {1., 1., 1.});
  ASSERT_TRUE(solution.solved());
  EXPECT_NEAR(solution.z[0], 1., 1e-14);
  EXPECT_NEAR(solution.z[1], 0., 1e-14);
  EXPECT_NEAR(solution.z[2], 0., 1e-14);
}

// M = 0, q < 0 has no solution: the method ends on the ray z.
TEST(Lemke, RayWithoutSolution)
{
  const LcpSolution solution = solve_lcp(DenseMatrix(1, 1), {-1.}, {1.});
  EXPECT_EQ(solution.status, LcpStatus::ray);
  EXPECT_EQ(solution.z[0], 1.);
}

// M. M. Kostreva, Cycling in linear complementarity problems, Math. Prog. 16 (1979): q = -1 makes
// every ratio test a tie; without the lexicographic rule the method cycles. z = 1/3 by symmetry.
TEST(Lemke, KostrevasCyclingExample)
{
  const DenseMatrix M        = square(3, {1., 2., 0., 0., 1., 2., 2., 0., 1.});
  const LcpSolution solution = solve_lcp(M, {-1., -1., -1.}, {1., 1., 1.});
  ASSERT_TRUE(solution.solved());
  for (const double z : solution.z)
    EXPECT_NEAR(z, 1. / 3., 1e-14);
}

// Up to 60 elements whose symmetry and equal data make ties of most ratio tests, against the
// independent Lemke of the judges (at f = 0.7 and 60 elements both end on a ray); 1e-9: conditions
// up to 1e4 in up to 180 pivots.
TEST(Lemke, SymmetricBoundarySets)
{
  std::size_t n_partly = 0;
  for (const std::size_t n : {1, 2, 3, 5, 8, 20, 21, 60})
    for (const double f : {0., 0.2, 0.4})
      for (const double T : {0., 0.4, 1.})
        for (const bool mirrored : {false, true})
          {
            SCOPED_TRACE(testing::Message() << n << " elements, f = " << f << ", T = " << T);
            const SymmetricContact contact(n, f);
            const Vector q             = contact.reserves(f, -1., T, mirrored);
            const LcpSolution solution = solve_lcp(contact.M, q, contact.covering);
            const auto judge           = judges::lemke(contact.M, q, contact.covering);
            ASSERT_EQ(judge.status, judges::LemkeStatus::solution);
            ASSERT_TRUE(solution.solved());
            const Vector w       = multiply(contact.M, solution.z);
            std::size_t n_active = 0;
            for (std::size_t i = 0; i < 3 * n; ++i)
              {
                EXPECT_NEAR(w[i] + q[i], judge.w[i], 1e-9) << i;
                EXPECT_GE(w[i] + q[i], -1e-9) << i;
                EXPECT_LE((w[i] + q[i]) * solution.z[i], 1e-9) << i;
                n_active += solution.z[i] > 1e-9 ? 1 : 0;
              }
            n_partly += n_active > 0 && n_active < 2 * n ? 1 : 0;
          }
  EXPECT_GT(n_partly, 40u);
}
