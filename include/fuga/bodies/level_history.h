// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_level_history_h
#define fuga_bodies_level_history_h

#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** The level of a depth pressure as a function of the load time. */
  class LevelHistory
  {
  public:
    /** @p load must outlive this object. @throws InputError, as evaluation does. */
    LevelHistory(const LoadDefinition &load, const std::map<std::string, double> &constants);

    double
    operator()(const double t) const;

    /** Load times strictly between @p begin and @p end at which the level has a corner: it is
     *  linear in between, if is_piecewise_linear(). */
    std::vector<double>
    corners(const double begin, const double end) const;

    /** A table, or an expression that is linear between @p begin and @p end. */
    bool
    is_piecewise_linear(const double begin, const double end) const;

  private:
    const DepthPressure &depth;
    mutable FieldExpression<2> expression;
  };

  /** Whether the level of @p depth is not the same at all times. */
  bool
  level_changes(const DepthPressure &depth);
} // namespace fuga

#endif
