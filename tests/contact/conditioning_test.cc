// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"

#include <fuga/base/errors.h>
#include <fuga/contact/judge/conditioning.h>
#include <fuga/contact/path/event_path.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** One node on a spring of stiffness one in both directions, pressed and sheared on a rigid
   * joint. The shear of 1 at
   * the end is what friction 0.5 of the pressure 2 carries, but for @p reserve. */
  struct Pressed
  {
    explicit Pressed(const double reserve)
      : history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., 1. - reserve}})
    {
      node.S = node.F = DenseMatrix(2, 2);
      node.S(0, 0) = node.S(1, 1) = 1.;
      node.F(0, 0)                = -2.;
      node.F(1, 1)                = 1.;
      node.motions                = DenseMatrix(2, 0);
      node.motion_loads           = DenseMatrix(0, 2);
    }

    Conditioning
    measure() const
    {
      const LayeredSystem layered(node, joint.elements);
      return conditioning(
        [&](const LoadHistory &loads) {
          return std::make_unique<EventPath>(joint.elements, layered, loads, PathOptions());
        },
        layered,
        history,
        {2.});
    }

    ToySystem node;
    const ToyJoint joint = ToyJoint(1, 1., make_rigid_law(), make_rigid_law(), {0.5, 0.});
    const LoadHistory history;
  };

  /** A path that comes as far as it is told, and fails there. */
  class FailingPath : public EventPath
  {
  public:
    FailingPath(const ToyJoint &joint,
                const LayeredSystem &layered,
                const LoadHistory &loads,
                const double t)
      : EventPath(joint.elements, layered, loads, PathOptions()), end(t)
    {
    }

  private:
    PathResult
    follow(const std::vector<double> &, ReportCounter &observer) override
    {
      JointState state = cut.state;
      state.t          = end;
      observer.jumped(state);
      throw NumericalFailure("planted");
    }

    const double end;
  };
} // namespace

// Forces in equilibrium with the loads grow as these do: by 2^-49 of the largest, and no jump at
// all.
TEST(Conditioning, OfStatics)
{
  const Conditioning found = Pressed(0.1).measure();
  EXPECT_NEAR(found.forces, 0x1p-49, 0x1p-52);
  EXPECT_EQ(found.jumps, 0.);
  EXPECT_FALSE(found.other_end);
  EXPECT_FALSE(found.explains(1e-9));
  EXPECT_TRUE(found.explains(1e-14));
}

// What changes by more than rounding is no excuse for a wrong path, and an end that changes is one
// for small errors only.
TEST(Conditioning, OfAnEndThatChanges)
{
  Conditioning found;
  found.other_end = true;
  EXPECT_TRUE(found.explains(1e-9));
  EXPECT_FALSE(found.explains(1e-3));
  found.forces = 1.;
  EXPECT_FALSE(found.explains(1e-3));
}

// The node is pushed by 1e9 against friction of 0.5 times 2 and slides until its spring of one
// carries the rest: d = 1e9, but for 2. Body and compliance D = 1 in series resist with W = S/(1 +
// S D) = 1/2, and the largest force is the pressure of 2.
TEST(Conditioning, OfTheLastDigitOfAFarSlip)
{
  Pressed pressed(0.1);
  const ToyJoint joint(1, 1., make_rigid_law(), make_linear_law(1.), {0.5, 0.});
  const LoadHistory history({0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., 1e9}});
  const LayeredSystem layered(pressed.node, joint.elements);
  const Conditioning found = conditioning(
    [&](const LoadHistory &loads) {
      return std::make_unique<EventPath>(joint.elements, layered, loads, PathOptions());
    },
    layered,
    history,
    {2.});
  // To 2 beside 1e9, and the rounding of the scale.
  EXPECT_NEAR(found.last_digit / (0x1p-52 * 1e9 * 0.5 / 2.), 1., 1e-8);
  EXPECT_TRUE(found.explains_by_last_digit(found.last_digit));
  EXPECT_FALSE(found.explains_by_last_digit(100. * found.last_digit));
}

// A joint that never carries anything has gaps with digits, but no force beside which they would
// excuse an error: the node is pulled away from the lip by one.
TEST(Conditioning, OfAJointWithoutForces)
{
  const Pressed pressed(0.1);
  const LoadHistory history({0., 1.}, {{0., 0.}, {-1., 0.}});
  const LayeredSystem layered(pressed.node, pressed.joint.elements);
  const Conditioning found = conditioning(
    [&](const LoadHistory &loads) {
      return std::make_unique<EventPath>(pressed.joint.elements, layered, loads, PathOptions());
    },
    layered,
    history,
    {1.});
  EXPECT_EQ(found.last_digit, 0.);
  EXPECT_FALSE(found.explains_by_last_digit(1e-9));
}

// A path that fails in the same way whatever the last digits are says nothing against the data; one
// that fails only under one of the loads does.
TEST(Conditioning, OfAPathThatFails)
{
  const Pressed pressed(0.1);
  const LayeredSystem layered(pressed.node, pressed.joint.elements);
  for (const int n_failures : {3, 1})
    {
      int n_paths              = 0;
      const Conditioning found = conditioning(
        [&](const LoadHistory &loads) {
          if (n_paths++ < n_failures)
            throw NumericalFailure("planted");
          return std::make_unique<EventPath>(pressed.joint.elements, layered, loads, PathOptions());
        },
        layered,
        pressed.history,
        {2.});
      EXPECT_EQ(n_paths, 3);
      EXPECT_EQ(found.other_end, n_failures == 1);
    }
}

// Wherever it fails: two failures are not two ends.
TEST(Conditioning, OfAPathThatFailsElsewhere)
{
  const Pressed pressed(0.1);
  const LayeredSystem layered(pressed.node, pressed.joint.elements);
  double t                 = 0.5;
  const Conditioning found = conditioning(
    [&](const LoadHistory &loads) {
      return std::make_unique<FailingPath>(pressed.joint, layered, loads, t += 0.1);
    },
    layered,
    pressed.history,
    {2.});
  EXPECT_FALSE(found.other_end);
}
