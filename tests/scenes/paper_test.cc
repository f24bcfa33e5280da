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
  /** A variant of problem S0 (reference/README.md). */
  struct Row
  {
    const char *file;
    const char *compliance; // both; nullptr = as in the file
  };

  std::ostream &
  operator<<(std::ostream &out, const Row &row)
  {
    return out << row.file << ' ' << (row.compliance != nullptr ? row.compliance : "");
  }

  const Row rows[] = {{"paper_1_rigid.prm", nullptr},
                      {"paper_2_linear.prm", "1.25e-7"},
                      {"paper_2_linear.prm", "1.25e-4"},
                      {"paper_2_linear.prm", "1.25e-3"},
                      {"paper_3_cubic_root.prm", "1.25e-7"},
                      {"paper_3_cubic_root.prm", "1.25e-4"},
                      {"paper_3_cubic_root.prm", "1.25e-3"}};

  /** Its answers; the independent code takes 1e-11 m/MPa for the rigid joint. */
  const nlohmann::json &
  answers_of(const Row &row)
  {
    const std::string law =
      std::string(row.file) == "paper_3_cubic_root.prm" ? "cubic root" : "linear";
    const double compliance = row.compliance != nullptr ? std::stod(row.compliance) : 1e-11;
    for (const nlohmann::json &answers : independent_answers().at("S0"))
      if (answers.at("law") == law && answers.at("compliance") == compliance)
        return answers;
    throw std::runtime_error("no answers");
  }

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

// An independent code. Tolerance: half a unit of its last digit, and a hundredth of it for
// rounding.
TEST_P(PaperTable, Row)
{
  const Row &row                = GetParam();
  const nlohmann::json &answers = answers_of(row);
  const SceneRun run            = PaperTable::run(row);
  const double half             = 0.505e-4;
  EXPECT_EQ(run.summary.at("verdict"), "done");
  EXPECT_EQ(run.count("open", 2.), answers.at("open"));
  EXPECT_EQ(run.count("stick", 2.), answers.at("stick"));
  EXPECT_EQ(run.count("slip", 2.), answers.at("slip"));
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
  const auto expect = [&](const char *quantity, const double ours) {
    expect_answer({"S0 stand-in for the paper's test",
                   fmt::format("{}: {}", variant, quantity),
                   answers.at(quantity),
                   independent_code},
                  ours,
                  half);
  };
  expect("largest pressure [MPa]", largest(run.values("pressure", 2.)));
  expect("largest closure [mm]", mm * closure);
  expect("mean jump added [mm]", mm * added);
  expect("largest jump [mm]", mm * largest(after));
  expect("largest gap [mm]", mm * largest(run.values("gap", 2.)));
}

// The bound that the program itself states: every run is certified. Law (9) with
// the compliance as printed is a nearly rigid nonlinear layer.
TEST_P(PaperTable, IsCertified)
{
  const SceneRun run = PaperTable::run(GetParam());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
}

INSTANTIATE_TEST_SUITE_P(S0, PaperTable, testing::ValuesIn(rows));

// Events of stage 2 with law (9) at 1.25e-4, from an independent code, six digits: half a unit of
// the last. (Its list begins after the re-sticking that the reversal at the start of stage 2
// causes.)
TEST(PaperEvents, CubicRoot)
{
  const Vector times = run_scene("paper_3_cubic_root.prm").event_times(1.);
  const nlohmann::json &expected =
    independent_answers().at("S0 events of stage 2, law (9), 1.25e-4");
  ASSERT_EQ(times.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    expect_answer({"S0 stand-in for the paper's test",
                   fmt::format("law (9), ρ0 = 1.25e-4: load of event {} of stage 2", i + 1),
                   expected.at(i),
                   independent_code},
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

// What the paper claims of its variants: opening longest for the rigid
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
