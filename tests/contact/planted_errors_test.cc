// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// The judge must find what is wrong in a state, also where a body moves by far more than it
// deforms.

#include "contact/toy_system.h"

#include <fuga/base/errors.h>
#include <fuga/base/numerics/accurate.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/virgin_state.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr std::size_t n = 40, last = n - 1, somewhere = 12, elsewhere = 25;
  /** Compliance of the joint, stiffness of the chain one, load of a node one, friction. */
  constexpr double D = 1e3, f = 0.3;
  /** The largest force of the scene; 12 would be needed to slide. */
  constexpr double shear = 10.;
  /** Share of the force or jump concerned. */
  constexpr double error = 1e-9;

  /** Nodes one after the other, held together by springs of stiffness one in both directions, and
   * by nothing else: their joint is a thousand times softer than they are. Load 0 presses every
   * node, load 1 shears the last one. */
  ToySystem
  floating_chain()
  {
    ToySystem chain;
    chain.S       = DenseMatrix(2 * n, 2 * n);
    chain.F       = DenseMatrix(2 * n, 2);
    chain.motions = DenseMatrix(2 * n, 2);
    for (std::size_t node = 0; node < n; ++node)
      for (std::size_t c = 0; c < 2; ++c)
        {
          const std::size_t i = 2 * node + c;
          chain.motions(i, c) = 1.;
          chain.S(i, i)       = node == 0 || node == last ? 1. : 2.;
          if (node < last)
            chain.S(i, i + 2) = chain.S(i + 2, i) = -1.;
          if (c == 0)
            chain.F(i, 0) = -1.;
        }
    chain.F(2 * last + 1, 1) = 1.;
    chain.motion_loads       = multiply_transposed(chain.motions, chain.F);
    return chain;
  }

  class PlantedErrors : public testing::Test
  {
  protected:
    PlantedErrors()
    {
      const LayeredSystem layered(chain, joint.elements);
      EventPath path(joint.elements, layered, history, {});
      path.run({2.}, record);
      EXPECT_EQ(record.levels.size(), 1u);
      state = record.levels.at(0);
    }

    /** The certificate of the state after @p plant has spoilt it. */
    Certificate
    judge(const std::function<void(JointState &)> &plant) const
    {
      JointState planted = state;
      plant(planted);
      Judge copy = record.judge;
      return copy.judge(planted);
    }

    const ToySystem chain = floating_chain();
    const ToyJoint joint  = ToyJoint(n, 1., make_linear_law(D), make_linear_law(D), {f, 0.});
    const LoadHistory history{{0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., shear}}};
    Record record{chain, joint.elements, history};
    JointState state;
  };
} // namespace

// Every node carries its load, 1, and the shear lets the last ones slip: that
// the state is right to 1e-12 is the premise of what follows.
TEST_F(PlantedErrors, NoneIsSeenWithout)
{
  EXPECT_NEAR(state.forces[0], -1., 1e-9);
  EXPECT_EQ(state.states[0], ContactState::stick);
  EXPECT_EQ(state.states[last], ContactState::slip_forward);
  EXPECT_LE(record.worst.worst(), 1e-12);
}

// Two normal forces, one larger, one smaller by e: the joint gives way by D e there, the chain
// answers with 2 D e (two springs), so equilibrium is missed by (1 + 2 D) e. One percent: what the
// judge concedes to rounding is less than a thousandth of it.
TEST_F(PlantedErrors, ForcesThatDoNotBalance)
{
  const Certificate found = judge([](JointState &planted) {
    planted.forces[2 * somewhere] += error;
    planted.forces[2 * elsewhere] -= error;
  });
  const double known      = (1. + 2. * D) * error / shear;
  EXPECT_NEAR(found.equilibrium, known, 0.01 * known);
  EXPECT_LE(found.body_equilibrium, 1e-13);
}

// A comparison with something that is not a number is never true: it must not pass for no error,
// neither in one state nor after others that are right.
TEST_F(PlantedErrors, WhatIsNotANumber)
{
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (const auto &plant : std::vector<std::function<void(JointState &)>>{
         [](JointState &planted) { planted.forces[2 * somewhere] = not_a_number; },
         [](JointState &planted) { planted.forces[2 * somewhere + 1] = not_a_number; },
         [](JointState &planted) { planted.dislocations[2 * somewhere] = not_a_number; },
         [](JointState &planted) { planted.slips[last][0] = not_a_number; },
         [](JointState &planted) { planted.forces[0] = std::numeric_limits<double>::infinity(); }})
    {
      Certificate found = judge(plant);
      EXPECT_TRUE(std::isnan(found.worst()));
      found.absorb(judge([](JointState &) {}));
      EXPECT_TRUE(std::isnan(found.worst()));
    }
}

// Errors are shares of the largest jump on the way, also where no state that has it was judged.
TEST_F(PlantedErrors, TheWayGivesTheScale)
{
  Judge judge(chain, joint.elements, history);
  const JointState start   = virgin_state(joint.elements, 2 * n, false);
  const JointRates nothing = {Vector(2 * n, 0.), Vector(2 * n, 0.)};
  judge.follow({start, nothing}, {state, nothing}, 0.);
  JointState planted      = start;
  planted.states[0]       = ContactState::open;
  planted.dislocations[0] = -error;
  double largest          = 0.;
  for (std::size_t bar = 0; bar < 2 * n; ++bar)
    largest = std::max(largest, std::abs(state.dislocations[bar] + D * state.forces[bar]));
  EXPECT_NEAR(judge.judge(planted).penetration, error / largest, 1e-6 * error / largest);
}

// All normal forces too large by the same: the chain moves as a rigid body and feels nothing but
// the forces themselves, whose sum is wrong by n e.
TEST_F(PlantedErrors, ABodyOutOfEquilibrium)
{
  const Certificate found = judge([](JointState &planted) {
    for (std::size_t node = 0; node < n; ++node)
      planted.forces[2 * node] += error;
  });
  EXPECT_NEAR(found.body_equilibrium, n * error / shear, 0.01 * n * error / shear);
}

// A stuck element slips by a share of the largest jump.
TEST_F(PlantedErrors, SlipOfAStuckElement)
{
  const std::size_t bar = 2 * somewhere + 1;
  const double largest  = record.judge.memory().largest_jump;
  const Certificate found =
    judge([&](JointState &planted) { planted.dislocations[bar] += error * largest; });
  EXPECT_NEAR(found.layer_law, error, 0.01 * error);
  EXPECT_NEAR(found.equilibrium, 2. * error * largest / shear, 0.02 * error * largest / shear);
}

// A slipping element with more shear than its strength f N allows.
TEST_F(PlantedErrors, ShearBeyondTheStrength)
{
  const double strength = f * std::abs(state.forces[2 * last]);
  const Certificate found =
    judge([&](JointState &planted) { planted.forces[2 * last + 1] += error * strength; });
  EXPECT_NEAR(found.cone, error * strength / shear, 0.01 * error * strength / shear);
  EXPECT_NEAR(found.slip_direction, error * strength / shear, 0.01 * error * strength / shear);
}

namespace
{
  /** The chain at its limit, f N n = 12, with the motion in which it slides as a whole. */
  class PlantedMechanisms : public PlantedErrors
  {
  protected:
    PlantedMechanisms()
    {
      const LayeredSystem layered(chain, joint.elements);
      EventPath path(joint.elements, layered, beyond, {});
      const PathResult result = path.run({}, at_limit);
      EXPECT_EQ(result.verdict, Verdict::limit_load);
      EXPECT_NEAR(result.t, 1. + f * n / (2. * shear), 1e-9);
      motion = result.mechanism_jumps;
    }

    /** The certificate of the motion after @p plant has changed it. */
    MechanismCertificate
    judge_motion(const std::function<void(Vector &)> &plant) const
    {
      Vector planted = motion;
      plant(planted);
      return at_limit.judge.judge_mechanism(at_limit.last, planted);
    }

    const LoadHistory beyond{{0., 1., 2.}, {{0., 0.}, {1., 0.}, {1., 2. * shear}}};
    Record at_limit{chain, joint.elements, beyond};
    Vector motion;
  };
} // namespace

// The load does all the work on the growth of the load: nothing dissipates more while forces rest.
TEST_F(PlantedMechanisms, NoneIsSeenWithout)
{
  for (std::size_t node = 0; node < n; ++node)
    {
      EXPECT_NEAR(motion[2 * node], 0., 1e-9);
      EXPECT_NEAR(motion[2 * node + 1], 1., 1e-9);
    }
  const MechanismCertificate found = judge_motion([](Vector &) {});
  EXPECT_LE(found.error(), 1e-9);
  EXPECT_NEAR(found.drive, 1., 1e-12);
}

// Backwards: slip against the force, a load that does negative work.
TEST_F(PlantedMechanisms, AMotionAgainstTheLoad)
{
  const MechanismCertificate found = judge_motion([](Vector &planted) {
    for (double &jump : planted)
      jump = -jump;
  });
  EXPECT_NEAR(found.inadmissible, 2., 1e-9);
  EXPECT_NEAR(found.drive, -1., 1e-12);
}

// Lips that go into each other by e, or come apart although they are pressed.
TEST_F(PlantedMechanisms, PenetrationAndOpening)
{
  for (const double sign : {-1., 1.})
    {
      const MechanismCertificate found = judge_motion([sign](Vector &planted) {
        for (std::size_t node = 0; node < n; ++node)
          planted[2 * node] += sign * 1e-3;
      });
      EXPECT_NEAR(found.inadmissible, 1e-3, 1e-9);
    }
}

// One node moves on by e: its two springs answer 2 e, its neighbours' one, beside the row
// (-1, 2, -1) of S, whose norm is √6.
TEST_F(PlantedMechanisms, ABodyThatDeforms)
{
  const MechanismCertificate found =
    judge_motion([](Vector &planted) { planted[2 * somewhere + 1] += 1e-3; });
  EXPECT_NEAR(found.resistance, 2e-3 / std::sqrt(6.) / 1.001, 1e-8);
}

// The judge finds the motion of the limit by itself, whatever the path says; below the limit there
// is none, nor under a load that falls, but where it waits for strength that is lost.
TEST_F(PlantedMechanisms, TheJudgeFindsTheDrivenMotion)
{
  const std::optional<Vector> found = at_limit.judge.driven_motion(at_limit.last);
  ASSERT_TRUE(found);
  for (std::size_t node = 0; node < n; ++node)
    {
      EXPECT_NEAR((*found)[2 * node], 0., 1e-12);
      EXPECT_NEAR((*found)[2 * node + 1], 1., 1e-12);
    }
  JointState below = at_limit.last;
  below.forces[2 * somewhere + 1] *= 0.9;
  EXPECT_FALSE(at_limit.judge.driven_motion(below));

  const LoadHistory falling{{0., 1., 2.}, {{0., 0.}, {1., 2. * shear}, {1., 0.}}};
  JointState at_fall = at_limit.last;
  at_fall.t          = 1.5;
  Judge judge(chain, joint.elements, falling);
  judge.judge(at_limit.last);
  EXPECT_FALSE(judge.driven_motion(at_fall));
  at_fall.unreleased.assign(at_fall.forces.size(), 0.);
  for (std::size_t node = 0; node < n; ++node)
    at_fall.unreleased[2 * node + 1] = 0.1 * at_fall.forces[2 * node + 1];
  EXPECT_TRUE(judge.driven_motion(at_fall));
  EXPECT_NEAR(judge.judge_mechanism(at_fall, motion).drive, 1., 1e-12);
}

// A load that takes weight from the chain while the shear stays does no work on the motion in which
// it slides, but no change of forces balances it: on the motion that rises by the angle of friction
// it does.
TEST_F(PlantedMechanisms, AStrengthThatTheLoadTakesAway)
{
  const LoadHistory lighter{{0., 1., 2.}, {{0., 0.}, {1., 12.}, {0.5, 12.}}};
  JointState at_strength = at_limit.last;
  at_strength.t          = 1.;
  Judge judge(chain, joint.elements, lighter);
  judge.judge(at_limit.last);
  EXPECT_FALSE(judge.driven_motion(at_strength));
  const std::optional<Vector> found =
    judge.driven_motion(at_strength, Judge::Motions::resisted_by_none);
  ASSERT_TRUE(found);
  for (std::size_t node = 0; node < n; ++node)
    {
      EXPECT_NEAR((*found)[2 * node], f, 1e-12);
      EXPECT_NEAR((*found)[2 * node + 1], 1., 1e-12);
    }
  EXPECT_NEAR(judge.judge_mechanism(at_strength, motion).drive, 1., 1e-12);
  // The chain slides, which the contact allows, though the load does not push it.
  PathResult lost;
  lost.verdict = Verdict::no_continuation;
  lost.tried   = "Nothing was found";
  const LayeredSystem layered(chain, joint.elements);
  EXPECT_TRUE(prove_limit(judge, joint.elements, layered, at_strength, lost).proves());
  EXPECT_EQ(lost.verdict, Verdict::limit_load);
  EXPECT_EQ(lost.mechanism, MechanismKind::sliding);
  for (std::size_t node = 0; node < n; ++node)
    EXPECT_NEAR(lost.mechanism_jumps[2 * node + 1], 1., 1e-12);
  const LoadHistory heavier{{0., 1., 2.}, {{0., 0.}, {1., 12.}, {2., 12.}}};
  Judge judge_of_heavier(chain, joint.elements, heavier);
  judge_of_heavier.judge(at_limit.last);
  EXPECT_FALSE(judge_of_heavier.mechanism(at_strength));
  EXPECT_LE(judge_of_heavier.judge_mechanism(at_strength, motion).drive, 0.);
}

// A wrong motion of a right limit is replaced; a limit where no motion proves it is a failure.
TEST_F(PlantedMechanisms, AVerdictNeedsAProof)
{
  const LayeredSystem layered(chain, joint.elements);
  PathResult planted;
  planted.verdict         = Verdict::limit_load;
  planted.mechanism_jumps = motion;
  planted.mechanism_jumps[2 * somewhere + 1] += 1.;
  EXPECT_FALSE(at_limit.judge.judge_mechanism(at_limit.last, planted.mechanism_jumps).proves());
  JointState below = at_limit.last;
  below.forces[2 * somewhere + 1] *= 0.9;
  PathResult unproven = planted;
  EXPECT_THROW(prove_limit(at_limit.judge, joint.elements, layered, below, unproven),
               NumericalFailure);
  const LimitProof proof =
    prove_limit(at_limit.judge, joint.elements, layered, at_limit.last, planted);
  EXPECT_TRUE(proof.proves());
  EXPECT_EQ(planted.mechanism, MechanismKind::sliding);
  for (std::size_t node = 0; node < n; ++node)
    EXPECT_NEAR(planted.mechanism_jumps[2 * node + 1], 1., 1e-12);
}

// A path that found no continuation has met a limit load if a motion proves it, and not else.
TEST_F(PlantedMechanisms, NoContinuationMayBeALimitLoad)
{
  const LayeredSystem layered(chain, joint.elements);
  PathResult lost;
  lost.verdict    = Verdict::no_continuation;
  JointState held = at_limit.last;
  held.forces[2 * somewhere + 1] *= 0.9;
  prove_limit(at_limit.judge, joint.elements, layered, held, lost);
  EXPECT_EQ(lost.verdict, Verdict::no_continuation);
  prove_limit(at_limit.judge, joint.elements, layered, at_limit.last, lost);
  EXPECT_EQ(lost.verdict, Verdict::limit_load);
  EXPECT_EQ(lost.mechanism, MechanismKind::sliding);
}

// What was only not found is shown by a jump that stays as large with less load before it.
TEST_F(PlantedMechanisms, NoContinuationMayBeShownByAJump)
{
  const LayeredSystem layered(chain, joint.elements);
  PathResult lost;
  lost.verdict    = Verdict::no_continuation;
  lost.tried      = "Something";
  lost.jump       = {true, 1., 1e-6, 1., 2., 1., 0.01};
  JointState held = at_limit.last;
  held.forces[2 * somewhere + 1] *= 0.9;
  EXPECT_THROW(prove_limit(at_limit.judge, joint.elements, layered, held, lost), NumericalFailure);
  lost.jump.size_nearer = 1.;
  prove_limit(at_limit.judge, joint.elements, layered, held, lost);
  EXPECT_EQ(lost.verdict, Verdict::no_continuation);
  EXPECT_TRUE(lost.tried.empty());
  lost.tried           = "Something";
  lost.jump.dissipated = 2.;
  EXPECT_THROW(prove_limit(at_limit.judge, joint.elements, layered, held, lost), NumericalFailure);
}

// Sums that cancel: 2^60 + 1 - 2^60 loses the one in double precision, and so does what the second
// number of the vector has beyond double.
TEST(Accurate, ProductsKeepWhatDoubleLoses)
{
  DenseMatrix A(9, 3);
  const double large = std::pow(2., 60);
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    {
      A(i, 0) = large;
      A(i, 1) = 1. + static_cast<double>(i);
      A(i, 2) = -large;
    }
  const long double little = std::pow(2.L, -30), tiny = std::pow(2.L, -62);
  Accurate y(9, little);
  add_product(-1.L, A, {1.L, 1.L, 1.L + tiny}, y);
  for (std::size_t i = 0; i < y.size(); ++i)
    EXPECT_EQ(y[i], little - (1.L + static_cast<long double>(i)) + 0.25L) << i;
}
