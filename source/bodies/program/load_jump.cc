// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/loads/level_history.h>
#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/bodies/program/load_jump.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** The levels that make a load nonzero; for a depth pressure always the first one. */
    struct ActingLevels
    {
      bool level     = true;
      bool tailwater = false;
    };

    // Each of the two waters is considered alone, with the other one far below everything.
    template <int dim>
    ActingLevels
    acting_levels(const ModelDefinition &model,
                  const CondensedSystem<dim> &system,
                  const std::size_t load,
                  const double t)
    {
      if (model.loads[load].kind != LoadKind::uplift)
        return {};
      constexpr double nowhere = -1e100;
      const auto acts          = [&](const WaterLevels &alone) {
        const LoadPattern pattern = system.uplift(load).assemble(alone);
        const auto is_any         = [](const Vector &values) {
          return std::any_of(
            values.begin(), values.end(), [](const double value) { return value != 0.; });
        };
        return is_any(pattern.closed_water) || is_any(pattern.opening_water);
      };
      const WaterLevels levels = levels_of_water(model.loads[load], model.constants, t);
      return {acts({levels.reservoir, nowhere}), acts({nowhere, levels.tailwater})};
    }

    /** "its level is 5, the first one of the table, which begins only at 2". */
    std::string
    statement(const LoadDefinition &load,
              const LevelDefinition &level,
              const std::map<std::string, double> &constants,
              const std::string &subject,
              const double t)
    {
      const double height = LevelHistory(level, load, constants)(t);
      std::string text    = fmt::format("{} {:g}", subject, height);
      if (!level.level_table.empty() && level.level_table.front()[0] > t)
        text += fmt::format(", the first one of the table, which begins only at {:g}",
                            level.level_table.front()[0]);
      return text;
    }

    /** Return why a load with a level is not zero at load time @p t. */
    std::string
    cause(const LoadDefinition &load,
          const std::map<std::string, double> &constants,
          const ActingLevels &acting,
          const double t)
    {
      std::string text = fmt::format("At load time {:g} ", t);
      if (acting.level)
        text += statement(load, load.depth, constants, "its level is", t);
      if (acting.tailwater)
        text += (acting.level ? ", and " : "") +
                statement(load, load.uplift.tailwater, constants, "its tailwater stands at", t);
      return text + ": what lies below is loaded at once. ";
    }

    std::string
    remedy(const LoadDefinition &load, const ActingLevels &acting, const double t)
    {
      const bool one = acting.level != acting.tailwater;
      return fmt::format(
        "let {} rise from below all that {}: a table for {} that begins with '{:g}: LEVEL', LEVEL "
        "being the lowest point that is loaded, or lower; or begin the history with 0, for example "
        "'{}: t'.",
        acting.tailwater ? (acting.level ? "the reservoir and the tailwater" : "the tailwater")
                         : "the water or the ground",
        one ? "it loads" : "they load",
        acting.tailwater ? (acting.level ? "'Level' and 'Tailwater level'" : "'Tailwater level'")
                         : "'Level'",
        t,
        load.name);
    }
  } // namespace


  template <int dim>
  void
  throw_jump(const ModelDefinition &model,
             const CondensedSystem<dim> &system,
             const LoadFactors::Jump &jump)
  {
    const StageDefinition &stage            = model.stages[jump.stage];
    const StageDefinition::History &history = stage.histories[jump.history];
    const LoadDefinition &load              = model.loads[history.load];
    const double t                          = static_cast<double>(jump.stage);
    std::string why, what_to_do;
    if (load.has_level() && jump.from == 0.)
      {
        const ActingLevels acting = acting_levels(model, system, history.load, t);
        why                       = cause(load, model.constants, acting, t);
        what_to_do                = remedy(load, acting, t);
      }
    else
      what_to_do =
        fmt::format("begin the history with {:g}; t is the fraction of the stage and goes "
                    "from 0 to 1.",
                    jump.from);
    throw InputError(fmt::format(
      "{}: stage '{}': the load '{}' jumps from the factor {:g} to {:g} at the beginning of "
      "the stage (history '{}' at t = 0). {}A load must grow from where it is, so that no "
      "event is passed over: {}",
      stage.origin,
      stage.name,
      load.name,
      jump.from,
      jump.to,
      history.expression,
      why,
      what_to_do));
  }

  template void
  throw_jump(const ModelDefinition &, const CondensedSystem<2> &, const LoadFactors::Jump &);
  template void
  throw_jump(const ModelDefinition &, const CondensedSystem<3> &, const LoadFactors::Jump &);
} // namespace fuga
