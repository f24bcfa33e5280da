// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cubic.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Return ∫ f(x) dx over [0, 1] by Gauss's rule with three points, which is exact for
     * polynomials of degree five. */
    template <typename Function>
    double
    integral(const Function &f)
    {
      const double r = std::sqrt(0.15);
      return (5. * f(0.5 - r) + 8. * f(0.5) + 5. * f(0.5 + r)) / 18.;
    }
  } // namespace

  CubicOnUnitInterval::CubicOnUnitInterval(const double value_0,
                                           const double slope_0,
                                           const double value_1,
                                           const double slope_1)
    : c0(value_0)
    , c1(slope_0)
    , c2(3. * (value_1 - value_0) - 2. * slope_0 - slope_1)
    , c3(2. * (value_0 - value_1) + slope_0 + slope_1)
  {
  }

  double
  CubicOnUnitInterval::value(const double x) const
  {
    return c0 + x * (c1 + x * (c2 + x * c3));
  }

  double
  CubicOnUnitInterval::slope(const double x) const
  {
    return c1 + x * (2. * c2 + x * 3. * c3);
  }

  // The minimiser has zero slope and positive curvature; it is 1 if it does not lie inside.
  double
  CubicOnUnitInterval::inner_minimiser() const
  {
    const double discriminant = c2 * c2 - 3. * c1 * c3;
    if (discriminant <= 0.)
      return 1.;
    // This is the root of c1 + 2 c2 x + 3 c3 x² with positive second derivative, without
    // cancellation.
    const double root = std::sqrt(discriminant);
    const double x    = c2 > 0. ? -c1 / (c2 + root) : (root - c2) / (3. * c3);
    return x > 0. && x < 1. ? x : 1.;
  }

  double
  CubicOnUnitInterval::minimum() const
  {
    return std::min({value(0.), value(inner_minimiser()), value(1.)});
  }

  // Up to its inner minimum the cubic falls through zero at most once. Bisection combined with
  // secants is safe and short.
  double
  CubicOnUnitInterval::first_descending_root() const
  {
    if (value(0.) < 0.)
      return 0.;
    double low = 0., high = inner_minimiser();
    if (value(high) >= 0.)
      high = 1.;
    if (value(high) >= 0.)
      return 1.;
    for (int i = 0; i < 200 && high - low > std::numeric_limits<double>::epsilon() * high; ++i)
      {
        const double v_low = value(low), v_high = value(high);
        double x = low + (high - low) * v_low / (v_low - v_high);
        if (i % 2 == 1 || !(x > low && x < high))
          x = 0.5 * (low + high);
        (value(x) >= 0. ? low : high) = x;
      }
    return high;
  }

  double
  work_of(const CubicOnUnitInterval &force, const CubicOnUnitInterval &jump)
  {
    return integral([&](const double x) { return force.value(x) * jump.slope(x); });
  }

  double
  work_across(const std::array<CubicOnUnitInterval, 2> &force,
              const std::array<CubicOnUnitInterval, 2> &slip,
              const double x)
  {
    return std::abs(force[0].value(x) * slip[1].slope(x) - force[1].value(x) * slip[0].slope(x));
  }

  double
  detour(const CubicOnUnitInterval &first, const CubicOnUnitInterval &second)
  {
    const double chord[] = {first.value(1.) - first.value(0.), second.value(1.) - second.value(0.)};
    const double size    = std::hypot(chord[0], chord[1]);
    return integral([&](const double x) {
      const double a = first.slope(x), b = second.slope(x);
      const double along = size > 0. ? (chord[0] * a + chord[1] * b) / size : 0.;
      return std::hypot(a, b) - along;
    });
  }
} // namespace fuga
