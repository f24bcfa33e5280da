// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_parameter_expressions_h
#define fuga_input_syntax_parameter_expressions_h

#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /** The variables on which an expression may depend. */
  enum class ExpressionArguments
  {
    /** The position x, y. */
    place,
    /** The position x, y and the load time t. */
    place_and_time,
    /** The position x, y, z. */
    place_in_space,
    /** The position x, y, z and the load time t. */
    place_in_space_and_time,
    /** The stage fraction t. */
    stage_fraction,
    /** The deformation w of a layer. */
    deformation,
    /** The load time t. */
    load_time
  };

  /**
   * Parse and evaluate an expression once, before anything is computed with it.
   * @returns "" or a sentence that says what is wrong and what to do. Values which are not finite
   * are wrong at any stage fraction tried, but at places only if they are so at all points tried (a
   * pressure may well be defined at its own boundary only). Among deformations, w = 0 is tried.
   */
  std::string
  expression_problem(const std::string &expression,
                     const ExpressionArguments arguments,
                     const std::map<std::string, double> &constants);

  /**
   * Return the names of variables and constants in an expression, in its order; names of functions
   * are not included.
   */
  std::vector<std::string>
  names_in_expression(const std::string &expression);

  /**
   * Store the value of an expression that contains only constants in @p value. @returns "" or what
   * is wrong.
   */
  std::string
  evaluate_constant(const std::string &expression,
                    const std::map<std::string, double> &constants,
                    double &value);
} // namespace fuga

#endif
