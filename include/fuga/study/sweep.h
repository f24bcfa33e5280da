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
   * Runs all variants of section Sweep and writes one row each to sweep.csv and one line each to
   * log.txt: verdict and mechanism, first opening, first slip, resultants at the end, factors of
   * safety, certificate. Variants that differ only in their joints and the motion of the ground
   * share one condensation of the bodies, and those that do not differ in the layers of joints
   * share the layered system as well.
   */
  template <int dim>
  class Sweep
  {
  public:
    /**
     * Check all variants and condense the bodies of the first ones; nothing is written.
     * @throws InputError, NumericalFailure
     */
    explicit Sweep(const Parameters &parameters);

    /**
     * Run all variants. The exit code is that of the worst certificate and of failures; a limit
     * load is a result here.
     */
    ExitCode
    run();

  private:
    class VariantRun;

    /** Make the model of the variants with this condensation. */
    void
    condense(const std::size_t number);
    /** Add the work done with the model, and with time steps, to the summary. */
    void
    count_model();
    void
    count_steps();
    SweepRow
    run_variant(const Variant &variant);
    /** Add a phase of a variant to the summary, at its end. */
    void
    count(const PhaseRun<dim> &phase);
    /** Add a variant to the summary. */
    void
    count(const SweepRow &row);
    void
    write_summary(const std::string &verdict, const ExitCode code);

    /** Write a line to the log, and to the screen unless the run is quiet. */
    void
    say(const std::string &text);
    void
    say_header();
    /**
     * Write the totals of the model of a condensation, and its warnings, unless they were written
     * before.
     */
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
    /** The system of the first phase of the previous variants. */
    std::shared_ptr<const LayeredSystem> layered;
    /** The bodies of all later phases, whose loads differ in every variant. */
    std::shared_ptr<CondensedSystem<dim>> later_bodies;
    /** The solvers of the last motion. */
    std::shared_ptr<StepSolvers> steps;
    SweepSummary summary;
  };

  /** Return all parameters of a variant on this condensation. */
  Parameters
  parameters_of(const Variant &variant, const Parameters &condensation);

  /**
   * Return the model of a condensation, after checking the joints of all of its variants. @throws
   * InputError that names the variant.
   */
  template <int dim>
  std::unique_ptr<const Model<dim>>
  checked_model(const Parameters &sweep, const std::size_t condensation, const Condensation how);
} // namespace fuga

#endif
