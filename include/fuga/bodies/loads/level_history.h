// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_level_history_h
#define fuga_bodies_loads_level_history_h

#include <fuga/bodies/field_expression.h>
#include <fuga/bodies/loads/water_line.h>
#include <fuga/bodies/model_definition.h>

namespace fuga
{
  /** A level as a function of the load time. */
  class LevelHistory
  {
  public:
    /**
     * Create the history of the level of a depth pressure, or of the reservoir of an uplift;
     * @p load must outlive this object. @throws InputError, like the evaluation.
     */
    LevelHistory(const LoadDefinition &load, const std::map<std::string, double> &constants);

    /** Create the history of @p level, which belongs to @p load and must outlive this object. */
    LevelHistory(const LevelDefinition &level,
                 const LoadDefinition &load,
                 const std::map<std::string, double> &constants);

    double
    operator()(const double t) const;

    /**
     * Return the load times strictly between @p begin and @p end at which the level has a corner;
     * it is linear in between, if is_piecewise_linear().
     */
    std::vector<double>
    corners(const double begin, const double end) const;

    /**
     * Return whether the level is a table, or an expression that is linear between @p begin and
     * @p end.
     */
    bool
    is_piecewise_linear(const double begin, const double end) const;

  private:
    const LevelDefinition &definition;
    mutable FieldExpression<2> expression;
  };

  /** Return both levels of an uplift at load time @p t. @throws InputError */
  WaterLevels
  levels_of_water(const LoadDefinition &load,
                  const std::map<std::string, double> &constants,
                  const double t);

  /** Return whether a level changes with time. */
  bool
  level_changes(const LevelDefinition &level);
} // namespace fuga

#endif
