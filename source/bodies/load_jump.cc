// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/level_history.h>
#include <fuga/bodies/load_jump.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Why a load with a level is not zero at load time @p t. */
    std::string
    cause(const LoadDefinition &load,
          const std::map<std::string, double> &constants,
          const double t)
    {
      const double level = LevelHistory(load, constants)(t);
      const auto &table  = load.depth.level_table;
      std::string text   = fmt::format("At load time {:g} its level is {:g}", t, level);
      if (!table.empty() && table.front()[0] > t)
        text +=
          fmt::format(", the first one of the table, which begins only at {:g}", table.front()[0]);
      if (load.uplift.has_tailwater)
        text += fmt::format(", and the tailwater stands at {:g}",
                            LevelHistory(load.uplift.tailwater, load, constants)(t));
      return text + ": what lies below is loaded at once. ";
    }

    std::string
    remedy(const LoadDefinition &load, const double t)
    {
      return fmt::format(
        "let the water or the ground rise from below all that it loads: a level table that begins "
        "with '{:g}: LEVEL', LEVEL being the lowest point that is loaded, or lower{}; or begin the "
        "history with 0, for example '{}: t'.",
        t,
        load.uplift.has_tailwater ? " (the same holds for the tailwater)" : "",
        load.name);
    }
  } // namespace


  void
  throw_jump(const ModelDefinition &model, const LoadFactors::Jump &jump)
  {
    const StageDefinition &stage            = model.stages[jump.stage];
    const StageDefinition::History &history = stage.histories[jump.history];
    const LoadDefinition &load              = model.loads[history.load];
    const bool is_by_level                  = load.has_level() && jump.from == 0.;
    const double t                          = static_cast<double>(jump.stage);
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
      is_by_level ? cause(load, model.constants, t) : "",
      is_by_level ? remedy(load, t)
                  : fmt::format("begin the history with {:g}; t is the fraction of the stage "
                                "and goes from 0 to 1.",
                                jump.from)));
  }
} // namespace fuga
