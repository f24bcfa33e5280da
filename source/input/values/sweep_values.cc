// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/syntax/constant_expressions.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/sweep_plan.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fuga
{
  namespace
  {
    /** Largest number of values of a range; more than this are a slip of the pen. */
    constexpr double max_values = 20000.;

    /** Return the pieces between separators outside of brackets; '||' separates nothing. */
    std::vector<std::string>
    split_outside(const std::string &text, const char separator)
    {
      std::vector<std::string> pieces(1);
      int depth = 0;
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          const char c = text[i];
          depth += c == '(' ? 1 : c == ')' ? -1 : 0;
          const bool is_double = c == '|' && ((i > 0 && text[i - 1] == '|') ||
                                              (i + 1 < text.size() && text[i + 1] == '|'));
          if (c == separator && depth == 0 && !is_double)
            pieces.emplace_back();
          else
            pieces.back() += c;
        }
      for (std::string &piece : pieces)
        piece = normalise_blanks(piece);
      return pieces;
    }

    /** Return the constants of a file, as far as they are correct; errors are reported
     * elsewhere. */
    ConstantExpressions
    constants_of(const ParameterScan &file)
    {
      ConstantExpressions constants;
      for (const ScannedEntry &entry : file.entries)
        if (entry.path == SectionPath{entries_of<ConstantEntries>().name})
          {
            const ConstantExpressions::Result result = constants.number(entry.value);
            if (const auto value = number_of_text(result.text); result.problem.empty() && value)
              constants.add(entry.name, *value);
          }
      return constants;
    }

    std::vector<std::string>
    range(const ScannedEntry &line,
          const std::vector<std::string> &words,
          const ConstantExpressions &constants)
    {
      std::vector<double> numbers;
      for (const std::string &word : words)
        {
          const ConstantExpressions::Result result = constants.number(word);
          const auto value                         = number_of_text(result.text);
          if (!result.problem.empty())
            line.fail(result.problem);
          if (!value)
            line.fail(
              fmt::format("'{}' is not a number. A range is written first : step : last; "
                          "tables, and other values that contain ':', are separated by '|'.",
                          word));
          numbers.push_back(*value);
        }
      const double first = numbers[0], step = numbers[1], last = numbers[2];
      if (!(step > 0.) || last < first)
        line.fail("a range needs a step > 0 and a last value not below the first.");
      if ((last - first) / step > max_values)
        line.fail(
          fmt::format("the range has more than {:g} values. Take a larger step.", max_values));
      std::vector<std::string> values;
      const double rounding = 1e-9;
      for (int i = 0; first + i * step <= last + rounding * step; ++i)
        values.push_back(fmt::format("{:.12g}", first + i * step));
      return values;
    }
  } // namespace

  std::vector<std::string>
  split_swept_values(const ScannedEntry &line, const ParameterScan &file)
  {
    std::vector<std::string> values = split_outside(line.value, '|');
    if (values.size() == 1)
      {
        const bool is_plain = line.value.find_first_of(";?\"") == std::string::npos;
        const auto words    = split_outside(line.value, ':');
        values              = split_outside(line.value, ',');
        if (is_plain && values.size() == 1 && words.size() == 3)
          return range(line, words, constants_of(file));
        if (is_plain && values.size() == 1 && words.size() == 2)
          line.fail("a range is written first : step : last.");
      }
    if (std::find(values.begin(), values.end(), "") != values.end())
      line.fail("there is an empty value. Write values separated by single commas, or by '|' where "
                "they contain commas.");
    for (auto value = values.begin(); value != values.end(); ++value)
      if (std::find(values.begin(), value, *value) != value)
        line.fail(fmt::format("the value '{}' is there twice. Remove one of the two.", *value));
    return values;
  }
} // namespace fuga
