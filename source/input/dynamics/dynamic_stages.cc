// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/construction.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/bodies/straightness.h>
#include <fuga/input/dynamics/dynamics_readers.h>
#include <fuga/input/entries/parameter_entries.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    bool
    changes(const StageDefinition::History &history,
            const ModelDefinition &model,
            const std::string &what)
    {
      FieldExpression<2> expression({history.expression}, model.constants, what);
      const auto factor = [&expression](const double t) {
        expression.set_time(t);
        return expression.value(dealii::Point<2>(), 0);
      };
      return !is_straight(factor, 0., 1.) || factor(0.) != factor(1.);
    }


    /** Return whether any stage up to this one names the load. */
    bool
    acts(const unsigned int load, const std::size_t stage, const ModelDefinition &model)
    {
      for (std::size_t s = 0; s <= stage; ++s)
        for (const StageDefinition::History &history : model.stages[s].histories)
          if (history.load == load)
            return true;
      return false;
    }


    void
    check_loads(const ParameterSection &section,
                const std::size_t stage,
                const ModelDefinition &model)
    {
      const StageEntries &e = entries_of<StageEntries>();
      for (const StageDefinition::History &history : model.stages[stage].histories)
        if (const LoadDefinition &load = model.loads[history.load];
            load.is_without_inertia() && changes(history, model, section.origin(e.loads)))
          section.fail(e.loads,
                       fmt::format("the load '{}' must not change in a stage with a Duration: "
                                   "displacements, gaps and temperatures are prescribed without "
                                   "inertia. Apply it in a stage of its own before or after.",
                                   load.name));
      for (unsigned int i = 0; i < model.loads.size(); ++i)
        if (const LoadDefinition &load = model.loads[i];
            load.is_without_inertia() && depends_on_time(load) && acts(i, stage, model))
          section.fail(e.duration,
                       fmt::format("the value of load '{}' ({}) depends on t, but displacements, "
                                   "gaps and temperatures must not change in a stage with a "
                                   "Duration. Write the change as factors of the stages before.",
                                   load.name,
                                   load.origin));
    }


    void
    check_settings(const ParameterValues &values,
                   const ParameterSection &section,
                   const Parameters &parameters)
    {
      const StageEntries &e         = entries_of<StageEntries>();
      const SolverEntries &solver   = entries_of<SolverEntries>();
      const ParameterSection chosen = values.section<SolverEntries>();
      const auto refuse             = [&](const bool is_chosen, const AnyEntry &entry) {
        if (is_chosen)
          section.fail(e.duration,
                       fmt::format("'{}/{} = {}' ({}) is for slow loads only. Remove one of the "
                                               "two.",
                                   solver.name,
                                   entry.name(),
                                   chosen.text(entry),
                                   chosen.origin(entry)));
      };
      refuse(!parameters.solver.follow_events, solver.follow);
      refuse(parameters.solver.beyond_limit == LimitLoadChoice::arc_length, solver.beyond_limit);
      refuse(parameters.model.body_solver == BodySolver::matrix_free, solver.bodies);
    }


    void
    check_stage(const ParameterValues &values,
                const ParameterSection &section,
                const unsigned int number,
                const Parameters &parameters)
    {
      const StageEntries &e        = entries_of<StageEntries>();
      const ModelDefinition &model = parameters.model;
      const auto &stages           = model.stages;
      check_settings(values, section, parameters);
      if (changes_construction(model, number))
        section.fail(
          e.duration,
          "bodies are built or removed, or joints grouted, at the beginning of this stage. "
          "Let that happen in a stage of its own, without a Duration, before it.");
      if (section.given(e.water) && !section.value(e.water))
        section.fail(
          e.water,
          "water does not follow the opening within the time of a stage with a Duration. "
          "Write unchanged, or remove this entry; it follows in the next stage.");
      if (number + 1 < stages.size() && stages[number + 1].purpose != StagePurpose::loading)
        section.fail(e.duration,
                     "a search for safety begins with an equilibrium, but after this stage bodies "
                     "may still move. Add a stage without a Duration after it, or remove the "
                     "entries of section Safety.");
      check_loads(section, number, model);
    }
  } // namespace


  void
  check_dynamic_stages(const ParameterValues &values, const Parameters &parameters)
  {
    const std::vector<ParameterSection> sections = values.subsections<StageEntries>();
    for (unsigned int s = 0; s < sections.size(); ++s)
      if (parameters.model.stages[s].is_dynamic())
        values.attempt(sections[s], [&]() { check_stage(values, sections[s], s, parameters); });
  }
} // namespace fuga
