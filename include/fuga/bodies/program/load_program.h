// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_load_program_h
#define fuga_bodies_program_load_program_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/loads/temperature_field.h>
#include <fuga/contact/load_history.h>

namespace fuga
{
  /**
   * The stages of the model in the form that the contact layer needs: load patterns fixed in space,
   * and their factors, piecewise linear in the load time. A stage whose histories are linear in its
   * fraction, and whose loads do not depend on time otherwise, is one segment and exact; any other
   * is divided by LoadKnots into segments, between whose ends the load is interpolated (this is
   * stated in the report, with the accuracy in the middle of segments of loads that change with
   * time).
   */
  struct LoadProgram
  {
    /** The origin of a pattern: a load at one load time. */
    struct Source
    {
      unsigned int load;
      double t;
    };

    std::vector<LoadPattern> patterns;
    /** The source of every pattern. */
    std::vector<Source> sources;
    LoadHistory history;
    /** Load times at which results are written: the levels of all stages. */
    std::vector<double> levels;
    /** Lines for the log. */
    std::vector<std::string> report;
    /**
     * Factor of every load at the corners of the history, independent of its representation by
     * patterns.
     */
    LoadHistory load_factors;
    /** Load time at which the loads end and the searches for safety begin. */
    double end_of_loading = 0.;

    /** Return the factors of the loads at a load time, by name. */
    std::map<std::string, double>
    factors_by_name(const ModelDefinition &model, const double t) const;

    /** Return the temperature at a load time, interpolated between knots like the loads. */
    template <int dim>
    TemperatureField<dim>
    temperature(const ModelDefinition &model,
                const std::vector<std::string> &body_names,
                const double t) const;
  };

  /**
   * Create the load program of the phase that begins with @p first_stage; if that is dynamic, loads
   * may jump there.
   * @throws InputError for a history that cannot be evaluated, or that makes a load jump at the
   * beginning of a stage without inertia.
   */
  template <int dim>
  LoadProgram
  make_load_program(const ModelDefinition &model,
                    const CondensedSystem<dim> &system,
                    const unsigned int first_stage = 0);
} // namespace fuga

#endif
