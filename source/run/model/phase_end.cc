// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/virgin_state.h>
#include <fuga/run/model/phase_end.h>

#include <algorithm>
#include <map>

namespace fuga
{
  PhaseTransfer::PhaseTransfer(const PhaseEnd &phase_before,
                               const std::vector<ContactElement> &new_elements,
                               const std::vector<ElementIdentity> &identities)
    : before(phase_before), elements(new_elements)
  {
    std::map<ElementIdentity, std::size_t> numbers;
    for (std::size_t k = 0; k < before.identities.size(); ++k)
      numbers[before.identities[k]] = k;
    for (const ElementIdentity &identity : identities)
      {
        const auto found = numbers.find(identity);
        old_numbers.push_back(found == numbers.end() ? none : found->second);
      }
  }

  Vector
  PhaseTransfer::of_bars(const Vector &values) const
  {
    std::size_t n_bars = 0;
    for (const ContactElement &element : elements)
      n_bars += element.n_bars();
    Vector result(n_bars, 0.);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        if (old_numbers[k] == none)
          continue;
        const ContactElement &old      = before.elements[old_numbers[k]];
        result[elements[k].normal_bar] = values[old.normal_bar];
        if (elements[k].has_tangential_bar() && old.has_tangential_bar())
          result[elements[k].tangential_bar] = values[old.tangential_bar];
        if (elements[k].has_second_tangential_bar() && old.has_second_tangential_bar())
          result[elements[k].second_tangential_bar] = values[old.second_tangential_bar];
      }
    return result;
  }

  template <typename Value>
  std::vector<Value>
  PhaseTransfer::of_elements(const std::vector<Value> &values) const
  {
    std::vector<Value> result(elements.size(), Value{});
    for (std::size_t k = 0; k < elements.size(); ++k)
      if (old_numbers[k] != none)
        result[k] = values[old_numbers[k]];
    return result;
  }

  template Vector
  PhaseTransfer::of_elements(const Vector &values) const;

  std::vector<std::size_t>
  PhaseTransfer::numbers(const std::vector<std::size_t> &old) const
  {
    std::vector<std::size_t> result;
    for (const std::size_t number : old)
      for (std::size_t k = 0; k < elements.size(); ++k)
        if (old_numbers[k] == number)
          result.push_back(k);
    return result;
  }

  JointState
  PhaseTransfer::state(const std::vector<ContactElement> &with_laws,
                       const std::vector<bool> &grouted) const
  {
    const JointState &old = before.checkpoint.record.last_state;
    JointState state      = virgin_state(with_laws, of_bars(old.forces).size(), !old.water.empty());
    state.t               = old.t;
    state.forces          = of_bars(old.forces);
    state.dislocations    = of_bars(old.dislocations);
    state.unreleased      = of_bars(old.unreleased);
    if (!old.water.empty())
      {
        state.water         = of_bars(old.water);
        state.missing_water = of_bars(old.missing_water);
        state.kept_water    = of_bars(old.kept_water);
      }
    state.slips     = of_elements(old.slips);
    state.dilations = of_elements(old.dilations);
    for (std::size_t k = 0; k < elements.size(); ++k)
      {
        if (old_numbers[k] == none)
          continue;
        state.states[k]    = old.states[old_numbers[k]];
        state.strengths[k] = old.strengths[old_numbers[k]];
        if (!old.access.empty())
          state.access[k] = old.access[old_numbers[k]];
        const ContactElement &element = with_laws[k];
        if (!grouted[element.joint] || state.states[k] != ContactState::open)
          continue;
        // The slip of an open element follows the jump, so there is no shear.
        state.states[k]                        = ContactState::stick;
        state.dislocations[element.normal_bar] = -element.initial_gap;
        state.dilations[k]                     = 0.;
        state.strengths[k]                     = virgin_strength(element.friction, element.area);
      }
    return state;
  }
} // namespace fuga
