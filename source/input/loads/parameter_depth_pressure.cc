// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/loads/load_readers.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

namespace fuga
{
  LevelDefinition
  read_level(const ParameterSection &section,
             const AnyEntry &entry,
             const std::map<std::string, double> &constants)
  {
    LevelDefinition result;
    const std::string level = section.text(entry);
    // A ':' may also belong to 'a ? b : c'.
    if (level.find(':') != std::string::npos && level.find('?') == std::string::npos)
      result.level_table = read_table(section, entry, "t: level");
    else
      {
        if (level.empty())
          section.fail(entry, "the level is empty. Write a number, an expression or a table.");
        check_expression(section, entry, level, ExpressionArguments::load_time, constants);
        result.level = level;
      }
    return result;
  }


  DepthPressure
  read_depth_pressure(const ParameterSection &section,
                      const std::map<std::string, double> &constants)
  {
    const LoadEntries &e = entries_of<LoadEntries>();
    DepthPressure depth;
    static_cast<LevelDefinition &>(depth) = read_level(section, e.level, constants);
    const LoadType type                   = section.value(e.type);
    const double unit_weight              = section.value(e.unit_weight);
    if (type == LoadType::westergaard)
      {
        depth.root   = 7. / 8. * section.value(e.horizontal_coefficient) * unit_weight;
        depth.bottom = section.value(e.bottom_level);
        if (depth.root == 0.)
          section.fail(e.horizontal_coefficient,
                       "the coefficient is 0, so that this load does nothing. Set it, or remove "
                       "the load.");
        return depth;
      }
    const double coefficient =
      type == LoadType::earth_pressure ? section.value(e.earth_coefficient) : 1.;
    depth.gradient  = coefficient * unit_weight;
    depth.surcharge = coefficient * section.value_or(e.surcharge, 0.);
    return depth;
  }
} // namespace fuga
