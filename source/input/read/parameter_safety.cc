// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/read/parameter_readers.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Return the position of the item with this name, or -1. */
    template <typename Items, typename Name>
    std::ptrdiff_t
    position(const Items &items, const std::string &wanted, const Name &name)
    {
      const auto found =
        std::find_if(items.begin(), items.end(), [&](const auto &i) { return name(i) == wanted; });
      return found == items.end() ? -1 : found - items.begin();
    }


    /** Return the loads given by name, and those of stages. */
    std::vector<unsigned int>
    read_increased_loads(const ParameterSection &section, const ModelDefinition &model)
    {
      const SafetyEntries &e = entries_of<SafetyEntries>();
      std::vector<unsigned int> loads;
      const auto add = [&loads](const unsigned int load) {
        if (std::find(loads.begin(), loads.end(), load) == loads.end())
          loads.push_back(load);
      };
      for (const std::string &name : section.list(e.load_factor))
        {
          const auto name_of = [](const auto &item) { return item.name; };
          const auto load    = position(model.loads, name, name_of);
          const auto stage   = position(model.stages, name, name_of);
          if (load >= 0)
            add(static_cast<unsigned int>(load));
          else if (stage >= 0)
            for (const auto &history : model.stages[static_cast<std::size_t>(stage)].histories)
              add(history.load);
          else
            {
              std::vector<std::string> known;
              for (const LoadDefinition &item : model.loads)
                known.push_back(item.name);
              for (const StageDefinition &item : model.stages)
                if (position(model.loads, item.name, name_of) < 0)
                  known.push_back(item.name);
              section.fail(e.load_factor,
                           fmt::format("there is neither a load nor a stage '{}'. {}",
                                       name,
                                       name_hint(name, known, "loads and stages")));
            }
        }
      return loads;
    }


    /** Check the dilatancy: sliding lips that rise by more than friction resists would create
     * energy. */
    void
    check_dilatancy(const ParameterSection &section,
                    const JointParameters &joint,
                    const double largest_factor)
    {
      const FrictionLaw &law = joint.friction;
      if (law.dilatancy == 0. || law.dilatancy * largest_factor <= residual_friction(law))
        return;
      section.fail(
        entries_of<SafetyEntries>().largest_factor,
        fmt::format("joint '{}' has the dilatancy {:g}, which is not reduced and must not "
                    "exceed the friction {:g} / factor: sliding would create energy. "
                    "Allowed are factors up to {:g}.",
                    joint.definition.name,
                    law.dilatancy,
                    residual_friction(law),
                    residual_friction(law) / law.dilatancy));
    }


    void
    mark_reduced_joints(const ParameterSection &section,
                        const double largest_factor,
                        std::vector<JointParameters> &joints)
    {
      const SafetyEntries &e = entries_of<SafetyEntries>();
      const auto name_of     = [](const JointParameters &joint) { return joint.definition.name; };
      std::vector<std::string> known;
      for (const JointParameters &joint : joints)
        known.push_back(name_of(joint));
      const bool all                       = !section.given(e.joints);
      const std::vector<std::string> names = all ? known : section.list(e.joints);
      bool any                             = false;
      for (const std::string &name : names)
        {
          JointParameters &joint = joints[number_of(name, known, "joint", section, e.joints)];
          joint.friction.reduced = !joint.friction.is_frictionless();
          any |= joint.friction.reduced;
          if (!all && !joint.friction.reduced)
            section.fail(e.joints,
                         fmt::format("joint '{}' has neither friction nor cohesion, so that "
                                     "there is nothing to reduce. Take it out of the list.",
                                     name));
          check_dilatancy(section, joint, largest_factor);
        }
      if (!any)
        section.fail(e.strength_reduction,
                     "no joint has friction or cohesion, so that there is nothing to reduce. Write "
                     "no, or remove the line.");
    }
  } // namespace


  void
  read_safety(const ParameterValues &values, Parameters &parameters)
  {
    const SafetyEntries &e         = entries_of<SafetyEntries>();
    const ParameterSection section = values.section<SafetyEntries>();
    ModelDefinition &model         = parameters.model;
    const bool reduction           = section.value(e.strength_reduction);
    if (section.given(e.joints) && !reduction)
      section.fail(e.joints,
                   "these joints are for a strength reduction. Add 'Strength reduction = yes', or "
                   "remove the line.");

    std::vector<StageDefinition> searches;
    const auto add = [&](const char *name, const StagePurpose purpose, const AnyEntry &entry) {
      StageDefinition stage;
      stage.name           = name;
      stage.origin         = section.origin(entry);
      stage.purpose        = purpose;
      stage.largest_factor = section.value(e.largest_factor);
      searches.push_back(stage);
    };
    if (reduction)
      {
        add("strength reduction", StagePurpose::strength_reduction, e.strength_reduction);
        mark_reduced_joints(section, searches.back().largest_factor, parameters.joints);
      }
    if (section.given(e.load_factor))
      {
        add("load factor", StagePurpose::load_factor, e.load_factor);
        searches.back().increased_loads = read_increased_loads(section, model);
      }
    for (const StageDefinition &search : searches)
      for (const StageDefinition &stage : model.stages)
        if (stage.name == search.name)
          section.fail(fmt::format("a stage of section Stages is called '{}', as the search for "
                                   "safety is in the results. Give it another name.",
                                   stage.name));
    model.stages.insert(model.stages.end(), searches.begin(), searches.end());
  }
} // namespace fuga
