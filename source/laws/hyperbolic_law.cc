// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/hyperbolic_law.h>

#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  HyperbolicLaw::HyperbolicLaw(const double initial_compliance, const double closure_limit)
    : compliance(initial_compliance), limit(closure_limit)
  {
  }

  double
  HyperbolicLaw::stress(const double w) const
  {
    return w / (compliance * (1. - w / limit));
  }

  double
  HyperbolicLaw::tangent(const double w) const
  {
    const double rest = 1. - w / limit;
    return 1. / (compliance * rest * rest);
  }

  // With u = w/V_m, ∫σ dw is (V_m²/ρ0)(-ln(1 - u) - u).
  double
  HyperbolicLaw::energy(const double w) const
  {
    return limit * limit / compliance * rest_of_logarithm(w / limit, 2);
  }

  double
  HyperbolicLaw::deformation(const double sigma) const
  {
    return sigma > 0. ? limit * (sigma * compliance / (limit + sigma * compliance)) : 0.;
  }

  double
  HyperbolicLaw::deformation_limit() const
  {
    return limit;
  }

  double
  HyperbolicLaw::deformation_scale() const
  {
    return limit;
  }

  std::string
  HyperbolicLaw::description() const
  {
    return fmt::format(
      "hyperbolic law, initial compliance {:g}, closure limit {:g}", compliance, limit);
  }
} // namespace fuga
