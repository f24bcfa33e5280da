// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"
#include "known_answer.h"

#include <fuga/base/interruption.h>
#include <fuga/contact/rates/rate_problem.h>
#include <fuga/contact/virgin_state.h>

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <limits>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Number of continuations of V10's node at its strength, over all load rates and both signs. */
  struct Counts
  {
    unsigned int smallest = 1000;
    unsigned int largest  = 0;
  };

  Counts
  count_continuations(const double normal_stiffness)
  {
    const ToyJoint joint(
      1, 1., make_linear_law(1. / normal_stiffness), make_linear_law(1.), {2., 0.});
    ToySystem system;
    system.S       = DenseMatrix(2, 2);
    system.S(0, 0) = system.S(1, 1) = 1.;
    system.S(0, 1) = system.S(1, 0) = -0.6;
    system.F                        = DenseMatrix(2, 2);
    system.F(0, 0) = system.F(1, 1) = 1.;
    const LayeredSystem layered(system, joint.elements);
    WorkingScheme scheme(joint.elements, layered);
    RateProblem problem(joint.elements, layered, scheme);

    Counts counts;
    const int n_directions = 48;
    for (const double sign : {1., -1.})
      for (int i = 0; i < n_directions; ++i)
        {
          // Off the directions in which both rates of the boundary vanish.
          const double angle = 2. * M_PI * (i + 0.37) / n_directions;
          JointState state;
          state.states = {sign > 0. ? ContactState::slip_forward : ContactState::slip_backward};
          state.forces = {-1., 2. * sign};
          state.dislocations = {0., 0.};
          state.slips        = {{{0., 0.}}};
          state.dilations    = {0.};
          state.strengths    = {virgin_strength(joint.elements[0].friction, 1.)};
          state.unreleased   = {0., 0.};
          const Drive drive{
            multiply(layered.reactions(), Vector{std::cos(angle), std::sin(angle)}), {}, {}};
          const auto n = static_cast<unsigned int>(
            problem.branches(state, {{0, false, ShearPosition::at_strength, sign}}, drive).size());
          counts.smallest = std::min(counts.smallest, n);
          counts.largest  = std::max(counts.largest, n);
        }
    return counts;
  }
} // namespace

// The search for the rates of one event may take longer than anybody waits. In a process of its
// own: a signal stays.
TEST(RateProblemDeathTest, EndsWhenInterrupted)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto interrupted_search         = []() {
    interruption::listen();
    std::raise(SIGTERM); // SIGINT may be ignored, as in a shell in the background
    try
      {
        count_continuations(4.);
      }
    catch (const Interrupted &end)
      {
        std::cerr << end.what();
        std::_Exit(interruption::exit_code());
      }
    std::_Exit(0);
  };
  EXPECT_EXIT(interrupted_search(), testing::ExitedWithCode(143), "states of the joints");
}

// Seven faces that open in six nearly parallel ways, the seventh as the first and the second less
// the third: their equations depend on each other, however the scheme was reached. Exchanged one by
// one they leave a pivot of rounding, 1e-8 of the stiffness, and the loads P = S·1 allow a
// solution.
TEST(RateProblem, DependentEquationsAreSingularHoweverTheyCame)
{
  constexpr std::size_t n = 7;
  const ToyJoint joint(n, 1., make_rigid_law(), make_rigid_law(), {0.5, 0.});
  DenseMatrix motions(n, n - 1);
  for (std::size_t j = 0; j + 1 < n; ++j)
    {
      for (std::size_t i = 0; i + 1 < n; ++i)
        motions(i, j) = i == j ? 1.001 : 1.;
      motions(n - 1, j) = motions(0, j) + motions(1, j) - motions(2, j);
    }
  ToySystem system;
  system.S = DenseMatrix(2 * n, 2 * n);
  system.F = DenseMatrix(2 * n, 1);
  for (std::size_t i = 0; i < n; ++i)
    {
      system.S(2 * i + 1, 2 * i + 1) = 1.;
      for (std::size_t k = 0; k < n; ++k)
        {
          for (std::size_t j = 0; j + 1 < n; ++j)
            system.S(2 * i, 2 * k) += motions(i, j) * motions(k, j);
          system.F(2 * i, 0) += system.S(2 * i, 2 * k);
        }
    }
  const LayeredSystem layered(system, joint.elements);
  const Drive drive{multiply(layered.reactions(), Vector{1.}), {}, {}};
  for (const bool one_by_one : {false, true})
    {
      WorkingScheme scheme(joint.elements, layered);
      for (std::size_t k = 0; k < n; ++k)
        {
          scheme.set_state(k, ContactState::open);
          if (one_by_one && k + 1 < n)
            {
              EXPECT_TRUE(scheme.rates(drive)) << k;
            }
        }
      EXPECT_FALSE(scheme.rates(drive)) << one_by_one;
    }
}

// Two faces without friction: T1 + T2 is what the load pushes with, and no slip makes it vanish.
// The normal forces, given by statics alone, have no stiffness to be measured by; beside the
// rounding they are then measured by, the motion 8e14 times what drives it would look like one of a
// soft scheme.
TEST(RateProblem, ForcesWithoutStiffnessAllowNoMechanism)
{
  const ToyJoint joint(2, 1., make_rigid_law(), make_rigid_law(), {0., 0.});
  ToySystem system;
  system.S       = DenseMatrix(4, 4);
  system.S(1, 1) = system.S(3, 3) = 1.79391791048567706;
  system.S(1, 3) = system.S(3, 1) = -1.79391791048567528;
  system.F                        = DenseMatrix(4, 1);
  system.F(0, 0) = system.F(2, 0) = -6.4e-5;
  system.F(1, 0)                  = 2.1e-6;
  system.F(3, 0)                  = 1.1e-6;
  const LayeredSystem layered(system, joint.elements);
  WorkingScheme scheme(joint.elements, layered);
  scheme.set_state(0, ContactState::slip_forward);
  scheme.set_state(1, ContactState::slip_forward);
  EXPECT_FALSE(scheme.rates({multiply(layered.reactions(), Vector{1.}), {}, {}}));
}

// What is left of a stiffness when all that resists has been released is rounding, 1e-17 of what it
// was. Brought to the size of the others it would look like one.
TEST(RateProblem, RoundingIsNoStiffness)
{
  const auto condition = [](const LuFactors::Scaling scaling) {
    DenseMatrix M(2, 2);
    M(0, 0) = 1e-17;
    M(1, 1) = 1.;
    return LuFactors(std::move(M), scaling).reciprocal_condition();
  };
  EXPECT_NEAR(condition(LuFactors::Scaling::as_given), 1e-17, 1e-30);
  EXPECT_GT(condition(LuFactors::Scaling::equilibrated), 0.1);
}

// V10: f_c = a/|b| + (a d - b²)/(C_n |b|) with a = d = 1, b = -0.6: at f = 2 the continuation is
// unique exactly for C_n < 0.64/0.2 = 3.2; beyond it there are load rates with two and with none.
TEST(RateProblem, UniqueUpToTheCriticalFriction)
{
  const Counts below = count_continuations(3.19), above = count_continuations(3.21);
  const auto expect_count = [](const char *quantity, const double known, const unsigned int ours) {
    expect_answer({"V10 beyond critical friction", quantity, known, "closed form"}, ours, 0.);
  };
  expect_count("fewest continuations, C_n = 3.19", 1., below.smallest);
  expect_count("most continuations, C_n = 3.19", 1., below.largest);
  expect_count("fewest continuations, C_n = 3.21", 0., above.smallest);
  expect_count("most continuations, C_n = 3.21", 2., above.largest);
}

// V10's node with a rigid joint, f = 2, on its strength: a slip ṡ takes the reserve to q + (1 - 2 ∙
// 0.6) ṡ. With q > 0 there are two continuations, with q < 0 none. Of thirteen such nodes, more
// than all combinations are tried of, one has none.
TEST(RateProblem, RulesOutWhatIsTooMuchToBeTried)
{
  constexpr std::size_t n = 13;
  const ToyJoint joint(n, 1., make_rigid_law(), make_rigid_law(), {2., 0.});
  ToySystem system;
  system.S = system.F = DenseMatrix(2 * n, 2 * n);
  JointState state;
  std::vector<BoundaryElement> set;
  Vector reactions;
  for (std::size_t k = 0; k < n; ++k)
    {
      for (const std::size_t i : {2 * k, 2 * k + 1})
        system.S(i, i) = system.F(i, i) = 1.;
      system.S(2 * k, 2 * k + 1) = system.S(2 * k + 1, 2 * k) = -0.6;
      state.states.push_back(ContactState::slip_forward);
      state.forces.insert(state.forces.end(), {-1., 2.});
      state.dislocations.insert(state.dislocations.end(), {0., 0.});
      state.slips.push_back({{0., 0.}});
      state.dilations.push_back(0.);
      state.strengths.push_back(virgin_strength(joint.elements[k].friction, 1.));
      state.unreleased.insert(state.unreleased.end(), {0., 0.});
      set.push_back({k, false, ShearPosition::at_strength, 1.});
      reactions.insert(reactions.end(), {0., -1.});
    }
  const LayeredSystem layered(system, joint.elements);
  WorkingScheme scheme(joint.elements, layered);
  RateProblem problem(joint.elements, layered, scheme);
  ASSERT_FALSE(problem.can_be_enumerated(set));
  EXPECT_TRUE(problem.solve(state, set, {reactions, {}, {}}).exists);
  reactions.back()         = 1.;
  const Continuation found = problem.solve(state, set, {reactions, {}, {}});
  EXPECT_FALSE(found.exists);
  EXPECT_TRUE(found.is_ruled_out);
}

// One element on its cone, f = 0.5, N = -1, T = (0.5, 0), on a body of stiffness 1: a load along
// its slip at the rate 1e-6 makes it slip at that rate, nothing else resists. If its slip has just
// come to rest and it is held, it stays stuck and its force takes the load.
TEST(ConeRates, WhatIsHeldAtRestTakesTheLoad)
{
  constexpr double load_rate = 1e-6, whatever = std::numeric_limits<double>::max();
  const ConeJoint joint(1, 1., make_rigid_law(), make_rigid_law(), 0.5);
  ToySystem system;
  system.S = system.F = DenseMatrix(3, 3);
  for (std::size_t i = 0; i < 3; ++i)
    system.S(i, i) = system.F(i, i) = 1.;
  const LayeredSystem layered(system, joint.elements);
  WorkingScheme scheme(joint.elements, layered);
  RateProblem problem(joint.elements, layered, scheme);
  JointState state                       = virgin_state(joint.elements, 3, false);
  state.states                           = {ContactState::slip_forward};
  state.forces                           = {-1., 0.5, 0.};
  const std::vector<BoundaryElement> set = {{0, false, ShearPosition::at_strength, {{1., 0.}}}};
  const Drive drive{{0., load_rate, 0.}, {}, {}};

  const Continuation slips = problem.solve(state, set, drive, {0});
  ASSERT_TRUE(slips.exists);
  EXPECT_EQ(scheme.state(0), ContactState::slip_forward);
  EXPECT_NEAR(slips.rates.dislocations[1], load_rate, 1e-12 * load_rate); // rounding

  const Continuation rests = problem.solve(state, set, drive, {0}, whatever);
  ASSERT_TRUE(rests.exists);
  EXPECT_EQ(scheme.state(0), ContactState::stick);
  EXPECT_EQ(rests.rates.dislocations[1], 0.);
  EXPECT_NEAR(rests.rates.forces[1], load_rate, 1e-12 * load_rate);

  // Held is only what has come to rest.
  problem.solve(state, set, drive, {}, whatever);
  EXPECT_EQ(scheme.state(0), ContactState::slip_forward);
}
