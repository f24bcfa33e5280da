// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/products_only.h"
#include "navier_with_crack.h"

#include <fuga/contact/path/matrix_free_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  Record
  follow(const ToySystem &system,
         const ToyJoint &joint,
         const LoadHistory &history,
         const unsigned int n_levels,
         PathResult &result)
  {
    std::vector<double> levels;
    for (unsigned int i = 1; i <= n_levels; ++i)
      levels.push_back(history.end() * i / n_levels);
    const LayeredSystem layered(system, joint.elements);
    Record record(system, joint.elements, history);
    result = EventPath(joint.elements, layered, history, {}).run(levels, record);
    return record;
  }

  /** One element of area 1 on a layer of compliance 0.5 that a body of stiffness 3 presses; load 0
   * presses with 1, load 1 pulls with 1, load 2 is the water: it pulls the open lips with 1. */
  struct OneElement
  {
    ToySystem system;
    ToyJoint joint{1, 1., make_linear_law(0.5), make_linear_law(0.5), FrictionLaw{1.}};

    OneElement()
    {
      system.S       = DenseMatrix(2, 2);
      system.S(0, 0) = 3.;
      system.S(1, 1) = 1.;
      system.F       = DenseMatrix(2, 3);
      system.F(0, 0) = -1.;
      system.F(0, 1) = 1.;
      DenseMatrix water(2, 3);
      water(0, 2)  = 1.;
      system.water = std::make_shared<ToyWater>(water);
    }
  };

  /**
   * A dam as rigid as the toy allows on n + 1 bars: base b = 8, upstream end at x = -4, weight and
   * its arm given, water of unit weight 0.01 up to the level h, thrust γh²/2 at h/3. Patterns: 0
   * horizontal, 1 vertical, 2 moment, 3 linear uplift of unit pressure at the upstream end.
   */
  struct Dam
  {
    static constexpr double base = 8., gamma = 0.01, weight = 24e-3 * 40., arm = -8. / 6.;
    const std::size_t n;
    const NavierWithCrack navier;
    ToySystem system;
    ToyJoint joint;

    /** @p share: of the uplift in the closed part. */
    explicit Dam(const std::size_t n_elements, const double share = 1.)
      : n(n_elements)
      , navier(n, base, share)
      , system(rigid_block(n, base))
      , joint(
          rigid_block_joint(n, base, make_linear_law(1e-3), make_linear_law(1e-3), FrictionLaw{5.}))
    {
      DenseMatrix F(3, 4);
      for (std::size_t i = 0; i < 3; ++i)
        F(i, i) = 1.;
      DenseMatrix water(2 * (n + 1), 4);
      for (std::size_t k = 0; k <= n; ++k)
        {
          F(1, 3) += navier.closed[k];
          F(2, 3) += navier.closed[k] * navier.x[k];
          water(2 * k, 3) = navier.area[k] - navier.closed[k];
        }
      system.water        = std::make_shared<ToyWater>(water);
      system.F            = F;
      system.motion_loads = F;
    }

    /** Factors for the level h, and the weight. */
    static Vector
    factors(const double h)
    {
      const double thrust = gamma * h * h / 2.;
      return {thrust, -weight, -weight * arm - thrust * h / 3., gamma * h};
    }

    /** Weight, then a reservoir that goes to the level h (and to h_end), by straight pieces of a
     * tenth. */
    static LoadHistory
    history(const double h, const double h_end = -1.)
    {
      std::vector<double> corners = {0., 1.};
      std::vector<Vector> values  = {Vector(4, 0.), factors(0.)};
      const auto go               = [&](const double from, const double to) {
        const double start = corners.back();
        for (int i = 1; i <= 10; ++i)
          {
            corners.push_back(start + i / 10.);
            values.push_back(factors(from + (to - from) * i / 10.));
          }
      };
      go(0., h);
      if (h_end >= 0.)
        go(h, h_end);
      return {corners, values};
    }

    std::vector<double>
    pressures(const double h, const std::size_t m) const
    {
      return navier.pressures(weight, -factors(h)[2], gamma * h, m);
    }

    std::size_t
    crack(const double h) const
    {
      return navier.crack(weight, -factors(h)[2], gamma * h);
    }
  };
} // namespace

// By hand: closed 3δ + N = f, δ = N/2, so it opens at f = 0; the water q = 0.6 then moves it to δ =
// q/3 at the same load; it closes at f = -q, and is pressed to N = -q/(1 + 3/2) as the water
// leaves.
TEST(Uplift, OneElementOpensAndClosesAtDifferentLoads)
{
  const OneElement one;
  const LoadHistory history({0., 1., 2., 3.},
                            {{0., 0., 0.}, {1., 0., 0.6}, {1., 2., 0.6}, {1., 0., 0.6}});
  PathResult result;
  const Record record = follow(one.system, one.joint, history, 6, result);
  EXPECT_EQ(result.verdict, Verdict::done);
  ASSERT_EQ(record.events.size(), 2u);
  EXPECT_EQ(record.events[0].to, ContactState::open);
  EXPECT_NEAR(record.events[0].t, 1.5, 1e-14);
  EXPECT_EQ(record.events[1].from, ContactState::open);
  EXPECT_NEAR(record.events[1].t, 2.8, 1e-14); // -1 + 2 (3 - t) = -0.6
  EXPECT_LT(record.worst.worst(), 1e-13);
  ASSERT_EQ(record.levels.size(), 6u);
  const JointState &open = record.levels[3]; // t = 2: f = 1
  EXPECT_NEAR(open.dislocations[0], 1.6 / 3., 1e-14);
  EXPECT_NEAR(open.forces[0], 0., 1e-14);
  EXPECT_NEAR(open.water[0], 0.6, 1e-15);
  const JointState &closed = record.levels[5]; // f = -1 again
  EXPECT_NEAR(closed.forces[0], -1. / 2.5, 1e-14);
  EXPECT_NEAR(closed.dislocations[0], 0., 1e-14);
  EXPECT_EQ(closed.water[0], 0.);
}

// The water in an open element follows the level: N = 0 and 3δ = f + q all the time.
TEST(Uplift, WaterOfOpenElementFollowsItsLevel)
{
  const OneElement one;
  const LoadHistory history(
    {0., 1., 2., 3., 4.},
    {{0., 0., 0.}, {1., 0., 0.}, {1., 1.5, 0.}, {1., 1.5, 0.9}, {1., 1.5, 0.2}});
  PathResult result;
  const Record record = follow(one.system, one.joint, history, 8, result);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_LT(record.worst.worst(), 1e-13);
  for (const JointState &state : record.levels)
    if (state.t > 1.7)
      {
        const Vector a = history.factors(state.t);
        EXPECT_NEAR(state.dislocations[0], (a[1] - 1. + a[2]) / 3., 1e-14) << state.t;
      }
}

// With a bond of strength 0.2 it opens at N = 0.2; what is lost and what comes in act together:
// afterwards 3δ = f + q with f = 2.5 · 0.2.
TEST(Uplift, BondAndWaterGoTogether)
{
  OneElement one;
  one.joint.elements[0].friction.cohesion         = 1.;
  one.joint.elements[0].friction.tensile_strength = 0.2;
  const LoadHistory history({0., 1., 2.}, {{0., 0., 0.}, {1., 0., 0.6}, {1., 2., 0.6}});
  PathResult result;
  const Record record = follow(one.system, one.joint, history, 1, result);
  ASSERT_EQ(record.events.size(), 1u);
  EXPECT_NEAR(record.events[0].t, 1.75, 1e-14); // -1 + 2 (t - 1) = 0.5
  EXPECT_NEAR(record.levels.back().dislocations[0], 1.6 / 3., 1e-14);
  EXPECT_LT(record.worst.worst(), 1e-13);
}

// Navier's formula with crack and full uplift in it. The elements' areas are those of the
// trapezoidal rule, and so are the sums of the closed form.
TEST(Uplift, RigidDamAgainstNavierWithCrack)
{
  for (const std::size_t n : {4u, 16u, 33u, 128u})
    for (const double h : {6., 9.75, 10., 10.1, 10.26})
      {
        const Dam dam(n);
        PathResult result;
        const Record record = follow(dam.system, dam.joint, Dam::history(h), 1, result);
        ASSERT_EQ(result.verdict, Verdict::done) << n << " " << h;
        EXPECT_LT(record.worst.worst(), 1e-10);
        const JointState &end = record.levels.back();
        const std::size_t m   = dam.crack(h);
        const auto p          = dam.pressures(h, m);
        const double largest  = p.back();
        for (std::size_t k = 0; k <= n; ++k)
          {
            EXPECT_EQ(end.states[k] == ContactState::open, k < m) << n << " " << h << " " << k;
            EXPECT_NEAR(-end.forces[2 * k] / dam.navier.area[k], k < m ? 0. : p[k], 1e-9 * largest)
              << n << " " << h << " " << k;
            const double full = Dam::gamma * h * (dam.navier.area[k] - dam.navier.closed[k]);
            EXPECT_NEAR(end.water[2 * k], k < m ? full : 0., 1e-15);
          }
        EXPECT_TRUE(h < 9. ? m == 0 : m > 0 || n < 16) << "no crack at " << h;
      }
}

// The same where the stiffness of the bodies is not known: the water follows the elements that are
// open at the end of a step, until none opens any more.
TEST(Uplift, WithoutStiffnessWaterComesInAtTheEndOfAStep)
{
  for (const std::size_t n : {4u, 33u, 128u})
    for (const double h : {6., 9.75, 10.26})
      {
        SCOPED_TRACE(testing::Message() << n << ", " << h);
        const Dam dam(n);
        const LoadHistory history = Dam::history(h);
        const LayeredSystem layered(dam.system, dam.joint.elements);
        const ProductsOnly bodies(dam.system, 1e4);
        Record record(dam.system, dam.joint.elements, history);
        MatrixFreePath(dam.joint.elements, layered, bodies, bodies, history)
          .run({history.end()}, record);
        EXPECT_LT(record.worst.worst(), 1e-9);
        const JointState &end = record.levels.back();
        const std::size_t m   = dam.crack(h);
        const auto p          = dam.pressures(h, m);
        for (std::size_t k = 0; k <= n; ++k)
          {
            EXPECT_EQ(end.states[k] == ContactState::open, k < m) << k;
            EXPECT_NEAR(-end.forces[2 * k] / dam.navier.area[k], k < m ? 0. : p[k], 1e-9 * p.back())
              << k;
            const double full = Dam::gamma * h * (dam.navier.area[k] - dam.navier.closed[k]);
            EXPECT_NEAR(end.water[2 * k], k < m ? full : 0., 1e-15) << k;
          }
      }
}

// A good drain: a fifth of the linear pressure where the joint is closed. By Navier's formula there
// is no crack at h = 11.1 and no equilibrium at all at 11.3: the water that comes in at the
// upstream end opens one element after the other at the same load, until the dam turns over.
TEST(Uplift, NeighboursOpenWhileTheWaterComesIn)
{
  const Dam dam(128, 0.2);
  ASSERT_EQ(dam.crack(11.1), 0u);
  ASSERT_GT(dam.crack(11.3), dam.n);
  PathResult result;
  const Record record = follow(dam.system, dam.joint, Dam::history(11.3), 1, result);
  EXPECT_EQ(result.verdict, Verdict::limit_load);
  std::map<double, std::size_t> openings;
  for (const ContactEvent &event : record.events)
    openings[event.t] += event.to == ContactState::open ? 1 : 0;
  std::size_t together = 0;
  for (const auto &[t, n] : openings)
    together = std::max(together, n);
  EXPECT_GT(together, 100u);
  for (const auto &[name, error] : record.worst.entries())
    EXPECT_LT(error, 1e-9) << name;
}

TEST(Uplift, LevelsDoNotMatter)
{
  const Dam dam(128);
  PathResult result;
  const Record one  = follow(dam.system, dam.joint, Dam::history(10.1), 1, result);
  const Record many = follow(dam.system, dam.joint, Dam::history(10.1), 97, result);
  ASSERT_EQ(one.events.size(), many.events.size());
  for (std::size_t i = 0; i < one.events.size(); ++i)
    {
      EXPECT_EQ(one.events[i].element, many.events[i].element);
      EXPECT_EQ(one.events[i].t, many.events[i].t);
    }
  const JointState &a = one.levels.back(), &b = many.levels.back();
  EXPECT_EQ(a.states, b.states);
  for (std::size_t i = 0; i < a.forces.size(); ++i)
    {
      EXPECT_NEAR(a.forces[i], b.forces[i], 1e-9 * max_abs(a.forces));
      EXPECT_NEAR(a.dislocations[i], b.dislocations[i], 1e-9 * max_abs(a.dislocations));
    }
}

// Without slip nothing remains of a crack that has closed: the stresses are Navier's without crack.
TEST(Uplift, CrackClosesAsTheReservoirIsEmptied)
{
  const Dam dam(32);
  PathResult result;
  const Record record = follow(dam.system, dam.joint, Dam::history(10.1, 2.), 2, result);
  ASSERT_EQ(result.verdict, Verdict::done);
  EXPECT_LT(record.worst.worst(), 1e-10);
  const auto p = dam.pressures(2., 0);
  EXPECT_GT(record.events.size(), 2u);
  for (std::size_t k = 0; k <= dam.n; ++k)
    EXPECT_NEAR(-record.levels.back().forces[2 * k] / dam.navier.area[k], p[k], 1e-9 * p.front())
      << k;
}

// Above the level for which Navier's formula has a crack at all the dam turns over: a verdict.
TEST(Uplift, NoEquilibriumIsALimitLoad)
{
  const Dam dam(32);
  ASSERT_GT(dam.crack(11.), dam.n);
  PathResult result;
  const Record record = follow(dam.system, dam.joint, Dam::history(11.), 1, result);
  EXPECT_EQ(result.verdict, Verdict::limit_load);
  EXPECT_EQ(result.mechanism, MechanismKind::overturning);
  EXPECT_LT(record.worst.worst(), 1e-9);
}
