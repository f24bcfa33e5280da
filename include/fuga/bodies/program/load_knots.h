// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_load_knots_h
#define fuga_bodies_program_load_knots_h

#include <fuga/bodies/loads/level_history.h>

namespace fuga
{
  /** The behaviour of the factor of a load in a stage. */
  enum class FactorCourse
  {
    /** The factor is zero throughout. */
    none,
    constant,
    changing
  };

  /**
   * The division of a stage into pieces on which all loads are assumed to be linear in t:
   * ModelDefinition::load_knots pieces, or the time steps of a dynamic stage. Between these knots
   * the error of everything smooth is at most an eighth of the square of the length times its
   * second derivative. There is also a knot where a level has a corner, or passes one of the
   * levels_of_kinks(); where it moves above or below everything that it can wet, or stands still,
   * there is none, because the pressure due to the depth is linear there (unless its factor changes
   * as well).
   */
  class LoadKnots
  {
  public:
    /**
     * @p kinks are the levels_of_kinks() of every load; empty for loads that are not depth
     * pressures.
     */
    LoadKnots(const ModelDefinition &model, std::vector<std::vector<double>> kinks);

    /**
     * Return the knots of one stage as fractions of it, in increasing order; 0 is left out, 1 is
     * the last one. @p courses are those of all loads; @p straight tells whether all histories are
     * linear.
     */
    std::vector<double>
    fractions(const std::size_t stage,
              const std::vector<FactorCourse> &courses,
              const bool straight) const;

  private:
    unsigned int
    number_of_pieces(const std::size_t stage) const;

    /** Add the knots of @p level of load @p number in a stage. */
    void
    add_level_knots(const unsigned int number,
                    const LevelDefinition &level,
                    const std::size_t stage,
                    const FactorCourse course,
                    std::vector<double> &special,
                    std::vector<bool> &uniform) const;

    const ModelDefinition &model;
    std::vector<std::vector<double>> kinks_of_loads;
  };
} // namespace fuga

#endif
