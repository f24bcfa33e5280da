// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** A row of the table of problem S0, verification.md, in its units and digits. */
  struct Row
  {
    const char *file;
    const char *compliance; // both; nullptr = as in the file
    std::size_t n_open, n_stick, n_slip;
    double p_max, closure, added_jump, jump, gap; // MPa, mm
  };

  std::ostream &
  operator<<(std::ostream &out, const Row &row)
  {
    return out << row.file << ' ' << (row.compliance != nullptr ? row.compliance : "");
  }

  const Row rows[] = {
    {"paper_1_rigid.prm", nullptr, 2, 6, 1, 0.8421, 0., 0.0026, 0.0180, 0.0282},
    {"paper_2_linear.prm", "1.25e-7", 2, 6, 1, 0.8420, 0.0001, 0.0026, 0.0180, 0.0282},
    {"paper_2_linear.prm", "1.25e-4", 2, 5, 2, 0.7892, 0.0986, 0.0080, 0.0263, 0.0461},
    {"paper_2_linear.prm", "1.25e-3", 2, 4, 3, 0.7091, 0.8864, 0.0799, 0.1130, 0.1981},
    {"paper_3_cubic_root.prm", "1.25e-7", 2, 6, 1, 0.8420, 0.0001, 0.0026, 0.0180, 0.0282},
    {"paper_3_cubic_root.prm", "1.25e-4", 2, 6, 1, 0.8055, 0.0681, 0.0080, 0.0271, 0.0384},
    {"paper_3_cubic_root.prm", "1.25e-3", 1, 5, 3, 0.7593, 0.3960, 0.0755, 0.1172, 0.0697}};

  class PaperTable : public testing::TestWithParam<Row>
  {
  protected:
    static SceneRun
    run(const Row &row)
    {
      if (row.compliance == nullptr)
        return run_scene(row.file);
      const std::string value = row.compliance;
      return run_scene(
        row.file,
        {"Joints/base/Normal compliance=" + value, "Joints/base/Shear compliance=" + value});
    }
  };

  double
  largest(const Vector &values)
  {
    double result = 0.;
    for (const double value : values)
      result = std::max(result, std::abs(value));
    return result;
  }
} // namespace

// The table of S0 in verification.md, found by two independent prototypes (the law (9) rows by
// one). Tolerance: half a unit of the last printed digit, and a hundredth of it for rounding.
TEST_P(PaperTable, Row)
{
  const Row &row     = GetParam();
  const SceneRun run = PaperTable::run(row);
  const double half  = 0.505e-4;
  EXPECT_EQ(run.summary.at("verdict"), "done");
  EXPECT_EQ(run.count("open", 2.), row.n_open);
  EXPECT_EQ(run.count("stick", 2.), row.n_stick);
  EXPECT_EQ(run.count("slip", 2.), row.n_slip);
  const double mm     = 1e3;
  const Vector before = run.values("jump_t1", 1.), after = run.values("jump_t1", 2.);
  ASSERT_EQ(after.size(), 9u);
  double added = 0.;
  for (std::size_t k = 0; k < after.size(); ++k)
    added += std::abs(after[k] - before[k]) / static_cast<double>(after.size());
  double closure = 0.;
  for (const double jump : run.values("jump_n", 2.))
    closure = std::max(closure, -jump);
  const bool law_9 = std::string(row.file) == "paper_3_cubic_root.prm";
  const std::string variant =
    row.compliance == nullptr
      ? std::string("rigid")
      : (law_9 ? "law (9), ρ0 = " : "linear, ρ = ") + std::string(row.compliance);
  const auto expect = [&](const char *quantity, const double known, const double ours) {
    expect_answer({"S0 stand-in for the paper's test",
                   fmt::format("{}: {}", variant, quantity),
                   known,
                   law_9 ? "a prototype" : "two prototypes"},
                  ours,
                  half);
  };
  expect("largest pressure [MPa]", row.p_max, largest(run.values("pressure", 2.)));
  expect("largest closure [mm]", row.closure, mm * closure);
  expect("mean jump added [mm]", row.added_jump, mm * added);
  expect("largest jump [mm]", row.jump, mm * largest(after));
  expect("largest gap [mm]", row.gap, mm * largest(run.values("gap", 2.)));
}

// The bound that the program itself states (verification.md: every run is certified). Law (9) with
// the compliance as printed is a nearly rigid nonlinear layer.
TEST_P(PaperTable, IsCertified)
{
  const SceneRun run = PaperTable::run(GetParam());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
}

INSTANTIATE_TEST_SUITE_P(S0, PaperTable, testing::ValuesIn(rows));

// Events of stage 2 with law (9) at 1.25e-4, verification.md, six digits: half a unit of the last.
// (Its list begins after the re-sticking that the reversal at the start of stage 2 causes.)
TEST(PaperEvents, CubicRoot)
{
  const Vector times      = run_scene("paper_3_cubic_root.prm").event_times(1.);
  const double expected[] = {0.727047, 0.825703, 0.897164, 0.992345};
  ASSERT_EQ(times.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    expect_answer({"S0 stand-in for the paper's test",
                   fmt::format("law (9), ρ0 = 1.25e-4: load of event {} of stage 2", i + 1),
                   expected[i],
                   "a prototype"},
                  times[i] - 1.,
                  5e-7);
}

// Equilibrium of the structure, by hand: N = 0.024 B H = 1.152 MN, T = q H = 0.1728 MN, M about the
// middle of the base = q H²/2 = 1.0368 MNm (counter-clockwise negative; forces of the joint on the
// structure are opposite). Direct solvers: 1e-12.
TEST(PaperResultants, BalanceTheLoads)
{
  for (const char *file : {"paper_1_rigid.prm", "paper_2_linear.prm", "paper_3_cubic_root.prm"})
    {
      const SceneRun run = run_scene(file);
      EXPECT_NEAR(run.resultant("N", 2.), -1.152, 1e-12) << file;
      EXPECT_NEAR(run.resultant("T", 2.), 0.1728, 1e-12) << file;
      EXPECT_NEAR(std::abs(run.resultant("M", 2.)), 1.0368, 1e-12) << file;
      EXPECT_NEAR(run.resultant("position_x", 2.), 2. + 1.0368 / 1.152, 1e-11) << file;
    }
}

// What the paper claims of its variants, as verification.md lists it: opening longest for the rigid
// joint, shear jump larger by tens of percent and contact pressure slightly lower with compliance;
// the hardening layer 1.4 to 1.7 times stiffer at 0.5 to 2 MPa (closed form of law (9)).
TEST(PaperClaims, AreShown)
{
  const SceneRun rigid = run_scene("paper_1_rigid.prm"), linear = run_scene("paper_2_linear.prm"),
                 cubic = run_scene("paper_3_cubic_root.prm");
  EXPECT_GE(rigid.count("open", 2.), linear.count("open", 2.));
  EXPECT_GE(rigid.count("open", 2.), cubic.count("open", 2.));
  const double jump = largest(rigid.values("jump_t1", 2.));
  EXPECT_GT(largest(linear.values("jump_t1", 2.)), 1.2 * jump);
  EXPECT_GT(largest(cubic.values("jump_t1", 2.)), 1.2 * jump);
  const double p = largest(rigid.values("pressure", 2.));
  EXPECT_LT(largest(linear.values("pressure", 2.)), p);
  EXPECT_GT(largest(linear.values("pressure", 2.)), 0.9 * p);
  const Vector pressure = cubic.values("pressure", 2.), jump_n = cubic.values("jump_n", 2.);
  for (std::size_t k = 0; k < pressure.size(); ++k)
    if (pressure[k] > 0.5)
      {
        const double secant_ratio = pressure[k] / -jump_n[k] * 1.25e-4;
        EXPECT_GT(secant_ratio, 1.4);
        EXPECT_LT(secant_ratio, 1.7);
      }
}
