// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Masses on springs that rub: motions whose answers are known in closed form.

#include "contact/toy_system.h"
#include "dynamics/moving_springs.h"
#include "known_answer.h"

#include <fuga/contact/virgin_state.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    FrictionLaw
    coulomb(const double coefficient)
    {
      FrictionLaw friction;
      friction.coefficient = coefficient;
      return friction;
    }

    /** A mass that slides along the ground, on which it is pressed by N, and that a spring may
     * hold: displacements along the ground, and across it without mass. */
    struct Slider
    {
      ToyJoint joint;
      Springs springs;
      JointState first;

      Slider(const double mass, const double k, const double N, const FrictionLaw &friction)
        : joint(1, 1., make_rigid_law(), make_linear_law(1e-4 / (mass * 1e6)), friction)
      {
        springs.masses          = {0., mass};
        springs.stiffness       = DenseMatrix(2, 2);
        springs.stiffness(0, 0) = 1.;
        springs.stiffness(1, 1) = k;
        springs.jumps           = DenseMatrix(2, 2);
        springs.jumps(0, 0) = springs.jumps(1, 1) = 1.;
        first                                     = virgin_state(joint.elements, 2, false);
        first.forces[0]                           = -N;
      }

      SpringMotion
      move(const double step,
           const unsigned int n_steps,
           const std::function<double(const double)> &load,
           const unsigned int halvings = 5)
      {
        springs.step  = step;
        springs.loads = [load](const double t) { return Vector{0., load(t)}; };
        return SpringMotion(springs, joint.elements, first, n_steps, halvings);
      }
    };

    double
    at(const SpringMotion &motion, const double t)
    {
      std::size_t i = 0;
      while (motion.times[i] < t - 1e-9)
        ++i;
      return motion.displacements[i][1];
    }
  } // namespace

  // Coulomb's damper: the amplitude falls by 2 µN/k in every half period π/ω, until the spring is
  // weaker than friction.
  TEST(Springs, OscillatorWithFrictionTurnsWhereItShould)
  {
    const double U0 = 0.85e-3, k = 1e4, friction = 1.;
    Slider slider(1., k, 10., coulomb(0.1));
    const double half   = pi / 100.;
    SpringMotion motion = slider.move(half / 50., 300, [&](const double) { return -k * U0; });
    for (int n = 1; n <= 3; ++n)
      EXPECT_NEAR(U0 + at(motion, n * half),
                  (n % 2 == 0 ? 1. : -1.) * (U0 - 2. * n * friction / k),
                  1e-3 * U0)
        << "turning point " << n;
    EXPECT_NEAR(U0 + motion.displacements.back()[1], 0.05e-3, 1e-3 * U0);
    const MotionLedger &ledger = motion.ledgers.back();
    EXPECT_LT(std::abs(ledger.numerical), 1e-6 * ledger.largest);
    EXPECT_LT(std::abs(ledger.defect()), 1e-11 * ledger.largest);
    EXPECT_LT(motion.worst.worst(), 1e-9);
  }

  // What a spectral radius below 1 damps is known to the last digit: the terms of the ledger are
  // computed independently of each other.
  TEST(Springs, DampingOfTheMethodIsInTheLedger)
  {
    for (const double radius : {0., 0.5, 0.8})
      {
        const double k = 1e4;
        Slider slider(1., k, 10., coulomb(0.01));
        slider.springs.spectral_radius = radius;
        slider.springs.damping         = DenseMatrix(2, 2);
        slider.springs.damping(1, 1)   = 2.; // of the critical damping 0.01
        SpringMotion motion =
          slider.move(pi / 100. / 20., 200, [&](const double t) { return t < 0.1 ? 10. : -5.; });
        const MotionLedger &ledger = motion.ledgers.back();
        EXPECT_GT(ledger.numerical, 1e-5 * ledger.largest);
        EXPECT_LT(std::abs(ledger.defect()), 1e-11 * ledger.largest);
      }
  }

  // A pad on a spring and a frictional base under a sudden force (Code_Aster, SDNV104B):
  // x(T/2) = 2 (F - µN)/k, and back by 4 µN/k less.
  TEST(Springs, PadUnderASuddenForce)
  {
    const double F = 1e5, k = 1.2e4, friction = 1.05e4;
    Slider slider(1e3, k, friction / 0.3, coulomb(0.3));
    const double period = 2. * pi * std::sqrt(1e3 / k);
    SpringMotion motion = slider.move(period / 100., 100, [&](const double) { return F; });
    const char *source  = "closed form; Code_Aster SDNV104B";
    expect_answer({"D3 pad under a sudden force", "x(T/2) [m]", 2. * (F - friction) / k, source},
                  at(motion, 0.5 * period),
                  1e-3 * 14.9);
    expect_answer(
      {"D3 pad under a sudden force", "x(T) [m]", 3.5, source}, at(motion, period), 1e-3 * 14.9);
    EXPECT_LT(motion.worst.worst(), 1e-9);
  }

  // Two masses on a spring; the second one is pushed for 0.2 s, the first one rubs, and loses a
  // third of its friction with the first slip (Code_Aster, SDND106A).
  TEST(Springs, TwoMassesWithFrictionAtRestAndInMotion)
  {
    constexpr double m = 5., k = 1e4, N = 1e4, F = 3000.;
    FrictionLaw friction   = coulomb(0.3);
    friction.friction_loss = 0.1;
    // An element that is open all the time tells the displacement of the second mass.
    ToyJoint joint(2, 1., make_rigid_law(), make_linear_law(1e-4 / (m * 1e6)), friction);
    joint.elements[1].initial_gap = 1.;
    Springs springs;
    springs.masses    = {0., m, 0., m};
    springs.stiffness = springs.jumps = DenseMatrix(4, 4);
    for (std::size_t i = 0; i < 4; ++i)
      {
        springs.jumps(i, i)     = 1.;
        springs.stiffness(i, i) = i % 2 == 0 ? 1. : k;
      }
    springs.stiffness(1, 3) = springs.stiffness(3, 1) = -k;
    springs.step                                      = 1e-3;
    springs.loads    = [](const double) { return Vector{0., 0., 0., F}; };
    JointState first = virgin_state(joint.elements, 4, false);
    first.forces[0]  = -N;
    const SpringMotion motion(springs, joint.elements, first, 150);
    const char *problem = "D4 two masses with friction at rest and in motion";
    const char *source  = "Code_Aster SDND106A";
    const auto u        = [&](const double t, const std::size_t mass) {
      return motion.displacements[static_cast<std::size_t>(std::lround(t / 1e-3))][mass];
    };
    EXPECT_NEAR(u(0.02, 1), 0., 1e-6);
    expect_answer({problem, "u2(0.02) [m]", 0.11221, source}, u(0.02, 3), 1e-3 * 0.11221);
    expect_answer({problem, "u1(0.15) [m]", 1.35332, source}, u(0.15, 1), 1e-3 * 1.35332);
    expect_answer({problem, "u2(0.15) [m]", 1.80751, source}, u(0.15, 3), 1e-3 * 1.80751);
    EXPECT_LT(motion.worst.worst(), 1e-9);
  }

  // Newmark's sliding block under a rectangular pulse A of the duration T, yield N: it comes to
  // rest at A T/N, having slid (A T)²/(2 N) (1 - N/A).
  TEST(Springs, NewmarksBlock)
  {
    const double g = 9.81, A = 0.5 * g, T = 0.5, yield = 0.2 * g;
    Slider slider(1., 0., g, coulomb(0.2));
    SpringMotion motion = slider.move(0.005, 300, [&](const double t) {
      return std::abs(t - T) < 1e-9 ? -0.5 * A : t < T ? -A : 0.;
    });
    expect_answer({"D7 Newmark's block", "slip [m]", 0.9196875, "closed form (Newmark 1965)"},
                  -motion.displacements.back()[1],
                  1e-3 * 0.92);
    EXPECT_NEAR(at(motion, A * T / yield), motion.displacements.back()[1], 1e-4);
    EXPECT_GT(std::abs(at(motion, A * T / yield - 0.05) - motion.displacements.back()[1]), 1e-3);
    const MotionLedger &ledger = motion.ledgers.back();
    EXPECT_LT(std::abs(ledger.numerical), 1e-5 * ledger.largest);
    EXPECT_LT(std::abs(ledger.defect()), 1e-11 * ledger.largest);
    EXPECT_LT(motion.worst.worst(), 1e-9);
  }

  namespace
  {
    /** Of a block (m = 10, g = 10, f = 0.1) on a plane that is shaken with A sin 2πt: mean power of
     * wear from 4 s to 12 s, and the time of the first slip. */
    struct Wear
    {
      Wear(const double amplitude, const double step)
      {
        Slider slider(10., 0., 100., coulomb(0.1));
        const auto n_steps  = static_cast<unsigned int>(std::lround(12. / step));
        SpringMotion motion = slider.move(
          step, n_steps, [&](const double t) { return -10. * amplitude * std::sin(2. * pi * t); });
        const auto work = [&](const double t) {
          return motion.ledgers[static_cast<std::size_t>(std::lround(t / step))].joints;
        };
        power      = (work(12.) - work(4.)) / 8.;
        first_slip = motion.events.empty() ? 0. : motion.events.front().t * 12.;
        EXPECT_LT(motion.worst.worst(), 1e-9);
      }

      double power = 0., first_slip = 0.;
    };

    constexpr const char *wear_source = "Code_Aster SDND104A";
  } // namespace

  // The powers are those of Code_Aster's SDND104A, the times follow from A sin 2πt = f g. The load
  // is linear within a step, so what is sampled lacks (2πh)²/12 of its amplitude: errors fall with
  // h².
  TEST(Springs, WearOnAShakenPlane)
  {
    const Wear strong(15., 0.01), medium(1.5, 0.005), none(0.99, 0.01);
    expect_answer(
      {"D2 block on a shaken plane", "power of wear, A = 15 [W]", 15.2670996, wear_source},
      strong.power,
      1e-3 * 15.3);
    expect_answer(
      {"D2 block on a shaken plane", "power of wear, A = 1.5 [W]", 0.409062451, wear_source},
      medium.power,
      1e-3 * 0.409);
    EXPECT_NEAR(strong.first_slip, 0.0106182, 1e-4);
    EXPECT_NEAR(medium.first_slip, 0.1161398, 1e-4);
    EXPECT_EQ(none.first_slip, 0.);
    EXPECT_LT(none.power, 1e-12);
  }

  TEST(Springs, WearConvergesWithTheSquareOfTheStep)
  {
    const double known = 2.26164121e-4;
    double fine        = 0.;
    for (const double step : {0.01, 0.005, 0.0025})
      {
        fine = Wear(1.01, step).power - known;
        // Slips last as long as the root of the excess, 0.01 of the strength, and their velocities
        // grow with its power 1.5: the power is that of its square.
        const double lacking = 1.01 * std::pow(2. * pi * step, 2) / 12.;
        EXPECT_LT(std::abs(fine), 1.5 * known * 2. * lacking / 0.01) << step;
      }
    expect_answer({"D2 block on a shaken plane", "power of wear, A = 1.01 [W]", known, wear_source},
                  known + fine,
                  6e-3 * known);
  }

  // A point without mass on a damper is pulled along, by 1 m/s in a step of 1 µs and then, in steps
  // of 0.1 s, at 0.5 m/s. The trapezoidal rule has v = 2 Δu/h - v before: 2 m/s, then -1 and 2 in
  // turn. The acceleration of the first step, 4e6 m/s², must not be in the sums: it would leave
  // 1e-10.
  TEST(Springs, SuddenVelocityWithoutMassLeavesNoRounding)
  {
    TimeIntegration integration(
      {0.}, [](const Vector &v) { return Vector{3. * v[0]}; }, 1.);
    integration.begin({0.}, {0.});
    MotionLedger ledger;
    const auto pull = [&](const double h, const double speed) {
      integration.advance(h, {h * speed - integration.predicted(h).u[0]}, {0.}, ledger);
    };
    pull(1e-6, 1.);
    EXPECT_NEAR(integration.velocity()[0], 2., 1e-14);
    for (unsigned int n = 0; n < 100; ++n)
      {
        pull(0.1, 0.5);
        EXPECT_NEAR(integration.velocity()[0], n % 2 == 0 ? -1. : 2., 1e-13);
      }
  }
} // namespace fuga::tests
