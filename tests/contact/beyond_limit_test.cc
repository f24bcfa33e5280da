// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/beyond_record.h"

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr double rounding = 1e-12; // of a few dozen operations on numbers of order one
} // namespace

// V4 past its limit: all bars slip, the force stays f N while the block moves on by 5.
TEST(BeyondLimit, PlateauOfSlidingBlock)
{
  const double f = 0.2;
  const ToyJoint joint =
    rigid_block_joint(8, 1., make_linear_law(1.), make_linear_law(1.), {f, 0.});
  const ToySystem system = rigid_block(8, 1.);
  const LoadHistory history({0., 1., 2.},
                            {{0., 0., 0.}, {0., -1., -1. / 12.}, {1.1 * f, -1., -1. / 12.}});
  const auto [result, record] =
    follow_beyond_in_plane_and_space(system, joint.elements, history, 5., {1., 2.});

  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_LE(record.worst.worst(), rounding);
  EXPECT_EQ(result.beyond.end, BeyondLimit::End::largest_jump);
  EXPECT_NEAR(result.beyond.length, 5., rounding);
  EXPECT_EQ(result.beyond.t, result.t);
  ASSERT_EQ(record.beyond.size(), 1u);
  double T = 0.;
  for (std::size_t k = 0; k <= 8; ++k)
    {
      T += record.beyond[0].forces[2 * k + 1];
      // The last bar to slip had the jump 8/33 (V4: d = 0.10303 + 8 x 0.02424 =
      // 0.297).
      EXPECT_GT(record.beyond[0].slips[k][0], 5. - rounding);
    }
  EXPECT_NEAR(T, f, rounding);
}

// V3 past its limit: the block turns about its last bar, and its load stays.
TEST(BeyondLimit, PlateauOfOverturningBlock)
{
  const ToyJoint joint =
    rigid_block_joint(8, 1., make_linear_law(1.), make_linear_law(1.), {0.5, 0.});
  const ToySystem system = rigid_block(8, 1.);
  const LoadHistory history({0., 1., 2.}, {{0., 0., 0.}, {0., -1., 0.}, {0., -1., -0.6}});
  const auto [result, record] =
    follow_beyond_in_plane_and_space(system, joint.elements, history, 3., {1., 2.});
  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_LE(record.worst.worst(), rounding);
  EXPECT_EQ(result.beyond.end, BeyondLimit::End::largest_jump);
  EXPECT_NEAR(result.beyond.length, 3., rounding);
  ASSERT_FALSE(record.beyond.empty());
  EXPECT_NEAR(record.beyond.back().t, result.t, rounding);
  EXPECT_NEAR(record.beyond.back().forces[16], -1., rounding);
}

// V10 past the load with no continuation, S = [[1, -0.6], [-0.6, 1]], f = 2, F = (-1, F_t): from
// F_t = 2 on the node slips while the load falls, d_t = 5 (2 - F_t), N = -1 + 3 (2 - F_t), until it
// is unloaded at F_t = 5/3, d_t = 5/3. Then it opens, d = S⁻¹ F, and the load rises to F_t = 2
// again with d = (0.2, 1.4)/0.64: what in nature is a jump. By hand.
TEST(BeyondLimit, SnapBackBeyondCriticalFriction)
{
  const ToyJoint joint(1, 1., make_rigid_law(), make_rigid_law(), {2., 0.});
  ToySystem system;
  system.S       = DenseMatrix(2, 2);
  system.S(0, 0) = system.S(1, 1) = 1.;
  system.S(0, 1) = system.S(1, 0) = -0.6;
  system.F                        = DenseMatrix(2, 2);
  system.F(0, 0) = system.F(1, 1) = 1.;
  const LoadHistory history({0., 1., 2.}, {{0., 0.}, {-1., 0.}, {-1., 3.}});
  const auto [result, record] =
    follow_beyond_in_plane_and_space(system, joint.elements, history, 100., {1., 2.});

  EXPECT_EQ(result.verdict, Verdict::no_continuation);
  EXPECT_NEAR(result.t, 1. + 2. / 3., rounding);
  EXPECT_LE(record.worst.worst(), rounding);
  EXPECT_EQ(result.beyond.end, BeyondLimit::End::limit_regained);
  ASSERT_EQ(record.beyond.size(), 2u);
  EXPECT_NEAR(record.beyond[0].t, 1. + 5. / 9., rounding);
  EXPECT_NEAR(record.beyond[0].dislocations[1], 5. / 3., rounding);
  EXPECT_NEAR(record.beyond[0].forces[0], 0., rounding);
  EXPECT_NEAR(record.lengths[0], 5. / 3., rounding);
  EXPECT_EQ(record.beyond[1].states[0], ContactState::open);
  EXPECT_EQ(record.beyond[1].t, result.t);
  EXPECT_NEAR(record.beyond[1].dislocations[0], 0.2 / 0.64, rounding);
  EXPECT_NEAR(record.beyond[1].dislocations[1], 1.4 / 0.64, rounding);
}

// A block on three equal bars, N = 1 on each, cohesion 0.5 lost with the first slip, friction 0.6
// and then 0.4: the force rises to 3 (0.6 + 0.5) = 3.3, falls to 3 · 0.4 = 1.2 without slip, and
// stays. The elastic jump returns from 1.1 to 0.4 (C_t = 1). Load: force 4 per unit of t.
TEST(BeyondLimit, BrittleCohesionOfBlock)
{
  FrictionLaw friction;
  friction.coefficient   = 0.6;
  friction.friction_loss = 0.2;
  friction.cohesion      = 0.5;
  friction.bond_loss     = FrictionLaw::BondLoss::slip;
  const ToyJoint joint(3, 1., make_linear_law(1.), make_linear_law(1.), friction);
  const ToySystem system = rigid_block(2, 1.);
  const LoadHistory history({0., 1., 2.}, {{0., 0., 0.}, {0., -3., 0.}, {4., -3., 0.}});
  const auto [result, record] =
    follow_beyond_in_plane_and_space(system, joint.elements, history, 2.7, {1., 2.});

  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_NEAR(result.t, 1. + 3.3 / 4., rounding);
  EXPECT_LE(record.worst.worst(), rounding);
  EXPECT_EQ(result.beyond.end, BeyondLimit::End::largest_jump);
  ASSERT_EQ(record.beyond.size(), 2u);
  for (const JointState &state : record.beyond)
    {
      EXPECT_NEAR(state.t, 1. + 1.2 / 4., rounding);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(state.forces[2 * k + 1], 0.4, rounding);
    }
  EXPECT_NEAR(record.lengths[0], 0.7, rounding);
  EXPECT_NEAR(record.beyond[0].slips[0][0], 0., rounding);
  EXPECT_NEAR(record.lengths[1], 2.7, rounding);
  EXPECT_NEAR(record.beyond[1].slips[0][0], 2., rounding);
}

// V5 in the small, with bonds that break: a bar of two nodes with a spring k = 1 between them,
// pulled by P at the first; strength 1.2 (f N = 0.2, c A = 1) and 0.2 after the bond is lost. Rigid
// joints. At P = 1.2 the first bond breaks and the second takes over 1; from then on u = P - 0.2.
// At P = 1.4, u = 1.2, the second breaks. The load falls at constant u to 0.4 while the second node
// slips by 1; then the bar slides. A spring K between load and bar only adds P/K: P over u + P/K
// snaps back.
TEST(BeyondLimit, BrittleBondsOfBar)
{
  FrictionLaw friction;
  friction.coefficient = 0.2;
  friction.cohesion    = 1.;
  friction.bond_loss   = FrictionLaw::BondLoss::slip;
  const ToyJoint joint(2, 1., make_rigid_law(), make_rigid_law(), friction);
  ToySystem system; // bars N1, T1, N2, T2
  system.S       = DenseMatrix(4, 4);
  system.S(0, 0) = system.S(2, 2) = 1.;
  system.S(1, 1) = system.S(3, 3) = 1.;
  system.S(1, 3) = system.S(3, 1) = -1.;
  system.F                        = DenseMatrix(4, 2);
  system.F(0, 0) = system.F(2, 0) = -1.;
  system.F(1, 1)                  = 1.;
  const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., 2.}});
  const auto [result, record] =
    follow_beyond_in_plane_and_space(system, joint.elements, history, 3., {1., 1.65, 2.});

  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_NEAR(result.t, 1. + 1.4 / 2., rounding);
  EXPECT_LE(record.worst.worst(), rounding);
  EXPECT_NEAR(record.levels[1].slips[0][0], 1.1, rounding); // P = 1.3
  EXPECT_EQ(result.beyond.end, BeyondLimit::End::largest_jump);
  ASSERT_EQ(record.beyond.size(), 2u);
  for (const JointState &state : record.beyond)
    {
      EXPECT_NEAR(state.t, 1. + 0.4 / 2., rounding);
      EXPECT_NEAR(state.forces[1], 0.2, rounding);
      EXPECT_NEAR(state.forces[3], 0.2, rounding);
    }
  EXPECT_NEAR(record.beyond[0].slips[0][0], 1.2, rounding);
  EXPECT_NEAR(record.beyond[0].slips[1][0], 1., rounding);
  EXPECT_NEAR(record.beyond[1].slips[0][0] - record.beyond[0].slips[0][0], 2., rounding);
  EXPECT_NEAR(record.beyond[1].slips[1][0] - record.beyond[0].slips[1][0], 2., rounding);
}
