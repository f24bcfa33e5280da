// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_driving_quantity_h
#define fuga_bodies_program_driving_quantity_h

#include <fuga/bodies/model_definition.h>
#include <fuga/contact/load_history.h>

#include <functional>

namespace fuga
{
  /** What a stage moves, as an engineer names it, and its value at a load time. */
  struct DrivingQuantity
  {
    /** "F" of a strength reduction, "load factor", "level of LOAD", "factor of LOAD" or, if nothing
     * of this moves, "fraction of the stage". */
    std::string name;
    double value = 0.;

    /** "F = 1.185", for people. */
    std::string
    text() const;
  };

  /**
   * The quantity that drives each stage: the factor of a search for safety; else the first level of
   * water or earth that moves, of a load that acts; else the first factor of a load that changes.
   * Loads come in the order of the input.
   */
  class DrivingQuantities
  {
  public:
    /** @p model must outlive this object and its copies; @p load_factors: one per load.
     * @throws InputError, as the evaluation of levels does. */
    DrivingQuantities(const ModelDefinition &model, const LoadHistory &load_factors);

    /** In the stage with number @p stage, from 0, at the load time @p t. */
    DrivingQuantity
    at(const double t, const std::size_t stage) const;

  private:
    struct Course
    {
      std::string name;
      std::function<double(const double t)> value;
    };

    std::vector<Course> courses; // by stage
  };
} // namespace fuga

#endif
