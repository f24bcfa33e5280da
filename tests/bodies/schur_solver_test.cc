// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/schur_solver.h>

#include <gtest/gtest.h>

using namespace fuga;

namespace
{
  /** K = [[4, 1, 0], [1, 3, 2], [0, 2, 5]], one triangle. */
  SymmetricTriplets
  small_matrix()
  {
    return {3, {1, 2, 2, 3, 3}, {1, 1, 2, 2, 3}, {4., 1., 3., 2., 5.}};
  }
} // namespace

// Nothing eliminated: S = K, loads and solution unchanged.
TEST(SchurSolver, NothingToEliminate)
{
  SchurSolver solver;
  SymmetricTriplets matrix   = small_matrix();
  const DenseMatrix S        = solver.eliminate(matrix, 3);
  const double expected[][3] = {{4., 1., 0.}, {1., 3., 2.}, {0., 2., 5.}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(S(i, j), expected[i][j]);
  DenseMatrix loads(3, 1);
  loads(1, 0) = 7.;
  EXPECT_EQ(solver.condense(loads)(1, 0), 7.);
  solver.solve(loads);
  EXPECT_EQ(loads(1, 0), 0.);
}

// The first unknown eliminated, by hand: S = [[3 - 1/4, 2], [2, 5]], f = F_c - [1, 0] F_i/4,
// u_1 = F_1/4 for two loads at once. A few operations: rounding only.
TEST(SchurSolver, OneEliminated)
{
  SchurSolver solver;
  SymmetricTriplets matrix = small_matrix();
  const DenseMatrix S      = solver.eliminate(matrix, 2);
  EXPECT_NEAR(S(0, 0), 2.75, 1e-14);
  EXPECT_NEAR(S(0, 1), 2., 1e-14);
  EXPECT_NEAR(S(1, 1), 5., 1e-14);
  DenseMatrix loads(3, 1);
  loads(0, 0)               = 8.;
  const DenseMatrix reduced = solver.condense(loads);
  EXPECT_NEAR(reduced(0, 0), -2., 1e-14);
  EXPECT_NEAR(reduced(1, 0), 0., 1e-14);
  DenseMatrix u(3, 2);
  u(0, 0) = 8.;
  u(0, 1) = -2.;
  u(1, 1) = 5.; // kept: has no part in it
  solver.solve(u);
  EXPECT_NEAR(u(0, 0), 2., 1e-14);
  EXPECT_NEAR(u(0, 1), -0.5, 1e-14);
  for (const std::size_t kept : {1, 2})
    EXPECT_EQ(u(kept, 1), 0.);
}
