// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_study_sweep_h
#define fuga_study_sweep_h

#include <fuga/output/tables/summary.h>
#include <fuga/run/model/phase_run.h>
#include <fuga/study/sweep_row.h>

#include <set>

namespace fuga
{
  /**
   * Runs all variants of section Sweep and writes one row each to sweep.csv, one line each to
   * log.txt: verdict and mechanism, first opening, first slip, resultants at the end, factors of
   * safety, certificate. Variants that differ in their joints and the motion of the ground only
   * share one condensation of the bodies, and those that do not differ in the layers of joints
   * the layered system as well.
   */
  template <int dim>
  class Sweep
  {
  public:
    /**
     * Checks all variants and condenses the bodies of the first ones; nothing is written.
     * @throws InputError, NumericalFailure
     */
    explicit Sweep(const Parameters &parameters);

    /** The exit code is that of the worst certificate and of failures; a limit load is a result
     * here. */
    ExitCode
    run();

  private:
    class VariantRun;

    /** Makes the model of the variants with this condensation. */
    void
    condense(const std::size_t number);
    /** Adds what was done with the model, and with steps of time, to the summary. */
    void
    count_model();
    void
    count_steps();
    SweepRow
    run_variant(const Variant &variant);
    /** Adds a phase of a variant to the summary, at its end. */
    void
    count(const PhaseRun<dim> &phase);
    /** Adds a variant to it. */
    void
    count(const SweepRow &row);
    void
    write_summary(const std::string &verdict, const ExitCode code);

    /** A line for the log, and for the screen unless the run is quiet. */
    void
    say(const std::string &text);
    void
    say_header();
    /** What the model of a condensation adds up to, unless it was said before. */
    void
    say_model();
    void
    say_row(const SweepRow &row);
    void
    warn(const std::string &indent, const std::string &text);

    const Parameters &parameters;
    TextFile log;
    std::set<std::string> said;
    PhaseTimer timer;
    std::unique_ptr<const Model<dim>> model;
    std::unique_ptr<const DrivingQuantities> driving;
    std::size_t condensation = 0;
    /** Of the first phase of the variants before. */
    std::shared_ptr<const LayeredSystem> layered;
    /** Those of all later phases: their loads are others in every variant. */
    std::shared_ptr<CondensedSystem<dim>> later_bodies;
    /** Of the last motion. */
    std::shared_ptr<StepSolvers> steps;
    SweepSummary summary;
  };

  /** All of a variant on this condensation. */
  Parameters
  parameters_of(const Variant &variant, const Parameters &condensation);

  /** The model of a condensation, with the joints of all of its variants checked. @throws
   * InputError that names the variant. */
  template <int dim>
  std::unique_ptr<const Model<dim>>
  checked_model(const Parameters &sweep, const std::size_t condensation, const Condensation how);
} // namespace fuga

#endif
