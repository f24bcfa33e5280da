// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/warnings/motion_warnings.h>

#include <gtest/gtest.h>

namespace fuga::tests
{
  namespace
  {
    /** 2 MN m of work, half of them kinetic: @p numerical is what the integration takes of them,
     * @p lacking what nothing accounts for. */
    MotionLedger
    ledger_with(const double numerical, const double lacking)
    {
      MotionLedger ledger;
      ledger.work      = 2.;
      ledger.kinetic   = 1.;
      ledger.numerical = numerical;
      ledger.bodies    = 1. - numerical - lacking;
      ledger.note_largest();
      return ledger;
    }

    std::size_t
    n_warnings(const MotionLedger &ledger)
    {
      return motion_warnings(ledger, {10, 0}).size();
    }
  } // namespace

  // A warning begins at 1e-8 and 0.01 of the largest energy, 2 MN m (doc/dynamics.md), whatever the
  // sign.
  TEST(MotionWarnings, BeginWhereTheManualSays)
  {
    EXPECT_EQ(n_warnings(ledger_with(0.019, 1.9e-8)), 0u);
    EXPECT_EQ(n_warnings(ledger_with(-0.019, -1.9e-8)), 0u);
    EXPECT_EQ(n_warnings(ledger_with(0.021, 0.)), 1u);
    EXPECT_EQ(n_warnings(ledger_with(-0.021, 0.)), 1u);
    EXPECT_EQ(n_warnings(ledger_with(0., 2.1e-8)), 1u);
    EXPECT_EQ(n_warnings(ledger_with(0.021, -2.1e-8)), 2u);
    EXPECT_EQ(n_warnings(MotionLedger()), 0u);
  }

  TEST(MotionWarnings, SayTheNumberAndWhatToDo)
  {
    const MotionLedger ledger = ledger_with(0.05, 0.5);
    const std::string lacking = motion_warnings(ledger, {10, 0}).front();
    EXPECT_NE(lacking.find("0.25"), std::string::npos) << lacking;
    const std::string taken = motion_warnings(ledger, {10, 0}).back();
    EXPECT_NE(taken.find("0.025"), std::string::npos) << taken;
    EXPECT_EQ(taken.find("Halvings"), std::string::npos) << taken;
    const std::string too_long = motion_warnings(ledger, {10, 3}).back();
    EXPECT_NE(too_long.find("3 steps"), std::string::npos) << too_long;
    EXPECT_NE(too_long.find("Halvings"), std::string::npos) << too_long;
  }
} // namespace fuga::tests
