// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  // A block 8 wide and 16 high on a rigid plane, so stiff that it does not deform. MN, m. All
  // expected pressures are integrals by hand of the straight lines that the rules of doc/uplift.md
  // draw.
  constexpr double base = 8., height = 16., concrete = 0.024, water = 0.01;
  constexpr double weight = concrete * base * height;
  constexpr std::size_t n = 16;
  constexpr double h      = base / n;

  /** Weight, then a reservoir of the level 6 on the left, then an earthquake with a coefficient. */
  nlohmann::ordered_json
  shaken_block(const double coefficient)
  {
    nlohmann::ordered_json scene;
    scene["Bodies"]["block"] = {
      {"Young modulus", 1e14}, {"Poisson ratio", 0.2}, {"Weight density", concrete}};
    scene["Joints"]["base"]       = {{"Plus lip", "contact"},
                                     {"Minus lip", "rigid"},
                                     {"Normal stiffness", 1e3},
                                     {"Shear stiffness", 1e3},
                                     {"Friction coefficient", 3}};
    scene["Boundaries"]["right"]  = {{"Fixed", "free"}};
    scene["Boundaries"]["top"]    = {{"Fixed", "free"}};
    scene["Boundaries"]["corner"] = {{"Fixed", "free"}};
    scene["Loads"]["weight"]      = {{"Type", "weight"}};
    scene["Loads"]["quake"]       = {{"Type", "seismic"}, {"Horizontal coefficient", coefficient}};
    scene["Loads"]["water"]       = {{"Type", "hydrostatic"},
                                     {"Boundaries", "left"},
                                     {"Level", "1: 0; 2: 6"},
                                     {"Unit weight", water}};
    scene["Loads"]["uplift"]      = {{"Type", "uplift"},
                                     {"Joints", "base"},
                                     {"Level", "1: 0; 2: 6"},
                                     {"Unit weight", water},
                                     {"Upstream end", "left"}};
    scene["Stages"]["weight"]["Loads"] = "weight: t";
    scene["Stages"]["water"]           = {{"Loads", "water: 1; uplift: 1"}};
    scene["Stages"]["quake"]           = {{"Loads", "quake: t"}};
    scene["Output"]["Fields"]          = "never";
    return scene;
  }

  SceneRun
  run_block(const nlohmann::ordered_json &scene)
  {
    return run_scene(write_scene(
      block_mesh(uniform(-base / 2., base / 2., n), uniform(0., height, 8), base / 2.), scene));
  }

  /** ∫ N u / area per element for a pressure that falls from 1 at the upstream end to 0 at the
   * distance @p length from it, with linear elements. */
  std::vector<double>
  falling_pressure(const double length)
  {
    std::vector<double> result(n + 1, 0.);
    const auto u = [&](const double s) { return std::max(1. - s / length, 0.); };
    // Simpson's rule is exact for u N on both sides of its corner.
    const auto add = [&](const std::size_t e, const double a, const double b) {
      for (const auto &[s, w] : {std::pair(a, 1.), std::pair((a + b) / 2., 4.), std::pair(b, 1.)})
        for (const std::size_t k : {e, e + 1})
          result[k] += (b - a) / 6. * w * u(s) * (1. - std::abs(s / h - static_cast<double>(k)));
    };
    for (std::size_t e = 0; e < n; ++e)
      {
        const double a = h * static_cast<double>(e), b = a + h;
        const double corner = std::clamp(length, a, b);
        add(e, a, corner);
        add(e, corner, b);
      }
    for (std::size_t k = 0; k <= n; ++k)
      result[k] /= k == 0 || k == n ? h / 2. : h;
    return result;
  }
} // namespace

// An earthquake towards upstream opens the dry toe, one element after the other. Behind the tip the
// joint is drained; the element at the tip keeps what it had when it opened: the pressure before
// the one behind it was drained. Nothing there carries the head of the reservoir.
TEST(UpliftConnection, DryToeStaysDry)
{
  const SceneRun run = run_block(shaken_block(-0.35));
  ASSERT_EQ(run.exit_code, 0) << run.summary.dump(1).substr(0, 2000);
  EXPECT_LE(run.certificate(), 1e-9);
  const double head     = water * 6.;
  const std::size_t m   = run.count("open", 3.);
  const Vector pressure = run.values("water_pressure", 3.);
  ASSERT_GE(m, 4u);
  const auto states = run.states(3.);
  for (std::size_t k = n + 1 - m; k <= n; ++k)
    EXPECT_EQ(states[k], "open");
  // The joint is drained behind the tip element, or from it on if the relief has closed the one
  // before it again: from half-way between two elements on, where the pressure has fallen to
  // nothing.
  const double tip_at = h * static_cast<double>(n + 1 - m);
  double best         = 1.;
  for (const double length : {tip_at - h / 2., tip_at + h / 2.})
    {
      const auto expected = falling_pressure(length);
      double worst        = 0.;
      for (std::size_t k = 0; k < n + 1 - m; ++k)
        worst = std::max(worst, std::abs(pressure[k] / head - expected[k]));
      best = std::min(best, worst);
    }
  EXPECT_LE(best, 1e-12);
  double sum = 0.;
  for (std::size_t k = 0; k <= n; ++k)
    {
      if (k > n + 2 - m)
        {
          EXPECT_LT(pressure[k], 1e-12 * head) << k;
        }
      sum += pressure[k] * (k == 0 || k == n ? h / 2. : h);
    }
  EXPECT_LT(pressure[n], 1e-12 * head);
  EXPECT_NEAR(run.resultant("N", 3.), sum - weight, 1e-10 * weight);
}

// The same, but the stage says that water stands still: opening changes no pressure. The next
// stage, without any load of its own, drains the toe.
TEST(UpliftConnection, WaterUnchangedInAStage)
{
  nlohmann::ordered_json scene                = shaken_block(-0.35);
  scene["Stages"]["quake"]["Water in joints"] = "unchanged";
  scene["Stages"]["afterwards"]               = {{"Loads", "quake: 1"}};
  const SceneRun run                          = run_block(scene);
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  const Vector filled = run.values("water_pressure", 2.), shaken = run.values("water_pressure", 3.),
               after = run.values("water_pressure", 4.);
  const auto whole   = falling_pressure(base);
  for (std::size_t k = 0; k <= n; ++k)
    {
      EXPECT_NEAR(filled[k], water * 6. * whole[k], 1e-12);
      EXPECT_NEAR(shaken[k], filled[k], 1e-14);
    }
  EXPECT_GE(run.count("open", 3.), 4u);
  EXPECT_LT(after[n], 1e-12);
  EXPECT_LT(after[n - 1], 1e-12);
}

// A pocket that never touches, two metres wide: isolated, so that the water of the closed joint
// goes on in it. The level rises, the crack from the heel reaches it, and all of it gets the
// pressure of the reservoir at once: a connection is an event.
TEST(UpliftConnection, PocketIsReached)
{
  nlohmann::ordered_json scene           = shaken_block(-0.1);
  scene["Joints"]["base"]["Initial gap"] = "(x > -2.3)*(x < -0.7)*0.01";
  for (const char *const load : {"water", "uplift"})
    scene["Loads"][load]["Level"] = "1: 0; 2: 14";
  scene["Stages"]["water"]["Levels"] = 14;
  scene["Stages"].erase("quake");
  scene["Loads"].erase("quake");
  const SceneRun run = run_block(scene);
  EXPECT_LE(run.certificate(), 1e-9);
  std::size_t row = 0;
  while (row < run.events.rows.size() && run.events.text(row, "from") != "isolated")
    ++row;
  ASSERT_LT(row, run.events.rows.size());
  EXPECT_EQ(run.events.text(row, "to"), "reservoir");
  const double t = run.events.number(row, "t");
  // The first and the last level before and after it: elements 4, 5, 6 are the pocket.
  const double before = 1. + std::floor((t - 1.) * 14.) / 14.;
  const Vector closed = run.values("water_pressure", before);
  const double level  = 14. * (before - 1.);
  std::size_t m       = 0;
  for (const auto states = run.states(before); states[m] == "open";)
    ++m;
  ASSERT_LT(m, 4u);
  const double tip = m == 0 ? 0. : h * (static_cast<double>(m) - 0.5);
  EXPECT_NEAR(closed[5], water * level * (base - 5. * h) / (base - tip), 1e-9 * water * level);
  std::size_t connected = 0;
  for (std::size_t i = 0; i < run.events.rows.size(); ++i)
    connected += run.events.text(i, "from") == "isolated" && run.events.number(i, "t") == t;
  EXPECT_EQ(connected, 3u);
}

// The base in two joints that meet: one way, so the same pressures, forces and events as one joint.
// (Where they meet there are two elements, whose events come at the same load.)
TEST(UpliftConnection, TwoJointsAreOneWay)
{
  const auto scene_of = [](const bool divided) {
    nlohmann::ordered_json scene = shaken_block(0.05);
    for (const char *const load : {"water", "uplift"})
      scene["Loads"][load]["Level"] = "1: 0; 2: 12";
    scene["Bodies"]["block"]["Young modulus"] = 3000.;
    if (!divided)
      return scene;
    scene["Joints"]["second"]             = scene["Joints"]["base"];
    scene["Joints"]["second"]["Plus lip"] = "contact right";
    scene["Loads"]["uplift"]["Joints"]    = "second, base"; // in any order
    return scene;
  };
  GmshMesh mesh = block_mesh(uniform(-base / 2., base / 2., n), uniform(0., height, 8), base / 2.);
  const SceneRun one = run_scene(write_scene(mesh, scene_of(false)));
  int contact        = 0;
  for (const auto &[key, name] : mesh.physical_names)
    if (name == "contact")
      contact = key.second;
  constexpr int other             = 77;
  mesh.physical_names[{1, other}] = "contact right";
  for (MeshEntity &face : mesh.faces)
    if (face.physical_tag == contact &&
        mesh.vertices[face.vertices[0]][0] + mesh.vertices[face.vertices[1]][0] > 0.)
      face.physical_tag = other;
  const SceneRun two = run_scene(write_scene(mesh, scene_of(true)));
  ASSERT_EQ(one.exit_code, 0);
  ASSERT_EQ(two.exit_code, 0) << two.summary.at("certificate").dump(1);
  EXPECT_LE(two.certificate(), 1e-9);
  ASSERT_GT(one.count("open", 3.), 2u);
  double a = 0., b = 0.;
  for (std::size_t i = 0; i < one.resultants.rows.size(); ++i)
    if (one.resultants.number(i, "t") == 3.)
      a += one.resultants.number(i, "water");
  for (std::size_t i = 0; i < two.resultants.rows.size(); ++i)
    if (two.resultants.number(i, "t") == 3.)
      b += two.resultants.number(i, "water");
  EXPECT_NEAR(a, b, 1e-12 * weight);
  const auto loads_of_events = [](const SceneRun &run) {
    Vector times = run.event_times(0.);
    times.erase(std::unique(times.begin(),
                            times.end(),
                            [](const double s, const double t) { return t - s < 1e-10; }),
                times.end());
    return times;
  };
  EXPECT_LE(deviation(loads_of_events(one), loads_of_events(two)), 1e-9);
}

// Mirrored, with the reservoir on the right, and extruded one element deep, with the reservoir at
// the front end: the same events.
TEST(UpliftConnection, MirrorAndSpace)
{
  nlohmann::ordered_json scene = shaken_block(0.05);
  for (const char *const load : {"water", "uplift"})
    scene["Loads"][load]["Level"] = "1: 0; 2: 12";
  const SceneRun run                                   = run_block(scene);
  nlohmann::ordered_json mirrored                      = scene;
  mirrored["Loads"]["water"]["Boundaries"]             = "right";
  mirrored["Loads"]["uplift"]["Upstream end"]          = "right";
  mirrored["Loads"]["quake"]["Horizontal coefficient"] = -0.05;
  mirrored["Boundaries"].erase("right");
  mirrored["Boundaries"]["left"] = {{"Fixed", "free"}};
  const SceneRun other           = run_block(mirrored);
  ASSERT_EQ(run.exit_code, 0);
  ASSERT_EQ(other.exit_code, 0);
  EXPECT_GT(run.count("open", 3.), 2u);
  EXPECT_EQ(run.count("open", 3.), other.count("open", 3.));
  EXPECT_LE(deviation(run.event_times(0.), other.event_times(0.)), 1e-10);
  EXPECT_NEAR(run.resultant("water", 3.), other.resultant("water", 3.), 1e-12 * weight);

  nlohmann::ordered_json deep = scene;
  deep["Dimension"]           = 3;
  deep["Boundaries"].erase("corner");
  deep["Boundaries"]["front"] = deep["Boundaries"]["back"] = {{"Fixed", "y"}};
  const GmshMesh plane =
    block_mesh(uniform(-base / 2., base / 2., n), uniform(0., height, 8), base / 2.);
  GmshMesh upright = extruded(plane, {0., 1.});
  for (auto &vertex : upright.vertices) // in space up is z
    vertex = {{vertex[0], -vertex[2], vertex[1]}};
  const SceneRun space = run_scene(write_scene(upright, deep));
  ASSERT_EQ(space.exit_code, 0);
  EXPECT_LE(space.certificate(), 1e-9);
  EXPECT_NEAR(space.resultant("water", 3.), run.resultant("water", 3.), 1e-10 * weight);
  EXPECT_NEAR(space.resultant("N", 3.), run.resultant("N", 3.), 1e-10 * weight);
  EXPECT_EQ(space.count("open", 3.), 2 * run.count("open", 3.));
}

// A tailwater whose level is a table: USACE's trapezoid at both times, while nothing is open.
TEST(UpliftConnection, TailwaterWithAHistory)
{
  nlohmann::ordered_json scene = shaken_block(0.);
  scene["Loads"].erase("quake");
  scene["Stages"]["quake"]                    = {{"Loads", "water: 1"}};
  scene["Loads"]["uplift"]["Tailwater level"] = "1: 0; 2: 1; 3: 3";
  const SceneRun run                          = run_block(scene);
  ASSERT_EQ(run.exit_code, 0);
  ASSERT_EQ(run.count("open", 3.), 0u);
  for (const auto &[t, tail] : {std::pair(2., 1.), std::pair(3., 3.)})
    EXPECT_NEAR(run.resultant("water", t), base * water * (6. + tail) / 2., 1e-12 * weight);
}
