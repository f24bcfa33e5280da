// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"

#include <fuga/contact/element/layer_response.h>
#include <fuga/laws/cubic_root_law.h>

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

// Strength that is lost on the way: bonds, peak friction, dilatancy. One element between a body of
// stiffness S and a rigid base; all expected numbers are springs in series by hand, exact up to the
// rounding of a few divisions.
namespace
{
  constexpr double tolerance = 1e-12;

  /** One element; S = [[a, b], [b, d]]; load patterns: pulling the lips apart, and along. */
  struct OneElement
  {
    ToyJoint joint;
    ToySystem system;

    OneElement(const FrictionLaw &friction,
               const double compliance,
               const double a,
               const double b,
               const double d)
      : joint(1, 1., make_law(compliance), make_law(compliance), friction)
    {
      system.S       = DenseMatrix(2, 2);
      system.S(0, 0) = a;
      system.S(0, 1) = system.S(1, 0) = b;
      system.S(1, 1)                  = d;
      system.F                        = DenseMatrix(2, 2);
      system.F(0, 0) = system.F(1, 1) = 1.;
    }

    static std::unique_ptr<ComplianceLaw>
    make_law(const double compliance)
    {
      return compliance == 0. ? make_rigid_law() : make_linear_law(compliance);
    }
  };

  struct PathRun
  {
    LayeredSystem layered;
    Record record;
    PathResult result;

    PathRun(const OneElement &one, const LoadHistory &history, const std::vector<double> &levels)
      : layered(one.system, one.joint.elements), record(one.system, one.joint.elements, history)
    {
      EventPath path(one.joint.elements, layered, history, {});
      result = path.run(levels, record);
    }

    double
    jump(const std::size_t level, const std::size_t bar) const
    {
      return layered.jumps(record.levels[level].dislocations, record.levels[level].forces)[bar];
    }
  };
} // namespace

// Pulled with P(t) = 2t, the bar carries P·C/(a + C) until that reaches σ_t A; then the body alone
// carries P.
TEST(Bonds, TensileStrengthIsLostAtOnce)
{
  for (const double compliance : {0., 0.25, 1., 4.})
    {
      FrictionLaw law;
      law.coefficient      = 0.5;
      law.cohesion         = 1.;
      law.tensile_strength = 0.3;
      const OneElement one(law, compliance, 1., 0., 1.);
      const PathRun run(one, LoadHistory({0., 1.}, {{0., 0.}, {2., 0.}}), {1.});
      EXPECT_LE(run.record.worst.worst(), tolerance);
      EXPECT_EQ(run.result.verdict, Verdict::done);
      ASSERT_EQ(run.record.events.size(), 1u);
      EXPECT_EQ(run.record.events[0].to, ContactState::open);
      EXPECT_NEAR(run.record.events[0].t, 0.15 * (1. + compliance), tolerance);
      EXPECT_NEAR(run.jump(0, 0), 2., tolerance);
      EXPECT_NEAR(run.record.levels[0].forces[0], 0., tolerance);
      // Broken: half the energy of the spring that let go went into nothing else.
      const double P = 0.3 * (1. + compliance), x0 = 0.3 * compliance;
      EXPECT_NEAR(run.record.judge.energies().dissipation,
                  0.5 * (P - x0) * (P - x0) + 0.5 * 0.3 * 0.3 * compliance,
                  tolerance);
    }
}

// A brittle bond under N = -1 slips at T = c + f, drops to f_r at that load, and goes on with f_r.
// With the body's stiffness 1 along: slip jumps by c + f - f_r.
TEST(Bonds, BrittleBondDropsToResidualFriction)
{
  for (const double compliance : {0., 0.5})
    {
      FrictionLaw law;
      law.coefficient   = 0.6;
      law.friction_loss = 0.2;
      law.cohesion      = 0.7;
      law.bond_loss     = FrictionLaw::BondLoss::slip;
      const OneElement one(law, compliance, 1., 0., 1.);
      // Pressing first; a rigid base along, so that T = H C/(1 + C) for a compliant layer.
      const PathRun run(
        one,
        LoadHistory(
          {0., 1., 2., 3.},
          {{0., 0.}, {-1. - compliance, 0.}, {-1. - compliance, 4.}, {-1. - compliance, 0.}}),
        {1., 2., 3.});
      EXPECT_LE(run.record.worst.worst(), tolerance);
      EXPECT_NEAR(run.record.levels[0].forces[0], -1., tolerance);
      ASSERT_GE(run.record.events.size(), 2u);
      EXPECT_EQ(run.record.events[0].to, ContactState::slip_forward);
      EXPECT_NEAR(run.record.events[0].t, 1. + 1.3 * (1. + compliance) / 4., tolerance);
      EXPECT_NEAR(run.record.levels[1].forces[1], 0.4, tolerance);
      EXPECT_NEAR(run.jump(1, 1), 4. - 0.4, tolerance);
      // Reversal sticks at once; back slip when the layer has taken 2 f_r |N| back.
      EXPECT_EQ(run.record.events[1].to, ContactState::stick);
      EXPECT_NEAR(run.record.levels[2].forces[1], -0.4, tolerance);
      EXPECT_NEAR(run.jump(2, 1), 0.4, tolerance);
    }
}

// A bond under tension that breaks by slip where the shear it lets go presses the lips together
// (S_nt > 0): they do not part, and slide by x. With forces p = (0.1, 0.95) before, N = 0.1 - x/2
// and T = 0.95 - x. A neighbour without bond, pressed by n, is dragged along and slides too from
// 0.5 x = f n on: at x = 0.1, where the lips still pull, N = 0.05. At the end all slides, T = -f N.
TEST(Bonds, LipsPressEachOtherWhileTheirBondStillPulls)
{
  constexpr double f = 0.5, P = 0.1, H = 0.95, n = 0.1, t_break = 0.8;
  FrictionLaw law;
  law.coefficient      = f;
  law.cohesion         = 1.;
  law.tensile_strength = 0.5;
  law.bond_loss        = FrictionLaw::BondLoss::slip;
  ToyJoint joint(2, 1., make_rigid_law(), make_rigid_law(), law);
  joint.elements[1].friction             = {};
  joint.elements[1].friction.coefficient = f;
  ToySystem system;
  system.S = DenseMatrix(4, 4);
  for (std::size_t bar = 0; bar < 4; ++bar)
    system.S(bar, bar) = 1.;
  system.S(0, 1) = system.S(1, 0) = system.S(1, 3) = system.S(3, 1) = 0.5;
  system.F                                                          = DenseMatrix(4, 1);
  system.F(0, 0)                                                    = P;
  system.F(1, 0)                                                    = H;
  system.F(2, 0)                                                    = -n;
  const LayeredSystem layered(system, joint.elements);
  const LoadHistory history({0., 1.}, {{0.}, {1. / t_break}});
  Record record(system, joint.elements, history);
  const PathResult result = EventPath(joint.elements, layered, history, {}).run({1.}, record);
  EXPECT_EQ(result.verdict, Verdict::done);
  EXPECT_LE(record.worst.worst(), tolerance);
  ASSERT_GE(record.events.size(), 2u);
  EXPECT_NEAR(record.events.front().t, t_break, tolerance);
  EXPECT_EQ(record.events.back().element, 1u);
  EXPECT_EQ(record.events.back().to, ContactState::slip_backward);
  EXPECT_NEAR(record.events.back().t, t_break, tolerance);
  // H - x1 - x2/2 = f (x1/2 - P) and -x1/2 - x2 = -f n with all loads 1/t_break times as large.
  const double x = (H + f * P - 0.5 * f * n) / (1. + 0.5 * f - 0.25) / t_break;
  const double N = P / t_break - 0.5 * x;
  ASSERT_LT(N, 0.);
  const Vector expected = {N, -f * N, -n / t_break, -f * n / t_break};
  for (std::size_t bar = 0; bar < 4; ++bar)
    EXPECT_NEAR(record.levels[0].forces[bar], expected[bar], tolerance) << bar;
}

// Peak friction that a second sliding no longer finds: T = f at the first, f_r at the second.
TEST(Bonds, PeakFrictionIsLostOnce)
{
  FrictionLaw law;
  law.coefficient   = 0.5;
  law.friction_loss = 0.3;
  const OneElement one(law, 0.5, 1., 0., 1.);
  const double press = 1.5; // N = -1
  const PathRun run(one,
                    LoadHistory({0., 1., 2., 3., 4.},
                                {{0., 0.}, {-press, 0.}, {-press, 2.}, {-press, 0.}, {-press, 2.}}),
                    {2., 3., 4.});
  EXPECT_LE(run.record.worst.worst(), tolerance);
  EXPECT_NEAR(run.record.events[0].t, 1. + 0.5 * 1.5 / 2., tolerance);
  EXPECT_NEAR(run.record.levels[0].forces[1], 0.2, tolerance);
  EXPECT_NEAR(run.record.levels[1].forces[1], -0.2, tolerance);
  EXPECT_NEAR(run.record.levels[2].forces[1], 0.2, tolerance);
}

// The same where all begins at once, the apex of the cone: pressure 1 and shear h grow together.
// What sticks, h ≤ f, keeps its friction; what slides has f_r from the beginning. The body's
// stiffness along is 1, so that the jump is h (1 + ρ) - T.
TEST(Bonds, PeakFrictionIsLostAtTheApex)
{
  FrictionLaw law;
  law.coefficient   = 0.5;
  law.friction_loss = 0.2;
  for (const double compliance : {0., 0.5})
    for (const auto &[h, T] : {std::pair(0.45, 0.45), {0.6, 0.3}, {-0.6, -0.3}})
      {
        const OneElement one(law, compliance, 1., 0., 1.);
        const double P = 1. + compliance;
        const PathRun run(one, LoadHistory({0., 1.}, {{0., 0.}, {-P, h * P}}), {0.5, 1.});
        EXPECT_LE(run.record.worst.worst(), tolerance);
        EXPECT_EQ(run.result.verdict, Verdict::done);
        for (const std::size_t level : {0u, 1u})
          {
            const double share = level == 0 ? 0.5 : 1.;
            EXPECT_NEAR(run.record.levels[level].forces[0], -share, tolerance);
            EXPECT_NEAR(run.record.levels[level].forces[1], share * T, tolerance) << h;
            EXPECT_NEAR(run.jump(level, 1), share * (h * P - T), tolerance) << h;
          }
      }
}

// A rigid block on two elements, pressures 0.3 and 0.7 and the shear H growing together. H = 0.36:
// 0.18 each is more than 0.5·0.3, so the first slides, keeps 0.3·0.3 and leaves 0.27 to the second,
// which holds. H = 0.46: 0.31 would still be held, were it not for the 0.06 that the first loses;
// then both slide, and hold 0.3·1.
TEST(Bonds, FrictionLostAtTheApexIsRedistributed)
{
  FrictionLaw law;
  law.coefficient      = 0.5;
  law.friction_loss    = 0.2;
  const ToyJoint joint = rigid_block_joint(1, 1., make_linear_law(0.5), make_linear_law(0.5), law);
  const ToySystem system = rigid_block(1, 1.);
  const LayeredSystem layered(system, joint.elements);
  for (const double H : {0.36, 0.46})
    {
      const LoadHistory history({0., 1.}, {{0., 0., 0.}, {H, -1., -0.2}});
      Record record(system, joint.elements, history);
      EventPath path(joint.elements, layered, history, {});
      const PathResult result = path.run({1.}, record);
      EXPECT_LE(record.worst.worst(), tolerance);
      if (H > 0.4)
        {
          EXPECT_EQ(result.verdict, Verdict::limit_load);
          EXPECT_EQ(result.t, 0.);
          continue;
        }
      EXPECT_EQ(result.verdict, Verdict::done);
      const JointState &end = record.levels[0];
      EXPECT_NEAR(end.forces[0], -0.3, tolerance);
      EXPECT_NEAR(end.forces[1], 0.09, tolerance);
      EXPECT_NEAR(end.forces[3], 0.27, tolerance);
      // ρ/A = 1: the block moves by the shear of the second layer.
      EXPECT_NEAR(end.slips[0][0], 0.27 - 0.09, tolerance);
      EXPECT_EQ(end.slips[1][0], 0.);
    }
}

// Lips that rise as they slide press harder: with W = (1/a + ρ)^{-1} and the slip s,
// -N = N0 + W s tan ψ, T = f|N| = H - s (body stiffness 1, layer stiff along), until the rise is
// used up.
TEST(Bonds, DilatancyPressesUntilItsLimit)
{
  for (const double compliance : {0., 0.25})
    {
      FrictionLaw law;
      law.coefficient    = 0.6;
      law.dilatancy      = 0.3;
      law.dilation_limit = 0.15; // reached at s = 0.5
      OneElement one(law, compliance, 2., 0., 1.);
      one.joint.shear                 = make_rigid_law();
      one.joint.elements[0].shear_law = one.joint.shear.get();
      const double press              = 1. + 2. * compliance; // N0 = -1
      const PathRun run(one,
                        LoadHistory({0., 1., 2.}, {{0., 0.}, {-press, 0.}, {-press, 3.}}),
                        {1. + 0.9 / 3., 2.});
      EXPECT_LE(run.record.worst.worst(), tolerance);
      EXPECT_EQ(run.result.verdict, Verdict::done);
      const double W = 1. / (0.5 + compliance);
      EXPECT_NEAR(run.record.events[0].t, 1.2, tolerance);
      const double s = (0.9 - 0.6) / (1. + 0.6 * 0.3 * W);
      EXPECT_NEAR(run.record.levels[0].slips[0][0], s, tolerance);
      EXPECT_NEAR(run.record.levels[0].dilations[0], 0.3 * s, tolerance);
      EXPECT_NEAR(run.record.levels[0].forces[0], -1. - 0.3 * s * W, tolerance);
      const double N_end = -1. - 0.15 * W;
      EXPECT_NEAR(run.record.levels[1].forces[0], N_end, tolerance);
      EXPECT_NEAR(run.record.levels[1].dilations[0], 0.15, tolerance);
      EXPECT_NEAR(run.record.levels[1].slips[0][0], 3. + 0.6 * N_end, tolerance);
    }
}

// The same with a nonlinear layer, law (9): the state at the end satisfies the laws one by one, and
// energy balances along the curve.
TEST(Bonds, DilatancyOnNonlinearLayer)
{
  FrictionLaw law;
  law.coefficient = 0.6;
  law.dilatancy   = 0.3;
  OneElement one(law, 0.25, 2., 0., 1.);
  one.joint.normal                 = std::make_unique<CubicRootLaw>(0.25, 2.);
  one.joint.elements[0].normal_law = one.joint.normal.get();
  const PathRun run(one, LoadHistory({0., 1., 2.}, {{0., 0.}, {-1., 0.}, {-1., 1.}}), {1., 2.});
  EXPECT_LE(run.record.worst.worst(), 1e-10); // of the interpolated curve
  const JointState &end = run.record.levels[1];
  const double s = end.slips[0][0], N = end.forces[0];
  EXPECT_GT(s, 0.1);
  EXPECT_NEAR(end.dilations[0], 0.3 * s, tolerance);
  EXPECT_NEAR(end.forces[1], -0.6 * N, tolerance);
  const double gap = (-1. - N) / 2. - end.dilations[0]; // a x + N = load
  EXPECT_NEAR(N, -one.joint.normal->stress(-gap), 1e-11);
}

// Shear stiffness that grows with closure or pressure: a closed loop of loads without slip gives
// all energy back, and its order does not matter.
TEST(ShearCouplingPath, ClosedLoopsKeepEnergy)
{
  FrictionLaw law;
  law.coefficient = 5.;
  for (const ShearCoupling::Kind kind :
       {ShearCoupling::Kind::closure, ShearCoupling::Kind::pressure})
    for (const double exponent : {0.5, 1.})
      {
        OneElement one(law, 0.5, 1., 0.3, 1.);
        const ShearCoupling coupling(kind, *one.joint.normal, 0.5, 2., exponent);
        one.joint.elements[0].coupling = &coupling;
        const PathRun loop(one,
                           LoadHistory({0., 1., 2., 3., 4.},
                                       {{0., 0.}, {-1., 0.}, {-1., 0.8}, {-0.2, 0.3}, {0., 0.}}),
                           {2., 4.});
        EXPECT_LE(loop.record.worst.worst(), 1e-10);
        EXPECT_EQ(loop.record.events.size(), 0u);
        // Every step of the curve may lose 3e-12 of the work by interpolation.
        EXPECT_NEAR(loop.record.judge.energies().external_work, 0., 1e-10);
        const PathRun direct(one, LoadHistory({0., 1.}, {{0., 0.}, {-1., 0.8}}), {1.});
        for (std::size_t bar = 0; bar < 2; ++bar)
          {
            EXPECT_NEAR(loop.jump(0, bar), direct.jump(0, bar), 1e-11);
            EXPECT_NEAR(
              loop.record.levels[0].forces[bar], direct.record.levels[0].forces[bar], 1e-11);
          }
        // Equilibrium with the potential's own stresses.
        const auto r = coupling.response(-direct.jump(0, 0), direct.jump(0, 1));
        EXPECT_NEAR(direct.record.levels[0].forces[0], -r.sigma, 1e-11);
        EXPECT_NEAR(direct.record.levels[0].forces[1], r.tau, 1e-11);
      }
}

// With slip: T = f|N| and the layer's law hold at the end, energy balances, and after a reversal as
// well.
TEST(ShearCouplingPath, SlipAndReversal)
{
  FrictionLaw law;
  law.coefficient = 0.4;
  for (const ShearCoupling::Kind kind :
       {ShearCoupling::Kind::closure, ShearCoupling::Kind::pressure})
    {
      OneElement one(law, 0.5, 1., 0.3, 1.);
      const ShearCoupling coupling(kind, *one.joint.normal, 0.5, 2., 1.);
      one.joint.elements[0].coupling = &coupling;
      const PathRun run(
        one,
        LoadHistory({0., 1., 2., 3.}, {{0., 0.}, {-1., 0.}, {-1., 1.5}, {-0.8, -1.5}}),
        {2., 3.});
      EXPECT_LE(run.record.worst.worst(), 1e-10);
      ASSERT_EQ(run.record.events.size(), 3u);
      for (std::size_t level = 0; level < 2; ++level)
        {
          const JointState &state = run.record.levels[level];
          const double sign       = level == 0 ? 1. : -1.;
          EXPECT_NEAR(state.forces[1], -sign * 0.4 * state.forces[0], 1e-12);
          const auto r =
            coupling.response(-run.jump(level, 0), run.jump(level, 1) - state.slips[0][0]);
          EXPECT_NEAR(state.forces[0], -r.sigma, 1e-11);
          EXPECT_NEAR(state.forces[1], r.tau, 1e-11);
        }
    }
}
