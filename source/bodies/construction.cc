// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>

#include <algorithm>

namespace fuga
{
  bool
  is_there(const Material &material, const unsigned int stage)
  {
    return material.built_at <= stage && stage < material.removed_at;
  }


  std::vector<bool>
  bodies_in_stage(const std::vector<std::string> &body_names,
                  const ModelDefinition &model,
                  const unsigned int stage)
  {
    std::vector<bool> there(body_names.size(), true);
    for (const Material &material : model.materials)
      for (std::size_t body = 0; body < body_names.size(); ++body)
        if (body_names[body] == material.body)
          there[body] = is_there(material, stage);
    return there;
  }


  bool
  releases_supports(const ModelDefinition &model, const unsigned int stage)
  {
    return !model.dynamics.absorbing.names.empty() && stage < model.stages.size() &&
           model.stages[stage].is_dynamic();
  }


  bool
  keeps_structure(const ModelDefinition &model, const unsigned int stage)
  {
    return !changes_construction(model, stage) &&
           releases_supports(model, stage - 1) == releases_supports(model, stage);
  }


  bool
  changes_construction(const ModelDefinition &model, const unsigned int stage)
  {
    return !model.stages[stage].grouted_joints.empty() ||
           std::any_of(model.materials.begin(), model.materials.end(), [stage](const Material &m) {
             return (stage > 0 && m.built_at == stage) || m.removed_at == stage;
           });
  }


  bool
  changes_construction(const ModelDefinition &model)
  {
    for (unsigned int stage = 1; stage < model.stages.size(); ++stage)
      if (changes_construction(model, stage))
        return true;
    return false;
  }


  std::vector<unsigned int>
  first_stages_of_phases(const ModelDefinition &model)
  {
    std::vector<unsigned int> stages = {0};
    for (unsigned int stage = 1; stage < model.stages.size(); ++stage)
      if (changes_construction(model, stage) || model.stages[stage].is_dynamic() ||
          model.stages[stage - 1].is_dynamic())
        stages.push_back(stage);
    return stages;
  }


  unsigned int
  end_of_phase(const ModelDefinition &model, const unsigned int first)
  {
    for (const unsigned int stage : first_stages_of_phases(model))
      if (stage > first)
        return stage;
    return static_cast<unsigned int>(model.stages.size());
  }
} // namespace fuga
