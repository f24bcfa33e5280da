// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// The example of doc/examples/retaining_wall.md against its hand check.

#include "scenes/scene_run.h"

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  double
  resultant(const SceneRun &run, const std::string &joint, const std::string &name, const double t)
  {
    for (std::size_t r = 0; r < run.resultants.rows.size(); ++r)
      if (run.resultants.text(r, "joint") == joint && run.resultants.number(r, "t") == t)
        return run.resultants.number(r, name);
    throw std::out_of_range("no such row");
  }
} // namespace

// Areas of the lifts 7.5 and 4.5 m², weight density 0.024; earth Ka γ h²/2 = 0.33 · 0.018 h²/2 at
// h/3; centroids of the lifts at x = 9.5/7.5 and 3.5/4.5. By equilibrium, whatever the stiffnesses:
// 1e-9.
TEST(RetainingWall, ByHand)
{
  const SceneRun run = run_scene("retaining_wall.prm");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  const double lower = 7.5 * 0.024, upper = 4.5 * 0.024;
  const auto earth = [](const double h) { return 0.33 * 0.018 * h * h / 2.; };
  EXPECT_NEAR(resultant(run, "base", "N", 1.), -lower, 1e-9);
  EXPECT_THROW(resultant(run, "lift", "N", 1.), std::out_of_range);
  for (const double t : {2., 3., 4., 5.})
    {
      const double h = 2. * (t - 2.), h_lift = std::max(0., h - 3.);
      EXPECT_NEAR(resultant(run, "base", "N", t), -lower - upper, 1e-9);
      EXPECT_NEAR(resultant(run, "lift", "N", t), -upper, 1e-9);
      EXPECT_NEAR(std::abs(resultant(run, "base", "T", t)), earth(h), 1e-9);
      EXPECT_NEAR(std::abs(resultant(run, "lift", "T", t)), earth(h_lift), 1e-9);
      const double x = (9.5 * 0.024 + 3.5 * 0.024 + earth(h) * h / 3.) / (lower + upper);
      EXPECT_NEAR(resultant(run, "base", "position_x", t), x, 1e-8);
    }
  EXPECT_NEAR(resultant(run, "base", "sliding_safety", 5.), 0.6 * 0.288 / 0.10692, 1e-8);
}
