// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_friction_law_h
#define fuga_laws_friction_law_h

#include <cmath>
#include <limits>

namespace fuga
{
  /**
   * The shape of the shear strength over the pressure, τ = c + f G(σ): the generalised power law
   *
   *     G(σ) = σ_r/b [(1 + σ/σ_r)^b - 1],   G'(σ) = (1 + σ/σ_r)^(b-1),   0 < b ≤ 1,
   *
   * which bends down from the straight line G(σ) = σ, Coulomb's law (b = 1), that it keeps under
   * tension. The coefficient of friction f is the slope without pressure. With c = f σ_r/b it is
   * Baker's τ = p_a A (σ/p_a + T)^b, σ_r = p_a T (J. Geotech. Geoenviron. Eng. 130 (2004),
   * 498-506).
   */
  struct StrengthEnvelope
  {
    /** Exponent b. */
    double exponent = 1.;
    /** Pressure σ_r that the pressure is compared with [MPa]. */
    double pressure = std::numeric_limits<double>::infinity();

    bool
    is_curved() const
    {
      return exponent != 1.;
    }

    /** Return G(σ) [MPa]. */
    double
    value(const double sigma) const
    {
      return is_curved() && sigma > 0.
               ? pressure / exponent * std::expm1(exponent * std::log1p(sigma / pressure))
               : sigma;
    }

    /** Return G'(σ). */
    double
    slope(const double sigma) const
    {
      return is_curved() && sigma > 0. ? std::exp((exponent - 1.) * std::log1p(sigma / pressure))
                                       : 1.;
    }
  };

  /**
   * The strength of a closed joint: friction with a bond,
   *
   *     |T|/A ≤ f G(σ) + c,   σ = -N/A ≥ -σ_t     while the bond holds,
   *     |T|/A ≤ f_r G(σ),     σ ≥ 0               after it broke,
   *
   * with Coulomb's G(σ) = σ or a curved envelope, and its dilatancy: sliding lips rise by tan ψ per
   * unit of slip until they have risen by the limit.
   */
  struct FrictionLaw
  {
    /** The event at which a bond breaks for good; it always does where the lips part. */
    enum class BondLoss
    {
      opening,
      /** Brittle: the bond also breaks at the first slip. */
      slip
    };

    /** Coefficient of friction f ≥ 0. */
    double coefficient = 0.;
    /** Cohesion c ≥ 0 [MPa]. */
    double cohesion = 0.;
    /** Tensile strength σ_t ≥ 0 [MPa], at most c/f: the tip of Coulomb's cone. */
    double tensile_strength = 0.;
    BondLoss bond_loss      = BondLoss::opening;
    /** Friction f - f_r ≥ 0 that is lost at the first slip. */
    double friction_loss = 0.;
    /** Tangent of the dilatancy angle, 0 ≤ tan ψ ≤ f_r. */
    double dilatancy = 0.;
    /** Largest rise of the lips [m]. */
    double dilation_limit = std::numeric_limits<double>::infinity();
    /** If true, f, c and σ_t are divided by the factor of a strength reduction. */
    bool reduced = false;
    /** What friction multiplies. */
    StrengthEnvelope envelope = {};

    /** Return whether no shear can ever be carried, so that the tangential bars need not exist. */
    bool
    is_frictionless() const
    {
      return coefficient == 0. && cohesion == 0.;
    }

    /** Return whether this is Coulomb's law alone, which does not depend on the history. */
    bool
    is_plain() const
    {
      return cohesion == 0. && tensile_strength == 0. && friction_loss == 0. && dilatancy == 0.;
    }
  };

  /** Return A G(P/A) [MN], which friction multiplies, under the force P that presses an element of
   * the area A. */
  inline double
  resisting_force(const FrictionLaw &law, const double area, const double P)
  {
    return law.envelope.is_curved() ? area * law.envelope.value(P / area) : P;
  }

  /** Return f_r. */
  inline double
  residual_friction(const FrictionLaw &law)
  {
    return law.coefficient - law.friction_loss;
  }

  /** The remaining strength of one element, which changes along a path. */
  struct Strength
  {
    /** Coefficient of friction without pressure: f, or f_r. */
    double friction = 0.;
    /** Force of cohesion: c A, or 0 [MN]. */
    double cohesion = 0.;
    /** Tensile force: σ_t A, or 0 [MN]. */
    double tension = 0.;
    /** Dilatancy: tan ψ, or 0 after the lips have risen to the limit. */
    double dilatancy = 0.;
    /**
     * Share 1/F of the strength that a strength reduction leaves; already contained in f, cA and
     * σ_t A.
     */
    double share = 1.;

    bool
    has_bond() const
    {
      return cohesion > 0. || tension > 0.;
    }

    /** Return whether Coulomb's cone is more than the line T = 0. */
    bool
    resists_shear() const
    {
      return friction > 0. || cohesion > 0.;
    }

    bool
    operator==(const Strength &other) const
    {
      return friction == other.friction && cohesion == other.cohesion && tension == other.tension &&
             dilatancy == other.dilatancy && share == other.share;
    }
  };

  /** Reduce the remaining strength to a share of the one given by the law. */
  inline void
  reduce(Strength &strength, const FrictionLaw &law, const double area, const double share)
  {
    const bool residual =
      strength.friction < strength.share * 0.5 * (law.coefficient + residual_friction(law));
    strength.friction = share * (residual ? residual_friction(law) : law.coefficient);
    if (strength.cohesion > 0.)
      strength.cohesion = share * (law.cohesion * area);
    if (strength.tension > 0.)
      strength.tension = share * (law.tensile_strength * area);
    strength.share = share;
  }

  /** Return the initial strength of an element of the given area. */
  inline Strength
  virgin_strength(const FrictionLaw &law, const double area)
  {
    return {law.coefficient, law.cohesion * area, law.tensile_strength * area, law.dilatancy, 1.};
  }
} // namespace fuga

#endif
