// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Bars that hit an obstacle: waves between contact and flight, by whole runs of the program.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fuga::tests
{
  namespace
  {
    /** A bar of the length 10 (c = 30) that falls 5 under g = 10 onto a rigid obstacle. */
    nlohmann::ordered_json
    falling_bar(const double duration, const double step, const int levels)
    {
      nlohmann::ordered_json scene;
      scene["Bodies"]["block"] = {
        {"Young modulus", 900.}, {"Poisson ratio", 0.}, {"Weight density", 10.}};
      scene["Joints"]["ground"]            = {{"Plus lip", "contact"},
                                              {"Minus lip", "rigid"},
                                              {"Normal law", "rigid"},
                                              {"Initial gap", 5.}};
      scene["Boundaries"]["left"]["Fixed"] = scene["Boundaries"]["right"]["Fixed"] = "x";
      for (const char *side : {"top", "corner"})
        scene["Boundaries"][side]["Fixed"] = "free";
      scene["Loads"]["weight"] = {{"Type", "weight"}};
      scene["Stages"]["fall"]  = {
         {"Loads", "weight: 1"}, {"Duration", duration}, {"Levels", levels}};
      scene["Dynamics"] = {{"Time step", step}, {"Gravity", 10.}, {"Event tolerance", 1e-6}};
      return scene;
    }
  } // namespace

  // D. Doyen, A. Ern, S. Piperno, Time-integration schemes for the finite element dynamic Signorini
  // problem, SIAM J. Sci. Comput. 33, 2011: contact from t = 1 to 5/3 with the force
  // (E/c)(v0 + g τ), then free flight; energy constant.
  TEST(Impact, BouncingBar)
  {
    const SceneRun run = run_scene(write_scene(
      block_mesh(uniform(0., 0.1, 1), uniform(0., 10., 200), 0.1), falling_bar(2., 0.001, 40)));
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    const char *source = "closed form (Doyen, Ern and Piperno 2011)";
    for (const int i : {22, 24, 26, 28, 30, 32})
      {
        const double t = 0.05 * i;
        double force   = 0.;
        for (const double N : run.values("N", t / 2.))
          force -= N;
        expect_answer({"D5 bouncing bar",
                       "force / area at t = " + std::to_string(t),
                       300. + 300. * (t - 1.),
                       source},
                      force / 0.1,
                      0.01 * 500.);
      }
    const auto &motion   = run.summary.at("motion");
    const double largest = motion.at("largest_energy");
    EXPECT_LT(std::abs(motion.at("numerical").get<double>()), 1e-6 * largest);
    EXPECT_LT(std::abs(motion.at("not_accounted_for").get<double>()), 1e-10 * largest);
  }

  // Lips have no mass. Their weight F, that of half a cell, begins to act all at once: they sink by
  // F/k on a cell of the stiffness k = E A/h, and half of the work is lost, F²/(2 k). Meanwhile the
  // bar falls by g t²/2, a millionth of that.
  TEST(Impact, WeightThatBeginsToActLosesEnergyAtTheLips)
  {
    constexpr double A = 0.1, h = 0.5, E = 900., F = 10. * A * h / 2., step = 1e-5;
    const SceneRun run = run_scene(write_scene(
      block_mesh(uniform(0., A, 1), uniform(0., 10., 20), A), falling_bar(4. * step, step, 1)));
    ASSERT_EQ(run.exit_code, 0);
    const nlohmann::json &motion = run.summary.at("motion");
    const double lost            = F * F / (2. * E * A / h);
    EXPECT_NEAR(motion.at("sudden").get<double>(), lost, 1e-5 * lost);
    EXPECT_LT(std::abs(motion.at("numerical").get<double>()), 1e-9 * lost);
    EXPECT_LT(std::abs(motion.at("not_accounted_for").get<double>()), 1e-9 * lost);
  }

  // A hundred bounces shall not change the energy by more than 1e-10; a bounce costs a hundredth of
  // that.
  TEST(Impact, BounceKeepsTheEnergy)
  {
    const auto lost = [](const int n_bounces) {
      nlohmann::ordered_json scene         = falling_bar(n_bounces * 16. / 3., 0.01, 4 * n_bounces);
      scene["Dynamics"]["Halvings"]        = 20;
      scene["Dynamics"]["Event tolerance"] = 1e-14;
      const SceneRun run =
        run_scene(write_scene(block_mesh(uniform(0., 0.1, 1), uniform(0., 10., 20), 0.1), scene));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      const nlohmann::json &motion = run.summary.at("motion");
      return motion.at("numerical").get<double>() + motion.at("not_accounted_for").get<double>();
    };
    const double energy = 0.5 * 1. * 10. * 0.1 * 10. * 10.; // m v0²/2
    EXPECT_NEAR(lost(2), lost(1), 1e-12 * energy);
  }

  // A bar of a material that is all but incompressible falls freely: K u, with entries of
  // E/(1 - 2ν), must not make forces of the digits of a way that is thousands of times what the
  // bar deforms. It falls as a point does, but for the lips: without mass, and with a fortieth
  // of the weight, they miss half of the first of a hundred steps, 1/8000 of the velocity.
  TEST(Impact, FlightDoesNotCostTheDigitsOfForces)
  {
    constexpr double v = 0.003, g = 0.1, duration = 2.;
    nlohmann::ordered_json scene = falling_bar(duration, duration / 100., 1);
    nlohmann::ordered_json &bar = scene["Bodies"]["block"], &ground = scene["Joints"]["ground"];
    bar["Poisson ratio"]                 = 0.499;
    bar["Initial velocity"]              = "0; " + std::to_string(v);
    ground["Normal law"]                 = "linear";
    ground["Normal compliance"]          = 1e-3;
    scene["Boundaries"]["left"]["Fixed"] = scene["Boundaries"]["right"]["Fixed"] = "free";
    scene["Stages"]["fall"]["Loads"] = "weight: " + std::to_string(g / 10.);
    const SceneRun run =
      run_scene(write_scene(block_mesh(uniform(0., 0.1, 2), uniform(0., 10., 20), 0.1), scene));
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 3e-10);
    const double known = 0.5 * std::pow(v - g * duration, 2); // of a mass of one
    EXPECT_NEAR(run.summary.at("motion").at("kinetic_energy").get<double>(), known, 3e-4 * known);
  }

  // A square of one cell, of which three corners are lips of rigid joints: were these without mass,
  // it would turn about the fourth without inertia. A force (F, F) on its right side for the time T
  // takes it off both joints. With a quarter of the mass m in each corner its moment of inertia is
  // m a²/2, that of the force F a/2: F² T²/m + F² T²/(4 m). Vibrations: F a/E of the square.
  TEST(Impact, BodyOfOneCellTurnsWithInertia)
  {
    constexpr double a = 2., F = 0.3, T = 0.5, m = a * a;
    nlohmann::ordered_json scene = falling_bar(T, T / 100., 1);
    scene["Bodies"]["block"]     = {
          {"Young modulus", 1e6}, {"Poisson ratio", 0.}, {"Weight density", 10.}};
    scene["Joints"]["wall"]             = scene["Joints"]["ground"];
    scene["Joints"]["wall"]["Plus lip"] = "left";
    scene["Boundaries"].erase("right");
    scene["Boundaries"].erase("left");
    scene["Loads"]["weight"] = {{"Type", "traction"},
                                {"Boundaries", "right"},
                                {"Value", std::to_string(F / a) + "; " + std::to_string(F / a)}};
    const SceneRun run =
      run_scene(write_scene(block_mesh(uniform(0., a, 1), uniform(0., a, 1), a), scene));
    ASSERT_EQ(run.exit_code, 0);
    const nlohmann::json &motion = run.summary.at("motion");
    const double known           = 1.25 * F * F * T * T / m;
    EXPECT_NEAR(motion.at("kinetic_energy").get<double>(), known, 1e-3 * known);
    EXPECT_LT(std::abs(motion.at("not_accounted_for").get<double>()), 1e-10 * known);
  }

  /** Which touch, or fly through this gap before. */
  class TwoBars : public testing::TestWithParam<double>
  {
  };

  // A bar hits an equal one, whose other end is held (Code_Aster, test SDNL111: impact de deux
  // poutres): the waves of contact come back from both ends at 2 L/c, and at 4 L/c the bar leaves
  // with the velocity with which it came. Fronts are as wide as some cells.
  TEST_P(TwoBars, Collide)
  {
    const double gap        = GetParam();
    constexpr double length = 1., side = 0.02, modulus = 2e11, density = 7800., duration = 1e-3;
    const double c = std::sqrt(modulus / density);
    nlohmann::ordered_json scene;
    for (const char *body : {"lower", "upper"})
      scene["Bodies"][body] = {
        {"Young modulus", modulus}, {"Poisson ratio", 0.}, {"Weight density", 10. * density}};
    scene["Bodies"]["upper"]["Initial velocity"] = "0; -1";
    scene["Joints"]["contact"]                   = {{"Line", "joint"},
                                                    {"Plus body", "upper"},
                                                    {"Minus body", "lower"},
                                                    {"Normal law", "rigid"},
                                                    {"Initial gap", gap}};
    scene["Boundaries"]["left"]["Fixed"] = scene["Boundaries"]["right"]["Fixed"] = "x";
    scene["Boundaries"]["bottom"]["Fixed"]                                       = "all";
    scene["Boundaries"]["top"]["Fixed"]                                          = "free";
    scene["Mesh"]["Thickness"]                                                   = side;
    scene["Loads"]["none"]    = {{"Type", "weight"}};
    scene["Stages"]["impact"] = {{"Loads", "none: 0"}, {"Duration", duration}, {"Levels", 10}};
    scene["Dynamics"]         = {{"Time step", 1e-6}, {"Gravity", 10.}, {"Event tolerance", 1e-5}};
    scene["Monitors"]["end"]  = {{"Point", "0, 0"}, {"Body", "upper"}};
    const SceneRun run        = run_scene(
      write_scene(two_blocks_mesh(uniform(0., side, 1), uniform(0., length, 200)), scene));
    ASSERT_EQ(run.exit_code, 0) << run.summary.at("certificate").dump(1);
    EXPECT_LE(run.certificate(), 1e-9);
    const double way = length / c; // of the end, at half of the velocity, in 2 L/c
    for (std::size_t row = 0; row < run.monitors.rows.size(); ++row)
      {
        if (run.monitors.text(row, "occasion") != "level")
          continue;
        const double t = run.monitors.number(row, "t") * duration - gap; // since contact
        const double u = -gap + (t < 2. * way   ? -0.5 * t
                                 : t < 4. * way ? -way + 0.5 * (t - 2. * way)
                                                : t - 4. * way);
        expect_answer({"D10 two bars",
                       fmt::format("displacement of the end {:.3g} ms after contact, gap {:g} [m]",
                                   1e3 * t,
                                   gap),
                       u,
                       "closed form (Code_Aster SDNL111)"},
                      run.monitors.number(row, "uy"),
                      0.02 * way);
      }
    const auto &motion   = run.summary.at("motion");
    const double largest = motion.at("largest_energy");
    EXPECT_LT(std::abs(motion.at("numerical").get<double>()), 1e-5 * largest);
    EXPECT_LT(std::abs(motion.at("not_accounted_for").get<double>()), 1e-10 * largest);
  }

  INSTANTIATE_TEST_SUITE_P(Impact, TwoBars, testing::Values(0., 3e-7));
} // namespace fuga::tests
