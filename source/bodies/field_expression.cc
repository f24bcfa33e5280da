// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/point_text.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace fuga
{
  bool
  expression_uses(const std::string &expression, const std::string &identifier)
  {
    const auto is_part = [](const char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    for (std::size_t at = expression.find(identifier); at != std::string::npos;
         at             = expression.find(identifier, at + 1))
      {
                    const std::size_t end = at + identifier.size();
                    if ((at == 0 || !is_part(expression[at - 1])) &&
            (end == expression.size() || !is_part(expression[end])))
          return true;
      }
    return false;
  }


  template <int dim>
  FieldExpression<dim>::FieldExpression(const std::vector<std::string> &expressions,
                                        const std::map<std::string, double> &constants,
                                        const std::string &description)
    : what(description)
    , parser(std::make_unique<dealii::FunctionParser<dim>>(
        std::max(1U, static_cast<unsigned int>(expressions.size()))))
  {
    const std::string variables = dealii::FunctionParser<dim>::default_variable_names();
    std::vector<std::string> filled;
    for (const auto &expression : expressions)
      {
        filled.push_back(expression.empty() ? "0" : expression);
        for (unsigned int c = 0; c < dim; ++c)
          uniform = uniform && !expression_uses(expression, std::string(1, "xyz"[c]));
      }
    if (filled.empty())
      filled = {"0"}; // a load that is described by numbers alone
    std::map<std::string, double> all_constants = constants;
    all_constants.emplace("pi", dealii::numbers::PI);
    try
      {
        parser->initialize(variables + ",t", filled, all_constants, true);
        for (unsigned int c = 0; c < filled.size(); ++c)
          parser->value(dealii::Point<dim>(), c); // syntax errors only appear at the first
                                                  // evaluation
      }
    catch (const dealii::ExceptionBase &error)
      {
        throw InputError(fmt::format("{}: {}", what, error.what()));
      }
  }


  template <int dim>
  FieldExpression<dim>::~FieldExpression() = default;


  template <int dim>
  void
  FieldExpression<dim>::set_time(const double t)
  {
    parser->set_time(t);
  }


  template <int dim>
  double
  FieldExpression<dim>::value(const dealii::Point<dim> &position,
                              const unsigned int component) const
  {
    const double result = parser->value(position, component);
    if (!std::isfinite(result))
      throw InputError(fmt::format("{}: the value at {}, t = {:g} is not a finite number.",
                                   what,
                                   text_of(position),
                                   parser->get_time()));
    return result;
  }


  template class FieldExpression<2>;
  template class FieldExpression<3>;
} // namespace fuga
