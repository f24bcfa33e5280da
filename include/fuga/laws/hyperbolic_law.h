// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_hyperbolic_law_h
#define fuga_laws_hyperbolic_law_h

#include <fuga/laws/nonlinear_law.h>

namespace fuga
{
  /**
   * Closure of a rock joint after Bandis, Lumsden and Barton (1983):
   *     σ = w / [ρ0 (1 - w/V_m)],   dσ/dw = 1 / [ρ0 (1 - w/V_m)²],   w = σ ρ0 V_m / (V_m + ρ0 σ),
   * with the initial stiffness K_ni = 1/ρ0 and the closure limit V_m.
   */
  class HyperbolicLaw : public NonlinearLaw
  {
  public:
    /** @p initial_compliance ρ0 > 0 [m/MPa], @p closure_limit V_m > 0 [m]. */
    HyperbolicLaw(const double initial_compliance, const double closure_limit);

    double
    stress(const double w) const override;
    double
    tangent(const double w) const override;
    double
    energy(const double w) const override;
    double
    deformation(const double sigma) const override;
    double
    deformation_limit() const override;
    double
    deformation_scale() const override;
    std::string
    description() const override;

  private:
    const double compliance;
    const double limit;
  };
} // namespace fuga

#endif
