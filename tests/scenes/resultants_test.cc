// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// resultants.csv and monitors.csv of the program beside statics by hand.

#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr int n    = 8; // elements of the base -1/2 ≤ x ≤ 1/2
  constexpr double b = 1., h = 2., k = 50., f = 0.6, c = 0.02, p = 1.;
  constexpr double tau = 0.05; // shear traction at the top

  /** A block on a layer of the stiffness k above a rigid plane: pressed by p, then pushed at the
   * top by `push: τ`, then pressed eccentrically by `turn: e`, the resultant's distance from the
   * middle.
   */
  nlohmann::ordered_json
  block(const double E)
  {
    nlohmann::ordered_json scene;
    scene["Bodies"]["block"] = {{"Young modulus", E}, {"Poisson ratio", 0.}};
    scene["Joints"]["base"]  = {{"Plus lip", "contact"},
                                {"Minus lip", "rigid"},
                                {"Normal stiffness", k},
                                {"Shear stiffness", k},
                                {"Friction coefficient", f},
                                {"Cohesion", c}};
    for (const char *side : {"left", "right", "corner"})
      scene["Boundaries"][side]["Fixed"] = "free";
    const std::string top    = "top";
    scene["Loads"]["press"]  = {{"Type", "pressure"}, {"Boundaries", top}, {"Value", p}};
    scene["Loads"]["push"]   = {{"Type", "traction"}, {"Boundaries", top}, {"Value", "1; 0"}};
    scene["Loads"]["turn"]   = {{"Type", "pressure"}, {"Boundaries", top}, {"Value", "12*x"}};
    scene["Stages"]["press"] = {{"Loads", "press: t"}};
    scene["Stages"]["push"]  = {{"Loads", "push: 0.05*t"}};
    scene["Stages"]["back"]  = {{"Loads", "push: 0.05*(1 - t)"}};
    scene["Stages"]["turn"]  = {{"Loads", "turn: 0.2*t"}};
    return scene;
  }

  SceneRun
  run(nlohmann::ordered_json scene, const std::vector<std::string> &overrides = {})
  {
    const SceneRun result = run_scene(
      write_scene(block_mesh(uniform(-b / 2., b / 2., n), uniform(0., h, 2 * n), b / 2.), scene),
      overrides);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_LE(result.certificate(), 1e-9);
    return result;
  }
} // namespace

// A block of E = 1e10 k b is rigid to 1e-9. N = -p b, T = τ b, M = τ b h (the push bends to the
// right), e = M/|N|; pressures p ± M b/(2 I), I of the eight elements b³/12 (1 + 2/n²). After that
// the resultant moves to e = 0.2 b: between 0.171875 and 0.214285714 (problem V3) one element, of
// b/16, is open at the left. Strength against sliding: f p b + c b (c only on what is closed).
TEST(Resultants, OfABlock)
{
  const SceneRun r = run(block(1e9 * k));
  const double M = tau * b * h, e = M / (p * b);
  const double change  = M * b / 2. / (b * b * b / 12. * (1. + 2. / (n * n)));
  constexpr double eps = 1e-8;
  const auto expect    = [&](const std::string &name, const double t, const double value) {
    EXPECT_NEAR(r.resultant(name, t), value, eps) << name << " at " << t;
  };
  expect("N", 2., -p * b);
  expect("T", 2., tau * b);
  expect("M", 2., M);
  expect("eccentricity", 2., e);
  expect("position_x", 2., e);
  expect("position_y", 2., 0.);
  expect("in_middle_third", 2., 1.);
  expect("largest_pressure", 2., p + change);
  expect("smallest_pressure", 2., p - change);
  expect("share_compression", 2., 1.);
  expect("cracked_length", 2., 0.);
  expect("sliding_safety", 2., (f * p * b + c * b) / (tau * b));
  expect("overturning_safety", 2., b / 2. / e);

  expect("eccentricity", 4., 0.2);
  expect("in_middle_third", 4., 0.);
  expect("overturning_safety", 4., 2.5);
  expect("share_compression", 4., 15. / 16.);
  expect("cracked_length", 4., b / 16.);
  expect("crack_from_first", 4., b / 16.);
  expect("crack_from_last", 4., 0.);
  expect("smallest_pressure", 4., 0.);
  expect("joint_dissipation", 4., 0.);
}

// A bar of ν = 0 under the pressure p: linear elements are exact, u_y = -p/k - p y/E. Then the
// eccentric load of a stiff block on the layer: a rotation M/(k I) about the middle of the base.
// Monitors at a node, in a cell, and on the line of the joint.
TEST(Monitors, OfABlock)
{
  constexpr double E = 100., eps = 1e-12;
  nlohmann::ordered_json scene = block(E);
  scene["Monitors"]["top"]     = {{"Point", "0.5, 2"}};
  scene["Monitors"]["inside"]  = {{"Point", "-0.21, 0.83"}};
  scene["Monitors"]["base"]    = {{"Point", "0.25, 0"}, {"Body", "block"}};
  const CsvTable table         = run(scene).monitors;
  ASSERT_EQ(table.rows.size(), 3u * 4u); // levels: one for each of the four stages
  const double y[] = {2., 0.83, 0.};
  for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_EQ(table.number(i, "t"), 1.);
      EXPECT_EQ(table.text(i, "occasion"), "level");
      EXPECT_EQ(table.number(i, "y"), y[i]);
      EXPECT_NEAR(table.number(i, "ux"), 0., eps);
      EXPECT_NEAR(table.number(i, "uy"), -p / k - p * y[i] / E, eps) << table.text(i, "monitor");
    }

  scene["Bodies"]["block"]["Young modulus"] = 1e9 * k;
  scene["Stages"]["turn"]["Loads"]          = "turn: 0.1*t"; // closed all along
  const CsvTable stiff                      = run(scene, {"Output/Monitors=events"}).monitors;
  const double angle = -0.1 * p * b / (k * b * b * b / 12. * (1. + 2. / (n * n)));
  const double x[]   = {0.5, -0.21, 0.25};
  for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t row = stiff.rows.size() - 3 + i;
      EXPECT_EQ(stiff.number(row, "t"), 4.);
      EXPECT_NEAR(stiff.number(row, "ux"), -angle * y[i], 1e-9);
      EXPECT_NEAR(stiff.number(row, "uy"), -p / k + angle * x[i], 1e-9);
    }
}

// Uniform stress, exact in linear elements: a block without friction, free at its sides, under the
// pressure p and warmed by ΔT: σyy = -p; the strain across the plane is held, so σzz = -νp - EαΔT.
// A cylinder under p and the pressure q on its side: σxx = hoop stress = -q. Inside, at a face and
// at a corner. Relative to E/k = 2, where displacements of that order are differentiated: 1e-11.
TEST(Monitors, Stress)
{
  constexpr double E = 100., nu = 0.2, alpha = 1e-4, warming = 20., q = 0.3, eps = 1e-11;
  nlohmann::ordered_json scene = block(E);
  scene["Joints"]["base"]      = {
         {"Plus lip", "contact"}, {"Minus lip", "rigid"}, {"Normal stiffness", k}};
  scene["Bodies"]["block"] = {
    {"Young modulus", E}, {"Poisson ratio", nu}, {"Thermal expansion", alpha}};
  scene["Boundaries"]["left"]["Fixed"] = "x";
  scene["Loads"]    = {{"press", {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", p}}},
                       {"heat", {{"Type", "temperature"}, {"Value", warming}}}};
  scene["Stages"]   = {{"press", {{"Loads", "press: t"}}}, {"heat", {{"Loads", "heat: t"}}}};
  scene["Monitors"] = {{"inside", {{"Point", "0.21, 0.83"}, {"Stress", "true"}}},
                       {"face", {{"Point", "0.1, 2"}, {"Stress", "true"}}},
                       {"corner", {{"Point", "0.5, 0"}, {"Body", "block"}, {"Stress", "true"}}},
                       {"without", {{"Point", "0.5, 2"}}}};
  const auto expect =
    [&](const CsvTable &table, const std::size_t row, const double xx, const double zz) {
      EXPECT_NEAR(table.number(row, "stress_xx"), xx, eps) << row;
      EXPECT_NEAR(table.number(row, "stress_yy"), -p, eps) << row;
      EXPECT_NEAR(table.number(row, "stress_zz"), zz, eps) << row;
      EXPECT_NEAR(table.number(row, "stress_xy"), 0., eps) << row;
    };
  const CsvTable table = run(scene).monitors;
  ASSERT_EQ(table.rows.size(), 2u * 4u);
  for (std::size_t i = 0; i < 3; ++i)
    {
      expect(table, i, 0., -nu * p);
      expect(table, 4 + i, 0., -nu * p - E * alpha * warming);
    }
  EXPECT_TRUE(std::isnan(table.number(3, "stress_yy")));

  scene["Mesh"]["Assumption"]          = "axisymmetric";
  scene["Boundaries"]["left"]["Fixed"] = "free";
  scene["Boundaries"].erase("right");
  scene["Loads"]["press"]["Boundaries"] = "top";
  scene["Loads"]["heat"] = {{"Type", "pressure"}, {"Boundaries", "right"}, {"Value", q}};
  scene["Monitors"]["corner"]["Point"]  = "0, 0";
  scene["Monitors"]["without"]["Point"] = "1, 2";
  const SceneRun cylinder =
    run_scene(write_scene(block_mesh(uniform(0., 1., n), uniform(0., h, 2 * n), 1.), scene));
  EXPECT_EQ(cylinder.exit_code, 0);
  for (std::size_t i = 0; i < 3; ++i)
    expect(cylinder.monitors, 4 + i, -q, -q);
  EXPECT_NEAR(cylinder.resultant("N", 2.), -p * M_PI, eps); // over the circle of radius 1
}

// Displacements at every event cost no solution of the bodies: four for each monitor (two
// components, refined once) before the path begins and nothing later. Without monitors, no file.
TEST(Monitors, CostNothingIfNotAskedFor)
{
  nlohmann::ordered_json scene = block(100.);
  const auto solutions         = [](const SceneRun &r) {
    return r.summary.at("work").at("solutions_of_bodies").get<int>();
  };
  const SceneRun without = run(scene);
  EXPECT_TRUE(without.monitors.header.empty());
  EXPECT_FALSE(without.summary.at("seconds").contains("monitors"));
  scene["Monitors"]["top"] = {{"Point", "0.5, 2"}};
  const SceneRun with      = run(scene, {"Output/Monitors=events"});
  EXPECT_EQ(solutions(with), solutions(without) + 4);
  EXPECT_EQ(with.summary.at("work").at("factorisations_of_bodies"), 1);
  std::size_t n_event_rows = 0;
  const CsvTable &table    = with.monitors;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    n_event_rows += table.text(row, "occasion") == "event";
  EXPECT_GT(n_event_rows, 0u);
  EXPECT_LE(n_event_rows, with.events.rows.size());
}
