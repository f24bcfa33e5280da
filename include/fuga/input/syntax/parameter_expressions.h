// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_parameter_expressions_h
#define fuga_input_syntax_parameter_expressions_h

#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /** What an expression may depend on. */
  enum class ExpressionArguments
  {
    /** x, y. */
    place,
    /** x, y and the load time t. */
    place_and_time,
    /** x, y, z. */
    place_in_space,
    /** x, y, z and the load time t. */
    place_in_space_and_time,
    /** The stage fraction t. */
    stage_fraction,
    /** The deformation w of a layer. */
    deformation,
    /** The load time t. */
    load_time
  };

  /**
   * Parses and evaluates an expression once, before anything is computed with it.
   * @returns "" or a sentence that says what is wrong and what to do. Values which are not finite
   * are wrong at any stage fraction tried, but of places only if they are so at all points tried
   * (a pressure may well be defined at its own boundary only). Of deformations w = 0 is tried.
   */
  std::string
  expression_problem(const std::string &expression,
                     const ExpressionArguments arguments,
                     const std::map<std::string, double> &constants);

  /** The names of variables and constants in an expression, in its order; functions are none. */
  std::vector<std::string>
  names_in_expression(const std::string &expression);

  /** Puts the value of an expression of constants alone into @p value. @returns "" or what is wrong. */
  std::string
  evaluate_constant(const std::string &expression,
                    const std::map<std::string, double> &constants,
                    double &value);
} // namespace fuga

#endif
