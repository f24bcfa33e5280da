// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_layer_response_h
#define fuga_contact_layer_response_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

namespace fuga
{
  /**
   * The force-deformation relations of one element's layer, with the signs of the bars: gap
   * positive in opening, N positive in tension, so that N = -A σ(w), w = -gap. A *nonlinear* bar
   * has in LayeredSystem only its stiffness at zero deformation; its dislocation is the rest.
   */
  bool
  has_nonlinear_closure(const ContactElement &element);
  bool
  has_nonlinear_shear(const ContactElement &element);

  /** Gap g = initial gap + normal jump [m] of any element; negative = closure of the layer. */
  double
  gap(const ContactElement &element, const JointState &at);

  /** Elastic shear deformation of the layer, jump - slip [m]. */
  double
  elastic_shear(const ContactElement &element, const JointState &at, const std::size_t k);

  /** N_law(g) of a nonlinear layer [MN]; continued linearly into tension so that Newton can cross
   * zero. */
  double
  normal_force(const ContactElement &element, const JointState &at);
  /** dN/dg [MN/m]. */
  double
  normal_stiffness(const ContactElement &element, const JointState &at);

  /** T_law(jump - slip) of a nonlinear layer [MN] and its derivative [MN/m]. */
  double
  shear_force(const ContactElement &element, const JointState &at, const std::size_t k);
  double
  shear_stiffness(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Rate of slip ṡ of an element that slips, from the rates of its tangential bar [m per unit of
   * the path]. */
  double
  slip_rate(const ContactElement &element,
            const JointState &at,
            const std::size_t k,
            const JointRates &rates);

  /** What cohesion adds to the shear strength [MN]: cA, or what is left of it after the element
   * broke. */
  double
  cohesive_strength(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Largest shear the element can carry, f|N| + cohesive strength [MN]. */
  double
  shear_strength(const ContactElement &element, const JointState &at, const std::size_t k);

  /** Rate of the cohesive strength under a drive. */
  double
  cohesive_strength_rate(const Drive &drive, const std::size_t k);
} // namespace fuga

#endif
