// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/construction.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/loads/load_readers.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    void
    read_life(const ParameterSection &section,
              const std::vector<std::string> &stages,
              Material &material)
    {
      const BodyEntries &e = entries_of<BodyEntries>();
      if (section.given(e.built_at))
        material.built_at =
          number_of(section.value(e.built_at), stages, "stage", section, e.built_at);
      if (!section.given(e.removed_at))
        return;
      material.removed_at =
        number_of(section.value(e.removed_at), stages, "stage", section, e.removed_at);
      if (material.removed_at <= material.built_at)
        section.fail(
          e.removed_at,
          "the body would be removed before it has stood for a stage. Name a stage after "
          "the one in which it is built (without 'Built at stage' the first one).");
    }


    void
    read_grouted_joints(const ParameterSection &section,
                        const std::vector<std::string> &joints,
                        const bool is_first,
                        StageDefinition &stage)
    {
      const StageEntries &e = entries_of<StageEntries>();
      if (!section.given(e.grouted_joints))
        return;
      if (is_first)
        section.fail(e.grouted_joints,
                     "before the first stage nothing has opened. A joint without 'Initial gap' is "
                     "closed from the start.");
      stage.grouted_joints = section.list(e.grouted_joints);
      for (const std::string &joint : stage.grouted_joints)
        number_of(joint, joints, "joint", section, e.grouted_joints);
    }
  } // namespace


  void
  read_construction(const ParameterValues &values, ModelDefinition &model)
  {
    const std::vector<ParameterSection> bodies = values.subsections<BodyEntries>();
    for (std::size_t i = 0; i < bodies.size(); ++i)
      read_life(bodies[i], values.subsection_names<StageEntries>(), model.materials[i]);
    const std::vector<ParameterSection> stages = values.subsections<StageEntries>();
    for (std::size_t i = 0; i < stages.size(); ++i)
      read_grouted_joints(
        stages[i], values.subsection_names<JointEntries>(), i == 0, model.stages[i]);
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
    if (parameters.of_sweep && changes_construction(parameters.model))
      throw InputError(fmt::format(
        "{}: sweeps are of structures that are there from the start, but here bodies are "
        "built or removed, or joints grouted, on the way. Take the section Sweep out "
        "and run the variants one by one (--set).",
        values.file()));
  }
} // namespace fuga
