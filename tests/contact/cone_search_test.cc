// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// The search through all states of a rate problem in space, where no virtual motion shows that it
// has no solution and its combinations are too many to be tried.

#include "contact/cone_toy.h"

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr std::size_t n_nodes = 14;
  constexpr double friction     = 4.;

  /** Nodes whose slips along t1 change the reserve of the first by -z1 + 2 z2 - (z3 + ...)/10, of
   * the second by z2, of the others by z - z1/10. W is a unit matrix but for W(n1, t1) = -1/2,
   * W(n1, t2) = 1/2 and W(t1, t) = -1/10 for the others, positive definite since
   * 1 > (1/2)²/(1 - 12/10²) + (1/2)². Loads press all nodes, shear the first, or the others. */
  ToySystem
  nodes()
  {
    ToySystem result;
    const std::size_t n = 3 * n_nodes;
    result.S            = DenseMatrix(n, n);
    result.F            = DenseMatrix(n, 3);
    for (std::size_t i = 0; i < n; ++i)
      result.S(i, i) = 1.;
    result.S(0, 1) = result.S(1, 0) = -0.5;
    result.S(0, 4) = result.S(4, 0) = 0.5;
    for (std::size_t row = 6; row < n; row += 3)
      result.S(1, row + 1) = result.S(row + 1, 1) = -0.1;
    for (std::size_t row = 0; row < n; row += 3)
      {
        result.F(row, 0)                    = 1.;
        result.F(row + 1, row == 0 ? 1 : 2) = 1.;
      }
    return result;
  }

  /** Pressed by one, sheared until all are on their strength at t = 2, and then by so much more. */
  PathResult
  shear(const double first, const double others)
  {
    const ToySystem system = nodes();
    const ConeJoint joint(n_nodes, 1., make_rigid_law(), make_rigid_law(), friction);
    const LoadHistory history({0., 1., 2., 3.},
                              {{0., 0., 0.},
                               {-1., 0., 0.},
                               {-1., friction, friction},
                               {-1., friction + first, friction + others}});
    return ConeRun(system, joint.elements, history, {}).result;
  }
} // namespace

// The reserves are w1 = -1 - z1 + 2 z2 - ... and w2 = 1 + z2. By hand: w2 > 0, so that z2 = 0, and
// then w1 < 0. Without complementarity z2 = 1 were admissible: no virtual motion shows it.
TEST(ConeSearch, ProvesThatThereIsNoContinuation)
{
  const PathResult result = shear(1., -1.);
  EXPECT_EQ(result.verdict, Verdict::no_continuation);
  EXPECT_NEAR(result.t, 2., 1e-12);
  EXPECT_TRUE(result.barrier.forces.empty());
  EXPECT_TRUE(result.tried.empty());
  EXPECT_TRUE(result.critical.all_counted);
}

// With w1 = 1 - z1 + 2 z2 - ... and -1 + z for the others, z1 = 0 and one for the others.
TEST(ConeSearch, RulesOutNothingThatExists)
{
  const PathResult result = shear(-1., 1.);
  EXPECT_NE(result.verdict, Verdict::no_continuation);
}
