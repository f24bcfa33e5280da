// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_results_joint_results_h
#define fuga_output_results_joint_results_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

#include <string>

namespace fuga
{
  /**
   * The published results of one contact element at one load; signs and units as in
   * doc/notation.md.
   */
  struct ElementResult
  {
    ContactState state = ContactState::stick;
    /** Bar forces [force]; N is positive in tension. */
    double N = 0.;
    double T = 0.;
    /** Bar force along the second tangent, in space. */
    double T2 = 0.;
    /** Pressure p = -N/A and shear stress τ = T/A [stress]. */
    double pressure = 0.;
    double shear    = 0.;
    double shear2   = 0.;
    /** Opening and closure of the layer, neither of them ever negative [length]. */
    double gap     = 0.;
    double closure = 0.;
    /** Irreversible part of the tangential jump, and total jumps [length]. */
    double slip    = 0.;
    double slip2   = 0.;
    double jump_n  = 0.;
    double jump_t  = 0.;
    double jump_t2 = 0.;
    /** |T| as a fraction of the strength; 0 while open, 1 while slipping. */
    double utilisation = 0.;
    /** Shear strength f|N| + cohesive strength of a closed element [force]. */
    double strength = 0.;
    /** Pressure of the water in the joint, in addition to that of the lips [stress]. */
    double water_pressure = 0.;
  };

  /**
   * Return the results of all elements. @p jumps are the jumps δ of all bars; @p closed_water are
   * the forces of water in the bars of closed elements, empty without water.
   */
  std::vector<ElementResult>
  element_results(const std::vector<ContactElement> &elements,
                  const JointState &state,
                  const Vector &jumps,
                  const Vector &closed_water = {});
} // namespace fuga

#endif
