// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_cubic_root_law_h
#define fuga_laws_cubic_root_law_h

#include <fuga/laws/nonlinear_law.h>

namespace fuga
{
  /**
   * The common base of both readings of law (9) of the paper, C(u) = A/[ρ0 (1 - q)] with q =
   * (w/ζ0)^{1/3}.
   */
  class LawNine : public NonlinearLaw
  {
  public:
    double
    initial_compliance() const override;
    double
    deformation_limit() const override;
    double
    deformation_scale() const override;

  protected:
    /** @p initial_compliance ρ0 > 0 [m/MPa], @p thickness ζ0 > 0 [m], the closure limit. */
    LawNine(const double initial_compliance, const double thickness);

    /** Return q. */
    double
    root(const double w) const;
    /** Return C(u)/A = 1/[ρ0 (1 - q)] [MPa/m]. */
    double
    stiffness(const double w) const;

    const double compliance;
    const double thickness;
  };

  /**
   * Law (9) as equations (5) and (6) of the paper use it: C is the secant stiffness, C(u) u is the
   * force of the layer. σ = w / [ρ0 (1 - q)], dσ/dw = (1 - 2q/3) / [ρ0 (1 - q)²].
   */
  class CubicRootLaw : public LawNine
  {
  public:
    CubicRootLaw(const double initial_compliance, const double thickness);

    double
    stress(const double w) const override;
    double
    tangent(const double w) const override;
    double
    secant(const double w) const override;
    double
    energy(const double w) const override;
    double
    deformation(const double sigma) const override;
    std::string
    description() const override;
  };

  /**
   * The other reading of law (9): C(u) is the tangent stiffness of the layer, as in a step-by-step
   * analysis.
   *     dσ/dw = 1 / [ρ0 (1 - q)],   σ = (3 ζ0/ρ0) [-ln(1 - q) - q - q²/2].
   * It is softer than the secant reading, and its stress grows only like a logarithm near the
   * limit.
   */
  class CubicRootTangentLaw : public LawNine
  {
  public:
    CubicRootTangentLaw(const double initial_compliance, const double thickness);

    double
    stress(const double w) const override;
    double
    tangent(const double w) const override;
    double
    energy(const double w) const override;
    double
    deformation(const double sigma) const override;
    std::string
    description() const override;
  };
} // namespace fuga

#endif
