// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_load_knots_h
#define fuga_bodies_program_load_knots_h

#include <fuga/bodies/loads/level_history.h>

namespace fuga
{
  /** What the factor of a load does in a stage. */
  enum class FactorCourse
  {
    /** Zero throughout. */
    none,
    constant,
    changing
  };

  /**
   * Where a stage is cut into pieces on which all loads are taken as linear in t: into
   * ModelDefinition::load_knots, or the time steps of a dynamic stage. Between these knots
   * everything smooth is off by no more than an eighth of the square of the length times its second
   * derivative. Where a level has a corner, or passes one of
   * the levels_of_kinks(), there is a knot as well; where it moves above or below all that it can
   * wet, or stands still, there is none, because the pressure of the depth is linear there (unless
   * its factor changes as well).
   */
  class LoadKnots
  {
  public:
    /** @p kinks: levels_of_kinks() of every load; empty for loads that are no depth pressures. */
    LoadKnots(const ModelDefinition &model, std::vector<std::vector<double>> kinks);

    /**
     * Knots of one stage as fractions of it, increasing; 0 is left out, 1 the last one. @p courses
     * of all loads; @p straight: all histories are linear.
     */
    std::vector<double>
    fractions(const std::size_t stage,
              const std::vector<FactorCourse> &courses,
              const bool straight) const;

  private:
    unsigned int
    number_of_pieces(const std::size_t stage) const;

    /** Adds the knots of @p level of load @p number in a stage. */
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
