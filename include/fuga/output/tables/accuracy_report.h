// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_accuracy_report_h
#define fuga_output_tables_accuracy_report_h

#include <cstddef>
#include <string>
#include <vector>

namespace fuga
{
  /** Report on the adaptation of a mesh to section Target accuracy. */
  struct AccuracyReport
  {
    struct Round
    {
      std::size_t cells = 0, unknowns = 0, contact_elements = 0;
      /** Unknowns of the mesh refined once more; 0 if it was not computed. */
      std::size_t unknowns_compared = 0;
      /** Estimated relative error; not a number if it is not known. */
      double estimate = 0.;
      double seconds  = 0.;
    };

    /** Name of the quantity in the parameter file. */
    std::string quantity;
    double target = 0.;
    /** The rounds of refinement; empty if no accuracy was requested. */
    std::vector<Round> rounds;
    /** Reason why the adaptation ended with the last round. */
    std::string end;
    bool reached = false;

    /** Return what the log says about a round. */
    std::string
    description(const std::size_t round) const;

    /** Return what the log says at the end. */
    std::string
    conclusion() const;
  };

  /** Write refinement.csv in @p directory: one row per round. */
  void
  write_refinement_table(const std::string &directory, const AccuracyReport &report);
} // namespace fuga

#endif
