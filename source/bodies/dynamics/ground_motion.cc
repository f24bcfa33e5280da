// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/dynamics/ground_motion.h>

#include <array>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return ∫ v w dt of two motions whose velocities are quadratic between their samples; Gauss'
     * rule with three points is exact for it. */
    double
    product_of_velocities(const GroundMotion &v_motion, const GroundMotion &w_motion)
    {
      const Vector v = integrated(v_motion).velocities, w = integrated(w_motion).velocities;
      const double h                                  = v_motion.step;
      const double outer                              = std::sqrt(3. / 5.) / 2.;
      const std::array<std::array<double, 2>, 3> rule = {
        {{{0.5 - outer, 5. / 18.}}, {{0.5, 8. / 18.}}, {{0.5 + outer, 5. / 18.}}}};
      double sum = 0.;
      for (std::size_t i = 0; i + 1 < v.size(); ++i)
        for (const auto &[s, weight] : rule)
          {
            const double t = h * (static_cast<double>(i) + s);
            sum += weight * velocity_at(v_motion, v, t) * velocity_at(w_motion, w, t);
          }
      return sum * h;
    }
  } // namespace


  double
  acceleration_at(const GroundMotion &motion, const double t)
  {
    const double place = t / motion.step;
    const Vector &a    = motion.accelerations;
    if (a.empty() || !(place >= 0. && place <= static_cast<double>(a.size() - 1)))
      return 0.;
    const auto i = static_cast<std::size_t>(place);
    return i + 1 == a.size() ? a[i] : a[i] + (place - static_cast<double>(i)) * (a[i + 1] - a[i]);
  }


  double
  duration_of(const GroundMotion &motion)
  {
    return motion.accelerations.empty()
             ? 0.
             : motion.step * static_cast<double>(motion.accelerations.size() - 1);
  }


  IntegratedMotion
  integrated(const GroundMotion &motion)
  {
    const Vector &a = motion.accelerations;
    const double h  = motion.step;
    IntegratedMotion result;
    double v = 0., u = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        if (i > 0)
          {
            u += h * v + h * h * (a[i - 1] / 3. + a[i] / 6.);
            v += h * (a[i - 1] + a[i]) / 2.;
          }
        result.velocities.push_back(v);
        result.displacements.push_back(u);
      }
    return result;
  }


  double
  velocity_at(const GroundMotion &motion, const Vector &velocities, const double t)
  {
    if (velocities.empty() || t <= 0.)
      return 0.;
    const double place = t / motion.step;
    if (place >= static_cast<double>(velocities.size() - 1))
      return velocities.back();
    const auto i    = static_cast<std::size_t>(place);
    const double s  = place - static_cast<double>(i);
    const Vector &a = motion.accelerations;
    return velocities[i] + motion.step * s * (a[i] + s / 2. * (a[i + 1] - a[i]));
  }


  double
  mean_period(const GroundMotion &motion)
  {
    const Vector &a = motion.accelerations;
    double size = 0., change = 0.;
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
      {
        size += (a[i] * a[i] + a[i] * a[i + 1] + a[i + 1] * a[i + 1]) / 3.;
        change += (a[i + 1] - a[i]) * (a[i + 1] - a[i]);
      }
    return 2. * std::acos(-1.) * motion.step * std::sqrt(size / change);
  }


  GroundMotion
  without_parabola(const GroundMotion &motion)
  {
    constexpr std::size_t n = 3;
    const std::size_t last  = motion.accelerations.size() - 1;
    std::array<GroundMotion, n> powers;
    for (std::size_t k = 0; k < n; ++k)
      {
        powers[k].step = motion.step;
        for (std::size_t i = 0; i <= last; ++i)
          powers[k].accelerations.push_back(
            std::pow(static_cast<double>(i) / static_cast<double>(last), k));
      }
    DenseMatrix products(n, n), coefficients(n, 1);
    for (std::size_t k = 0; k < n; ++k)
      {
        for (std::size_t l = 0; l < n; ++l)
          products(k, l) = product_of_velocities(powers[k], powers[l]);
        coefficients(k, 0) = product_of_velocities(powers[k], motion);
      }
    LuFactors(std::move(products)).solve(coefficients);
    GroundMotion result = motion;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i <= last; ++i)
        result.accelerations[i] -= coefficients(k, 0) * powers[k].accelerations[i];
    return result;
  }
} // namespace fuga
