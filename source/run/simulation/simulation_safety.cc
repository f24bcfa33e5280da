// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/run/simulation/simulation.h>

#include <fmt/format.h>

namespace fuga
{
  // Every search begins with the state at the end of the loads, also where another one came before
  // it.
  template <int dim>
  void
  Simulation<dim>::find_safety(Outcome &outcome)
  {
    if (!safety_search.is_wanted())
      return;
    if (outcome.path.verdict != Verdict::done)
      {
        outcome.safety = safety_search.announced();
        return;
      }
    const JointState loaded = last_state;
    searching               = true;
    outcome.safety          = safety_search.run(
      path->last_cut(),
      judge,
      *this,
      [this](const JointState &start) { last_state = start; },
      [this]() { write_last_state(); });
    searching  = false;
    last_state = loaded;
  }

  template <int dim>
  void
  Simulation<dim>::log_safety(const SafetyFactor &safety)
  {
    const auto listed = [](const std::vector<std::string> &names) {
      return fmt::format("{}", fmt::join(names, ", "));
    };
    std::string text = fmt::format("Safety      {} of {}: ", safety.method, listed(safety.acts_on));
    if (safety.verdict == SafetyFactor::not_computed)
      text += "not computed, because the loads are not carried to their end";
    else if (safety.verdict == SafetyFactor::largest_factor_reached)
      text += fmt::format("above {:.12g}, the largest factor asked for", safety.factor);
    else
      text += fmt::format("{:.12g}, {}", safety.factor, safety.verdict);
    if (safety.mechanism != MechanismKind::none)
      text += fmt::format(
        ", mechanism: {} of {}", mechanism_name(safety.mechanism), listed(safety.moving_joints));
    log.line(text);
    if (!safety.motion.empty())
      log.line("            " + safety.motion);
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga
