// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_power_law_h
#define fuga_laws_power_law_h

#include <fuga/laws/law_foot.h>
#include <fuga/laws/nonlinear_law.h>

namespace fuga
{
  /**
   * σ = σ_r (w/w_r)^m. The power itself has the tangent 0 (m > 1) or ∞ (m < 1) at w = 0. Up to
   *     w1 = w_r max(10^{-3/|m-1|}, 10⁻³ (m > 1) or 10⁻⁶ (m ≤ 1))
   * a polynomial leads from the origin to the curve and meets it with equal value, slope and
   * curvature. Thus the initial stiffness is within a factor of some thousand of σ_r/w_r.
   */
  class PowerLaw : public NonlinearLaw
  {
  public:
    /** Smallest and largest exponent. */
    static constexpr double smallest_exponent = 0.2;
    static constexpr double largest_exponent  = 5.;

    /** @p reference_deformation w_r > 0 [m], @p reference_stress σ_r > 0 [MPa], @p exponent m. */
    PowerLaw(const double reference_deformation,
             const double reference_stress,
             const double exponent);

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
    const double scale;
    const double reference;
    const double exponent;
    const LawFoot foot;
  };
} // namespace fuga

#endif
