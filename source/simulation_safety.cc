// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/mechanism_text.h>
#include <fuga/simulation.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** A joint moves in a mechanism if its jump is more than this share of the largest. */
    constexpr double smallest_motion = 1e-6;
  } // namespace

  template <int dim>
  bool
  Simulation<dim>::looks_for_safety() const
  {
    return model.loads.end_of_loading < model.loads.history.end();
  }

  // Every search begins with the state at the end of the loads, also where another one came before
  // it.
  template <int dim>
  void
  Simulation<dim>::find_safety(Outcome &outcome)
  {
    if (!looks_for_safety())
      return;
    const auto first = static_cast<std::size_t>(model.loads.end_of_loading);
    if (outcome.path.verdict != Verdict::done)
      {
        for (std::size_t s = first; s < model.stage_names.size(); ++s)
          outcome.safety.push_back(announced_factor(parameters.model.stages[s]));
        return;
      }
    const JudgeMemory judged = judge.memory();
    const JointState loaded  = last_state;
    searching                = true;
    for (std::size_t s = first; s < model.stage_names.size(); ++s)
      {
        outcome.safety.push_back(find_factor(s, path->last_cut()));
        judge.restore(judged);
      }
    searching  = false;
    last_state = loaded;
  }

  template <int dim>
  SafetyFactor
  Simulation<dim>::find_factor(const std::size_t search, const PathCut &end_of_loading)
  {
    const StageDefinition &stage = parameters.model.stages[search];
    PathCut start                = end_of_loading;
    start.state.t                = static_cast<double>(search);
    const auto &levels           = model.loads.levels;
    start.next_level             = static_cast<std::size_t>(
      std::upper_bound(levels.begin(), levels.end(), start.state.t) - levels.begin());
    last_state          = start.state;
    PathOptions options = model.path_options();
    options.follow      = PathOptions::Follow::events;
    // A mechanism is what is looked for, not an obstacle on the way.
    options.beyond_limit = false;

    const LoadHistory history_to_follow = history_of(search);
    const auto way = make_contact_path(joint.elements, layered, history_to_follow, options);
    const PathResult result = way->resume(start, levels, *this);
    if (result.verdict != Verdict::done)
      write_last_state();

    SafetyFactor safety = announced_factor(stage);
    safety.verdict      = result.verdict == Verdict::done ? SafetyFactor::largest_factor_reached
                                                          : verdict_name(result.verdict);
    safety.t            = result.t;
    const double done   = std::max(result.t, start.state.t) - start.state.t;
    safety.factor       = stage.purpose == StagePurpose::strength_reduction
                            ? 1. / history_to_follow.strength_share(result.t)
                            : 1. + (stage.largest_factor - 1.) * done;
    safety.mechanism    = result.mechanism;
    if (result.mechanism != MechanismKind::none)
      safety.moving_joints = moving_joints(result.mechanism_jumps);
    safety.motion = motion_of(result);
    return safety;
  }

  // What is known before the search.
  template <int dim>
  SafetyFactor
  Simulation<dim>::announced_factor(const StageDefinition &search) const
  {
    SafetyFactor safety;
    safety.method  = search.name;
    safety.verdict = SafetyFactor::not_computed;
    if (search.purpose == StagePurpose::strength_reduction)
      for (const JointParameters &reduced : parameters.joints)
        if (reduced.friction.reduced)
          safety.acts_on.push_back(reduced.definition.name);
    for (const unsigned int load : search.increased_loads)
      safety.acts_on.push_back(parameters.model.loads[load].name);
    return safety;
  }

  template <int dim>
  LoadHistory
  Simulation<dim>::history_of(const std::size_t search) const
  {
    const StageDefinition &stage = parameters.model.stages[search];
    LoadHistory history_to_end   = model.loads.history.until(static_cast<double>(search + 1));
    return stage.purpose == StagePurpose::strength_reduction
             ? history_to_end.reducing_strength(1. / stage.largest_factor)
             : history_to_end;
  }

  template <int dim>
  std::vector<std::string>
  Simulation<dim>::moving_joints(const Vector &mechanism_jumps) const
  {
    std::vector<bool> moves(model.joint_names.size(), false);
    for (const ContactElement &element : joint.elements)
      for (const std::size_t bar :
           {element.normal_bar, element.tangential_bar, element.second_tangential_bar})
        if (bar != ContactElement::no_bar && std::abs(mechanism_jumps[bar]) > smallest_motion)
          moves[element.joint] = true;
    std::vector<std::string> result;
    for (std::size_t j = 0; j < moves.size(); ++j)
      if (moves[j])
        result.push_back(model.joint_names[j]);
    return result;
  }

  template <int dim>
  std::string
  Simulation<dim>::motion_of(const PathResult &result) const
  {
    if (result.mechanism == MechanismKind::none || result.mechanism_jumps.empty())
      return "";
    return mechanism_text(
      joint_motions(
        model.joint_names.size(), joint.elements, model.frames, result.mechanism_jumps, dim == 3),
      model.joint_names);
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
