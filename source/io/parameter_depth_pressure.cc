// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/parameter_entries.h>
#include <fuga/io/parameter_names.h>
#include <fuga/io/parameter_readers.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    double
    read_number(const ParameterSection &section,
                const AnyEntry &entry,
                const std::string &form,
                const std::string &point,
                const std::string &text)
    {
      const std::optional<double> number = number_of_text(text);
      if (!number)
        section.fail(entry,
                     fmt::format("'{}' is no point of a table: '{}' {}. Write '{}' with two "
                                 "numbers, and ';' between the points.",
                                 point,
                                 text,
                                 text.empty() ? "is empty" : "is not a number",
                                 form));
      return *number;
    }
  } // namespace


  std::vector<std::array<double, 2>>
  read_table(const ParameterSection &section, const AnyEntry &entry, const std::string &form)
  {
    std::vector<std::array<double, 2>> table;
    for (const std::string &point : split_pieces(section.text(entry), ';'))
      {
        const std::vector<std::string> numbers = split_pieces(point, ':');
        if (numbers.size() != 2)
          section.fail(entry,
                       fmt::format("'{}' is no point of a table. Write '{}' with two "
                                   "numbers, and ';' between the points.",
                                   point,
                                   form));
        const double a = read_number(section, entry, form, point, numbers[0]);
        const double b = read_number(section, entry, form, point, numbers[1]);
        if (!table.empty() && a <= table.back()[0])
          section.fail(
            entry,
            fmt::format("the first numbers of the table do not increase: {:g} comes "
                        "after {:g}. {}",
                        a,
                        table.back()[0],
                        entry.declaration->content == TextContent::level
                          ? "t is the load time: it runs from 0 to 1 in the first stage, "
                            "from 1 to 2 in the second one."
                          : "Sort the points."));
        table.push_back({{a, b}});
      }
    return table;
  }


  LevelDefinition
  read_level(const ParameterSection &section,
             const AnyEntry &entry,
             const std::map<std::string, double> &constants)
  {
    LevelDefinition result;
    const std::string level = section.text(entry);
    // A ':' may also be that of 'a ? b : c'.
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
