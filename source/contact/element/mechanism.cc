// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/element/mechanism.h>
#include <fuga/contact/tangent_vector.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Share of the reaction of the stuck joint below which a force does not resist. */
    constexpr double free_force = 1e-7;
    /** Share of the work below which a force does not resist either, such as the force in a contact
     * that has shrunk to a point, about which a body turns. */
    constexpr double free_work = 1e-7;
    /** Share of the largest jump below which a jump counts as zero. */
    constexpr double no_jump = 1e-6;
    /** Share of the largest jump of a motion that the layer may take up without resisting the
     * motion. */
    constexpr double free_layer = 0.02;
  } // namespace

  // A layer that is soft compared with all others responds with a force that is negligible compared
  // with theirs, and yet it is not free: its lips do not move as the bodies do.
  bool
  is_free_motion(const JointRates &motion, const LayeredSystem &system)
  {
    const double largest = max_abs(system.jumps(motion.dislocations, motion.forces));
    for (std::size_t i = 0; i < motion.forces.size(); ++i)
      if (!system.is_curved(i) &&
          std::abs(system.compliance(i) * motion.forces[i]) > free_layer * largest)
        return false;
    const double size = system.scaled_size(motion.dislocations);
    double resistance = 0., work = 0.;
    for (std::size_t i = 0; i < motion.forces.size(); ++i)
      {
        resistance = std::max(resistance, std::abs(motion.forces[i]) / system.scale(i));
        work += motion.forces[i] * motion.dislocations[i];
      }
    return size > 0. &&
           (resistance <= free_force * size || std::abs(work) <= free_work * size * size);
  }

  double
  widest_gap_closed(const JointRates &motion,
                    const std::vector<ContactElement> &elements,
                    const LayeredSystem &system,
                    const JointState &state)
  {
    const double largest_rate = max_abs(system.jumps(motion.dislocations, motion.forces));
    const double closed =
      closed_to_motions * max_abs(system.jumps(state.dislocations, state.forces));
    double widest = 0.;
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (state.states[k] == ContactState::open &&
          lip_opening_rate(elements[k], state, motion) < -no_jump * largest_rate)
        if (const double gap = lip_opening(elements[k], state, k); gap <= closed)
          widest = std::max(widest, gap);
    return widest;
  }

  Vector
  mechanism_jumps(const JointRates &motion, const LayeredSystem &system)
  {
    Vector jumps         = system.jumps(motion.dislocations, motion.forces);
    const double largest = max_abs(jumps);
    for (double &jump : jumps)
      jump /= largest;
    return jumps;
  }

  bool
  closes_lips(const Vector &jumps,
              const std::vector<ContactElement> &elements,
              const JointState &state)
  {
    constexpr double closing = 1e-3; // of the largest jump
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (state.states[k] == ContactState::open && jumps[elements[k].normal_bar] < -closing)
        return true;
    return false;
  }

  MechanismKind
  classify_mechanism(const Vector &jumps, const std::vector<ContactElement> &elements)
  {
    double opening = 0., closing = 0., sliding = 0.;
    for (const ContactElement &element : elements)
      {
        opening = std::max(opening, jumps[element.normal_bar]);
        closing = std::max(closing, -jumps[element.normal_bar]);
        if (element.has_tangential_bar())
          sliding = std::max(sliding, std::abs(jumps[element.tangential_bar]));
        if (element.has_second_tangential_bar())
          sliding = std::max(sliding, std::abs(jumps[element.second_tangential_bar]));
      }
    const double normal = std::max(opening, closing);
    if (normal <= no_jump * sliding)
      return MechanismKind::sliding;
    if (sliding > no_jump * normal)
      return MechanismKind::mixed;
    return opening <= no_jump * closing ? MechanismKind::closing : MechanismKind::overturning;
  }

  ContactState
  state_in_mechanism(const BoundaryElement &candidate,
                     const ContactElement &element,
                     const JointState &state,
                     const Vector &jumps)
  {
    const ContactState now = state.states[candidate.element];
    if (now == ContactState::open)
      return now;
    if (candidate.grazing && candidate.shear != ShearPosition::at_strength &&
        jumps[element.normal_bar] > no_jump)
      return ContactState::open;
    if (candidate.shear != ShearPosition::at_strength || now != ContactState::stick)
      return now;
    const TangentVector T = tangential(element, state.forces);
    if (dot(T, tangential(element, jumps)) <= no_jump * length(T))
      return now;
    return element.has_second_tangential_bar() || T[0] > 0. ? ContactState::slip_forward
                                                            : ContactState::slip_backward;
  }
} // namespace fuga
