// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/nonlinear_law.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  ComplianceKind
  NonlinearLaw::kind() const
  {
    return ComplianceKind::nonlinear;
  }

  double
  NonlinearLaw::initial_compliance() const
  {
    return 1. / tangent(0.);
  }

  double
  NonlinearLaw::compliance_towards(const double secant_compliance) const
  {
    const double initial = initial_compliance();
    return std::min(initial, std::sqrt(initial * secant_compliance));
  }

  double
  NonlinearLaw::secant(const double w) const
  {
    return w > 0. ? stress(w) / w : tangent(0.);
  }

  double
  NonlinearLaw::deformation_between(const double sigma, double lower, double upper) const
  {
    const int max_iterations = 200;
    const double lowest = stress(lower), highest = stress(upper);
    double w = lower + (upper - lower) * (sigma - lowest) / (highest - lowest);
    if (!(w > lower && w <= upper))
      w = 0.5 * (lower + upper);
    double change = upper - lower, last_change = change;
    for (int i = 0; i < max_iterations; ++i)
      {
        const double residual           = stress(w) - sigma;
        (residual > 0. ? upper : lower) = w;
        const double slope              = tangent(w);
        double next                     = w - residual / slope;
        // Newton's method creeps along an exponential, so a step must be below half of the last but
        // one. It would stagnate where only the slope overflows.
        if (!(std::isfinite(slope) && next >= lower && next <= upper &&
              std::abs(next - w) <= 0.5 * last_change))
          next = 0.5 * (lower + upper);
        last_change = change;
        change      = std::abs(next - w);
        w           = next;
        if (change <= 2. * std::numeric_limits<double>::epsilon() * w)
          break;
      }
    return w;
  }

  // The closed form cancels: at q = 0.3 the terms that begin with q⁶ are 5e-4 of the logarithm.
  // Extended precision has these digits to spare; for smaller q the series needs few terms.
  double
  NonlinearLaw::rest_of_logarithm(const double q, const int first)
  {
    constexpr double series_limit = 0.3;
    if (q > series_limit)
      {
        long double sum = 0.L;
        for (int k = first - 1; k > 0; --k)
          sum = q * (1.L / k + sum);
        return static_cast<double>(-std::log1p(-static_cast<long double>(q)) - sum);
      }
    double sum   = 0.;
    double power = std::pow(q, first);
    for (int k = first; power > 1e-18 * sum && k < 100; ++k, power *= q)
      sum += power / k;
    return sum;
  }
} // namespace fuga
