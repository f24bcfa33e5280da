// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_study_adaptive_run_h
#define fuga_study_adaptive_run_h

#include <fuga/output/tables/accuracy_report.h>
#include <fuga/run/journal/run_outcome.h>
#include <fuga/run/model/model.h>
#include <fuga/study/accuracy_estimate.h>

namespace fuga
{
  /**
   * Finds the mesh for section Target accuracy and runs the simulation on it. In every round the
   * mesh is compared with the same one refined once more; if the estimated error is too large, the
   * cells that hold most of the energy of the difference are refined; meshes of triangles are
   * refined as a whole.
   */
  template <int dim>
  class AdaptiveRun
  {
  public:
    /** @p first_model is the model with the mesh of the file. */
    explicit AdaptiveRun(std::unique_ptr<const Model<dim>> first_model);

    /** Find the mesh and run the simulation. @throws InputError, NumericalFailure */
    ExitCode
    run();

  private:
    void
    begin_output() const;
    /**
     * Estimate the error on the mesh of the model. Return whether the mesh can be refined; in this
     * case @p next is the definition of the refined model.
     */
    bool
    do_round(ModelDefinition &next);
    void
    compare(AccuracyReport::Round &round, ModelDefinition &next) const;
    void
    mark(const TrialRun<dim> &coarse, const TrialRun<dim> &fine, ModelDefinition &next) const;
    bool
    is_too_large(const std::size_t n_unknowns) const;
    void
    replace_model(const ModelDefinition &definition);

    std::unique_ptr<const Model<dim>> model;
    AccuracyReport report;
  };
} // namespace fuga

#endif
