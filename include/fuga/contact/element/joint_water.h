// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_joint_water_h
#define fuga_contact_element_joint_water_h

#include <fuga/contact/joint_state.h>
#include <fuga/contact/system/layered_system.h>

namespace fuga
{
  /*
   * Water pressure in joints that follows the opening (doc/theory.md, section 12). The water
   * ω = q - missing + kept that presses the two sides of an element apart is a load on the joint;
   * q(t) belongs to the present access of the water to all elements. A change of access does not
   * change ω, so that the difference to its new value is missing; this part fades at constant load
   * like the strength of a broken bond. The part that an isolated element has kept does not fade.
   * All of these functions do nothing if no joint has water.
   */

  /** Tells whether a crack may lower the pressure of the elements behind its tip. */
  enum class WaterRelief
  {
    allowed,
    /** Used once a contact configuration has come back at the same load: relief may close a crack,
     * and the closed crack may fill again. */
    refused
  };

  /** Set ω at the load factors @p factors. */
  void
  set_water(const LayeredSystem &system, const Vector &factors, JointState &state);

  /**
   * Let the water follow the states of the elements, without changing ω. An open element that is
   * connected with the reservoir is filled by it, one that is connected with the tailwater only by
   * that. A connection that would lower the pressure counts only behind the tip of the crack, where
   * all neighbours are open too, so that the tip cannot open and close for ever. @p no_force is the
   * force that counts as zero [MN], per bar. Return the elements whose access has changed.
   */
  std::vector<std::size_t>
  renew_water(const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const Vector &factors,
              const Vector &no_force,
              const WaterRelief relief,
              JointState &state);

  /** Add the reactions to the rates of the water, ω̇ = q̇, minus the rate of the missing part. */
  void
  add_water_rates(const LayeredSystem &system,
                  const JointState &state,
                  const Vector &factor_rates,
                  Drive &drive);
} // namespace fuga

#endif
