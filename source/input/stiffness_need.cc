// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>
#include <fuga/input/stiffness_need.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    bool
    is_rigid(const LayerLaw law, const double compliance)
    {
      return law == LayerLaw::rigid || (law == LayerLaw::linear && compliance == 0.);
    }

    bool
    is_rigid(const JointParameters &joint)
    {
      return is_rigid(joint.normal_law, joint.normal_compliance) ||
             (is_rigid(joint.shear_law, joint.shear_compliance) &&
              !joint.friction.is_frictionless());
    }

    bool
    lets_water_in(const LoadDefinition &load)
    {
      return load.kind == LoadKind::uplift && load.uplift.fills_cracks;
    }

    bool
    is_search(const StageDefinition &stage)
    {
      return stage.purpose != StagePurpose::loading;
    }
  } // namespace


  std::string
  what_needs_stiffness(const Parameters &parameters)
  {
    const ModelDefinition &model = parameters.model;
    if (parameters.solver.follow_events)
      return "following the loads from event to event (Solver/Follow = events) is";
    if (changes_construction(model))
      return "construction in stages is";
    if (parameters.of_sweep)
      return "a sweep is";
    if (parameters.accuracy.quantity != AccuracyTarget::Quantity::none)
      return "a target accuracy is";
    if (may_move(parameters))
      return "inertia is";
    if (std::any_of(model.stages.begin(), model.stages.end(), is_search))
      return "a search for a factor of safety is";
    if (std::any_of(model.loads.begin(), model.loads.end(), lets_water_in))
      return "water that comes into opening joints is";
    for (const JointParameters &joint : parameters.joints)
      if (is_rigid(joint))
        return fmt::format("joint '{}', whose layer is rigid, is", joint.definition.name);
    return {};
  }
} // namespace fuga
