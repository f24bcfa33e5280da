// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/ground_motion.h>
#include <fuga/bodies/dynamics/response_spectrum.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Number of parts of a period, in each of which displacement and velocity have at most one
     * extremum. */
    constexpr double parts_of_period = 20.;

    struct Oscillator
    {
      Oscillator(const double period, const double damping_ratio)
        : omega(2. * std::acos(-1.) / period)
        , damping(damping_ratio)
        , damped_omega(omega * std::sqrt(1. - damping * damping))
      {
      }

      const double omega, damping, damped_omega;
    };

    struct Motion
    {
      double displacement = 0., velocity = 0.;
    };

    /**
     * The exact motion under the ground acceleration a + s τ: the equation u'' + 2ξω u' + ω²
     * u = -a - s τ has the solution -(a + s τ)/ω² + 2ξ s/ω³ + exp(-ξωτ) (A cos ω_d τ + B sin ω_d
     * τ).
     */
    class Step
    {
    public:
      Step(const Oscillator &the_oscillator,
           const Motion &begin,
           const double acceleration,
           const double change_of_acceleration)
        : oscillator(the_oscillator), a(acceleration), s(change_of_acceleration)
      {
        const double w = oscillator.omega, xi = oscillator.damping;
        A = begin.displacement + a / (w * w) - 2. * xi * s / (w * w * w);
        B = (begin.velocity + xi * w * A + s / (w * w)) / oscillator.damped_omega;
      }

      Motion
      at(const double tau) const
      {
        const double w = oscillator.omega, xi = oscillator.damping, wd = oscillator.damped_omega;
        const double decay = std::exp(-xi * w * tau);
        const double c = decay * std::cos(wd * tau), d = decay * std::sin(wd * tau);
        return {A * c + B * d - (a + s * tau) / (w * w) + 2. * xi * s / (w * w * w),
                (wd * B - xi * w * A) * c - (wd * A + xi * w * B) * d - s / (w * w)};
      }

      double
      relative_acceleration(const double tau) const
      {
        const Motion motion = at(tau);
        return -a - s * tau - 2. * oscillator.damping * oscillator.omega * motion.velocity -
               oscillator.omega * oscillator.omega * motion.displacement;
      }

    private:
      const Oscillator &oscillator;
      double a, s, A, B;
    };

    /** Return the zero of a function that has different signs at the ends of [0, length]. */
    template <typename Function>
    double
    root(const Function &function, const double length)
    {
      double low = 0., high = length;
      const bool rises = function(high) > 0.;
      for (double middle = length / 2.; middle != low && middle != high; middle = (low + high) / 2.)
        ((function(middle) > 0.) == rises ? high : low) = middle;
      return high;
    }

    /** Advance by @p length seconds and update the maxima. */
    void
    advance(const Step &step, const double length, Motion &motion, SpectralResponse &largest)
    {
      const auto keep = [&largest](const Motion &at) {
        largest.displacement = std::max(largest.displacement, std::abs(at.displacement));
        largest.velocity     = std::max(largest.velocity, std::abs(at.velocity));
      };
      const Motion end = step.at(length);
      if (motion.velocity * end.velocity < 0.)
        keep(step.at(root([&](const double tau) { return step.at(tau).velocity; }, length)));
      const auto acceleration = [&](const double tau) { return step.relative_acceleration(tau); };
      if (acceleration(0.) * acceleration(length) < 0.)
        keep(step.at(root(acceleration, length)));
      keep(end);
      motion = end;
    }

    SpectralResponse
    response(const GroundMotion &ground, const double period, const double damping)
    {
      const Oscillator oscillator(period, damping);
      const Vector &a = ground.accelerations;
      const double n  = std::max(1., std::ceil(parts_of_period * ground.step / period));
      const double h  = ground.step / n;
      Motion motion;
      SpectralResponse largest;
      largest.period = period;
      for (std::size_t i = 0; i + 1 < a.size(); ++i)
        {
          const double rate = (a[i + 1] - a[i]) / ground.step;
          for (double k = 0.; k < n; ++k)
            advance(Step(oscillator, motion, a[i] + k * h * rate, rate), h, motion, largest);
        }
      // After the record follows a free vibration, in which no later period has a larger motion
      // than the first one.
      for (double k = 0.; k < parts_of_period; ++k)
        advance(Step(oscillator, motion, 0., 0.), period / parts_of_period, motion, largest);
      largest.pseudo_acceleration = oscillator.omega * oscillator.omega * largest.displacement;
      return largest;
    }
  } // namespace


  std::vector<SpectralResponse>
  response_spectrum(const GroundMotion &motion, const Vector &periods, const double damping)
  {
    std::vector<SpectralResponse> spectrum;
    for (const double period : periods)
      spectrum.push_back(response(motion, period, damping));
    return spectrum;
  }
} // namespace fuga
