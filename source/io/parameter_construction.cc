// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/construction.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    unsigned int
    read_stage(const ParameterSection &section,
               const std::string &entry,
               const std::vector<std::string> &stages)
    {
      const std::string name = section.text(entry);
      const auto found       = std::find(stages.begin(), stages.end(), name);
      if (found == stages.end())
        section.fail(entry,
                     fmt::format("there is no stage '{}' in section Stages. {}",
                                 name,
                                 name_hint(name, stages, "stages")));
      return static_cast<unsigned int>(found - stages.begin());
    }


    void
    read_life(const ParameterSection &section,
              const std::vector<std::string> &stages,
              Material &material)
    {
      if (section.given("Built at stage"))
        material.built_at = read_stage(section, "Built at stage", stages);
      if (!section.given("Removed at stage"))
        return;
      material.removed_at = read_stage(section, "Removed at stage", stages);
      if (material.removed_at <= material.built_at)
        section.fail(
          "Removed at stage",
          "the body would be removed before it has stood for a stage. Name a stage behind "
          "the one in which it is built (without 'Built at stage' the first one).");
    }


    void
    read_grouted_joints(const ParameterSection &section,
                        const std::vector<std::string> &joints,
                        const bool is_first,
                        StageDefinition &stage)
    {
      if (!section.given("Grouted joints"))
        return;
      if (is_first)
        section.fail("Grouted joints",
                     "before the first stage nothing has opened. A joint without 'Initial gap' is "
                     "closed from the start.");
      stage.grouted_joints = section.list("Grouted joints");
      for (const std::string &joint : stage.grouted_joints)
        if (std::find(joints.begin(), joints.end(), joint) == joints.end())
          section.fail("Grouted joints",
                       fmt::format("there is no joint '{}' in section Joints. {}",
                                   joint,
                                   name_hint(joint, joints, "joints")));
    }
  } // namespace


  void
  read_construction(const ParameterValues &values, ModelDefinition &model)
  {
    const std::vector<ParameterSection> bodies = values.subsections("Bodies");
    for (std::size_t i = 0; i < bodies.size(); ++i)
      read_life(bodies[i], values.subsection_names("Stages"), model.materials[i]);
    const std::vector<ParameterSection> stages = values.subsections("Stages");
    for (std::size_t i = 0; i < stages.size(); ++i)
      read_grouted_joints(stages[i], values.subsection_names("Joints"), i == 0, model.stages[i]);
    for (const unsigned int stage : first_stages_of_phases(model))
      if (!model.stages.empty() &&
          std::none_of(model.materials.begin(), model.materials.end(), [stage](const auto &body) {
            return is_there(body, stage);
          }))
        throw InputError(
          fmt::format("{}: no body is there in stage '{}': all of them are built later, or removed "
                      "by then. One at least has to be there.",
                      values.file(),
                      model.stages[stage].name));
  }


  void
  check_sweep_of_construction(const ParameterValues &values, const Parameters &parameters)
  {
    if (parameters.of_sweep && first_stages_of_phases(parameters.model).size() > 1)
      throw InputError(fmt::format(
        "{}: sweeps are of structures that are there from the start, but here bodies are "
        "built or removed, or joints grouted, on the way. Take the section Sweep out "
        "and run the variants one by one (--set).",
        values.file()));
  }
} // namespace fuga
