// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_joint_water_h
#define fuga_contact_joint_water_h

#include <fuga/contact/joint_state.h>
#include <fuga/contact/layered_system.h>

namespace fuga
{
  /*
   * Water pressure in joints that follows the opening (doc/theory.md, section 12). An element is
   * wet while it is open; the water ω = q(t) - missing that presses its lips apart is a load on the
   * joint. A change of state leaves ω as it is, so that what it should become is missing; that
   * fades at constant load like the strength of a broken bond. All of these functions do nothing if
   * no joint has water.
   */

  /** ω at the load factors @p factors: all of it in open elements, none in closed ones, less what
   * is missing. */
  void
  set_water(const std::vector<ContactElement> &elements,
            const LayeredSystem &system,
            const Vector &factors,
            JointState &state);

  /**
   * What element @p k misses after a change of its state: the water stays what it was.
   * @p no_force: what counts as no force [MN].
   */
  void
  keep_water(const ContactElement &element,
             const std::size_t k,
             const LayeredSystem &system,
             const Vector &factors,
             const double no_force,
             JointState &state);

  /** Some element with water was opened or closed since it had the states @p before: its water now
   * follows the load in another way. */
  bool
  water_has_changed(const std::vector<ContactElement> &elements,
                    const LayeredSystem &system,
                    const std::vector<ContactState> &before,
                    const JointState &state);

  /** Adds the reactions to the rates of the water, ω̇ = q̇ in open elements, less the rate of what is
   * missing. */
  void
  add_water_rates(const std::vector<ContactElement> &elements,
                  const LayeredSystem &system,
                  const JointState &state,
                  const Vector &factor_rates,
                  Drive &drive);
} // namespace fuga

#endif
