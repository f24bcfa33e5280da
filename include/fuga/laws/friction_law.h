// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_laws_friction_law_h
#define fuga_laws_friction_law_h

#include <limits>

namespace fuga
{
  /**
   * What a closed joint can carry: Coulomb's law with a bond,
   *
   *     |T| ≤ f|N| + c A,   N ≤ σ_t A       while the bond holds,
   *     |T| ≤ f_r|N|,       N ≤ 0           after it broke,
   *
   * and what sliding does to its lips: they rise by tan ψ per slip until they have risen by the
   * limit.
   */
  struct FrictionLaw
  {
    /** When a bond breaks for good; it always does where the lips part. */
    enum class BondLoss
    {
      opening,
      /** Brittle: at the first slip as well. */
      slip
    };

    /** f ≥ 0. */
    double coefficient = 0.;
    /** c ≥ 0 [MPa]. */
    double cohesion = 0.;
    /** σ_t ≥ 0 [MPa], at most c/f: the tip of Coulomb's cone. */
    double tensile_strength = 0.;
    BondLoss bond_loss      = BondLoss::opening;
    /** f - f_r ≥ 0, lost at the first slip. */
    double friction_loss = 0.;
    /** tan ψ, 0 ≤ tan ψ ≤ f_r. */
    double dilatancy = 0.;
    /** Largest rise of the lips [m]. */
    double dilation_limit = std::numeric_limits<double>::infinity();
    /** f, c and σ_t are divided by the factor of a strength reduction. */
    bool reduced = false;

    /** No shear can ever be carried: the tangential bars need not exist. */
    bool
    is_frictionless() const
    {
      return coefficient == 0. && cohesion == 0.;
    }

    /** The law of Coulomb alone: nothing of it depends on what happened before. */
    bool
    is_plain() const
    {
      return cohesion == 0. && tensile_strength == 0. && friction_loss == 0. && dilatancy == 0.;
    }
  };

  /** f_r. */
  inline double
  residual_friction(const FrictionLaw &law)
  {
    return law.coefficient - law.friction_loss;
  }

  /** What is left of it in one element, and what a path changes. */
  struct Strength
  {
    /** f, or f_r. */
    double friction = 0.;
    /** c A, or 0 [MN]. */
    double cohesion = 0.;
    /** σ_t A, or 0 [MN]. */
    double tension = 0.;
    /** tan ψ, or 0 when the lips have risen to the limit. */
    double dilatancy = 0.;
    /** 1/F: share of the strength that a strength reduction leaves; contained in f, cA and σ_t A.
     */
    double share = 1.;

    bool
    has_bond() const
    {
      return cohesion > 0. || tension > 0.;
    }

    /** Coulomb's cone is more than the line T = 0. */
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

  /** What is left of a strength is reduced to a share of what the law says. */
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

  /** The strength of an element of the given area before anything happened. */
  inline Strength
  virgin_strength(const FrictionLaw &law, const double area)
  {
    return {law.coefficient, law.cohesion * area, law.tensile_strength * area, law.dilatancy, 1.};
  }
} // namespace fuga

#endif
