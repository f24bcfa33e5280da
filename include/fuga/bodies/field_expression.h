// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_field_expression_h
#define fuga_bodies_field_expression_h

#include <deal.II/base/point.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  template <int dim>
  class FunctionParser;
}

namespace fuga
{
  /** Return whether the variable or constant @p identifier occurs in a muParser expression. */
  bool
  expression_uses(const std::string &expression, const std::string &identifier);

  /**
   * Functions of the position (x, y, ...) and of the load time t, given by muParser expressions.
   */
  template <int dim>
  class FieldExpression
  {
  public:
    /**
     * Parse the expressions; an empty expression is zero. Every message begins with @p what.
     * @throws InputError, like the evaluation, with muParser's message or the position where the
     * value is not a finite number.
     */
    FieldExpression(const std::vector<std::string> &expressions,
                    const std::map<std::string, double> &constants,
                    const std::string &what);

    ~FieldExpression();

    void
    set_time(const double t);

    double
    value(const dealii::Point<dim> &position, const unsigned int component) const;

    /** Return whether no expression depends on the position. */
    bool
    is_uniform() const
    {
      return uniform;
    }

  private:
    std::string what;
    std::unique_ptr<dealii::FunctionParser<dim>> parser;
    bool uniform = true;
  };
} // namespace fuga

#endif
