// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/rate_law.h>

#include <algorithm>

namespace fuga
{
  RateLaw::RateLaw(const BoundaryElement &member,
                   const ContactElement &contact_element,
                   const JointState &state,
                   const Drive &drive)
    : element(member.element)
    , tension_rate(tensile_strength_rate(contact_element, drive))
    , at_apex(member.shear != ShearPosition::at_strength)
    , grazing(member.grazing)
    , n_tangents(member.shear == ShearPosition::inside ? 0 : contact_element.n_bars() - 1)
  {
    if (n_tangents == 0)
      return;
    friction        = strength_line(contact_element, state, element).friction;
    rise            = state.strengths[element].dilatancy;
    strength_rate   = shear_strength_rate(contact_element, friction, drive);
    shear_direction = member.direction;
    if (!drive.release.empty())
      shear_release = tangential(contact_element, drive.release);
  }

  // At the apex the force of Alart and Curnier's projection, i.e. the present force plus the
  // stiffness of each bar times its rate, determines the state; slip and strength are chosen such
  // that Newton's method starts from it.
  DemandedAnswer
  RateLaw::demand(const RateAnswer &now, const LocalRates &rates) const
  {
    DemandedAnswer wanted{now, 0.};
    const bool open = now.state == ContactState::open;
    if (!open && grazing && rates.force - tension_rate > rates.no_force)
      {
        wanted.violation = rates.force - tension_rate;
        wanted.state     = ContactState::open;
        return wanted;
      }
    if (open && rates.opening >= -rates.no_opening)
      return wanted;
    if (open)
      wanted.violation = -rates.opening * rates.normal_stiffness;
    const auto change_to = [&](const ContactState state) {
      wanted.state = state;
      wanted.slip = wanted.strength = 0.;
      return wanted;
    };
    if (n_tangents == 0)
      return change_to(ContactState::stick);
    if (is_slipping(now.state))
      {
        if (rates.slip >= -rates.no_slip)
          return wanted;
        wanted.violation = -rates.slip * rates.shear_stiffness;
        return change_to(ContactState::stick);
      }
    if (!at_apex)
      {
        const double excess =
          dot(shear_direction, rates.shear) + friction * rates.force - strength_rate;
        wanted.direction = shear_direction;
        wanted.violation = std::max(wanted.violation, excess);
        return change_to(excess > rates.no_shear ? ContactState::slip_forward
                                                 : ContactState::stick);
      }
    const double strength =
      friction * std::max(open ? -rates.opening * rates.normal_stiffness : -rates.force, 0.);
    const TangentVector shear =
      open ? sum({{0., 0.}}, rates.shear_stiffness, rates.velocity) : rates.shear;
    const double excess = length(shear) - strength;
    if (excess <= rates.no_shear)
      return change_to(ContactState::stick);
    wanted.state     = ContactState::slip_forward;
    wanted.direction = direction_of(shear);
    wanted.slip      = excess / rates.shear_stiffness;
    wanted.strength  = strength;
    wanted.violation = std::max(wanted.violation, excess);
    return wanted;
  }

  ContactState
  state_of(const RateAnswer &answer, const ContactElement &element)
  {
    return is_slipping(answer.state) && !element.has_second_tangential_bar() &&
               answer.direction[0] < 0.
             ? ContactState::slip_backward
             : answer.state;
  }
} // namespace fuga
