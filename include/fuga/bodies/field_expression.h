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
  /** Whether the variable or constant @p identifier occurs in a muParser expression. */
  bool
  expression_uses(const std::string &expression, const std::string &identifier);

  /** Expressions of the place (x, y, ...) and of the load time t, as muParser understands them. */
  template <int dim>
  class FieldExpression
  {
  public:
    /**
     * An empty expression is zero. @p what begins every message.
     * @throws InputError, as evaluation does, with muParser's message or the place where the value
     * is not a finite number.
     */
    FieldExpression(const std::vector<std::string> &expressions,
                    const std::map<std::string, double> &constants,
                    const std::string &what);

    ~FieldExpression();

    void
    set_time(const double t);

    double
    value(const dealii::Point<dim> &position, const unsigned int component) const;

    /** No expression uses the place. */
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
