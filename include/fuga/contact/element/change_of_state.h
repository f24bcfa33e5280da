// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_element_change_of_state_h
#define fuga_contact_element_change_of_state_h

#include <fuga/contact/contact_element.h>
#include <fuga/contact/joint_state.h>

#include <functional>

namespace fuga
{
  /**
   * Change the state of an element at a load, with everything besides the state that changes: lips
   * that meet have gap 0, a bond is lost for good where the lips part, friction and a brittle bond
   * are lost at the first slip. Forces that were carried by the lost strength become `unreleased`.
   * @p direction is the direction of slip, see slip_direction(). @p no_force is the force of the
   * normal bar that counts as zero [MN].
   */
  void
  change_state(const ContactElement &element,
               const std::size_t k,
               const ContactState to,
               const TangentVector &direction,
               const double no_force,
               JointState &state);

  /**
   * Break the bond of element @p k; the forces that the element carries become unreleased. Under
   * tension the element can only be open.
   */
  void
  break_bond(const ContactElement &element,
             const std::size_t k,
             const double no_force,
             JointState &state);

  /**
   * Return the strengths with which the elements go through a step from @p start. Lips that meet
   * within the step do not rise before the next one, since it is not known for how much of their
   * way they slid apart. If they rose by all of it they would be pressed together as soon as they
   * meet, by a force that depends on their way alone, and most steps would have two ends or none.
   */
  std::vector<Strength>
  strengths_in_step(const JointState &start);

  /**
   * Subtract from the strengths of @p start, except for the dilatancy, what a step from @p start
   * costs if it ends in @p end: bonds that would have to carry more than their strength break;
   * elements that begin to slip although they have lost nothing for it lose what that costs, and so
   * do those that open. Return whether anything is lost; @p end is then no equilibrium.
   * @p direction_of(k) is the direction of slip.
   */
  bool
  lose_strength_in_step(const std::vector<ContactElement> &elements,
                        const JointState &end,
                        const std::function<TangentVector(std::size_t)> &direction_of,
                        const double no_force,
                        JointState &start);
} // namespace fuga

#endif
