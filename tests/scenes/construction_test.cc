// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Bodies that are built and removed in stages, joints that are grouted: against columns by hand.

#include "scenes/blocks_mesh.h"
#include "scenes/construction_data.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Displacement (or another column) of a monitor at the end of stage t. */
  double
  displacement(const SceneRun &run,
               const std::string &name,
               const double t,
               const std::string &column = "uy")
  {
    for (std::size_t r = 0; r < run.monitors.rows.size(); ++r)
      if (run.monitors.text(r, "monitor") == name && run.monitors.number(r, "t") == t)
        return run.monitors.number(r, column);
    throw std::out_of_range("no such monitor at this time");
  }

  /** Values of a column for one joint at load time t. */
  Vector
  of_joint(const SceneRun &run, const std::string &joint, const std::string &name, const double t)
  {
    Vector result;
    for (std::size_t r = 0; r < run.history.rows.size(); ++r)
      if (run.history.text(r, "joint") == joint && run.history.number(r, "t") == t)
        result.push_back(run.history.number(r, name));
    return result;
  }

  double
  sum(const Vector &values)
  {
    double result = 0.;
    for (const double value : values)
      result += value;
    return result;
  }

  /** The same, one element and 1 m deep between free faces; y remains vertical. */
  SceneRun
  run_in(const unsigned int dimension, const GmshMesh &mesh, Json scene)
  {
    if (dimension == 2)
      return run_scene(write_scene(mesh, scene));
    scene["Dimension"] = 3;
    for (const char *face : {"front", "back"})
      scene["Boundaries"][face] = {{"Fixed", "free"}};
    for (auto &load : scene["Loads"])
      load["Value"] =
        load.contains("Value") ? load["Value"].get<std::string>() + "; 0" : "0; -1; 0";
    return run_scene(write_scene(extruded(mesh, {0., 1.}), scene));
  }

  class ConstructionIn : public testing::TestWithParam<unsigned int>
  {
  };

  INSTANTIATE_TEST_SUITE_P(Dimensions, ConstructionIn, testing::Values(2u, 3u));
} // namespace

// n layers of height h, each bonded to the one below, ν = 0. Behind its own stage the top of layer
// k at z = k h settles by γ h z/E with every further layer: γ z (H - z)/E, the profile of
// embankments that are built in layers; in its own stage by γ h (z - h)/E + γ h²/2E. Bilinear
// elements are exact at nodes here; 1e-9 of the largest.
TEST(Construction, ColumnInLayers)
{
  constexpr unsigned int n = 4;
  constexpr double h       = 1.;
  Json p                   = common();
  std::vector<std::vector<std::string>> bodies;
  Axis ys = {0.};
  for (unsigned int k = 1; k <= n; ++k)
    {
      const std::string name = fmt::format("layer{}", k), stage = fmt::format("stage{}", k);
      bodies.push_back({name});
      ys.push_back(k * h);
      p["Bodies"][name]                       = body(k > 1 ? stage.c_str() : nullptr);
      p["Stages"][stage]                      = {{"Loads", k == 1 ? "weight: t" : "weight: 1"}};
      p["Monitors"][fmt::format("z{}", k)]    = {{"Point", fmt::format("0.5, {}", k)}};
      p["Monitors"][fmt::format("cell{}", k)] = {{"Point", fmt::format("0.25, {}", k - 0.25)},
                                                 {"Stress", "true"}};
    }
  const SceneRun run = run_scene(write_scene(blocks_mesh({0., 1.}, ys, 2, bodies, {}), p));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  for (unsigned int last = 1; last <= n; ++last)
    for (unsigned int k = 1; k <= n; ++k)
      {
        const double z          = k * h;
        const double settlement = k > last ? 0.
                                           : weight * z * (last * h - z) / E +
                                               weight * h * (z - h) / E + weight * h * h / 2. / E;
        EXPECT_NEAR(displacement(run, fmt::format("z{}", k), last), -settlement, 1e-9 * 0.008)
          << "layer " << k << " after stage " << last;
        // In the middle of a cell: the weight of what is there above.
        const double stress = k > last ? 0. : -weight * (last * h - (z - 0.25));
        EXPECT_NEAR(
          displacement(run, fmt::format("cell{}", k), last, "stress_yy"), stress, 1e-9 * weight * n)
          << "layer " << k << " after stage " << last;
      }
}

// A block on a soft joint, and another one upon it in the next stage: the upper joint does not feel
// how far the lower block had settled. Column by hand, ν = 0; 1e-9.
TEST(Construction, BlockUponBlock)
{
  Json p                = common();
  p["Bodies"]["rock"]   = {{"Young modulus", E}, {"Poisson ratio", 0.}};
  p["Bodies"]["lower"]  = body();
  p["Bodies"]["upper"]  = body("second");
  p["Joints"]["base"]   = joint("base", "lower", "rock");
  p["Joints"]["bed"]    = joint("bed", "upper", "lower");
  p["Monitors"]["top"]  = {{"Point", "0.5, 3"}};
  p["Monitors"]["bed"]  = {{"Point", "0.5, 2"}, {"Body", "lower"}};
  p["Stages"]["first"]  = {{"Loads", "weight: t"}, {"Levels", 2}};
  p["Stages"]["second"] = {{"Loads", "weight: 1"}, {"Levels", 2}};
  const SceneRun run =
    run_scene(write_scene(blocks_mesh({0., 1.},
                                      {0., 1., 2., 3.},
                                      2,
                                      {{"rock"}, {"lower"}, {"upper"}},
                                      {{"base", true, 1, 0, 1}, {"bed", true, 2, 0, 1}}),
                          p));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  EXPECT_TRUE(of_joint(run, "bed", "pressure", 1.).empty());
  for (const double s : {0.5, 1.})
    {
      for (const double value : of_joint(run, "base", "pressure", 1. + s))
        EXPECT_NEAR(value, weight * (1. + s), 1e-9 * weight);
      for (const double value : of_joint(run, "bed", "pressure", 1. + s))
        EXPECT_NEAR(value, weight * s, 1e-9 * weight);
      for (const double value : of_joint(run, "bed", "jump_n", 1. + s))
        EXPECT_NEAR(value, -rho * weight * s, 1e-9 * rho * weight);
    }
  // First stage: rock 1/E, joint ρ, half of the block; second: rock, joint, lower block, bed, half
  // of the upper block.
  const double first = weight * (1. / E + rho + 0.5 / E), more = weight * (2. / E + rho);
  EXPECT_NEAR(displacement(run, "bed", 1.), -first, 1e-9 * first);
  EXPECT_NEAR(displacement(run, "bed", 2.), -first - more, 1e-9 * first);
  EXPECT_EQ(displacement(run, "top", 1.), 0.);
  EXPECT_NEAR(displacement(run, "top", 2.), -(more + weight * (rho + 0.5 / E)), 1e-9 * first);
}

// A block of weight W on a joint with f = 0.5, pushed by 0.75 W, and another block of weight W that
// is built on top of it: before the push it holds it (0.5 · 2 W), after it comes too late; the
// limit is f W = 0.5 W, two thirds of the push. By equilibrium; 1e-9.
TEST_P(ConstructionIn, OrderMattersWithFriction)
{
  for (const bool built_first : {true, false})
    {
      Json p               = common();
      p["Bodies"]["rock"]  = {{"Young modulus", E}, {"Poisson ratio", 0.2}};
      p["Bodies"]["lower"] = body(nullptr, 0.2);
      p["Bodies"]["upper"] = body("build", 0.2);
      p["Joints"]["base"]  = joint("base", "lower", "rock");
      p["Loads"]["push"]   = {{"Type", "weight"}, {"Bodies", "lower"}, {"Value", "0.75; 0"}};
      p["Stages"]["first"] = {{"Loads", "weight: t"}};
      for (const char *stage : {built_first ? "build" : "push", built_first ? "push" : "build"})
        p["Stages"][stage] = {{"Loads", std::string(stage) == "push" ? "push: t" : "weight: 1"}};
      const SceneRun run = run_in(GetParam(),
                                  blocks_mesh({0., 4.},
                                              {0., 1., 2., 3.},
                                              4,
                                              {{"rock"}, {"lower"}, {"upper"}},
                                              {{"base", true, 1, 0, 1}}),
                                  p);
      EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
      const double W = weight * 4.;
      if (built_first)
        {
          EXPECT_EQ(run.exit_code, 0);
          EXPECT_NEAR(std::abs(sum(of_joint(run, "base", "T1", 3.))), 0.75 * W, 1e-9 * W);
          EXPECT_NEAR(sum(of_joint(run, "base", "N", 3.)), -2. * W, 1e-9 * W);
        }
      else
        {
          EXPECT_EQ(run.exit_code, 3);
          EXPECT_EQ(run.summary.at("verdict"), "limit load");
          // In space the directions of slip turn into those of the mechanism as the load
          // approaches its limit, and the path ends less than 1e-6 of it before.
          EXPECT_NEAR(
            run.summary.at("t").get<double>(), 1. + 2. / 3., GetParam() == 2 ? 1e-9 : 1e-6);
        }
    }
}

// What is removed leaves nothing behind in an elastic column.
TEST(Construction, Removal)
{
  Json p                                   = common();
  p["Bodies"]["lower"]                     = body();
  p["Bodies"]["upper"]                     = body("load");
  p["Bodies"]["upper"]["Removed at stage"] = "unload";
  p["Bodies"]["rock"]                      = {{"Young modulus", E}, {"Poisson ratio", 0.}};
  p["Joints"]["base"]                      = joint("base", "lower", "rock");
  p["Joints"]["bed"]                       = joint("bed", "upper", "lower");
  p["Monitors"]["bed"]                     = {{"Point", "0.5, 2"}, {"Body", "lower"}};
  for (const char *stage : {"first", "load", "unload"})
    p["Stages"][stage] = {{"Loads", std::string(stage) == "first" ? "weight: t" : "weight: 1"},
                          {"Levels", 2}};
  const SceneRun run =
    run_scene(write_scene(blocks_mesh({0., 1.},
                                      {0., 1., 2., 3.},
                                      2,
                                      {{"rock"}, {"lower"}, {"upper"}},
                                      {{"base", true, 1, 0, 1}, {"bed", true, 2, 0, 1}}),
                          p));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  const double first = weight * (1. / E + rho + 0.5 / E), more = weight * (2. / E + rho);
  EXPECT_NEAR(displacement(run, "bed", 2.), -first - more, 1e-9 * first);
  EXPECT_NEAR(displacement(run, "bed", 2.5), -first - more / 2., 1e-9 * first);
  EXPECT_NEAR(displacement(run, "bed", 3.), -first, 1e-9 * first);
  for (const double value : of_joint(run, "base", "pressure", 3.))
    EXPECT_NEAR(value, weight, 1e-9 * weight);
  EXPECT_TRUE(of_joint(run, "bed", "pressure", 3.).empty());
}

// A bar of length 2 whose joint is pulled open by 0.02, grouted, and closed again by 0.005: in
// compression from the beginning, p = 0.005 s/(2/E + ρ); 1e-9. (Without grouting it stays open.)
TEST_P(ConstructionIn, Grouting)
{
  Json p;
  p["Bodies"]["lower"] = p["Bodies"]["upper"] = body();
  p["Joints"]["cut"]                          = joint("cut", "upper", "lower");
  p["Boundaries"]["bottom"] = p["Boundaries"]["top"] = {{"Fixed", "all"}};
  p["Boundaries"]["left"] = p["Boundaries"]["right"] = {{"Fixed", "free"}};
  p["Loads"]["pull"]  = {{"Type", "displacement"}, {"Boundaries", "top"}, {"Value", "; 0.02"}};
  p["Output"]         = {{"Log", "quiet"}};
  p["Stages"]["pull"] = {{"Loads", "pull: t"}};
  p["Stages"]["back"] = {{"Loads", "pull: 1-0.25*t"}, {"Levels", 10}};
  for (const bool grouted : {false, true})
    {
      if (grouted)
        p["Stages"]["back"]["Grouted joints"] = "cut";
      const SceneRun run = run_in(
        GetParam(),
        blocks_mesh({0., 1.}, {0., 1., 2.}, 2, {{"lower"}, {"upper"}}, {{"cut", true, 1, 0, 1}}),
        p);
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
      for (const double value : of_joint(run, "cut", "gap", 1.))
        EXPECT_NEAR(value, 0.02, 1e-11);
      for (const double s : {0.1, 0.5, 1.})
        {
          const double pressure = grouted ? 0.005 * s / (2. / E + rho) : 0.;
          for (const double value : of_joint(run, "cut", "pressure", 1. + s))
            EXPECT_NEAR(value, pressure, 1e-9);
          for (const double value : of_joint(run, "cut", "gap", 1. + s))
            EXPECT_NEAR(value, grouted ? 0. : 0.02 - 0.005 * s, 1e-11);
        }
    }
}
