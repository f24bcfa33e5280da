// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_constant_expressions_h
#define fuga_input_syntax_constant_expressions_h

#include <fuga/input/syntax/parameter_declarations.h>

#include <map>
#include <set>

namespace fuga
{
  /**
   * Numbers written as expressions of the constants of section Constants and pi, such as "0.9*H".
   * They are evaluated once, when the file is read; from then on there are only numbers.
   */
  class ConstantExpressions
  {
  public:
    ConstantExpressions();

    /** Add a constant that later expressions may use. */
    void
    add(const std::string &name, const double value);

    /** Add a constant that has an error itself: expressions that use it are not evaluated. */
    void
    add_unknown(const std::string &name);

    /** The result of evaluating a text. */
    struct Result
    {
      /** The text with numbers in place of expressions; otherwise unchanged. */
      std::string text;
      /** Empty, or a sentence that says what is wrong and what to do. */
      std::string problem;
      /** Whether it depends on a constant that is unknown because of an error in it. */
      bool is_unknown = false;
    };

    /** Evaluate a text that represents one number. */
    Result
    number(const std::string &text) const;

    /**
     * Evaluate the numbers of a table "a: b; a: b", a vector "a; b" or a list "a, b". Parts that
     * are not expressions of constants stay unchanged, and so do other texts: a name, an expression
     * of x or t.
     */
    Result
    numbers(const std::string &text) const;

  private:
    Result
    evaluate(const std::string &expression) const;

    std::map<std::string, double> values;
    std::set<std::string> unknown;
  };
} // namespace fuga

#endif
