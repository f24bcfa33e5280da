// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_joint_strength_h
#define fuga_contact_element_joint_strength_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

namespace fuga
{
  /** Return the shear that a broken bond has not yet released [MN]. */
  double
  unreleased_shear(const ContactElement &element, const JointState &at);

  /** The shear strength c - f N near some normal force N. */
  struct StrengthLine
  {
    double friction = 0.;
    /** c [MN]. */
    double cohesion = 0.;
  };

  /** Return the tangent at @p N of the shear strength of a closed element. It is Coulomb's line
   * itself where the envelope is straight; the cohesion is then c A, or T_u + f N_u, where T_u and
   * N_u are the shear and the tension that a broken bond has not yet released. */
  StrengthLine
  strength_line(const ContactElement &element,
                const JointState &at,
                const std::size_t k,
                const double N);

  /** Return the tangent at the present normal force. */
  inline StrengthLine
  strength_line(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    return strength_line(element, at, k, at.forces[element.normal_bar]);
  }

  /** Return the slope of the strength at the present normal force in units of f: 1 where its
   * envelope is straight. */
  double
  strength_slope(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Return the largest shear that the element can carry if its normal force is @p N [MN]. */
  double
  shear_strength(const ContactElement &element,
                 const JointState &at,
                 const std::size_t k,
                 const double N);

  /** Return the largest shear that the element can carry at its present normal force [MN]. */
  inline double
  shear_strength(const ContactElement &element, const JointState &at, const std::size_t k)
  {
    return shear_strength(element, at, k, at.forces[element.normal_bar]);
  }

  /** Return the largest tension that the element can carry while closed: σ_t A plus what a broken
   * bond has not yet released [MN]. */
  double
  tensile_strength(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Return the rate of the tensile strength under a drive. */
  double
  tensile_strength_rate(const ContactElement &element, const Drive &drive);

  /** Return the rate of the shear strength under a drive, for given N and the slope @p friction of
   * the strength at it. */
  double
  shear_strength_rate(const ContactElement &element, const double friction, const Drive &drive);
} // namespace fuga

#endif
