// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"
#include "known_answer.h"

#include <fuga/contact/judge/limit_proof.h>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Event loads come from a few divisions of numbers of order one. */
  constexpr double event_tolerance = 1e-12;
} // namespace

// V1, Code_Aster SSND116A: all numbers are exact fractions that follow by hand from the springs in
// series and Coulomb's law.
TEST(EventPath, OneBarWithGapSlipAndReversal)
{
  ToyJoint joint(1, 1., make_linear_law(1.), make_linear_law(2.), {0.5, 0.});
  joint.elements[0].initial_gap = 0.5;
  ToySystem system;
  system.S       = DenseMatrix(2, 2);
  system.S(0, 0) = system.S(1, 1) = 1.;
  system.F                        = DenseMatrix(2, 2);
  system.F(0, 0)                  = -1.; // pressing
  system.F(1, 1)                  = 1.;
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 1.5, 2.}, {{0., 0.}, {1., 0.}, {1., 2.}, {1., 0.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  const PathResult result = path.run({1., 1.05, 1.5, 1.55, 2.}, record);

  EXPECT_LE(record.worst.worst(), event_tolerance);
  EXPECT_EQ(result.verdict, Verdict::done);
  ASSERT_EQ(record.events.size(), 4u);
  const double times[]        = {0.5, 1.09375, 1.5, 1.6875};
  const ContactState states[] = {ContactState::stick,
                                 ContactState::slip_forward,
                                 ContactState::stick,
                                 ContactState::slip_backward};
  for (std::size_t i = 0; i < 4; ++i)
    {
      expect_answer(
        {"V1 one bar", fmt::format("t of event {}", i + 1), times[i], "SSND116A, closed form"},
        record.events[i].t,
        event_tolerance);
      EXPECT_EQ(record.events[i].to, states[i]);
    }
  ASSERT_EQ(record.levels.size(), 5u);
  const auto jump = [&](const std::size_t level, const std::size_t bar) {
    return layered.jumps(record.levels[level].dislocations, record.levels[level].forces)[bar];
  };
  const auto expect_jump = [&](const char *name, const double known, const double ours) {
    expect_answer({"V1 one bar", name, known, "SSND116A, closed form"}, ours, event_tolerance);
  };
  expect_jump("u_n(1)", -0.75, jump(0, 0));
  expect_jump("u_t(1.05)", 2. / 15., jump(1, 1));
  expect_jump("u_t(1.5)", 1.875, jump(2, 1));
  expect_jump("u_t(1.55)", 1.8 - 0.35 / 6., jump(3, 1));
  expect_jump("u_t(2)", 0.125, jump(4, 1));
}

// A rigid body on two elements, which all but share their jump (stiffness k), slides by one against
// a spring and back: forces of one are differences of terms of 1e7. With the pressures 1 and 2, f =
// 1/2 and the push P = T1 + T2 + 2s (d1 + d2), s = 1/4: both slide beyond P = 3/2, d1 = d2 = 1 at P
// = 5/2; then both stick, until T1 = 1/2 - (5/2 - P)/2 = -1/2 at P = 1/2. The load has a corner
// 4e-7 before, where T1 is short of its strength by 2e-7 and nothing happens. Forces, differences
// of two terms of k whose last digits depend on the kernels of the BLAS, are known to four of
// these, and so is the load of the event, at a rate of 0.2 of T1.
TEST(EventPath, SmallDifferencesOfLargeTermsReachTheirStrengthWhereTheyDo)
{
  constexpr double k = 1e7, s = 0.25, before = 4e-7, unloading = 0.4;
  constexpr double digits = 4. * std::numeric_limits<double>::epsilon() * k / (0.5 * unloading);
  const ToyJoint joint(2, 1., make_rigid_law(), make_rigid_law(), {0.5, 0.});
  ToySystem system;
  system.S       = DenseMatrix(4, 4);
  system.F       = DenseMatrix(4, 2);
  system.S(1, 1) = system.S(3, 3) = k + s;
  system.S(1, 3) = system.S(3, 1) = s - k;
  system.F(0, 0)                  = -1.;
  system.F(2, 0)                  = -2.;
  system.F(1, 1) = system.F(3, 1) = 0.5;
  const double corner             = 0.5 + before;
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history(
    {0., 1., 2., 3., 4.}, {{0., 0.}, {1., 0.}, {1., 2.5}, {1., corner}, {1., corner - unloading}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  ASSERT_EQ(path.run({4.}, record).verdict, Verdict::done);
  ASSERT_EQ(record.events.size(), 5u);
  EXPECT_EQ(record.events.back().element, 0u);
  EXPECT_NEAR(record.events.back().t, 3. + before / unloading, digits);
  EXPECT_LE(record.worst.worst(), digits);
}

// Lips that rise as they slide under a normal force that statics alone gives: nothing resists their
// rise. By hand, from T = H - s = f on: s = H - f and a rise of s tan psi, while N stays -1.
TEST(EventPath, LipsRiseUnderAGivenForce)
{
  FrictionLaw law;
  law.coefficient = 0.5;
  law.dilatancy   = 0.2;
  const ToyJoint joint(1, 1., make_rigid_law(), make_rigid_law(), law);
  ToySystem system;
  system.S       = DenseMatrix(2, 2);
  system.F       = DenseMatrix(2, 2);
  system.S(1, 1) = system.F(0, 0) = system.F(1, 1) = 1.;
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2.}, {{0., 0.}, {-1., 0.}, {-1., 1.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  ASSERT_EQ(path.run({1., 2.}, record).verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), event_tolerance);
  EXPECT_NEAR(record.last.forces[0], -1., event_tolerance);
  EXPECT_NEAR(record.last.slips[0][0], 0.5, event_tolerance);
  EXPECT_NEAR(layered.jumps(record.last.dislocations, record.last.forces)[0], 0.1, event_tolerance);
}

// A body that only the friction under another one holds is left alone as that is lifted off: it is
// free to move, but nothing drives it. The path goes on; by hand N = a/2 while the joint is closed,
// and jumps of a thereafter.
TEST(EventPath, BodyThatNothingDrivesRests)
{
  const ToyJoint joint(1, 1., make_linear_law(1.), make_linear_law(1.), {0.5, 0.});
  ToySystem system;
  system.S             = DenseMatrix(2, 2);
  system.F             = DenseMatrix(2, 1);
  system.motions       = DenseMatrix(2, 1);
  system.motion_loads  = DenseMatrix(1, 1);
  system.S(0, 0)       = 1.;
  system.F(0, 0)       = 1.;
  system.motions(1, 0) = 1.;
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2.}, {{0.}, {-1.}, {1.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  ASSERT_EQ(path.run({1., 2.}, record).verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), event_tolerance);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_NEAR(record.events[0].t, 1.5, event_tolerance);
  EXPECT_NEAR(record.levels[0].forces[0], -0.5, event_tolerance);
  EXPECT_NEAR(record.last.dislocations[0], 1., event_tolerance);
  EXPECT_NEAR(record.last.dislocations[1], 0., event_tolerance);
}

// Nodes on [[1, -0.6], [-0.6, 1]] beside each other, rigid joints, f = 2 > 1/0.6: on their
// strength, at t = 1 + 2/3, none can go on. Of twelve all 2^12 combinations are tried, those of
// thirteen are ruled out by a proof.
TEST(EventPath, NoContinuationIsAVerdictWhereAllWasTriedOrRuledOut)
{
  for (const std::size_t n : {12, 13})
    {
      const ToyJoint joint(n, 1., make_rigid_law(), make_rigid_law(), {2., 0.});
      ToySystem system;
      system.S = DenseMatrix(2 * n, 2 * n);
      system.F = DenseMatrix(2 * n, 2);
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t a = 0; a < 2; ++a)
          {
            system.S(2 * k + a, 2 * k + a)     = 1.;
            system.S(2 * k + a, 2 * k + 1 - a) = -0.6;
            system.F(2 * k + a, a)             = 1.;
          }
      const LayeredSystem layered(system, joint.elements);
      const LoadHistory history({0., 1., 2.}, {{0., 0.}, {-1., 0.}, {-1., 3.}});
      EventPath path(joint.elements, layered, history, {});
      Record record(system, joint.elements, history);
      PathResult result = path.run({}, record);
      EXPECT_EQ(result.verdict, Verdict::no_continuation);
      EXPECT_NEAR(result.t, 1. + 2. / 3., event_tolerance);
      const auto prove = [&] {
        prove_limit(record.judge, joint.elements, layered, record.last, result);
      };
      EXPECT_NO_THROW(prove());
      EXPECT_TRUE(result.critical.all_counted);
    }
}

// V4: H(d) of bars that slip one after the other, by hand to nine digits and
// exact as fractions: d_k = (f k_n / k_t) w_k, H = Σ min(C_t d, f N_k).
TEST(EventPath, ProgressiveSlipOfRigidBlock)
{
  const std::size_t n = 8;
  const double f      = 0.2;
  const ToyJoint joint =
    rigid_block_joint(n, 1., make_linear_law(1.), make_linear_law(1.), {f, 0.});
  const ToySystem system = rigid_block(n, 1.);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2.},
                            {{0., 0., 0.}, {0., -1., -1. / 12.}, {1.1 * f, -1., -1. / 12.}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  const PathResult result = path.run({1., 2.}, record);

  EXPECT_LE(record.worst.worst(), event_tolerance);
  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_EQ(result.mechanism, MechanismKind::sliding);
  EXPECT_NEAR(result.t, 1. + 1. / 1.1, 1e-9);
  const double h[] = {0.515151515,
                      0.628787879,
                      0.727272727,
                      0.810606061,
                      0.878787879,
                      0.931818182,
                      0.969696970,
                      0.992424242,
                      1.};
  ASSERT_EQ(record.events.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i)
    expect_answer({"V4 progressive slip of the rigid block",
                   fmt::format("H/(fN) of slip {}", i + 1),
                   h[i],
                   "closed form"},
                  (record.events[i].t - 1.) * 1.1,
                  1e-9);
}

// V3: opening under a growing eccentricity, nine bars; the list by hand, exact as
// fractions (contact of m bars ends where the edge bar of the trapezoidal distribution is
// unloaded).
TEST(EventPath, EccentricLoadOnRigidBlock)
{
  const std::size_t n = 8;
  const ToyJoint joint =
    rigid_block_joint(n, 1., make_linear_law(1.), make_linear_law(1.), {0.5, 0.});
  const ToySystem system = rigid_block(n, 1.);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2.}, {{0., 0., 0.}, {0., -1., 0.}, {0., -1., -0.6}});
  EventPath path(joint.elements, layered, history, {});
  Record record(system, joint.elements, history);
  const PathResult result = path.run({1., 2.}, record);

  EXPECT_LE(record.worst.worst(), event_tolerance);
  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_EQ(result.mechanism, MechanismKind::overturning);
  // The last bar alone carries the load from e = 4/9 on: the discrete block topples there.
  const double e[] = {0.171875, 0.214285714, 0.256944444, 0.3, 0.34375, 0.388888889, 0.4375};
  ASSERT_GE(record.events.size(), 7u);
  for (std::size_t i = 0; i < 7; ++i)
    expect_answer({"V3 rigid block, eccentric load",
                   fmt::format("e/b of opening {}", i + 1),
                   e[i],
                   "closed form"},
                  (record.events[i].t - 1.) * 0.6,
                  1e-9);
}

// A monotone stage in one implicit step ends in the state the events lead to (here exactly known to
// be the same: every bar that slips keeps slipping).
TEST(EventPath, ImplicitStepEndsWhereEventsEnd)
{
  const std::size_t n = 8;
  const double f      = 0.2;
  const ToyJoint joint =
    rigid_block_joint(n, 1., make_linear_law(1.), make_linear_law(1.), {f, 0.});
  const ToySystem system = rigid_block(n, 1.);
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1., 2.},
                            {{0., 0., 0.}, {0., -1., -1. / 12.}, {0.95 * f, -1., -1. / 12.}});
  PathOptions ends;
  ends.follow = PathOptions::Follow::stage_ends;
  EventPath by_events(joint.elements, layered, history, {});
  EventPath by_steps(joint.elements, layered, history, ends);
  Record events(system, joint.elements, history), steps(system, joint.elements, history);
  by_events.run({1., 2.}, events);
  const PathResult result = by_steps.run({1., 2.}, steps);
  EXPECT_EQ(result.n_jumps, 2u);
  EXPECT_EQ(steps.events.size(), 0u);
  EXPECT_GE(events.events.size(), 6u);
  EXPECT_LE(steps.worst.worst(), event_tolerance);
  for (std::size_t level = 0; level < 2; ++level)
    {
      EXPECT_EQ(events.levels[level].states, steps.levels[level].states);
      for (std::size_t bar = 0; bar < 2 * (n + 1); ++bar)
        EXPECT_NEAR(
          events.levels[level].forces[bar], steps.levels[level].forces[bar], event_tolerance);
    }
}
