// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// What the estimates decide where one of them decides alone.

#include <fuga/bodies/solver_choice.h>

#include <gtest/gtest.h>

using namespace fuga;

namespace
{
  EliminationSize
  hundred_thousand_unknowns()
  {
    EliminationSize size;
    size.dimension         = 3;
    size.n_entries         = 4000000;
    size.n_unknowns        = 100000;
    size.n_interface       = 1000;
    size.direct_megabytes  = 1.;
    size.direct_operations = 1e11;
    return size;
  }
} // namespace

TEST(SolverChoice, FactorThatFits)
{
  EXPECT_EQ(estimate_solvers(hundred_thousand_unknowns()).choice, BodySolver::direct);
}

TEST(SolverChoice, FactorThatDoesNotFit)
{
  EliminationSize size  = hundred_thousand_unknowns();
  size.direct_megabytes = 1e12;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
  size.may_be_matrix_free = true;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::matrix_free);
  size.n_interface = 4; // S costs less than a scheme without it
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
}

// No joint: one solution against a factorisation of 1e15 operations.
TEST(SolverChoice, IterationThatIsMuchFaster)
{
  EliminationSize size   = hundred_thousand_unknowns();
  size.n_interface       = 0;
  size.direct_operations = 1e15;
  EXPECT_EQ(estimate_solvers(size).choice, BodySolver::iterative);
}
