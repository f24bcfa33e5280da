// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>

namespace fuga
{
  unsigned int
  number_of(const std::string &name,
            const std::vector<std::string> &known,
            const std::string &what,
            const ParameterSection &section,
            const AnyEntry &entry)
  {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      {
        const std::string names = what == "body" ? "bodies" : what + "s";
        std::string place       = names;
        place[0]                = static_cast<char>(std::toupper(place[0]));
        section.fail(entry,
                     fmt::format("there is no {} '{}' in section {}. {}",
                                 what,
                                 name,
                                 place,
                                 name_hint(name, known, names)));
      }
    return static_cast<unsigned int>(found - known.begin());
  }


  void
  check_expression(const ParameterSection &section,
                   const AnyEntry &entry,
                   const std::string &expression,
                   const ExpressionArguments arguments,
                   const std::map<std::string, double> &constants)
  {
    const std::string problem = expression_problem(expression, arguments, constants);
    if (!problem.empty())
      section.fail(entry, problem);
  }


  void
  refuse_both(const ParameterSection &section, const AnyEntry &one, const AnyEntry &other)
  {
    if (section.given(one) && section.given(other))
      section.fail(one,
                   fmt::format("'{}' is given as well, see {}. Keep one of the two.",
                               other.name(),
                               section.origin(other)));
  }


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


  std::vector<double>
  read_coordinates(const std::string &text)
  {
    std::vector<double> coordinates;
    for (const std::string &piece : split_pieces(text, ','))
      if (const auto number = number_of_text(piece))
        coordinates.push_back(*number);
      else
        return {};
    return coordinates;
  }


  PointReference
  read_point(const ParameterSection &section, const Text &entry, const unsigned int dimension)
  {
    const std::string text                = section.value(entry);
    const std::vector<double> coordinates = read_coordinates(text);
    PointReference point;
    if (coordinates.size() == dimension)
      std::copy(coordinates.begin(), coordinates.end(), point.coordinates.begin());
    else if (!coordinates.empty() || text.find(',') != std::string::npos)
      section.fail(
        entry,
        fmt::format("this is neither the name of one point nor {} coordinates separated "
                    "by a comma. Write for example 'Point = crest' or 'Point = 2.5, 10'.",
                    dimension));
    else
      point.name = text;
    return point;
  }
} // namespace fuga
