// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_joint_results_h
#define fuga_io_joint_results_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

#include <string>

namespace fuga
{
  /** What is published of one contact element at one load; signs and units as in doc/notation.md.
   */
  struct ElementResult
  {
    ContactState state = ContactState::stick;
    /** Bar forces [force], N tension positive. */
    double N = 0.;
    double T = 0.;
    /** p = -N/A, τ = T/A [stress]. */
    double pressure = 0.;
    double shear    = 0.;
    /** Opening positive, never negative; closure of the layer, never negative [length]. */
    double gap     = 0.;
    double closure = 0.;
    /** Irreversible part of the tangential jump; whole jumps [length]. */
    double slip   = 0.;
    double jump_n = 0.;
    double jump_t = 0.;
    /** |T| as a share of the strength; 0 while open, 1 while slipping. */
    double utilisation = 0.;
    /** f|N| + cohesive strength of a closed element [force]. */
    double strength = 0.;
  };

  /** Results of all elements. @p jumps: δ of all bars; @p tangential_jumps: of elements without such a bar. */
  std::vector<ElementResult>
  element_results(const std::vector<ContactElement> &elements,
                  const JointState &state,
                  const Vector &jumps);

  /** Resultants of one joint. Forces act on the plus side, in the mean frame of the joint. */
  struct JointResultant
  {
    /** Sums of the bar forces along the mean normal and the mean tangent [force]. */
    double N = 0.;
    double T = 0.;
    /** Moment about the joint's centroid, counter-clockwise, of the forces on the plus side. */
    double M = 0.;
    /** Where the resultant of the normal forces crosses the joint. */
    std::array<double, 2> position = {{0., 0.}};
    double share_open              = 0.;
    double share_stick             = 0.;
    double share_slip              = 0.;
    double largest_pressure        = 0.;
    double largest_gap             = 0.;
    double largest_slip            = 0.;
    /** Σ(f|N| + cA) / |ΣT| over closed elements; infinity without shear. */
    double sliding_safety = 0.;
  };

  JointResultant
  joint_resultant(const unsigned int joint,
                  const std::vector<ContactElement> &elements,
                  const std::vector<std::array<double, 3>> &normals,
                  const std::vector<ElementResult> &results);
} // namespace fuga

#endif
