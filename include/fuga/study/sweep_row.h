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
  /** The results of a sweep for one variant. */
  struct SweepRow
  {
    std::size_t number = 0;
    /** The varied values, as many as there are settings. */
    std::vector<std::string> settings;
    std::string verdict;
    DrivingQuantity drive;
    /** The mechanism in words. */
    std::string motion;
    PathResult path;
    std::vector<JointResultant> resultants;
    /** The displacement of each monitor. */
    std::vector<std::array<double, 3>> displacements;
    /** Load times of the first opening and the first slip; not a number if there was none. */
    double first_opening = std::numeric_limits<double>::quiet_NaN();
    double first_slip    = std::numeric_limits<double>::quiet_NaN();
    /** Largest gap of any element in a dynamic stage, by joint [length]. */
    std::vector<double> largest_openings;
    /** The energies of the last dynamic stage, at its end. */
    MotionLedger motion_energies;
    std::size_t n_iterations = 0;
    double certificate       = 0.;
    double seconds           = 0.;
    /** The exit code of a run of the variant alone. */
    ExitCode exit_code = ExitCode::done;
    /** Reason of a numerical failure. */
    std::string message;
    std::vector<SafetyFactor> safety;
    std::vector<std::string> warnings;
  };

  /**
   * Return the columns of sweep.csv, see doc/sweeps.md. @p model is that of any of the variants.
   */
  template <int dim>
  Columns<SweepRow>
  sweep_columns(const Model<dim> &model, const Parameters &parameters);
} // namespace fuga

#endif
