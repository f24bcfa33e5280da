// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>
#include <fuga/bodies/dynamics/time_steps.h>
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
    using Quantity = AccuracyTarget::Quantity;

    /** Return the numbers of the names in the list @p entry, or of all @p known names if it is not
     * given. */
    std::vector<unsigned int>
    read_numbers(const ParameterSection &section,
                 const AnyEntry &entry,
                 const std::string &what,
                 const std::vector<std::string> &known)
    {
      std::vector<unsigned int> numbers;
      for (const std::string &name : section.given(entry) ? section.list(entry) : known)
        {
          const auto found = std::find(known.begin(), known.end(), name);
          if (found == known.end())
            section.fail(
              entry,
              fmt::format(
                "there is no {} '{}'. {}", what, name, name_hint(name, known, what + "s")));
          numbers.push_back(static_cast<unsigned int>(found - known.begin()));
        }
      return numbers;
    }


    /** Reject an entry that belongs to another quantity, since the user then wants something
     * else. */
    void
    refuse(const ParameterSection &section, const AnyEntry &entry, const std::string &wanted)
    {
      const AccuracyEntries &e = entries_of<AccuracyEntries>();
      if (section.given(entry))
        section.fail(entry,
                     fmt::format("this belongs to Quantity = {}, but here is Quantity = {}. Remove "
                                 "the line, or change the quantity.",
                                 wanted,
                                 section.text(e.quantity)));
    }


    void
    read_pressure(const ParameterSection &section,
                  const ModelDefinition &model,
                  AccuracyTarget &target)
    {
      const AccuracyEntries &e = entries_of<AccuracyEntries>();
      refuse(section, e.components, "resultant or monitor");
      if (!section.given(e.where))
        return;
      target.where = section.text(e.where);
      check_expression(section,
                       e.where,
                       target.where,
                       model.dimension == 3 ? ExpressionArguments::place_in_space
                                            : ExpressionArguments::place,
                       model.constants);
    }


    void
    check_combinations(const ParameterSection &section, const Parameters &parameters)
    {
      const AccuracyEntries &e = entries_of<AccuracyEntries>();
      if (parameters.of_sweep)
        section.fail(
          e.quantity,
          "the variants of a sweep have the mesh of the file: none finds its own. Remove the "
          "section Sweep and run the variants one by one (--set), or remove this entry.");
      if (has_dynamic_stage(parameters.model))
        {
          const StageDefinition &stage =
            parameters.model.stages[first_dynamic_stage(parameters.model)];
          section.fail(
            e.quantity,
            fmt::format("the estimate of the error is of slow loads, but stage '{}' ({}) "
                        "has a Duration. Refine the mesh by Mesh/Refinements, and remove "
                        "this entry.",
                        stage.name,
                        stage.origin));
        }
      if (parameters.solver.beyond_limit == LimitLoadChoice::dynamic)
        section.fail(
          e.quantity,
          "the estimate of the error is of slow loads, but beyond a limit load the bodies "
          "are to move (Solver/Beyond limit load = dynamic). Remove one of the two.");
      if (changes_construction(parameters.model))
        section.fail(e.quantity,
                     "bodies are built or removed, or joints grouted, on the way: the mesh is not "
                     "adapted to that. Refine it by Mesh/Refinements, and remove this entry.");
    }
  } // namespace


  void
  read_accuracy(const ParameterValues &values, Parameters &parameters)
  {
    const AccuracyEntries &e       = entries_of<AccuracyEntries>();
    const ParameterSection section = values.section<AccuracyEntries>();
    AccuracyTarget &target         = parameters.accuracy;
    section.read(target);
    target.origin = section.origin(e.quantity);
    if (target.quantity != Quantity::monitor)
      refuse(section, e.monitors, "monitor");
    if (target.quantity != Quantity::pressure)
      refuse(section, e.where, "contact pressure");
    if (target.quantity == Quantity::none || target.quantity == Quantity::monitor)
      refuse(section, e.joints, "contact pressure or resultant");
    if (target.quantity == Quantity::none)
      {
        refuse(section, e.components, "resultant or monitor");
        return;
      }
    check_combinations(section, parameters);
    parameters.output.checkpoint = CheckpointOutput::never; // the mesh is not stored in it
    if (target.quantity == Quantity::pressure)
      read_pressure(section, parameters.model, target);

    const bool in_space = parameters.model.dimension == 3;
    std::vector<std::string> names, components = {"x", "y"};
    if (in_space)
      components.emplace_back("z");
    if (target.quantity == Quantity::monitor)
      {
        for (const MonitorDefinition &monitor : parameters.model.monitors)
          names.push_back(monitor.name);
        target.items = read_numbers(section, e.monitors, "monitor", names);
      }
    else
      {
        for (const JointParameters &joint : parameters.joints)
          names.push_back(joint.definition.name);
        target.items = read_numbers(section, e.joints, "joint", names);
        components   = {"N", "T", "M"};
        if (in_space)
          components.insert(components.end(), {"T2", "M1", "Mn"});
      }
    if (target.items.empty())
      section.fail(e.quantity,
                   target.quantity == Quantity::monitor
                     ? "there are no monitors. Add one to section Monitors."
                     : "there are no joints. Name a monitor instead.");
    if (target.quantity == Quantity::pressure)
      return;
    target.components = read_numbers(section, e.components, "component", components);
    if (!section.given(e.components))
      {
        target.components = {0, 1};
        if (in_space)
          target.components.push_back(target.quantity == Quantity::monitor ? 2 : 3);
      }
  }
} // namespace fuga
