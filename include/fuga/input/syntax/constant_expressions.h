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

    /** A constant that later expressions may use. */
    void
    add(const std::string &name, const double value);

    /** A constant with an error of its own: what is written with it is not looked at. */
    void
    add_unknown(const std::string &name);

    /** What came of a text. */
    struct Result
    {
      /** With numbers in the place of expressions; else as it was. */
      std::string text;
      /** "" or a sentence that says what is wrong and what to do. */
      std::string problem;
      /** It depends on a constant that is not known for an error of its own. */
      bool is_unknown = false;
    };

    /** A text that stands for one number. */
    Result
    number(const std::string &text) const;

    /**
     * The numbers of a table "a: b; a: b", a vector "a; b" or a list "a, b". What is no expression
     * of constants stays as it is, and texts that are neither: a name, an expression of x or t.
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
