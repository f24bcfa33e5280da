// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_rate_law_h
#define fuga_contact_element_rate_law_h

#include <fuga/contact/element/contact_boundary.h>

namespace fuga
{
  /** The answer of an element to the rates: its state, and the direction of its slip. Along one
   * tangent the direction is its sign and 0, and a slip either way is `slip_forward`. */
  struct RateAnswer
  {
    ContactState state      = ContactState::stick;
    TangentVector direction = {{1., 0.}};
    /** Rate of slip, and f times the rate at which the element presses at the apex. */
    double slip = 0., strength = 0.;
  };

  /** An answer that the present rates demand. */
  struct DemandedAnswer : RateAnswer
  {
    /** The amount by which the rates contradict the present answer [MN per unit of the path]. */
    double violation = 0.;
  };

  /** The rates of one element, and what counts as zero. */
  struct LocalRates
  {
    double force = 0., opening = 0., slip = 0.;
    TangentVector shear = {{0., 0.}}, velocity = {{0., 0.}};
    double no_force = 0., no_opening = 0., no_slip = 0., no_shear = 0.;
    /** Stiffness of the bars, which measures motions by forces. */
    double normal_stiffness = 1., shear_stiffness = 1.;
  };

  /**
   * The contact conditions of one element of the boundary set in rates (doc/theory.md, section 17):
   * with the rates v of dislocation and q of the forces,
   *
   *     on the cone, e = T/|T|      v_t = γ e,   0 ≤ γ ⟂ ρ̇ - (e·q_t + f q_n) ≥ 0,   v_n = γ tan ψ
   *     at its apex, N = gap = 0    0 ≤ v_n ⟂ -q_n ≥ 0,   |q_t| ≤ -f q_n,
   *                                 v_t = 0, or on it and v_t ∥ q_t
   *
   * where ρ̇ is the rate of the strength at the present pressure. Along one tangent the cone is the
   * wedge |T| ≤ -f N.
   */
  struct RateLaw
  {
    std::size_t element = 0;
    double friction     = 0.;
    /** The rise tan ψ of the lips per unit of slip. */
    double rise = 0.;
    /** Rates of the shear strength at the present pressure and of the tensile strength. */
    double strength_rate = 0., tension_rate = 0.;
    /** Rate of the shear that a broken bond still carries, used if the element is open. */
    TangentVector shear_release = {{0., 0.}};
    /** True on the boundary of zero strength, where every direction of slip is free or there is no
     * slip. */
    bool at_apex = false;
    /** True if the element may open. */
    bool grazing = false;
    /** Number of tangents along which the element may slip now. */
    std::size_t n_tangents = 0;
    /** Direction of T on the cone. */
    TangentVector shear_direction = {{1., 0.}};

    RateLaw(const BoundaryElement &member,
            const ContactElement &element,
            const JointState &state,
            const Drive &drive);

    /** Return the answer that @p rates demand of an element with the answer @p now. */
    DemandedAnswer
    demand(const RateAnswer &now, const LocalRates &rates) const;
  };

  /** Return the state of an element that answers so: along one tangent slip has a sign. */
  ContactState
  state_of(const RateAnswer &answer, const ContactElement &element);
} // namespace fuga

#endif
