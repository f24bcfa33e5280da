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
    const std::array<const char *, 3> component_names = {{"x", "y", "z"}};


    BoundaryCondition
    read_boundary(const ParameterSection &section, const unsigned int dimension)
    {
      const BoundaryEntries &e = entries_of<BoundaryEntries>();
      BoundaryCondition condition;
      condition.boundary                   = section.name();
      condition.origin                     = section.origin(e.fixed);
      const std::vector<std::string> words = section.list(e.fixed);
      for (const std::string &word : words)
        {
          if ((word == "free" || word == "all") && words.size() > 1)
            section.fail(
              e.fixed,
              fmt::format("'{}' stands alone. Write either it or a list of components.", word));
          if (word == "z" && dimension == 2)
            section.fail(e.fixed, "a plane problem has no component z. Use x, y or all.");
          if (word == "free")
            condition.named_free = true;
          else if (word == "all")
            condition.fixed = {{true, true, dimension == 3}};
          else if (word == "x" || word == "y" || word == "z")
            condition.fixed[static_cast<std::size_t>(word[0] - 'x')] = true;
          else
            section.fail(e.fixed,
                         fmt::format("'{}' is unknown. Allowed: {}, or the words all, free.",
                                     word,
                                     dimension == 2 ? "x or y or x, y" : "some of x, y, z"));
        }
      return condition;
    }


    const BoundaryCondition *
    find_condition(const ModelDefinition &model, const std::string &boundary)
    {
      for (const BoundaryCondition &condition : model.boundary_conditions)
        if (condition.boundary == boundary)
          return &condition;
      return nullptr;
    }


    /** Check that no load acts where the user says that none does. */
    void
    check_free_boundaries(const ParameterSection &section,
                          const LoadDefinition &load,
                          const ModelDefinition &model)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      if (load.kind == LoadKind::weight || load.kind == LoadKind::temperature ||
          load.kind == LoadKind::uplift || load.kind == LoadKind::imposed_gap)
        return;
      for (const std::string &target : load.targets)
        if (const BoundaryCondition *condition = find_condition(model, target);
            condition != nullptr && condition->named_free)
          section.fail(
            load.kind == LoadKind::point_force ? e.point : e.boundaries,
            fmt::format("'{}' is said to be free at {}. Remove that statement or this load.",
                        target,
                        condition->origin));
    }


    /** Check that water, and an imposed gap, have a joint. */
    void
    check_joints(const ParameterSection &section,
                 const LoadDefinition &load,
                 const std::vector<std::string> &joints)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      if (load.kind != LoadKind::uplift && load.kind != LoadKind::imposed_gap)
        return;
      for (const std::string &target : load.targets)
        number_of(target, joints, "joint", section, e.joints);
    }


    /** Check that a displacement moves only components that are fixed. */
    void
    check_displacement(const ParameterSection &section,
                       const LoadDefinition &load,
                       const ModelDefinition &model)
    {
      const LoadEntries &e = entries_of<LoadEntries>();
      if (load.kind != LoadKind::displacement)
        return;
      for (const std::string &target : load.targets)
        {
          const BoundaryCondition *condition = find_condition(model, target);
          for (unsigned int c = 0; c < model.dimension; ++c)
            if (!load.expressions[c].empty() && (condition == nullptr || !condition->fixed[c]))
              section.fail(
                e.value,
                fmt::format("component {} of boundary '{}' is to be moved but it is not "
                            "fixed{}. Set Boundaries/{}/Fixed, or leave the component "
                            "empty.",
                            component_names[c],
                            target,
                            condition == nullptr ? "" : " (see " + condition->origin + ")",
                            target));
        }
    }


    bool
    is_used(const ModelDefinition &model, const std::size_t load)
    {
      return std::any_of(model.stages.begin(), model.stages.end(), [&](const auto &stage) {
        return std::any_of(stage.histories.begin(),
                           stage.histories.end(),
                           [&](const auto &history) { return history.load == load; });
      });
    }
  } // namespace


  std::vector<BoundaryCondition>
  read_boundaries(const ParameterValues &values, const unsigned int dimension)
  {
    std::vector<BoundaryCondition> conditions;
    for (const ParameterSection &section : values.subsections<BoundaryEntries>())
      values.attempt(section, [&]() { conditions.push_back(read_boundary(section, dimension)); });
    return conditions;
  }


  void
  check_loads_and_supports(const ParameterValues &values, const ModelDefinition &model)
  {
    const SweepEntries &e                        = entries_of<SweepEntries>();
    const std::vector<ParameterSection> sections = values.subsections<LoadEntries>();
    // A variant may leave out the stages of a load.
    const ParameterSection sweep = values.section<SweepEntries>();
    const bool stages_vary       = sweep.given(e.stages) || sweep.given(e.load_sequences);
    for (std::size_t i = 0; i < sections.size(); ++i)
      values.attempt(sections[i], [&]() {
        check_free_boundaries(sections[i], model.loads[i], model);
        if (!values.is_broken<BoundaryEntries>())
          check_displacement(sections[i], model.loads[i], model);
        check_joints(sections[i], model.loads[i], values.subsection_names<JointEntries>());
        if (!values.is_broken<StageEntries>() && !stages_vary && !is_used(model, i))
          sections[i].fail(fmt::format(
            "no stage uses this load; the stages are {}. Add '{}: t' to the Loads of one, or "
            "remove the load.",
            quoted_list(values.subsection_names<StageEntries>()),
            model.loads[i].name));
      });
  }
} // namespace fuga
