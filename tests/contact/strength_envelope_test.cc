// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/cone_toy.h"

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    constexpr double area = 0.5, friction = 0.8, reference = 0.4;
    /** Force that the area times the pressure of the envelope makes. */
    constexpr double P_r      = area * reference;
    constexpr double pressing = 1.5, pull = 2., coupling = 0.3, spring = 2.;

    FrictionLaw
    curved_law()
    {
      FrictionLaw law;
      law.coefficient = friction;
      law.envelope    = {0.5, reference};
      return law;
    }

    /** f A G of a force P for the exponent 1/2, written with the root. */
    double
    strength_of(const double P)
    {
      return 2. * friction * P_r * (std::sqrt(1. + P / P_r) - 1.);
    }

    /**
     * The slip of one element on rigid bars that is pressed by P0 and pulled by Q: a body of
     * stiffness k that presses it by another κ s as it slides by s,
     *
     *     Q - k s = 2 f P_r (z - 1),   z² = 1 + (P0 + κ s)/P_r,
     *
     * which is a quadratic equation for z.
     */
    double
    slip_under(const double Q)
    {
      const double a = spring * P_r / coupling, b = 2. * friction * P_r,
                   c = -(Q + b + spring * (P_r + pressing) / coupling);
      const double z = (-b + std::sqrt(b * b - 4. * a * c)) / (2. * a);
      return (P_r * (z * z - 1.) - pressing) / coupling;
    }

    /** Pressed, then pulled, in part back, and pulled farther. */
    LoadHistory
    pulled()
    {
      return LoadHistory({0., 1., 2., 2.5, 4.},
                         {{0., 0.},
                          {pressing, 0.},
                          {pressing, 0.7 * pull},
                          {pressing, 0.6 * pull},
                          {pressing, pull}});
    }

    void
    expect_slips_of_quadratic(const PathResult &result, const Record &record, const Vector &unit)
    {
      ASSERT_EQ(result.verdict, Verdict::done);
      ASSERT_EQ(record.events.size(), 3u); // slip, stick, slip
      // The pull of the second stage is 0.7 Q (t - 1), that of the last 0.6 Q + 0.4 Q (t
      // - 2.5)/1.5.
      EXPECT_NEAR(record.events[0].t, 1. + strength_of(pressing) / (0.7 * pull), 1e-12);
      EXPECT_NEAR(record.events[1].t, 2., 1e-12);
      EXPECT_NEAR(record.events[2].t, 2.5 + 1.5 * 0.25, 1e-11);
      for (const JointState &state : record.levels)
        {
          const double Q =
            state.t < 3. ? 0.7 * pull * (state.t - 1.) : pull * (0.6 + 0.4 * (state.t - 2.5) / 1.5);
          const double s = slip_under(Q);
          EXPECT_NEAR(state.forces[0], -(pressing + coupling * s), 1e-11);
          for (std::size_t a = 0; a < unit.size(); ++a)
            {
              EXPECT_NEAR(state.slips[0][a], s * unit[a], 1e-11) << state.t;
              EXPECT_NEAR(
                state.forces[1 + a], strength_of(pressing + coupling * s) * unit[a], 1e-11)
                << state.t;
            }
        }
      EXPECT_LT(record.worst.worst(), 1e-9);
    }

    const Vector levels = {1.9, 2., 3.5, 4.};
  } // namespace

  // The numbers are those of the formula: 0.5/0.5 (√4 - 1) = 1 and 1/√4 for 1 + σ/σ_r = 4.
  TEST(StrengthEnvelope, IsThePowerLaw)
  {
    const StrengthEnvelope envelope{0.5, 0.5};
    EXPECT_NEAR(envelope.value(1.5), 1., 1e-15);
    EXPECT_NEAR(envelope.slope(1.5), 0.5, 1e-15);
    EXPECT_EQ(envelope.slope(0.), 1.);
    // Of a small pressure no digit is lost: σ - σ²/(4 σ_r).
    EXPECT_NEAR(envelope.value(1e-9) / 1e-9, 1. - 0.5e-9, 1e-15);
    EXPECT_EQ(envelope.value(-0.2), -0.2);
    // Baker's τ = p_a A (σ/p_a + T)^b.
    const double p_a = 0.1, A = 0.9, T = 0.05, b = 0.7, sigma = 0.6;
    const StrengthEnvelope baker{b, p_a * T};
    const double cohesion = p_a * A * std::pow(T, b), slope = A * b * std::pow(T, b - 1.);
    EXPECT_NEAR(
      cohesion + slope * baker.value(sigma), p_a * A * std::pow(sigma / p_a + T, b), 1e-15);
    const StrengthEnvelope line;
    EXPECT_FALSE(line.is_curved());
    EXPECT_EQ(line.value(3.), 3.);
    EXPECT_EQ(line.slope(3.), 1.);
  }

  TEST(StrengthEnvelope, SlidesAlongTheCurveInThePlane)
  {
    ToySystem system;
    system.S       = DenseMatrix(2, 2);
    system.S(0, 0) = 1.;
    system.S(1, 1) = spring;
    system.S(0, 1) = system.S(1, 0) = coupling;
    system.F                        = DenseMatrix(2, 2);
    system.F(0, 0)                  = -1.;
    system.F(1, 1)                  = 1.;
    const ToyJoint joint(1, area, make_rigid_law(), make_rigid_law(), curved_law());
    const LoadHistory history = pulled();
    const LayeredSystem layered(system, joint.elements);
    Record record(system, joint.elements, history);
    EventPath path(joint.elements, layered, history, PathOptions());
    const PathResult result = path.run(levels, record);
    expect_slips_of_quadratic(result, record, {1.});
  }

  TEST(StrengthEnvelope, SlidesAlongTheCurveInSpace)
  {
    const Vector e = {0.6, 0.8};
    ToySystem system;
    system.S       = DenseMatrix(3, 3);
    system.F       = DenseMatrix(3, 2);
    system.S(0, 0) = 1.;
    system.F(0, 0) = -1.;
    for (std::size_t a = 0; a < 2; ++a)
      {
        system.S(1 + a, 1 + a) = spring;
        system.S(0, 1 + a) = system.S(1 + a, 0) = coupling * e[a];
        system.F(1 + a, 1)                      = e[a];
      }
    ConeJoint joint(1, area, make_rigid_law(), make_rigid_law(), friction);
    joint.elements[0].friction = curved_law();
    const ConeRun run(system, joint.elements, pulled(), levels);
    expect_slips_of_quadratic(run.result, run.record, e);
  }

  // A bond adds its cohesion; a brittle one loses it, and friction falls to f_r, at the first slip.
  TEST(StrengthEnvelope, LosesBondAndFriction)
  {
    constexpr double cohesion = 0.6, residual = 0.5;
    FrictionLaw law        = curved_law();
    law.cohesion           = cohesion;
    law.bond_loss          = FrictionLaw::BondLoss::slip;
    law.friction_loss      = friction - residual;
    const ToySystem system = spring_beside_joint(spring);
    const ToyJoint joint(1, area, make_rigid_law(), make_rigid_law(), law);
    const LoadHistory history({0., 1., 2.}, {{0., 0.}, {pressing, 0.}, {pressing, pull}});
    const LayeredSystem layered(system, joint.elements);
    Record record(system, joint.elements, history);
    EventPath path(joint.elements, layered, history, PathOptions());
    ASSERT_EQ(path.run({2.}, record).verdict, Verdict::done);
    ASSERT_FALSE(record.events.empty());
    EXPECT_NEAR(record.events[0].t, 1. + (strength_of(pressing) + cohesion * area) / pull, 1e-12);
    const JointState &end = record.levels.back();
    const double left     = residual / friction * strength_of(pressing);
    EXPECT_NEAR(end.forces[1], left, 1e-12);
    EXPECT_NEAR(end.slips[0][0], (pull - left) / spring, 1e-12);
    EXPECT_LT(record.worst.worst(), 1e-9);
  }

  // Nothing but the joint holds the body: F = (f A G(P/A) + c A)/Q.
  TEST(StrengthEnvelope, FactorOfSafety)
  {
    constexpr double cohesion = 0.3, smallest_share = 0.1, Q = 0.5;
    FrictionLaw law = curved_law();
    law.cohesion    = cohesion;
    law.reduced     = true;
    ToySystem system;
    system.S            = DenseMatrix(2, 2);
    system.F            = DenseMatrix::Identity(2, 2);
    system.F(0, 0)      = -1.;
    system.motions      = DenseMatrix::Identity(2, 2);
    system.motion_loads = system.F;
    const ToyJoint joint(1, area, make_linear_law(0.1), make_linear_law(0.2), law);
    const LoadHistory history(
      {0., 1., 2.}, {{0., 0.}, {pressing, Q}, {pressing, Q}}, {1., 1., smallest_share});
    const LayeredSystem layered(system, joint.elements);
    Record record(system, joint.elements, history);
    EventPath path(joint.elements, layered, history, PathOptions());
    const PathResult result = path.run({1.}, record);
    ASSERT_EQ(result.verdict, Verdict::limit_load);
    EXPECT_NEAR(
      1. / history.strength_share(result.t), (strength_of(pressing) + cohesion * area) / Q, 1e-10);
    EXPECT_LT(record.worst.worst(), 1e-9);
  }
} // namespace fuga::tests
