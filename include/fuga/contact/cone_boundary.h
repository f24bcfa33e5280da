// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cone_boundary_h
#define fuga_contact_cone_boundary_h

#include <fuga/contact/contact_boundary.h>
#include <fuga/contact/tangent_vector.h>

#include <algorithm>

namespace fuga
{
  /** It has tangential bars and friction in them. Without friction its tangential bars, if it has
   * any, carry nothing. */
  inline bool
  has_friction(const ContactElement &element)
  {
    return element.has_tangential_bar() && element.friction.coefficient > 0.;
  }

  /**
   * ContactBoundary with Coulomb's circular cone |T| ≤ f|N|, T in the tangent plane. In the state
   * slip the direction is that of T.
   */
  class ConeBoundary
  {
  public:
    ConeBoundary(const std::vector<ContactElement> &elements, const LayeredSystem &system);

    /** As ContactBoundary::set_scales(). */
    void
    set_scales(const JointState &state, const Vector &factors, const double widening);

    /** All elements on a boundary, slipping ones included; their `sign` has no meaning. */
    std::vector<BoundaryElement>
    elements_on_boundary(const JointState &state) const;

    /**
     * Length τ along the straight line state + τ rates after which the first boundary is reached,
     * for a stuck element the smallest root of |T + τ Ṫ|² = f²(N + τ Ṅ)²; infinity if none is.
     */
    double
    distance(const JointState &state, const JointRates &rates, const Drive &drive) const;

    /**
     * The reserves of all elements at a point: gap of open elements, pressure and strength left of
     * closed ones; always in the same order for the same states.
     */
    std::vector<Reserve>
    reserves(const JointState &state, const JointRates &rates) const;

    /** Force below which a bar counts as unloaded [MN]; never below the rounding of the largest
     * forces. */
    double
    force_tolerance(const std::size_t bar) const
    {
      return std::max(scales.force_tolerance(bar), smallest_tolerance);
    }

    Vector
    all_force_tolerances() const
    {
      Vector result = scales.all_force_tolerances();
      for (double &tolerance : result)
        tolerance = std::max(tolerance, smallest_tolerance);
      return result;
    }

    /** Force below which the strength of an element, or its distance from it, is zero [MN]. */
    double
    strength_tolerance(const std::size_t element) const;

    double
    gap_tolerance() const
    {
      return scales.gap_tolerance();
    }

  private:
    double
    distance_of(const std::size_t k,
                const JointState &state,
                const JointRates &rates,
                const ContactBoundary::RateNoise &noise) const;

    const std::vector<ContactElement> &elements;
    ContactBoundary scales;
    const LayeredSystem &system;
    double smallest_tolerance = 0.;
  };
} // namespace fuga

#endif
