// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_friction_law_h
#define fuga_laws_friction_law_h

#include <limits>

namespace fuga
{
  /**
   * The strength of a closed joint: Coulomb's law with a bond,
   *
   *     |T| ≤ f|N| + c A,   N ≤ σ_t A       while the bond holds,
   *     |T| ≤ f_r|N|,       N ≤ 0           after it broke,
   *
   * and its dilatancy: sliding lips rise by tan ψ per unit of slip until they have risen by the
   * limit.
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

  /** Return f_r. */
  inline double
  residual_friction(const FrictionLaw &law)
  {
    return law.coefficient - law.friction_loss;
  }

  /** The remaining strength of one element, which changes along a path. */
  struct Strength
  {
    /** Coefficient of friction: f, or f_r. */
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
