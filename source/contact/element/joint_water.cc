// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/joint_water.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return the access that the states of the elements demand. */
    std::vector<WaterAccess>
    demanded_access(const WaterNetwork &network, const std::vector<ContactState> &states)
    {
      std::vector<bool> open;
      for (const ContactState state : states)
        open.push_back(state == ContactState::open);
      const std::vector<bool> from_reservoir = connected(network, open, network.upstream);
      const std::vector<bool> from_tailwater = connected(network, open, network.downstream);
      std::vector<WaterAccess> access(states.size(), WaterAccess::seepage);
      for (std::size_t k = 0; k < states.size(); ++k)
        if (open[k] && network.wet[k])
          access[k] = from_reservoir[k]   ? WaterAccess::upstream
                      : from_tailwater[k] ? WaterAccess::downstream
                                          : WaterAccess::isolated;
      return access;
    }

    bool
    is_behind_tip(const std::size_t k,
                  const WaterNetwork &network,
                  const std::vector<ContactState> &states)
    {
      return std::all_of(network.neighbours[k].begin(),
                         network.neighbours[k].end(),
                         [&](const std::size_t i) { return states[i] == ContactState::open; });
    }

    /** Remove connections that would lower the pressure at the tip of a crack, since they do not
     * count. */
    void
    refuse_relief(const std::vector<ContactElement> &elements,
                  const WaterInJoints &water,
                  const Vector &factors,
                  const Vector &no_force,
                  const WaterRelief relief,
                  const JointState &state,
                  std::vector<WaterAccess> &access)
    {
      const Vector now  = water.forces(state.access, factors);
      const Vector then = water.forces(access, factors);
      for (std::size_t k = 0; k < access.size(); ++k)
        {
          const std::size_t n = elements[k].normal_bar;
          const bool connects =
            access[k] == WaterAccess::upstream || access[k] == WaterAccess::downstream;
          if (connects && access[k] != state.access[k] && then[n] < now[n] - no_force[n] &&
              (relief == WaterRelief::refused || !is_behind_tip(k, water.network(), state.states)))
            access[k] = WaterAccess::isolated;
        }
    }
  } // namespace

  void
  set_water(const LayeredSystem &system, const Vector &factors, JointState &state)
  {
    const WaterInJoints *water = system.water_in_joints();
    if (water == nullptr)
      return;
    state.water = water->forces(state.access, factors);
    for (std::size_t bar = 0; bar < state.water.size(); ++bar)
      state.water[bar] += state.kept_water[bar] - state.missing_water[bar];
  }

  std::vector<std::size_t>
  renew_water(const std::vector<ContactElement> &elements,
              const LayeredSystem &system,
              const Vector &factors,
              const Vector &no_force,
              const WaterRelief relief,
              JointState &state)
  {
    const WaterInJoints *water = system.water_in_joints();
    if (water == nullptr)
      return {};
    std::vector<WaterAccess> access = demanded_access(water->network(), state.states);
    if (access == state.access)
      return {};
    refuse_relief(elements, *water, factors, no_force, relief, state, access);
    std::vector<std::size_t> changed;
    for (std::size_t k = 0; k < access.size(); ++k)
      if (access[k] != state.access[k])
        changed.push_back(k);
    if (changed.empty())
      return {};
    state.access       = access;
    const Vector ought = water->forces(access, factors);
    for (std::size_t k = 0; k < access.size(); ++k)
      {
        const std::size_t n    = elements[k].normal_bar;
        const double excess    = state.water[n] - ought[n];
        const double left      = std::abs(excess) > no_force[n] ? excess : 0.;
        const bool keeps       = access[k] == WaterAccess::isolated;
        state.kept_water[n]    = keeps ? left : 0.;
        state.missing_water[n] = keeps ? 0. : -left;
      }
    return changed;
  }

  void
  add_water_rates(const LayeredSystem &system,
                  const JointState &state,
                  const Vector &factor_rates,
                  Drive &drive)
  {
    const WaterInJoints *water = system.water_in_joints();
    if (water == nullptr)
      return;
    Vector rates = water->forces(state.access, factor_rates);
    for (std::size_t bar = 0; bar < drive.missing_water.size(); ++bar)
      rates[bar] -= drive.missing_water[bar];
    system.add_water(rates, drive.reactions);
  }
} // namespace fuga
