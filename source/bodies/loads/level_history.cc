// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/loads/level_history.h>
#include <fuga/bodies/straightness.h>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  LevelHistory::LevelHistory(const LoadDefinition &load,
                             const std::map<std::string, double> &constants)
    : LevelHistory(load.depth, load, constants)
  {
  }


  LevelHistory::LevelHistory(const LevelDefinition &level,
                             const LoadDefinition &load,
                             const std::map<std::string, double> &constants)
    : definition(level)
    , expression(
        {level.level},
        constants,
        fmt::format(
          "{}{}level of load '{}'", load.origin, load.origin.empty() ? "" : ": ", load.name))
  {
  }


  double
  LevelHistory::operator()(const double t) const
  {
    const auto &table = definition.level_table;
    if (table.empty())
      {
        expression.set_time(t);
        return expression.value(dealii::Point<2>(), 0);
      }
    const auto after = std::upper_bound(
      table.begin(), table.end(), t, [](const double time, const auto &p) { return time < p[0]; });
    if (after == table.begin())
      return table.front()[1];
    if (after == table.end())
      return table.back()[1];
    const auto &[t0, h0] = *(after - 1);
    const auto &[t1, h1] = *after;
    return h0 + (h1 - h0) * (t - t0) / (t1 - t0);
  }


  std::vector<double>
  LevelHistory::corners(const double begin, const double end) const
  {
    std::vector<double> times;
    for (const auto &point : definition.level_table)
      if (point[0] > begin && point[0] < end)
        times.push_back(point[0]);
    return times;
  }


  bool
  LevelHistory::is_piecewise_linear(const double begin, const double end) const
  {
    return !definition.level_table.empty() || is_straight(*this, begin, end);
  }


  WaterLevels
  levels_of_water(const LoadDefinition &load,
                  const std::map<std::string, double> &constants,
                  const double t)
  {
    WaterLevels levels;
    levels.reservoir = LevelHistory(load, constants)(t);
    if (load.uplift.has_tailwater)
      levels.tailwater = LevelHistory(load.uplift.tailwater, load, constants)(t);
    return levels;
  }


  bool
  level_changes(const LevelDefinition &level)
  {
    for (const auto &point : level.level_table)
      if (point[1] != level.level_table.front()[1])
        return true;
    return level.level_table.empty() && expression_uses(level.level, "t");
  }
} // namespace fuga
