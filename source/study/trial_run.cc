// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/path/event_path.h>
#include <fuga/study/trial_run.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace fuga
{
  template <int dim>
  TrialRun<dim>::TrialRun(const Model<dim> &model)
    : its_model(model)
    , joint(make_joint_model<dim>(
        model.bodies, model.parameters.joints, model.parameters.model.constants))
    , layered(model.bodies, joint.elements)
    , judge(model.bodies, joint.elements, model.loads.history, model.loads.end_of_loading)
  {
    const LoadHistory loading = model.loads.history.until(model.loads.end_of_loading);
    PathOptions options       = model.path_options();
    options.beyond_limit      = false;
    std::make_unique<EventPath>(joint.elements, layered, loading, options)
      ->run(model.loads.levels, *this);
    n_reached = all_levels.size();
    if (!last_state.states.empty() && (all_levels.empty() || all_levels.back().t < last_state.t))
      add_level(last_state);
  }


  template <int dim>
  dealii::Vector<double>
  TrialRun<dim>::deformation(const Level &level) const
  {
    return its_model.bodies.recover(level.a, its_model.bodies.rigid_part(level.x).remainder);
  }


  template <int dim>
  void
  TrialRun<dim>::advanced(const PathPoint &, const PathPoint &to, const double)
  {
    last_state = to.state;
  }


  template <int dim>
  void
  TrialRun<dim>::jumped(const JointState &to)
  {
    last_state = to;
  }


  template <int dim>
  void
  TrialRun<dim>::changed(const std::vector<ContactEvent> &, const JointState &state)
  {
    last_state = state;
  }


  template <int dim>
  void
  TrialRun<dim>::reached(const std::size_t, const JointState &state)
  {
    add_level(state);
  }


  template <int dim>
  void
  TrialRun<dim>::add_level(const JointState &state)
  {
    const Vector jumps = layered.jumps(state.dislocations, state.forces);
    Level level;
    level.t          = state.t;
    level.x          = judge.coordinates(jumps, state.t);
    level.a          = its_model.loads.history.factors(state.t);
    level.results    = element_results(joint.elements, state, jumps);
    level.resultants = its_model.resultants(level.results, Vector(joint.elements.size(), 0.));
    all_levels.push_back(std::move(level));
  }


  template <int dim>
  std::vector<
    std::pair<const typename TrialRun<dim>::Level *, const typename TrialRun<dim>::Level *>>
  common_levels(const TrialRun<dim> &one, const TrialRun<dim> &other)
  {
    std::vector<
      std::pair<const typename TrialRun<dim>::Level *, const typename TrialRun<dim>::Level *>>
      pairs;
    for (std::size_t i = 0; i < std::min(one.levels().size(), other.levels().size()); ++i)
      if (one.levels()[i].t == other.levels()[i].t)
        pairs.emplace_back(&one.levels()[i], &other.levels()[i]);
    if ((one.ended_early() || other.ended_early()) && !one.levels().empty() &&
        !other.levels().empty())
      pairs.emplace_back(&one.levels().back(), &other.levels().back());
    return pairs;
  }


  template class TrialRun<2>;
  template class TrialRun<3>;
  template std::vector<std::pair<const TrialRun<2>::Level *, const TrialRun<2>::Level *>>
  common_levels(const TrialRun<2> &, const TrialRun<2> &);
  template std::vector<std::pair<const TrialRun<3>::Level *, const TrialRun<3>::Level *>>
  common_levels(const TrialRun<3> &, const TrialRun<3> &);
} // namespace fuga
