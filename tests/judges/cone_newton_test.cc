// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// One element on springs k, so that T = F_t - k s and N = F_n - k d_n: everything is known by hand.

#include "judges/cone_newton.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::judges;

namespace
{
  constexpr double k = 2., f = 0.5;

  /** Stiffness k against the normal and @p k_t against the tangential jumps. */
  ConeNewton
  one_element(const double k_t, ConeElement element = {})
  {
    DenseMatrix S(3, 3), unit(3, 3);
    S(0, 0) = k;
    S(1, 1) = S(2, 2) = k_t;
    for (unsigned int i = 0; i < 3; ++i)
      unit(i, i) = 1.;
    element.tangential_bars = {1, 2};
    element.friction        = f;
    return ConeNewton(S, DenseMatrix(), unit, {element});
  }

  void
  expect_near(const Vector &found, const Vector &expected)
  {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-13) << "entry " << i;
  }
} // namespace

TEST(ConeNewton, SlipsAlongTheForceFromTheVirginState)
{
  const ConeNewton newton = one_element(k);
  ASSERT_TRUE(newton.is_regular());
  const Vector none(3, 0.), load = {-5., 3., 4.}; // |T| = 5 > f P = 2.5
  const ConeStep step = newton.step(none, none, load);
  ASSERT_TRUE(step.converged);
  expect_near(step.state.dislocations, {0., 0.75, 1.}); // (5 - 2.5)/k along (0.6, 0.8)
  expect_near(step.state.forces, {-5., 1.5, 2.});
  EXPECT_LT(newton.residual(none, load, step.state), 1e-13);
}

TEST(ConeNewton, TurnsWithTheForceFromEarlierSlip)
{
  const ConeNewton newton = one_element(k);
  const Vector before = {0., 0.75, 1.}, load_before = {-5., 3., 4.}, load = {-5., 6., 1.};
  const ConeStep step = newton.step(before, load_before, load);
  ASSERT_TRUE(step.converged);
  const Vector trial  = {6. - k * 0.75, 1. - k * 1.};
  const double length = std::hypot(trial[0], trial[1]), slip = (length - 2.5) / k;
  expect_near(step.state.dislocations,
              {0., 0.75 + slip * trial[0] / length, 1. + slip * trial[1] / length});
  EXPECT_LT(newton.residual(before, load, step.state), 1e-13);
}

TEST(ConeNewton, SticksInsideTheConeAndOpensUnderTension)
{
  const ConeNewton newton = one_element(k);
  const Vector none(3, 0.);
  const ConeStep stuck = newton.step(none, none, {-5., 1., 2.});
  ASSERT_TRUE(stuck.converged);
  expect_near(stuck.state.dislocations, none);
  const ConeStep open = newton.step(none, none, {3., 1., 2.});
  ASSERT_TRUE(open.converged);
  expect_near(open.state.dislocations, {1.5, 0.5, 1.}); // F/k
  expect_near(open.state.forces, none);
}

TEST(ConeNewton, CohesionHoldsUntilTheJointOpens)
{
  ConeElement bonded;
  bonded.cohesion         = 1.;
  const ConeNewton newton = one_element(k, bonded);
  const Vector none(3, 0.), load = {-5., 3., 4.}; // |T| = 5 > f P + c A = 3.5
  const ConeStep step = newton.step(none, none, load);
  ASSERT_TRUE(step.converged);
  expect_near(step.state.dislocations, {0., 0.45, 0.6}); // (5 - 3.5)/k along (0.6, 0.8)
  expect_near(step.state.forces, {-5., 2.1, 2.8});
  EXPECT_LT(newton.residual(none, load, step.state), 1e-13);
  EXPECT_GT(one_element(k).residual(none, load, step.state), 0.1); // the bond is lost
  const ConeStep open = newton.step(none, none, {3., 1., 2.});
  ASSERT_TRUE(open.converged);
  expect_near(open.state.forces, none);
}

TEST(ConeNewton, ClosesALayerAlongItsCurve)
{
  ConeElement curved;
  curved.normal_compliance = 1.;
  curved.stress            = [](const double w) { return w + w * w; };
  curved.tangent           = [](const double w) { return 1. + 2. * w; };
  const ConeNewton newton  = one_element(k, curved);
  const Vector none(3, 0.), load = {-10., 3., 4.}; // k w + w + w² = 10: w = 2, P = 6, f P = 3
  const ConeStep step = newton.step(none, none, load);
  ASSERT_TRUE(step.converged);
  expect_near(step.state.dislocations, {-2., 0.6, 0.8}); // (5 - 3)/k along (0.6, 0.8)
  expect_near(step.state.forces, {-6., 1.8, 2.4});
  EXPECT_LT(newton.residual(none, load, step.state), 1e-13);
}

TEST(ConeNewton, FindsNothingWhereNothingHolds)
{
  const ConeNewton newton = one_element(0.);
  const Vector none(3, 0.);
  EXPECT_TRUE(newton.step(none, none, {-5., 1., 2.}).converged);
  EXPECT_FALSE(newton.step(none, none, {-5., 2., 2.}).converged); // |T| = 2.83 > 2.5
}

TEST(ConeNewton, ResidualSeesEveryViolation)
{
  const ConeNewton newton = one_element(k);
  const Vector none(3, 0.), load = {-5., 1., 2.};
  const ConeState right = newton.step(none, none, load).state;
  // No equilibrium; slip inside the cone; open under pressure.
  for (const auto &[d, p] : {std::make_pair(none, Vector{-4., 1., 2.}),
                             std::make_pair(Vector{0., 0.1, 0.}, Vector{-5., 0.8, 2.}),
                             std::make_pair(Vector{0.5, 0., 0.}, Vector{-6., 1., 2.})})
    EXPECT_GT(newton.residual(none, load, {p, d}), 1e-2);
  EXPECT_LT(newton.residual(none, load, right), 1e-14);
}
