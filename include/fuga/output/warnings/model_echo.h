// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_model_echo_h
#define fuga_output_warnings_model_echo_h

#include <fuga/bodies/program/load_resultant.h>
#include <fuga/contact/load_history.h>
#include <fuga/input/parameters.h>

namespace fuga
{
  class TextTable;

  /**
   * The sums that a reviewer checks before trusting a model, as tables in the units of the user:
   * sizes and weights of the bodies, sizes of the joints, supports, and the resultant of every load
   * at the end of every stage. It does not need condensed bodies.
   */
  template <int dim>
  class ModelEcho
  {
  public:
    /**
     * Create the echo of the stages from @p first_stage to the one before @p end_stage, in which
     * @p system has the bodies. @p load_factors are LoadProgram::load_factors.
     */
    ModelEcho(const Parameters &parameters,
              const CondensedSystem<dim> &system,
              const LoadHistory &load_factors,
              const unsigned int first_stage,
              const unsigned int end_stage);

    /** Return all tables. */
    std::vector<std::string>
    in_full() const;

    /** Return the tables of the bodies, and of the loads at the end of the last stage. */
    std::vector<std::string>
    in_brief() const;

  private:
    using Lines = std::vector<std::string>;

    Lines
    bodies() const;
    Lines
    joints() const;
    Lines
    supports() const;
    Lines
    loads(const unsigned int stage) const;

    /** Return whether a load of type weight acts on the body. */
    bool
    is_weighed(const std::string &body) const;

    /** Return the largest initial gap given by the entry of that name. */
    double
    largest_initial_gap(const unsigned int joint) const;

    /** The effect of one load, by itself or in one joint. */
    struct Action
    {
      std::string name;
      LoadResultant<dim> resultant;
      /** Whether it acts between the two sides of a joint, so that it is no load of the whole. */
      bool is_inner = false;
    };

    std::vector<Action>
    actions(const std::size_t load, const double t) const;

    void
    add_rows(const Action &action,
             const std::vector<std::string> &first_cells,
             TextTable &table) const;

    /**
     * Return "length [m]" in the plane, otherwise "area [m2]"; for bodies "area [m2]" and "volume
     * [m3]", respectively.
     */
    std::string
    measure_of_faces() const;
    std::string
    measure_of_bodies() const;

    const Parameters &parameters;
    const ModelDefinition &model;
    const CondensedSystem<dim> &system;
    const LoadHistory &load_factors;
    const unsigned int first_stage, end_stage;
    /**
     * Whether the model is in the plane, but not of revolution, and has lengths and areas instead
     * of areas and volumes.
     */
    const bool is_flat;
    /** Largest extent of the model. */
    double extent = 0.;
  };
} // namespace fuga

#endif
