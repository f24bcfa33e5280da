// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/change_of_state.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** What is lost is given up at this load, quasi-statically. */
    void
    weaken_by_slip(const ContactElement &element,
                   const std::size_t k,
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
      // Under tension a bond has c A - f N, which less friction would raise: nothing is lost there.
      const double residual = strength.share * residual_friction(element.friction);
      double lost           = N < -no_force ? (strength.friction - residual) * -N : 0.;
      if (N <= no_force)
        strength.friction = residual;
      if (bond_breaks)
        {
          lost += strength.cohesion;
          strength.cohesion = strength.tension = 0.;
        }
      if (lost > 0.)
        state.unreleased[element.tangential_bar] = slip_sign(state.states[k]) * lost;
    }
  } // namespace

  void
  change_state(const ContactElement &element,
               const std::size_t k,
               const ContactState to,
               const double no_force,
               JointState &state)
  {
    // A gap that closes is zero but for rounding, and stays so: to move the lips even by that much
    // would leave forces that do not belong to them where the bodies are stiff.
    const bool was_slipping = is_slipping(state.states[k]);
    state.states[k]         = to;
    if (to == ContactState::open)
      break_bond(element, k, no_force, state);
    else if (!was_slipping && is_slipping(to))
      weaken_by_slip(element, k, no_force, state);
  }

  // Without a bond nothing but rounding is left at N = 0.
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
        if (element.has_tangential_bar() &&
            std::abs(state.forces[element.tangential_bar]) > no_force)
          state.unreleased[element.tangential_bar] = state.forces[element.tangential_bar];
      }
    strength.cohesion = strength.tension = 0.;
    strength.friction                    = strength.share * residual_friction(element.friction);
  }
} // namespace fuga
