// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_strength.h>
#include <fuga/contact/element/layer_response.h>
#include <fuga/output/results/joint_results.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  std::vector<ElementResult>
  element_results(const std::vector<ContactElement> &elements,
                  const JointState &state,
                  const Vector &jumps,
                  const Vector &closed_water)
  {
    std::vector<ElementResult> results(elements.size());
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        const ContactElement &element = elements[k];
        ElementResult &result         = results[k];
        const double g = element.initial_gap + jumps[element.normal_bar] - state.dilations[k];
        result.state   = state.states[k];
        result.jump_n  = jumps[element.normal_bar];
        // Rounding must not give an open element a force, nor a closed one a gap.
        if (result.state == ContactState::open)
          result.gap = std::max(g, 0.);
        else
          {
            result.N       = std::min(state.forces[element.normal_bar], state.strengths[k].tension);
            result.closure = std::max(-g, 0.);
          }
        if (element.has_tangential_bar())
          {
            const double T = state.forces[element.tangential_bar];
            result.T =
              result.state == ContactState::open ? state.unreleased[element.tangential_bar] : T;
            result.jump_t = jumps[element.tangential_bar];
            result.slip   = state.slips[k][0];
            result.slip2  = state.slips[k][1];
          }
        if (element.has_second_tangential_bar())
          {
            const unsigned int bar = element.second_tangential_bar;
            result.T2 =
              result.state == ContactState::open ? state.unreleased[bar] : state.forces[bar];
            result.jump_t2 = jumps[bar];
          }
        if (!closed_water.empty())
          result.water_pressure = (closed_water[element.normal_bar] +
                                   (state.water.empty() ? 0. : state.water[element.normal_bar])) /
                                  element.area;
        result.pressure = result.N == 0. ? 0. : -result.N / element.area;
        result.shear    = result.T / element.area;
        result.shear2   = result.T2 / element.area;
        if (result.state != ContactState::open)
          result.strength = shear_strength(element, state, k);
        if (is_slipping(result.state))
          result.utilisation = 1.;
        else if (result.state == ContactState::stick && result.strength > 0.)
          result.utilisation = std::min(1., std::hypot(result.T, result.T2) / result.strength);
      }
    return results;
  }
} // namespace fuga
