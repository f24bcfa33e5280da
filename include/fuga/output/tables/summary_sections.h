// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_summary_sections_h
#define fuga_output_tables_summary_sections_h

#include <fuga/output/tables/summary.h>

#include <nlohmann/json.hpp>

namespace fuga
{
  using SummaryJson = nlohmann::ordered_json;

  /**
   * Return the section of summary.json with the factors of safety by method; a factor is null if
   * none was found.
   */
  SummaryJson
  safety_section(const std::vector<SafetyFactor> &factors);

  /** Return the section about the accuracy; an unknown estimate is null. */
  SummaryJson
  accuracy_section(const AccuracyReport &accuracy);

  SummaryJson
  motion_section(const MotionLedger &energies, const std::vector<std::size_t> &steps);

  SummaryJson
  continuations_section(const std::vector<MotionBeyondLimit> &continuations);
} // namespace fuga

#endif
