// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_sweep_h
#define fuga_sweep_h

#include <fuga/io/history_writer.h>
#include <fuga/io/output_files.h>
#include <fuga/io/summary.h>
#include <fuga/joint_model.h>
#include <fuga/model.h>
#include <fuga/simulation.h>

namespace fuga
{
  /**
   * Runs all variants of section Sweep on one condensation of the bodies and writes one row each to
   * sweep.csv: limit load and mechanism, first opening, first slip, resultants at the end,
   * certificate. Variants that differ in strength only also share the layered system.
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
    struct Row;

    Row
    run_variant(const Variant &variant);
    LoadHistory
    history_of(const Variant &variant) const;
    const LayeredSystem &
    layered_system_of(const JointModel &joint);
    /** Adds a variant to the summary. */
    void
    count(const Row &row, const ContactPath &path);
    void
    write_summary(const std::string &verdict, const ExitCode code);
    void
    write(CsvFile &table, const std::size_t number, const Variant &variant, const Row &row) const;
    std::vector<std::string>
    columns() const;

    const Model<dim> &model;
    std::unique_ptr<LayeredSystem> layered;
    SweepSummary summary;
  };
} // namespace fuga

#endif
