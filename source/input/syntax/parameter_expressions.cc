// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/syntax/parameter_expressions.h>
#include <fuga/input/syntax/parameter_names.h>

#include <deal.II/base/function_parser.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iostream>
#include <sstream>

namespace fuga
{
  namespace
  {
    /** Suppresses std::cerr, since deal.II prints muParser's message there and throws it as
     * well. */
    class SilentErrorStream
    {
    public:
      SilentErrorStream() : old_buffer(std::cerr.rdbuf(sink.rdbuf()))
      {
      }

      ~SilentErrorStream()
      {
        std::cerr.rdbuf(old_buffer);
      }

      SilentErrorStream(const SilentErrorStream &) = delete;
      SilentErrorStream &
      operator=(const SilentErrorStream &) = delete;

    private:
      std::ostringstream sink;
      std::streambuf *old_buffer;
    };


    const char *
    variable_names(const ExpressionArguments arguments)
    {
      switch (arguments)
        {
          case ExpressionArguments::place:
            return "x,y";
          case ExpressionArguments::place_and_time:
            return "x,y,t";
          case ExpressionArguments::place_in_space:
            return "x,y,z";
          case ExpressionArguments::place_in_space_and_time:
            return "x,y,z,t";
          case ExpressionArguments::deformation:
            return "w";
          default:
            return "t";
        }
    }


    /** Return a message if the expression contains what muParser accepts silently, and what nobody
     * means. */
    std::string
    silent_trap(const std::string &expression)
    {
      int depth = 0;
      for (std::size_t i = 0; i < expression.size(); ++i)
        {
          const char c        = expression[i];
          const char previous = i > 0 ? expression[i - 1] : ' ';
          const char next     = i + 1 < expression.size() ? expression[i + 1] : ' ';
          depth += c == '(' ? 1 : c == ')' ? -1 : 0;
          if (c == ',' && depth == 0)
            return "there is a comma outside of all brackets. Write decimal points, not commas, "
                   "and "
                   "separate expressions by ';'.";
          if (c == '=' && next != '=' && std::string("=<>!").find(previous) == std::string::npos)
            return "there is an assignment '='. Compare with '=='.";
        }
      return "";
    }


    /** Return "The parser said: Unexpected token ..." without the decoration of the exception. */
    std::string
    parser_message(const dealii::ExceptionBase &exception)
    {
      std::ostringstream text;
      exception.print_info(text);
      const std::string message = normalise_blanks(text.str());
      const std::string marker  = "The parser said: ";
      const std::size_t at      = message.find(marker);
      std::string reason = at == std::string::npos ? message : message.substr(at + marker.size());
      if (!reason.empty() && reason.back() == '.')
        reason.pop_back();
      return reason;
    }


    std::string
    not_understood(const std::string &expression,
                   const dealii::ExceptionBase &exception,
                   const std::string &variables,
                   const std::map<std::string, double> &constants)
    {
      std::vector<std::string> known = split_pieces(variables, ',');
      std::string list               = variables;
      for (const auto &[name, value] : constants)
        {
          known.push_back(name);
          list += (list.empty() ? "" : ", ") + name;
        }
      std::string hint;
      for (const std::string &name : names_in_expression(expression))
        if (std::find(known.begin(), known.end(), name) == known.end())
          if (const std::string close = name_hint(name, known, ""); close.rfind("Did", 0) == 0)
            hint = " " + close;
      return fmt::format("the expression '{}' cannot be understood: {}. Known here: {}.{}",
                         expression,
                         parser_message(exception),
                         list,
                         hint);
    }


    /** Return the problem if a value is not finite at a point where it has to be, or if there is no
     * finite value at all. */
    template <int n_arguments>
    std::string
    evaluate(const std::string &expression,
             const std::string &variables,
             const std::map<std::string, double> &constants,
             const std::vector<dealii::Point<n_arguments>> &points,
             const bool everywhere,
             const bool and_at_start = false)
    {
      dealii::FunctionParser<n_arguments> function(1);
      function.initialize(variables, std::vector<std::string>{expression}, constants, and_at_start);
      unsigned int n_finite = 0;
      std::string problem;
      for (const auto &point : points)
        {
          const double value = function.value(point);
          if (std::isfinite(value))
            ++n_finite;
          else if (problem.empty())
            {
              std::ostringstream place;
              place << point << (and_at_start ? " 0" : "");
              problem =
                fmt::format("its value at {} = ({}) is {}, not a finite number. Correct the "
                            "expression.",
                            variables,
                            place.str(),
                            std::isnan(value) ? "NaN" : "infinite");
            }
        }
      return everywhere || n_finite == 0 ? problem : "";
    }


    std::string
    evaluate(const std::string &expression,
             const ExpressionArguments arguments,
             const std::map<std::string, double> &constants)
    {
      const std::string variables = variable_names(arguments);
      if (arguments == ExpressionArguments::stage_fraction)
        return evaluate<1>(expression,
                           variables,
                           constants,
                           {dealii::Point<1>(0.), dealii::Point<1>(0.5), dealii::Point<1>(1.)},
                           true);
      if (arguments == ExpressionArguments::deformation)
        return evaluate<1>(expression, variables, constants, {dealii::Point<1>(0.)}, true);
      if (arguments == ExpressionArguments::load_time)
        return evaluate<1>(expression,
                           variables,
                           constants,
                           {dealii::Point<1>(0.), dealii::Point<1>(0.5), dealii::Point<1>(1.5)},
                           false);
      std::vector<dealii::Point<2>> plane;
      for (const double size : {0., 1., 13.7, 1234.})
        for (const double x : {-size, size})
          for (const double y : {-0.9 * size, 0.9 * size})
            plane.emplace_back(x + 0., y + 0.); // no -0 in messages
      if (arguments == ExpressionArguments::place)
        return evaluate<2>(expression, variables, constants, plane, false);
      if (arguments == ExpressionArguments::place_and_time)
        return evaluate<2>(expression, variables, constants, plane, false, true);
      std::vector<dealii::Point<3>> space;
      for (const auto &point : plane)
        for (const double z : {-0.8 * std::abs(point[0]), 0.8 * std::abs(point[0])})
          space.emplace_back(point[0], point[1], z + 0.);
      return evaluate<3>(expression,
                         variables,
                         constants,
                         space,
                         false,
                         arguments == ExpressionArguments::place_in_space_and_time);
    }
  } // namespace


  std::string
  expression_problem(const std::string &expression,
                     const ExpressionArguments arguments,
                     const std::map<std::string, double> &constants)
  {
    const std::string trap = silent_trap(expression);
    if (!trap.empty())
      return fmt::format("in the expression '{}' {}", expression, trap);
    const SilentErrorStream guard;
    try
      {
        const std::string problem = evaluate(expression, arguments, constants);
        return problem.empty()
                 ? ""
                 : fmt::format("the expression '{}' has no usable value: {}", expression, problem);
      }
    catch (const dealii::ExceptionBase &exception)
      {
        return not_understood(expression, exception, variable_names(arguments), constants);
      }
  }


  std::vector<std::string>
  names_in_expression(const std::string &expression)
  {
    const auto is_letter = [](const char c) {
      return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    const auto is_digit = [](const char c) {
      return std::isdigit(static_cast<unsigned char>(c)) != 0;
    };
    std::vector<std::string> names;
    for (std::size_t i = 0; i < expression.size();)
      {
        const std::size_t begin = i;
        while (i < expression.size() && (is_letter(expression[i]) || is_digit(expression[i])))
          ++i;
        if (i == begin)
          ++i;
        else if (const std::size_t next = expression.find_first_not_of(' ', i);
                 is_letter(expression[begin]) &&
                 (next == std::string::npos || expression[next] != '('))
          names.push_back(expression.substr(begin, i - begin));
      }
    return names;
  }


  std::string
  evaluate_constant(const std::string &expression,
                    const std::map<std::string, double> &constants,
                    double &value)
  {
    if (const std::string trap = silent_trap(expression); !trap.empty())
      return fmt::format("in the expression '{}' {}", expression, trap);
    const SilentErrorStream guard;
    try
      {
        dealii::FunctionParser<1> function(1);
        function.initialize("no_variable_", std::vector<std::string>{expression}, constants);
        value = function.value(dealii::Point<1>());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        return not_understood(expression, exception, "", constants);
      }
    return std::isfinite(value)
             ? ""
             : fmt::format("the expression '{}' is {}, not a finite number. Correct it.",
                           expression,
                           std::isnan(value) ? "NaN" : "infinite");
  }
} // namespace fuga
