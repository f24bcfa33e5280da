// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/run/model/safety_search.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Share of the largest jump above which a joint moves in a mechanism. */
    constexpr double smallest_motion = 1e-6;
  } // namespace

  template <int dim>
  SafetySearch<dim>::SafetySearch(const Model<dim> &shared_model,
                                  const std::vector<JointParameters> &joint_parameters,
                                  const JointModel &joint_model,
                                  const LayeredSystem &layered_system)
    : model(shared_model), joints(joint_parameters), joint(joint_model), layered(layered_system)
  {
  }

  template <int dim>
  std::vector<SafetyFactor>
  SafetySearch<dim>::announced() const
  {
    std::vector<SafetyFactor> result;
    for (std::size_t s = first(); s < model.stage_names.size(); ++s)
      result.push_back(announced(model.parameters.model.stages[s]));
    return result;
  }

  template <int dim>
  std::vector<SafetyFactor>
  SafetySearch<dim>::run(const PathCut &end_of_loading,
                         Judge &judge,
                         PathObserver &observer,
                         const std::function<void(const JointState &)> &begins,
                         const std::function<void()> &lost) const
  {
    const JudgeMemory judged          = judge.memory();
    const std::vector<double> &levels = model.loads.levels;
    std::vector<SafetyFactor> result  = announced();
    for (std::size_t s = first(); s < model.stage_names.size(); ++s)
      {
        const StageDefinition &stage = model.parameters.model.stages[s];
        PathCut start                = end_of_loading;
        start.state.t                = static_cast<double>(s);
        start.next_level             = static_cast<std::size_t>(
          std::upper_bound(levels.begin(), levels.end(), start.state.t) - levels.begin());
        begins(start.state);
        PathOptions options = model.path_options();
        options.follow      = PathOptions::Follow::events;
        // The search looks for a mechanism, which is not an obstacle on the way.
        options.beyond_limit = false;

        const LoadHistory history = history_of(s);
        const auto way = std::make_unique<EventPath>(joint.elements, layered, history, options);
        const PathResult reached = way->resume(start, levels, observer);
        if (!reached.tried.empty())
          throw NumericalFailure(
            fmt::format("Safety search '{}': no equilibrium was found after load time {:.12g}. {}.",
                        stage.name,
                        reached.t,
                        reached.tried));
        if (reached.verdict != Verdict::done)
          lost();

        SafetyFactor &safety = result[s - first()];
        safety.verdict    = reached.verdict == Verdict::done ? SafetyFactor::largest_factor_reached
                                                             : verdict_name(reached.verdict);
        safety.t          = reached.t;
        const double done = std::max(reached.t, start.state.t) - start.state.t;
        safety.factor     = stage.purpose == StagePurpose::strength_reduction
                              ? 1. / history.strength_share(reached.t)
                              : 1. + (stage.largest_factor - 1.) * done;
        safety.mechanism  = reached.mechanism;
        if (reached.mechanism != MechanismKind::none)
          safety.moving_joints = moving_joints(reached.mechanism_jumps);
        safety.motion = model.motion(joint.elements, reached);
        judge.restore(judged);
      }
    return result;
  }

  template <int dim>
  SafetyFactor
  SafetySearch<dim>::announced(const StageDefinition &search) const
  {
    SafetyFactor safety;
    safety.method  = search.name;
    safety.verdict = SafetyFactor::not_computed;
    if (search.purpose == StagePurpose::strength_reduction)
      for (const JointParameters &reduced : joints)
        if (reduced.friction.reduced)
          safety.acts_on.push_back(reduced.definition.name);
    for (const unsigned int load : search.increased_loads)
      safety.acts_on.push_back(model.parameters.model.loads[load].name);
    return safety;
  }

  template <int dim>
  LoadHistory
  SafetySearch<dim>::history_of(const std::size_t search) const
  {
    const StageDefinition &stage = model.parameters.model.stages[search];
    LoadHistory history_to_end   = model.loads.history.until(static_cast<double>(search + 1));
    return stage.purpose == StagePurpose::strength_reduction
             ? history_to_end.reducing_strength(1. / stage.largest_factor)
             : history_to_end;
  }

  template <int dim>
  std::vector<std::string>
  SafetySearch<dim>::moving_joints(const Vector &mechanism_jumps) const
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

  template class SafetySearch<2>;
  template class SafetySearch<3>;
} // namespace fuga
