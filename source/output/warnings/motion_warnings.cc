// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/warnings/motion_warnings.h>

#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Share of the largest energy that the time integration should not exceed. */
    constexpr double much_energy = 0.01;
    /** Share that the terms of the energy should not leave unexplained: they are exact up to
     * rounding. */
    constexpr double much_lacking = 1e-8;
  } // namespace

  std::vector<std::string>
  motion_warnings(const MotionLedger &ledger, const std::vector<std::size_t> &steps)
  {
    std::vector<std::string> result;
    if (const double lacking = ledger.share(ledger.defect()); lacking > much_lacking)
      result.push_back(fmt::format("The ledger of energy lacks {:.2g} of the largest energy of the "
                                   "motion; usual is less than {:.2g}. Do not trust this motion.",
                                   lacking,
                                   much_lacking));
    if (const double numerical = ledger.share(ledger.numerical); numerical > much_energy)
      result.push_back(
        fmt::format("The integration in time takes or gives {:.2g} of the largest energy of the "
                    "motion; usual is less than {:.2g}. "
                    "{}Give a smaller Dynamics/Time step or Event tolerance.",
                    numerical,
                    much_energy,
                    steps.back() == 0
                      ? ""
                      : fmt::format("{} steps were as short as they may be, and longer than what "
                                    "happened in the joints: allow more Dynamics/Halvings. ",
                                    steps.back())));
    return result;
  }
} // namespace fuga
