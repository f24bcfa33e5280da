// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_mechanism_h
#define fuga_contact_element_mechanism_h

#include <fuga/contact/element/contact_boundary.h>

namespace fuga
{
  /** Largest motion in units of LayeredSystem::scale() and of the force that drives it. A scheme
   * that answers with a larger one is a mechanism; this, and no pivot, distinguishes it from a soft
   * scheme. */
  constexpr double largest_motion = 1e8;

  /** The way in which equilibrium is lost. */
  enum class MechanismKind
  {
    none,
    /** The lips only slide along each other. */
    sliding,
    /** The lips only part. */
    overturning,
    /** Lips that are apart only approach each other. */
    closing,
    /** The lips slide, and part or approach each other. */
    mixed
  };

  /** Return whether the motion changes no force, i.e. nothing resists it. */
  bool
  is_free_motion(const JointRates &motion, const LayeredSystem &system);

  /** Share of the largest jump below which open lips count as closed to a motion: a motion that
   * closes them is not free, and proves no limit load. */
  constexpr double closed_to_motions = 1e-8;

  /** Return the widest gap of the open lips that are closed to motions and that @p motion closes;
   * zero if there is none [m]. */
  double
  widest_gap_closed(const JointRates &motion,
                    const std::vector<ContactElement> &elements,
                    const LayeredSystem &system,
                    const JointState &state);

  /** Return the jumps of a motion, scaled to a largest value of one. */
  Vector
  mechanism_jumps(const JointRates &motion, const LayeredSystem &system);

  /** Return whether a motion with these jumps closes open lips, so that it may come to rest. */
  bool
  closes_lips(const Vector &jumps,
              const std::vector<ContactElement> &elements,
              const JointState &state);

  MechanismKind
  classify_mechanism(const Vector &jumps, const std::vector<ContactElement> &elements);

  /**
   * Return the state in which a mechanism with these jumps moves an element that is on a boundary
   * in @p state. A bond that still carries shear keeps its state, since it would have to break
   * first.
   */
  ContactState
  state_in_mechanism(const BoundaryElement &candidate,
                     const ContactElement &element,
                     const JointState &state,
                     const Vector &jumps);
} // namespace fuga

#endif
