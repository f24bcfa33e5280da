// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_study_sweep_row_h
#define fuga_study_sweep_row_h

#include <fuga/bodies/program/driving_quantity.h>
#include <fuga/contact/path/path_result.h>
#include <fuga/output/files/table.h>
#include <fuga/output/results/joint_resultant.h>
#include <fuga/output/tables/summary.h>
#include <fuga/run/journal/run_outcome.h>

#include <limits>

namespace fuga
{
  /** What a sweep finds for one variant. */
  struct SweepRow
  {
    std::size_t number = 0;
    /** The values varied, as many as there are settings. */
    std::vector<std::string> settings;
    std::string verdict;
    DrivingQuantity drive;
    /** The mechanism in words. */
    std::string motion;
    PathResult path;
    std::vector<JointResultant> resultants;
    /** By monitor. */
    std::vector<std::array<double, 3>> displacements;
    /** Load times; not a number if there was none. */
    double first_opening = std::numeric_limits<double>::quiet_NaN();
    double first_slip    = std::numeric_limits<double>::quiet_NaN();
    /** Largest gap of any element in a dynamic stage, by joint [length]. */
    std::vector<double> largest_openings;
    /** Of the last dynamic stage, at its end. */
    MotionLedger motion_energies;
    std::size_t n_iterations = 0;
    double certificate       = 0.;
    double seconds           = 0.;
    /** That of a run of the variant alone. */
    ExitCode exit_code = ExitCode::done;
    /** Reason of a numerical failure. */
    std::string message;
    std::vector<SafetyFactor> safety;
    std::vector<std::string> warnings;
  };

  /** The columns of sweep.csv: doc/sweeps.md. @p model: of any of the variants. */
  template <int dim>
  Columns<SweepRow>
  sweep_columns(const Model<dim> &model, const Parameters &parameters);
} // namespace fuga

#endif
