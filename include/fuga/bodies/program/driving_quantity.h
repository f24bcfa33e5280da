// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_driving_quantity_h
#define fuga_bodies_program_driving_quantity_h

#include <fuga/bodies/model_definition.h>
#include <fuga/contact/load_history.h>

#include <functional>

namespace fuga
{
  /**
   * The quantity that changes in a stage, in the terms of an engineer, and its value at a load
   * time.
   */
  struct DrivingQuantity
  {
    /**
     * "F" of a strength reduction, "load factor", "level of LOAD", "factor of LOAD" or, if none of
     * these changes, "fraction of the stage".
     */
    std::string name;
    double value = 0.;

    /** Return a readable text such as "F = 1.185". */
    std::string
    text() const;
  };

  /**
   * The quantity that drives each stage: the factor of a search for safety; otherwise the first
   * level of water or earth that moves and belongs to a load that acts; otherwise the first factor
   * of a load that changes. Loads are considered in the order of the input.
   */
  class DrivingQuantities
  {
  public:
    /**
     * @p model must outlive this object and its copies; @p load_factors has one entry per load.
     * @throws InputError, like the evaluation of levels.
     */
    DrivingQuantities(const ModelDefinition &model, const LoadHistory &load_factors);

    /** Return the quantity in the stage with number @p stage, from 0, at the load time @p t. */
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
