// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"

#include <fuga/contact/element/mechanism.h>

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

// Beside bars of 1e6 MN/m a force of 6e-9 MN is no resistance, but in a layer of 1e8 m/MN it takes
// up 0.6 m of a motion whose largest jump is one metre; a force of 1e-11 MN takes up a millimetre.
TEST(Mechanism, ASoftLayerThatTakesUpTheMotionIsNotFree)
{
  ToySystem bodies;
  bodies.S = DenseMatrix(4, 4);
  bodies.F = DenseMatrix(4, 1);
  for (std::size_t i = 0; i < 4; ++i)
    bodies.S(i, i) = 1e6;
  ToyJoint joint(2, 1., make_rigid_law(), make_rigid_law(), FrictionLaw());
  const std::unique_ptr<ComplianceLaw> soft = make_linear_law(1e8);
  joint.elements[1].normal_law              = soft.get();
  const LayeredSystem system(bodies, joint.elements);
  const std::size_t bar = joint.elements[1].normal_bar;
  JointRates motion;
  motion.dislocations = {0., 1., 0., 0.};
  motion.forces       = {0., 0., 0., 0.};
  EXPECT_TRUE(is_free_motion(motion, system));
  motion.forces[bar] = -6e-9;
  EXPECT_FALSE(is_free_motion(motion, system));
  motion.forces[bar] = -1e-11;
  EXPECT_TRUE(is_free_motion(motion, system));
}
