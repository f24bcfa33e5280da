// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Section Target accuracy on problems with a known pressure: the mesh that is found has it, the
// estimate lies between 0.5 and 3 times the true error (what the page doc/adaptivity.md tables),
// and a uniform refinement with ten times the unknowns is not there yet.

#include "scenes/grid_mesh.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json                   = nlohmann::ordered_json;
  constexpr const char *target = "Target accuracy/";

  /** 0, 1, 3, 7, ... */
  Axis
  doubling(const unsigned int n)
  {
    Axis axis;
    for (unsigned int i = 0; i <= n; ++i)
      axis.push_back(std::exp2(i) - 1.);
    return axis;
  }

  /** V8: a frictionless punch of half-width 1 on a body 127 high; half model, half load 1. */
  Json
  punch()
  {
    Json scene;
    scene["Bodies"]["block"] = {{"Young modulus", 1000.}, {"Poisson ratio", 0.3}};
    scene["Joints"]["punch"] = {
      {"Plus lip", "contact"}, {"Minus lip", "rigid"}, {"Normal law", "rigid"}};
    scene["Boundaries"]["left"]["Fixed"] = "x";
    for (const char *side : {"right", "bottom_free", "corner"})
      scene["Boundaries"][side]["Fixed"] = "free";
    scene["Loads"]["press"] = {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", 1. / 127.}};
    scene["Stages"]["press"]["Loads"] = "press: t";
    return scene;
  }

  std::string
  punch_file()
  {
    return write_scene(block_mesh(doubling(7), doubling(7), 1.), punch());
  }

  double
  punch_pressure(const double x)
  {
    return 2. / (M_PI * std::sqrt(1. - x * x));
  }

  /** V7: two blocks of 32, 4 by 4 squares each, with the roundness of a cylinder between them;
   * half-width 0.85. */
  struct Hertz
  {
    static constexpr double a = 0.85, R = 100., nu = 0.3, E_upper = 1000., E_lower = 3000.;
    const double modulus = 1. / ((1. - nu * nu) * (1. / E_upper + 1. / E_lower));

    double
    pressure(const double x) const
    {
      return modulus * a / (2. * R) * std::sqrt(std::max(0., 1. - x * x / (a * a)));
    }

    std::string
    file() const
    {
      Json scene;
      scene["Bodies"]["upper"]               = {{"Young modulus", E_upper}, {"Poisson ratio", nu}};
      scene["Bodies"]["lower"]               = {{"Young modulus", E_lower}, {"Poisson ratio", nu}};
      scene["Joints"]["joint"]               = {{"Line", "joint"},
                                                {"Plus body", "upper"},
                                                {"Minus body", "lower"},
                                                {"Normal law", "rigid"},
                                                {"Initial gap", "x^2/200"}};
      scene["Boundaries"]["left"]["Fixed"]   = "x";
      scene["Boundaries"]["right"]["Fixed"]  = "free";
      scene["Boundaries"]["bottom"]["Fixed"] = "all";
      scene["Loads"]["press"]                = {
                       {"Type", "pressure"}, {"Boundaries", "top"}, {"Value", pressure(0.) * M_PI * a / 4. / 32.}};
      scene["Stages"]["press"]["Loads"] = "press: t";
      return write_scene(two_blocks_mesh(uniform(0., 32., 4), uniform(0., 32., 4)), scene);
    }
  };

  std::vector<std::string>
  pressure_within(const double error, const std::string &where = "")
  {
    std::vector<std::string> overrides = {std::string(target) + "Quantity=contact pressure",
                                          target + ("Relative error=" + std::to_string(error))};
    if (!where.empty())
      overrides.push_back(target + ("Where=" + where));
    return overrides;
  }

  /** Root of the mean square over the area up to x = @p end, relative. */
  double
  pressure_error(const SceneRun &run, const std::function<double(double)> &exact, const double end)
  {
    const Vector x = run.values("x", 1.), p = run.values("pressure", 1.),
                 A = run.values("area", 1.);
    double square = 0., size = 0.;
    for (std::size_t k = 0; k < x.size(); ++k)
      if (x[k] <= end)
        {
          square += A[k] * std::pow(p[k] - exact(x[k]), 2);
          size += A[k] * std::pow(exact(x[k]), 2);
        }
    return std::sqrt(square / size);
  }

  std::size_t
  n_unknowns(const SceneRun &run)
  {
    return run.summary.at("sizes").at("degrees_of_freedom").get<std::size_t>();
  }

  double
  estimate(const SceneRun &run)
  {
    return run.summary.at("accuracy").at("estimated_error").get<double>();
  }

  void
  expect_effective(const SceneRun &run, const double true_error)
  {
    EXPECT_GT(estimate(run), 0.5 * true_error);
    EXPECT_LT(estimate(run), 3. * true_error);
  }
} // namespace


TEST(Adaptive, Punch)
{
  const std::string file = punch_file();
  for (const double wanted : {0.05, 0.01})
    {
      const SceneRun run = run_scene(file, pressure_within(wanted, "x <= 0.9"));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      EXPECT_TRUE(run.summary.at("accuracy").at("reached").get<bool>());
      EXPECT_LE(estimate(run), wanted);
      const double error = pressure_error(run, punch_pressure, 0.9);
      expect_effective(run, error);
      EXPECT_LE(error, 2. * wanted);
      if (wanted != 0.01)
        continue;
      EXPECT_LE(error, 0.01);
      const SceneRun uniform_run = run_scene(file, {"Mesh/Refinements=4"});
      EXPECT_GT(n_unknowns(uniform_run), 10 * n_unknowns(run));
      EXPECT_GT(pressure_error(uniform_run, punch_pressure, 0.9), 0.01);
    }
}


// Both bodies deform; lips that were not refined alike would be an input error.
TEST(Adaptive, LineContact)
{
  const Hertz hertz;
  const SceneRun run = run_scene(hertz.file(), pressure_within(0.01));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_LE(estimate(run), 0.01);
  const auto exact   = [&](const double x) { return hertz.pressure(x); };
  const double error = pressure_error(run, exact, 32.);
  expect_effective(run, error);
  EXPECT_LE(error, 0.01);
  const SceneRun uniform_run = run_scene(hertz.file(), {"Mesh/Refinements=5"});
  EXPECT_GT(n_unknowns(uniform_run), 10 * n_unknowns(run));
  EXPECT_GT(pressure_error(uniform_run, exact, 32.), 0.01);
}


// V9: u_x at the left end of the base is 28.594, 28.604, 28.602 µm on 32, 64, 128 squares per side,
// by an independent code (reference/README.md), for a joint with a share of 1e-5 in the
// flexibility: known to 1e-4, about. The tolerance adds the target. A force at a lip, with elements
// that stick, slip and open around it.
TEST(Adaptive, RaousBlock)
{
  Json scene                             = raous_block();
  scene["Boundaries"]["corner"]["Fixed"] = "all";
  scene["Monitors"]["edge"]["Point"]     = "0, 0";
  scene["Target accuracy"]               = {
                  {"Quantity", "monitor"}, {"Components", "x"}, {"Relative error", 2e-4}};
  const SceneRun run =
    run_scene(write_scene(block_mesh(uniform(0., 40., 4), uniform(0., 40., 4), 40.), scene));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_TRUE(run.summary.at("accuracy").at("reached").get<bool>());
  EXPECT_GT(run.count("open", 1.), 0u);
  EXPECT_GT(run.count("slip", 1.), 0u);
  EXPECT_GT(run.count("stick", 1.), 0u);
  EXPECT_NEAR(run.monitors.number(run.monitors.rows.size() - 1, "ux"), 28.603e-3, 28.6e-3 * 3e-4);
  EXPECT_LT(n_unknowns(run), 33282u / 10u); // of 128 x 128
}


// The mesh of the file is good enough: it is used as it is, and the results are those without a
// target.
TEST(Adaptive, FirstMeshMeetsTheTarget)
{
  const std::string file = punch_file();
  const SceneRun run     = run_scene(file, pressure_within(0.5, "x <= 0.9"));
  EXPECT_EQ(run.summary.at("accuracy").at("rounds").size(), 1u);
  EXPECT_TRUE(run.summary.at("accuracy").at("reached").get<bool>());
  const SceneRun plain = run_scene(file);
  EXPECT_EQ(run.values("pressure", 1.), plain.values("pressure", 1.));
  EXPECT_FALSE(plain.summary.contains("accuracy"));
}


// Both limits end the search; the results are those of the last mesh, and the exit code that of its
// run.
TEST(Adaptive, LimitsAreSaid)
{
  const std::string file             = punch_file();
  std::vector<std::string> overrides = pressure_within(0.001, "x <= 0.9");
  overrides.emplace_back("Target accuracy/Largest number of rounds=3");
  const SceneRun rounds = run_scene(file, overrides);
  EXPECT_EQ(rounds.exit_code, 0);
  EXPECT_FALSE(rounds.summary.at("accuracy").at("reached").get<bool>());
  EXPECT_EQ(rounds.summary.at("accuracy").at("end"), "largest number of rounds");
  EXPECT_EQ(rounds.summary.at("accuracy").at("rounds").size(), 3u);
  EXPECT_EQ(rounds.summary.at("accuracy").at("rounds")[2].at("degrees_of_freedom"),
            n_unknowns(rounds));

  overrides.back()        = "Target accuracy/Largest number of unknowns=2000";
  const SceneRun unknowns = run_scene(file, overrides);
  EXPECT_EQ(unknowns.exit_code, 0);
  EXPECT_EQ(unknowns.summary.at("accuracy").at("end"), "largest number of unknowns");
  EXPECT_LE(4 * n_unknowns(unknowns), 2000u);
  EXPECT_GT(n_unknowns(unknowns), 150u);

  overrides.back()    = "Target accuracy/Largest number of unknowns=100";
  const SceneRun none = run_scene(file, overrides);
  EXPECT_EQ(none.exit_code, 0);
  EXPECT_TRUE(none.summary.at("accuracy").at("estimated_error").is_null());
  EXPECT_FALSE(none.summary.at("accuracy").at("reached").get<bool>());
}


// The checkpoint would not know the mesh.
TEST(Adaptive, CannotBeRestarted)
{
  const ProgramRun run = run_program({parameter_path("punch_adaptive.prm"), "--restart"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("punch_adaptive.prm:"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("cannot be restarted"), std::string::npos) << run.err;
}


// Blocks that rock: most cells of a dual field are only moved rigidly, and hold no energy but
// rounding. The marks remain few, and at a limit load the last states are compared; it is an
// answer, exit code 3.
TEST(Adaptive, RockingBlocks)
{
  std::vector<std::string> overrides = pressure_within(0.01);
  overrides.emplace_back("Target accuracy/Largest number of rounds=5");
  const SceneRun run = run_scene("pier.prm", overrides);
  const auto &rounds = run.summary.at("accuracy").at("rounds");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  for (std::size_t i = 1; i < rounds.size(); ++i)
    EXPECT_LT(rounds[i].at("cells").get<int>(), 2 * rounds[i - 1].at("cells").get<int>());
  EXPECT_LT(estimate(run), 0.25 * rounds[0].at("estimated_error").get<double>());

  overrides.back() = "Target accuracy/Largest number of rounds=2";
  overrides.emplace_back("Stages/wind/Loads=wind: 3*t");
  const SceneRun limit = run_scene("pier.prm", overrides);
  EXPECT_EQ(limit.exit_code, 3);
  EXPECT_EQ(limit.summary.at("verdict"), "limit load");
  EXPECT_EQ(limit.summary.at("accuracy").at("rounds").size(), 2u);
  EXPECT_FALSE(limit.summary.at("accuracy").at("estimated_error").is_null());
}


// Triangles are refined as a whole.
TEST(Adaptive, Triangles)
{
  std::vector<std::string> overrides = pressure_within(1e-6);
  overrides.push_back("Mesh/File=" + std::string(FUGA_SOURCE_DIR) + "/meshes/s0_tri.msh");
  overrides.emplace_back("Target accuracy/Largest number of rounds=2");
  const SceneRun run = run_scene("paper_2_linear.prm", overrides);
  const auto &rounds = run.summary.at("accuracy").at("rounds");
  EXPECT_EQ(run.exit_code, 0);
  ASSERT_EQ(rounds.size(), 2u);
  EXPECT_EQ(rounds[1].at("cells").get<int>(), 4 * rounds[0].at("cells").get<int>());
  EXPECT_LT(rounds[1].at("estimated_error").get<double>(),
            rounds[0].at("estimated_error").get<double>());
}
