// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/virgin_state.h>

namespace fuga
{
  JointState
  virgin_state(const std::vector<ContactElement> &elements,
               const std::size_t n_bars,
               const bool has_water)
  {
    JointState state;
    state.states.assign(elements.size(), ContactState::stick);
    state.forces.assign(n_bars, 0.);
    state.dislocations.assign(n_bars, 0.);
    state.slips.assign(elements.size(), TangentVector{{0., 0.}});
    state.dilations.assign(elements.size(), 0.);
    state.unreleased.assign(n_bars, 0.);
    if (has_water)
      {
        state.access.assign(elements.size(), WaterAccess::seepage);
        state.water = state.missing_water = state.kept_water = Vector(n_bars, 0.);
      }
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        state.strengths.push_back(virgin_strength(elements[k].friction, elements[k].area));
        if (elements[k].initial_gap > 0.)
          {
            // Lips that never touched have no bond.
            state.states[k]             = ContactState::open;
            state.strengths[k].cohesion = state.strengths[k].tension = 0.;
          }
      }
    return state;
  }
} // namespace fuga
