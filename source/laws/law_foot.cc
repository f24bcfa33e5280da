// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/law_foot.h>

namespace fuga
{
  // The conditions are value, slope m and curvature k at ξ = 1: b + c + d = 1 - a,
  // 2b + 3c + 4d = m - a, 2b + 6c + 12d = k.
  LawFoot::LawFoot(const double foot_length,
                   const double stress_at_end,
                   const double slope,
                   const double curvature,
                   const double initial_slope)
    : length(foot_length)
    , end_stress(stress_at_end)
    , a(initial_slope)
    , d(0.5 * curvature + 3. * (1. - a) - 2. * (slope - a))
    , c(slope - a - 2. * (1. - a) - 2. * d)
    , b(1. - a - c - d)
  {
  }

  double
  LawFoot::cubic_slope(const double slope, const double curvature)
  {
    return 3. - 2. * slope + 0.5 * curvature;
  }

  double
  LawFoot::stress(const double w) const
  {
    const double x = w / length;
    return end_stress * x * (a + x * (b + x * (c + x * d)));
  }

  double
  LawFoot::tangent(const double w) const
  {
    const double x = w / length;
    return end_stress / length * (a + x * (2. * b + x * (3. * c + x * 4. * d)));
  }

  double
  LawFoot::energy(const double w) const
  {
    const double x = w / length;
    return end_stress * length * x * x * (a / 2. + x * (b / 3. + x * (c / 4. + x * d / 5.)));
  }
} // namespace fuga
