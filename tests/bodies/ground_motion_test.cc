// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/ground_motion.h>
#include <fuga/bodies/dynamics/response_spectrum.h>
#include <fuga/bodies/dynamics/time_steps.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    const double pi = std::acos(-1.);

    /** Samples of a function at n + 1 times from 0 to @p duration. */
    template <typename Function>
    GroundMotion
    sampled(const Function &a, const double duration, const unsigned int n)
    {
      GroundMotion motion;
      motion.step = duration / n;
      for (unsigned int i = 0; i <= n; ++i)
        motion.accelerations.push_back(a(i * motion.step));
      return motion;
    }

    TEST(GroundMotion, IsLinearBetweenItsSamplesAndZeroBehindThem)
    {
      const GroundMotion motion = {0.5, {1., 3., -2.}};
      EXPECT_EQ(duration_of(motion), 1.);
      EXPECT_EQ(acceleration_at(motion, 0.), 1.);
      EXPECT_EQ(acceleration_at(motion, 0.125), 1.5);
      EXPECT_EQ(acceleration_at(motion, 0.75), 0.5);
      EXPECT_EQ(acceleration_at(motion, 1.), -2.);
      EXPECT_EQ(acceleration_at(motion, 1.0001), 0.);
      EXPECT_EQ(acceleration_at(motion, -0.1), 0.);
      EXPECT_EQ(acceleration_at({}, 0.), 0.);
      EXPECT_EQ(duration_of({}), 0.);
    }

    // a = 2 - 3t: v = 2t - 3t²/2, u = t² - t³/2, at the samples but for rounding.
    TEST(GroundMotion, IsIntegratedExactly)
    {
      const GroundMotion motion     = sampled([](const double t) { return 2. - 3. * t; }, 4., 7);
      const IntegratedMotion result = integrated(motion);
      for (unsigned int i = 0; i <= 7; ++i)
        {
          const double t = i * motion.step;
          EXPECT_NEAR(result.velocities[i], 2. * t - 1.5 * t * t, 1e-13);
          EXPECT_NEAR(result.displacements[i], t * t - 0.5 * t * t * t, 1e-13);
        }
    }

    // Of a harmonic motion over whole periods the mean period is its own; chords instead of arcs
    // change it by the square of 2π step/period.
    TEST(GroundMotion, HasAMeanPeriod)
    {
      const GroundMotion motion =
        sampled([](const double t) { return std::sin(2. * pi * t / 0.4); }, 2., 1000);
      EXPECT_NEAR(mean_period(motion), 0.4, 0.4 * std::pow(2. * pi * 0.002 / 0.4, 2));
      EXPECT_TRUE(std::isinf(mean_period({0.1, {1., 1., 1.}})));
    }

    TEST(GroundMotion, AParabolaIsTakenOff)
    {
      const GroundMotion parabola =
        sampled([](const double t) { return 0.3 - t + 0.25 * t * t; }, 5., 50);
      for (const double a : without_parabola(parabola).accelerations)
        EXPECT_NEAR(a, 0., 1e-12);
      // The normal equations of t³ on [0, 1], solved with rational numbers: 5/112 - 15/28 t + 45/32
      // t². Samples instead of the function cost the square of the step.
      const GroundMotion cubic = sampled([](const double t) { return t * t * t; }, 1., 1000);
      const GroundMotion rest  = without_parabola(cubic);
      for (unsigned int i = 0; i <= 1000; ++i)
        {
          const double t = i / 1000.;
          EXPECT_NEAR(rest.accelerations[i],
                      t * t * t - (5. / 112. - 15. / 28. * t + 45. / 32. * t * t),
                      1e-5);
        }
    }

    /** ∫ v w dt by Boole's rule, exact for these products of the fourth degree. */
    double
    product_of_velocities(const GroundMotion &a, const GroundMotion &b)
    {
      const auto velocity = [](const GroundMotion &motion, const std::size_t i, const double s) {
        const double a0 = motion.accelerations[i], a1 = motion.accelerations[i + 1];
        return integrated(motion).velocities[i] + motion.step * (a0 * s + (a1 - a0) * s * s / 2.);
      };
      const double weights[] = {7., 32., 12., 32., 7.};
      double sum             = 0.;
      for (std::size_t i = 0; i + 1 < a.accelerations.size(); ++i)
        for (unsigned int k = 0; k < 5; ++k)
          sum += weights[k] / 90. * a.step * velocity(a, i, k / 4.) * velocity(b, i, k / 4.);
      return sum;
    }

    // What is left moves orthogonally to what 1, t and t² would do, also with five samples.
    TEST(GroundMotion, NoParabolaWouldLeaveLessVelocity)
    {
      const GroundMotion rest = without_parabola({0.3, {1., -2., 0.5, 3., -1.}});
      for (unsigned int power = 0; power < 3; ++power)
        {
          const GroundMotion motion =
            sampled([power](const double t) { return std::pow(t, power); }, 1.2, 4);
          EXPECT_NEAR(product_of_velocities(rest, motion), 0., 1e-14);
        }
    }

    // An oscillator in a rectangular pulse a of the duration d (A. K. Chopra, Dynamics of
    // Structures, section 4.7): without damping u = 2a/ω² from d = T/2 on, 2a/ω² sin(πd/T) below,
    // after the end of the record; with damping, in a long one, a/ω² (1 + exp(-πξ/√(1 - ξ²))).
    TEST(ResponseSpectrum, OfARectangularPulse)
    {
      const double a           = 3.;
      const GroundMotion pulse = {0.1, Vector(11, a)};
      for (const double period : {0.03, 0.4, 1., 1.9, 2.1, 3., 10.})
        {
          const double omega = 2. * pi / period;
          const double undamped =
            2. * a / (omega * omega) * (period <= 2. ? 1. : std::sin(pi / period));
          const SpectralResponse response = response_spectrum(pulse, {period}, 0.)[0];
          EXPECT_EQ(response.period, period);
          EXPECT_NEAR(response.displacement, undamped, 1e-10 * undamped);
          EXPECT_NEAR(response.pseudo_acceleration, omega * omega * undamped, 1e-9);
          // v = a/ω sin ωt, and a free vibration after the pulse.
          if (period >= 2.)
            {
              const double velocity =
                a / omega * std::max(2. * std::sin(pi / period), period <= 4. ? 1. : 0.);
              EXPECT_NEAR(response.velocity, velocity, 1e-10);
            }
          if (period <= 1.)
            {
              const double damped =
                a / (omega * omega) * (1. + std::exp(-pi * 0.05 / std::sqrt(1. - 0.05 * 0.05)));
              EXPECT_NEAR(
                response_spectrum(pulse, {period})[0].displacement, damped, 1e-10 * damped);
            }
        }
    }

    // In resonance the amplitude tends to a/(2ξω²); 60 periods leave exp(-2π ξ 60) of the
    // difference, and samples 200 times in a period lower it by the square of 2π/200, a twelfth.
    TEST(ResponseSpectrum, InResonance)
    {
      const double period = 0.5, omega = 2. * pi / period;
      const GroundMotion harmonic =
        sampled([&](const double t) { return std::sin(omega * t); }, 60. * period, 60 * 200);
      const double amplitude          = 1. / (2. * 0.05 * omega * omega);
      const SpectralResponse response = response_spectrum(harmonic, {period})[0];
      EXPECT_NEAR(response.displacement, amplitude, 2e-4 * amplitude);
      EXPECT_NEAR(response.velocity, omega * amplitude, 2e-4 * omega * amplitude);
    }

    TEST(TimeSteps, LevelsAreEndsOfSteps)
    {
      DynamicsDefinition dynamics;
      dynamics.time_step = 0.005;
      StageDefinition stage;
      stage.duration = 20.;
      EXPECT_EQ(number_of_time_steps(dynamics, stage), 4000.);
      stage.levels = 3; // 1333.33 steps each
      EXPECT_EQ(number_of_time_steps(dynamics, stage), 3. * 1334.);
      stage.duration = 0.001;
      EXPECT_EQ(number_of_time_steps(dynamics, stage), 3.);
    }
  } // namespace
} // namespace fuga
