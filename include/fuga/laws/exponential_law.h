// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_exponential_law_h
#define fuga_laws_exponential_law_h

#include <fuga/laws/law_foot.h>
#include <fuga/laws/nonlinear_law.h>

namespace fuga
{
  /**
   * The exponential contact pressure of CalculiX: p = p0 exp(-β g) with β = ln(100)/c0, zero beyond
   * the clearance c0. Contact begins there, so the closure is w = c0 - g and
   *     σ = p0 exp(-β (c0 - w)),   dσ/dw = β σ.
   * The jump of p0/100 at w = 0 is replaced: up to w = c0/20 a cubic leads from the origin to the
   * curve and meets it with equal value, slope and curvature. From there on the formula is exact.
   */
  class ExponentialLaw : public NonlinearLaw
  {
  public:
    /** @p reference_closure c0 > 0 [m], at which the stress is @p reference_stress p0 > 0 [MPa]. */
    ExponentialLaw(const double reference_closure, const double reference_stress);

    double
    reference_compliance() const override;
    double
    stress(const double w) const override;
    double
    tangent(const double w) const override;
    double
    energy(const double w) const override;
    double
    deformation(const double sigma) const override;
    double
    deformation_scale() const override;
    std::vector<double>
    knots() const override;
    std::string
    description() const override;

  private:
    const double closure;
    const double pressure;
    const double beta;
    const LawFoot foot;
  };
} // namespace fuga

#endif
