// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/solvers/schur_solver.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

using namespace fuga;

namespace
{
  /** K = [[4, 1, 0], [1, 3, 2], [0, 2, 5]], one triangle. */
  SymmetricTriplets
  small_matrix()
  {
    return {3, {1, 2, 2, 3, 3}, {1, 1, 2, 2, 3}, {4., 1., 3., 2., 5.}};
  }

  /** Five points on a square of @p m × @p m unknowns, one triangle. */
  SymmetricTriplets
  grid_matrix(const int m)
  {
    SymmetricTriplets matrix;
    matrix.size    = m * m;
    const auto add = [&matrix](const int i, const int j, const double value) {
      matrix.rows.push_back(i);
      matrix.columns.push_back(j);
      matrix.values.push_back(value);
    };
    for (int k = 1; k <= m * m; ++k)
      {
        add(k, k, 4.1);
        if (k % m != 0)
          add(k + 1, k, -1.);
        if (k + m <= m * m)
          add(k + m, k, -1.);
      }
    return matrix;
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
  solver.solve(loads, InteriorSolver::Digits::first);
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
  solver.solve(u, InteriorSolver::Digits::first);
  EXPECT_NEAR(u(0, 0), 2., 1e-14);
  EXPECT_NEAR(u(0, 1), -0.5, 1e-14);
  for (const std::size_t kept : {1, 2})
    EXPECT_EQ(u(kept, 1), 0.);
}

// Files hold the same numbers as memory: S to the last digit; sums of solutions run in another
// order: a few units of the last digit of values below 64. The files are gone with the solver.
TEST(SchurSolver, FactorOnDisk)
{
  const std::string folder = ::testing::TempDir() + "fuga_factor_on_disk";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const char *const before   = std::getenv("TMPDIR");
  const std::string original = before == nullptr ? "" : before;
  setenv("TMPDIR", folder.c_str(), 1);

  constexpr int m             = 60;
  constexpr unsigned int kept = 2 * m;
  std::vector<DenseMatrix> results[2];
  for (const bool on_disk : {false, true})
    {
      SchurSolver solver;
      SymmetricTriplets matrix = grid_matrix(m);
      solver.analyse(matrix, kept);
      if (on_disk)
        solver.keep_factor_on_disk();
      results[on_disk].push_back(solver.eliminate(matrix, kept));
      EXPECT_EQ(std::filesystem::is_empty(folder), !on_disk);
      DenseMatrix loads(std::size_t(m) * m, 3);
      for (Eigen::Index i = 0; i < loads.rows() - kept; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          loads(i, j) = double(i % (7 + j));
      DenseMatrix again = loads;
      results[on_disk].push_back(solver.condense(loads));
      solver.solve(again, InteriorSolver::Digits::first);
      results[on_disk].push_back(again);
    }
  for (std::size_t r = 0; r < results[0].size(); ++r)
    for (Eigen::Index j = 0; j < results[0][r].cols(); ++j)
      for (Eigen::Index i = 0; i < results[0][r].rows(); ++i)
        ASSERT_NEAR(results[0][r](i, j), results[1][r](i, j), r == 0 ? 0. : 5e-14)
          << r << ' ' << i << ' ' << j;
  EXPECT_TRUE(std::filesystem::is_empty(folder));

  if (before == nullptr)
    unsetenv("TMPDIR");
  else
    setenv("TMPDIR", original.c_str(), 1);
}
