// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/nonlinear_law.h>

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
  NonlinearLaw::secant(const double w) const
  {
    return w > 0. ? stress(w) / w : tangent(0.);
  }

  double
  NonlinearLaw::deformation_between(const double sigma, double lower, double upper) const
  {
    const int max_iterations = 200;
    double w                 = 0.5 * (lower + upper);
    for (int i = 0; i < max_iterations; ++i)
      {
        const double residual           = stress(w) - sigma;
        (residual > 0. ? upper : lower) = w;
        double next                     = w - residual / tangent(w);
        if (!(next >= lower && next <= upper))
          next = 0.5 * (lower + upper);
        const double change = std::abs(next - w);
        w                   = next;
        if (change <= std::numeric_limits<double>::epsilon() * w)
          break;
      }
    return w;
  }
} // namespace fuga
