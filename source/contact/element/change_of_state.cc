// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/change_of_state.h>
#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/layer_response.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    void
    set_unreleased_shear(const ContactElement &element, const TangentVector &T, JointState &state)
    {
      state.unreleased[element.tangential_bar] = T[0];
      if (element.has_second_tangential_bar())
        state.unreleased[element.second_tangential_bar] = T[1];
    }

    /** The forces that are lost are given up at this load, quasi-statically. */
    void
    weaken_by_slip(const ContactElement &element,
                   const std::size_t k,
                   const TangentVector &direction,
                   const double no_force,
                   JointState &state)
    {
      Strength &strength = state.strengths[k];
      const bool bond_breaks =
        strength.has_bond() && element.friction.bond_loss == FrictionLaw::BondLoss::slip;
      const double N = state.forces[element.normal_bar];
      if (bond_breaks && N > no_force)
        {
          break_bond(element, k, no_force, state);
          return;
        }
      // Under tension a bond has the strength c A - f N, which less friction would raise: nothing
      // is lost there.
      const double residual = strength.share * residual_friction(element.friction);
      double lost           = N < -no_force ? (strength.friction - residual) *
                                      resisting_force(element.friction, element.area, -N)
                                            : 0.;
      if (N <= no_force)
        strength.friction = residual;
      if (bond_breaks)
        {
          lost += strength.cohesion;
          strength.cohesion = strength.tension = 0.;
        }
      if (lost > 0.)
        set_unreleased_shear(element, {{lost * direction[0], lost * direction[1]}}, state);
    }
  } // namespace

  void
  change_state(const ContactElement &element,
               const std::size_t k,
               const ContactState to,
               const TangentVector &direction,
               const double no_force,
               JointState &state)
  {
    // A gap that closes is zero up to rounding, and stays so: moving the lips even by that little
    // would leave forces that do not belong to them where the bodies are stiff.
    const bool was_slipping = is_slipping(state.states[k]);
    state.states[k]         = to;
    // The force that is still to be released has turned with the slip.
    if (to == ContactState::open && was_slipping && element.has_second_tangential_bar() &&
        length(tangential(element, state.unreleased)) > 0.)
      set_unreleased_shear(element, tangential(element, state.forces), state);
    if (to == ContactState::open)
      break_bond(element, k, no_force, state);
    else if (!was_slipping && is_slipping(to))
      weaken_by_slip(element, k, direction, no_force, state);
  }

  // Without a bond only rounding is left at N = 0.
  void
  break_bond(const ContactElement &element,
             const std::size_t k,
             const double no_force,
             JointState &state)
  {
    Strength &strength = state.strengths[k];
    if (strength.has_bond())
      {
        const double N = state.forces[element.normal_bar];
        if (N > no_force)
          {
            state.states[k]                      = ContactState::open;
            state.unreleased[element.normal_bar] = N;
          }
        if (element.has_tangential_bar())
          if (const TangentVector T = tangential(element, state.forces); length(T) > no_force)
            set_unreleased_shear(element, T, state);
      }
    strength.cohesion = strength.tension = 0.;
    strength.friction                    = strength.share * residual_friction(element.friction);
  }

  std::vector<Strength>
  strengths_in_step(const JointState &start)
  {
    std::vector<Strength> result = start.strengths;
    for (std::size_t k = 0; k < result.size(); ++k)
      if (start.states[k] == ContactState::open)
        result[k].dilatancy = 0.;
    return result;
  }

  bool
  lose_strength_in_step(const std::vector<ContactElement> &elements,
                        const JointState &end,
                        const std::function<TangentVector(std::size_t)> &direction_of,
                        const double no_force,
                        JointState &start)
  {
    JointState before = end;
    before.states     = start.states;
    before.strengths  = start.strengths;
    bool any          = false;
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        const bool breaks =
          start.strengths[k].has_bond() &&
          end.forces[element.normal_bar] > tensile_strength(element, end, k) + no_force;
        if (!breaks && (element.friction.is_plain() || end.states[k] == start.states[k]))
          continue;
        change_state(element,
                     k,
                     breaks ? ContactState::open : end.states[k],
                     direction_of(k),
                     no_force,
                     before);
        any |= !(before.strengths[k] == start.strengths[k]);
        start.strengths[k] = before.strengths[k];
      }
    return any;
  }
} // namespace fuga
