// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <fuga/contact/element/rate_law.h>
#include <fuga/contact/virgin_state.h>

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

// What one element with f = 0.5 demands of given rates; all numbers by hand, exact but for
// rounding.
namespace
{
  constexpr double rounding = 1e-15;

  RateLaw
  law_in_space(const bool grazing, const ShearPosition shear)
  {
    const ConeJoint joint(1, 1., make_rigid_law(), make_rigid_law(), 0.5);
    const JointState state = virgin_state(joint.elements, 3, false);
    return {{0, grazing, shear, {{0.6, 0.8}}}, joint.elements[0], state, {{0., 0., 0.}, {}, {}}};
  }

  LocalRates
  rates_of(const double force, const TangentVector &shear)
  {
    LocalRates rates;
    rates.force = force;
    rates.shear = shear;
    return rates;
  }
} // namespace

// The shear grows by 1 along the cone's direction, the strength by 0.5 of the pressure and 0.2 by
// itself: 0.3 are too much. With 0.3 to count as nothing it stays stuck.
TEST(RateLaw, StuckOnTheConeSlipsWhereShearOutgrowsStrength)
{
  RateLaw law                = law_in_space(false, ShearPosition::at_strength);
  law.strength_rate          = 0.2;
  LocalRates rates           = rates_of(-1., {{0.6, 0.8}});
  const DemandedAnswer slips = law.demand({}, rates);
  EXPECT_EQ(slips.state, ContactState::slip_forward);
  EXPECT_EQ(slips.direction, (TangentVector{{0.6, 0.8}}));
  EXPECT_NEAR(slips.violation, 0.3, rounding);
  rates.no_shear = 0.3 + rounding;
  EXPECT_EQ(law.demand({}, rates).state, ContactState::stick);
}

// A slip that would go back, at the rate 2 against bars of stiffness 3, sticks.
TEST(RateLaw, SlipBackwardsSticks)
{
  const RateLaw law     = law_in_space(false, ShearPosition::at_strength);
  LocalRates rates      = rates_of(-1., {{0., 0.}});
  rates.slip            = -2.;
  rates.shear_stiffness = 3.;
  const RateAnswer now{ContactState::slip_forward, {{0.6, 0.8}}, 0., 0.};
  EXPECT_EQ(law.demand(now, rates).state, ContactState::stick);
  EXPECT_EQ(law.demand(now, rates).violation, 6.);
  rates.no_slip = 2.;
  EXPECT_EQ(law.demand(now, rates).state, ContactState::slip_forward);
}

// A force that grows by 0.1 beyond the tensile strength opens what may open, and nothing else.
TEST(RateLaw, OnlyWhatGrazesOpens)
{
  RateLaw grazing      = law_in_space(true, ShearPosition::at_apex);
  grazing.tension_rate = 0.4;
  EXPECT_EQ(grazing.demand({}, rates_of(0.5, {{0., 0.}})).state, ContactState::open);
  EXPECT_NEAR(grazing.demand({}, rates_of(0.5, {{0., 0.}})).violation, 0.1, rounding);
  EXPECT_EQ(grazing.demand({}, rates_of(0.3, {{0., 0.}})).state, ContactState::stick);
  const RateLaw pressed = law_in_space(false, ShearPosition::inside);
  EXPECT_EQ(pressed.demand({}, rates_of(0.5, {{9., 0.}})).state, ContactState::stick);
}

// Lips that close at the rate 1 against a stiffness of 2 press with 2 and have the strength 1; that
// they move along by (0.3, 0.4) against 10 makes a shear of 5: they slip by the rest, 4/10.
TEST(RateLaw, LipsThatCloseSlipAtFirstIfTheyMoveAlongByMore)
{
  const RateLaw law      = law_in_space(true, ShearPosition::at_apex);
  LocalRates rates       = rates_of(0., {{0., 0.}});
  rates.opening          = -1.;
  rates.velocity         = {{0.3, 0.4}};
  rates.normal_stiffness = 2.;
  rates.shear_stiffness  = 10.;
  const RateAnswer open{ContactState::open, {{1., 0.}}, 0., 0.};
  const DemandedAnswer slips = law.demand(open, rates);
  EXPECT_EQ(slips.state, ContactState::slip_forward);
  EXPECT_NEAR(slips.direction[0], 0.6, rounding);
  EXPECT_NEAR(slips.direction[1], 0.8, rounding);
  EXPECT_NEAR(slips.slip, 0.4, rounding);
  EXPECT_NEAR(slips.strength, 1., rounding);
  EXPECT_NEAR(slips.violation, 4., 4. * rounding);
  rates.velocity = {{0.06, 0.08}}; // a shear of 1: just as much as it carries
  rates.no_shear = rounding;
  EXPECT_EQ(law.demand(open, rates).state, ContactState::stick);
  rates.opening = 1.;
  EXPECT_EQ(law.demand(open, rates).state, ContactState::open);
}

// Along one tangent the direction is a sign: -1 against a strength of 0.5 is a slip backwards.
TEST(RateLaw, AlongOneTangentSlipHasASign)
{
  const ToyJoint joint(1, 1., make_rigid_law(), make_rigid_law(), {0.5, 0.});
  const JointState state = virgin_state(joint.elements, 2, false);
  const RateLaw law(
    {0, true, ShearPosition::at_apex, {{1., 0.}}}, joint.elements[0], state, {{0., 0.}, {}, {}});
  const DemandedAnswer slips = law.demand({}, rates_of(-1., {{-1., 0.}}));
  EXPECT_EQ(slips.direction, (TangentVector{{-1., 0.}}));
  EXPECT_EQ(slips.violation, 0.5);
  EXPECT_EQ(state_of(slips, joint.elements[0]), ContactState::slip_backward);
}
