// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_load_patterns_h
#define fuga_bodies_program_load_patterns_h

#include <fuga/bodies/program/load_program.h>

namespace fuga
{
  /** The factor of every load at the corners of all stages. */
  struct LoadFactors
  {
    std::vector<double> corners = {0.};
    std::vector<Vector> values;
    /**
     * Load time after which there are only searches for safety: no load changes with time any more.
     */
    double end_of_loading = 0.;

    /** A history that makes the factor of a load jump at the beginning of a stage. */
    struct Jump
    {
      std::size_t stage, history;
      double from, to;
    };

    /**
     * Jumps of loads that change with time by themselves: they are harmless if such a load is zero
     * there.
     */
    std::vector<Jump> jumps;
  };

  /**
   * Loads as patterns fixed in space. A load that changes with time is represented by one pattern
   * per corner, with a hat function as history.
   */
  template <int dim>
  class LoadPatterns
  {
  public:
    /** @throws InputError, like LoadAssembly, and for a load that jumps. */
    LoadPatterns(const ModelDefinition &model,
                 const CondensedSystem<dim> &system,
                 const LoadFactors &factors);

    std::vector<LoadPattern> patterns;
    std::vector<LoadProgram::Source> sources;
    /** Factors of all patterns at every corner. */
    std::vector<Vector> values;
    /** Lines for the log about the accuracy with which changing loads are interpolated. */
    std::vector<std::string> report;

  private:
    void
    add(const unsigned int load, const double t, LoadPattern pattern);

    void
    add_changing(const unsigned int load);

    void
    check_jumps(const unsigned int load, const double size) const;

    const ModelDefinition &model;
    const CondensedSystem<dim> &system;
    const LoadFactors &factors;
  };
} // namespace fuga

#endif
