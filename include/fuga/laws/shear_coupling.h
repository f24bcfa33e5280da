// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_shear_coupling_h
#define fuga_laws_shear_coupling_h

#include <fuga/laws/compliance_law.h>

namespace fuga
{
  /**
   * A layer whose shear stiffness k_t = 1/ρt grows as it closes, the last requirement of the paper.
   * A shear stiffness that simply followed the closure would create energy on closed loops;
   * therefore both stresses are derived from one potential (doc/theory.md, section 7):
   *
   *     closure:    ρt(w) = ρt0 (1 - w/w_c)^m,     ψ(w,e)  = ψ_n(w) + e²/(2ρt),
   *                 σ = ∂ψ/∂w = σ_n(w) + ½k_t'(w)e²,   τ = ∂ψ/∂e = k_t(w) e,
   *     pressure:   ρt(σ) = ρt0 (1 + σ/σ_r)^{-m},  ψ*(σ,τ) = ψ_n*(σ) + ½ρt(σ)τ²,
   *                 w = ∂ψ* /∂σ = w_n(σ) + ½ρt'(σ)τ²,  e = ∂ψ* /∂τ = ρt(σ)τ,
   *
   * with w the closure, e the elastic shear jump. For 0 < m ≤ 1 both potentials are convex: the
   * layer is stable in every state. The price of the potential is that shear widens the layer.
   */
  class ShearCoupling
  {
  public:
    enum class Kind
    {
      closure,
      pressure
    };

    /** Stresses [MPa] and their symmetric tangent [MPa/m]. */
    struct Response
    {
      double sigma = 0., tau = 0.;
      double dsigma_dw = 0., dsigma_de = 0., dtau_de = 0.;
    };

    /**
     * @p normal_law σ_n is not rigid and has to outlive this object; @p compliance is ρt0 > 0
     * [m/MPa], @p scale is w_c [m] or σ_r [MPa], @p exponent is m.
     */
    ShearCoupling(const Kind kind,
                  const ComplianceLaw &normal_law,
                  const double compliance,
                  const double scale,
                  const double exponent);

    /** Return σ and τ at closure w (negative: layer under tension) and elastic shear jump e. */
    Response
    response(const double w, const double e) const;

    /** A closure and an elastic shear jump [m]. */
    struct Deformation
    {
      double closure = 0., shear = 0.;
    };

    /** Return the deformation that belongs to both stresses, the inverse of response(). */
    Deformation
    deformation(const double sigma, const double tau) const;

    /** Return the elastic shear jump that belongs to closure w and shear stress τ. */
    double
    shear_deformation(const double w, const double tau) const;

    /** Return the energy stored per area, ψ [MPa m]. */
    double
    energy(const double w, const double e) const;

    /** Return the closure that no finite stress reaches [m]. */
    double
    closure_limit() const;

    std::string
    description() const;

  private:
    /** k_t and its first two derivatives, at a closure or at a pressure. */
    struct Stiffness
    {
      double value, first, second;
    };

    Stiffness
    stiffness(const double at) const;
    double
    normal_stress(const double w) const;
    double
    normal_tangent(const double w) const;
    double
    normal_deformation(const double sigma) const;
    template <typename Widening>
    double
    pressure_at(const double w, const Widening &widening) const;

    const Kind kind;
    const ComplianceLaw &normal;
    const double compliance;
    const double scale;
    const double exponent;
  };
} // namespace fuga

#endif
