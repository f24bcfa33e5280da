// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_sweep_h
#define fuga_sweep_h

#include <fuga/io/summary.h>
#include <fuga/joint_model.h>
#include <fuga/model.h>
#include <fuga/simulation.h>
#include <fuga/sweep_row.h>

namespace fuga
{
  /**
   * Runs all variants of section Sweep on one condensation of the bodies and writes one row each to
   * sweep.csv, one line each to log.txt: limit load and mechanism, first opening, first slip,
   * resultants at the end, certificate. Variants that differ in strength only also share the
   * layered system.
   */
  template <int dim>
  class Sweep
  {
  public:
    explicit Sweep(const Model<dim> &model);

    /** The exit code is that of the worst certificate and of failures; a limit load is a result
     * here. */
    ExitCode
    run();

  private:
    SweepRow
    run_variant(const Variant &variant);
    bool
    has_stages_of_model(const Variant &variant) const;
    /** The model with the stages of a variant. */
    ModelDefinition
    definition_of(const Variant &variant) const;
    LoadHistory
    history_of(const Variant &variant) const;
    /** What drives the last stage, and the mechanism. */
    void
    describe_end(const Variant &variant,
                 const JointModel &joint,
                 const LoadHistory &history,
                 SweepRow &row) const;
    const LayeredSystem &
    layered_system_of(const JointModel &joint);
    /** Adds a variant to the summary. */
    void
    count(const SweepRow &row, const ContactPath &path);
    void
    write_summary(const std::string &verdict, const ExitCode code);

    /** A line for the log, and for the screen unless the run is quiet. */
    void
    say(const std::string &text);
    void
    say_header();
    void
    say_row(const Variant &variant, const SweepRow &row);

    const Model<dim> &model;
    TextFile log;
    std::unique_ptr<LayeredSystem> layered;
    SweepSummary summary;
  };
} // namespace fuga

#endif
