// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/syntax/constant_expressions.h>
#include <fuga/input/syntax/parameter_expressions.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/syntax/parameter_patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Return whether there is something to calculate, i.e. more than a number, followed by a unit
     * or the rest of a decimal comma, or a word. */
    bool
    is_calculation(const std::string &text)
    {
      double ignored       = 0.;
      const char *const at = text.data() + (text[0] == '-' || text[0] == '+' ? 1 : 0);
      const auto number    = std::from_chars(at, text.data() + text.size(), ignored);
      if (number.ec == std::errc::result_out_of_range)
        return false;
      const bool has_number =
        number.ec == std::errc() && std::isalpha(static_cast<unsigned char>(*at)) == 0;
      const std::size_t next = text.find_first_not_of(
        ' ', has_number ? static_cast<std::size_t>(number.ptr - text.data()) : 0);
      if (has_number)
        return next != std::string::npos &&
               std::string("+-*/^(<>!&|?").find(text[next]) != std::string::npos;
      return text.find_first_of("+-*/^(", 1) != std::string::npos || text[0] == '(';
    }
  } // namespace


  ConstantExpressions::ConstantExpressions() : values({{"pi", std::acos(-1.)}})
  {
  }


  void
  ConstantExpressions::add(const std::string &name, const double value)
  {
    values[name] = value;
    unknown.erase(name);
  }


  void
  ConstantExpressions::add_unknown(const std::string &name)
  {
    unknown.insert(name);
  }


  ConstantExpressions::Result
  ConstantExpressions::evaluate(const std::string &expression) const
  {
    std::vector<std::string> known;
    for (const auto &[name, value] : values)
      known.push_back(name);
    for (const std::string &name : names_in_expression(expression))
      {
        if (unknown.count(name) > 0)
          return {expression, "", true};
        if (values.count(name) == 0)
          return {expression,
                  fmt::format("the expression '{}' has the unknown name '{}'. {}",
                              expression,
                              name,
                              name_hint(name, known, "constants")),
                  false};
      }
    double value              = 0.;
    const std::string problem = evaluate_constant(expression, values, value);
    return {problem.empty() ? fmt::format("{}", value) : expression, problem, false};
  }


  ConstantExpressions::Result
  ConstantExpressions::number(const std::string &text) const
  {
    if (text.empty() || number_of_text(text))
      return {text, "", false};
    const std::vector<std::string> names = names_in_expression(text);
    const bool is_name =
      names.size() == 1 && (text == names.front() || text == "-" + names.front());
    if (is_name && values.count(names.front()) + unknown.count(names.front()) == 0)
      {
        // A word for which no constant can be meant is reported by the pattern of the entry.
        const Result result = evaluate(text);
        return result.problem.find("Did you mean") == std::string::npos ? Result{text, "", false}
                                                                        : result;
      }
    if (!is_name && !is_calculation(text))
      return {text, "", false};
    return evaluate(text);
  }


  ConstantExpressions::Result
  ConstantExpressions::numbers(const std::string &text) const
  {
    const bool is_table =
      text.find(':') != std::string::npos && text.find('?') == std::string::npos;
    const bool is_vector = !is_table && text.find(';') != std::string::npos;
    const bool is_list   = !is_table && !is_vector && text.find(',') != std::string::npos &&
                         text.find('(') == std::string::npos;
    if (!is_table && !is_vector && !is_list)
      return {text, "", false};
    const std::string separators = is_table ? ":;" : is_vector ? ";" : ",";
    Result whole;
    std::string piece;
    for (std::size_t i = 0; i <= text.size(); ++i)
      {
        if (i < text.size() && separators.find(text[i]) == std::string::npos)
          {
            piece += text[i];
            continue;
          }
        const Result result = number(normalise_blanks(piece));
        if (!result.problem.empty() || result.is_unknown)
          return {text, result.problem, result.is_unknown};
        // A piece that was a number stays as it was written.
        whole.text += result.text == normalise_blanks(piece) ? piece : " " + result.text;
        if (i < text.size())
          whole.text += text[i];
        piece.clear();
      }
    whole.text = normalise_blanks(whole.text);
    return whole;
  }
} // namespace fuga
