// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "navier_with_crack.h"
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
  // A block 8 wide and 16 high on a rigid plane, its reservoir on the left. MN, m.
  constexpr double base = 8., height = 16., concrete = 0.024, water = 0.01;
  constexpr double weight = concrete * base * height;

  /** Weight in the first stage; in the second one the level rises to @p level. */
  nlohmann::ordered_json
  dam(const double E, const double level, const unsigned int levels)
  {
    const std::string table = "1: 0; 2: " + std::to_string(level);
    nlohmann::ordered_json scene;
    scene["Bodies"]["block"] = {
      {"Young modulus", E}, {"Poisson ratio", 0.2}, {"Weight density", concrete}};
    scene["Joints"]["base"]       = {{"Plus lip", "contact"},
                                     {"Minus lip", "rigid"},
                                     {"Normal stiffness", 1e3},
                                     {"Shear stiffness", 1e3},
                                     {"Friction coefficient", 3}};
    scene["Boundaries"]["right"]  = {{"Fixed", "free"}};
    scene["Boundaries"]["top"]    = {{"Fixed", "free"}};
    scene["Boundaries"]["corner"] = {{"Fixed", "free"}};
    scene["Loads"]["weight"]      = {{"Type", "weight"}};
    scene["Loads"]["water"]       = {
            {"Type", "hydrostatic"}, {"Boundaries", "left"}, {"Level", table}, {"Unit weight", water}};
    scene["Loads"]["uplift"]           = {{"Type", "uplift"},
                                          {"Joints", "base"},
                                          {"Level", table},
                                          {"Unit weight", water},
                                          {"Profile from", "joint"},
                                          {"Upstream end", "left"}};
    scene["Stages"]["weight"]["Loads"] = "weight: t";
    scene["Stages"]["water"]           = {{"Loads", "water: 1; uplift: 1"}, {"Levels", levels}};
    scene["Output"]["Fields"]          = "end";
    return scene;
  }

  SceneRun
  run_dam(const nlohmann::ordered_json &scene, const std::size_t n)
  {
    return run_scene(write_scene(
      block_mesh(uniform(-base / 2., base / 2., n), uniform(0., height, 8), base / 2.), scene));
  }

  /** Moment of the water on the left face about the base. */
  double
  moment_of_thrust(const double h)
  {
    return water * h * h * h / 6.;
  }
} // namespace

// A block so stiff (E = 1e10 times the stiffness of the joint times its base) that its own
// deformation does not count: Navier's formula, with a crack at the highest levels, under both
// rules of uplift. All levels are knots of the load.
TEST(UpliftScene, RigidDamAgainstNavierWithCrack)
{
  const std::size_t n  = 32;
  const double highest = 15.;
  std::array<std::size_t, 2> cracks{};
  for (const bool from_tip : {false, true})
    {
      SCOPED_TRACE(from_tip ? "from the crack tip" : "over the joint");
      nlohmann::ordered_json scene = dam(1e14, highest, 10);
      if (from_tip)
        scene["Loads"]["uplift"].erase("Profile from"); // the default
      const SceneRun run = run_dam(scene, n);
      ASSERT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
      NavierWithCrack navier(n, base);
      navier.from_tip = from_tip;
      for (unsigned int i = 1; i <= 10; ++i)
        {
          const double t = 1. + i / 10., h = highest * i / 10., M = moment_of_thrust(h);
          const std::size_t m    = navier.crack(weight, M, water * h);
          const auto expected    = navier.pressures(weight, M, water * h, m);
          const auto unit        = navier.water(m);
          const Vector pressures = run.values("pressure", t),
                       in_joint  = run.values("water_pressure", t);
          const double largest   = *std::max_element(expected.begin(), expected.end());
          double uplift          = 0.;
          for (std::size_t k = 0; k <= n; ++k)
            {
              EXPECT_NEAR(pressures[k], k < m ? 0. : expected[k], 1e-9 * largest) << h << " " << k;
              const double u = water * h * unit[k] / navier.area[k];
              EXPECT_NEAR(in_joint[k], u, 1e-12 * water * h) << h << " " << k;
              uplift += u * navier.area[k];
            }
          if (from_tip) // p L [s + (1 - s)/2] of the codes
            {
              const double s = m == 0 ? 0. : (static_cast<double>(m) - 0.5) / n;
              EXPECT_NEAR(uplift, water * h * base * (s + (1. - s) / 2.), 1e-12 * weight);
            }
          EXPECT_NEAR(run.resultant("water", t), uplift, 1e-12 * weight);
          EXPECT_NEAR(run.resultant("N", t), uplift - weight, 1e-10 * weight);
          EXPECT_NEAR(run.resultant("T", t), water * h * h / 2., 1e-10 * weight);
          cracks[from_tip] = std::max(cracks[from_tip], m);
        }
    }
  EXPECT_GT(cracks[0], 0u);
  EXPECT_GT(cracks[1], cracks[0]);
}

// The checks by hand of doc/examples/dam.md: equilibrium of the dam, with full pressure in the
// crack up to its tip (five sixths into the third face, where the tributary length of its middle
// node ends), and from there to the drain and the toe.
TEST(UpliftScene, ExampleDam)
{
  const SceneRun run = run_scene("dam.prm");
  ASSERT_EQ(run.exit_code, 0);
  ASSERT_EQ(run.count("open", 2.), 6u);
  const double W = 24. * 11. * 30., arm = 9. - (2880. * 2. + 5040. * (4. + 14. / 3.)) / W;
  EXPECT_NEAR(run.resultant("N", 1.), -W, 1e-10 * W);
  EXPECT_NEAR(run.resultant("M", 1.), -W * arm, 1e-10 * W * arm);
  const double h = 28., u = 9.81 * h, tip = 2. + 5. / 6., fall = 3. - tip;
  const double drain      = 0.5 * (1. - fall / (18. - tip)) * u;
  const double water      = u * tip + fall * (u + drain) / 2. + 15. * drain / 2.;
  const double about_heel = u * tip * tip / 2. + fall * tip * (u + drain) / 2. +
                            fall * fall * (u / 6. + drain / 3.) + 15. * drain / 2. * 8.;
  const double M = -W * arm + 9.81 * h * h * h / 6. + 9. * water - about_heel;
  EXPECT_NEAR(run.resultant("water", 2.), water, 1e-9 * W);
  EXPECT_NEAR(run.resultant("N", 2.), water - W, 1e-9 * W);
  EXPECT_NEAR(run.resultant("T", 2.), 9.81 * h * h / 2., 1e-9 * W);
  EXPECT_NEAR(run.resultant("M", 2.), M, 1e-9 * W * arm);
  EXPECT_NEAR(run.resultant("eccentricity", 2.), M / (W - water), 1e-8);
  EXPECT_NEAR(run.resultant("sliding_safety", 2.), 0.7 * (W - water) / (9.81 * h * h / 2.), 1e-8);
}

// Two metres more and it slides, with all of the base at its strength.
TEST(UpliftScene, ExampleDamSlides)
{
  const std::string level = "Level=1: 0; 2: 30";
  const SceneRun run      = run_scene("dam.prm", {"Loads/water/" + level, "Loads/uplift/" + level});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_EQ(run.summary.at("limit_load").at("mechanism"), "sliding");
  const double t = run.last_t();
  EXPECT_EQ(run.count("stick", t), 0u);
  EXPECT_NEAR(run.resultant("sliding_safety", t), 1., 1e-9);
  EXPECT_NEAR(run.resultant("T", t), -0.7 * run.resultant("N", t), 1e-9 * 4000.);
}

// Bodies so stiff that water which leaves the crack at the toe closes it, and the water of the
// closed crack opens it again, at one load: the path goes on. The seam carries what statics say
// (doc/examples/high_dam.md), whatever the stiffness.
TEST(UpliftScene, StiffDamWithDryToe)
{
  const SceneRun run = run_scene("high_dam.prm",
                                 {"Bodies/dam/Young modulus=1e9",
                                  "Bodies/block/Young modulus=1e9",
                                  "Bodies/rock/Young modulus=1e9"});
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  for (std::size_t i = 0; i < run.resultants.rows.size(); ++i)
    if (run.resultants.text(i, "joint") == "seam" && run.resultants.number(i, "t") == 3.)
      {
        EXPECT_NEAR(run.resultants.number(i, "N"), -18298.7152, 1e-4);
        EXPECT_NEAR(run.resultants.number(i, "T"), 10842.2696, 1e-4);
      }
}

// An elastic block: where it opens is not known in closed form, but that levels do not matter is.
TEST(UpliftScene, LevelsDoNotMatter)
{
  nlohmann::ordered_json one = dam(3000., 15., 1), many = dam(3000., 15., 97);
  for (auto *scene : {&one, &many})
    (*scene)["Joints"]["base"]["Friction coefficient"] = 0.7;
  const SceneRun a = run_dam(one, 24), b = run_dam(many, 24);
  ASSERT_EQ(a.exit_code, 0);
  ASSERT_EQ(b.exit_code, 0);
  EXPECT_LE(b.certificate(), 1e-9);
  EXPECT_GT(a.count("open", 2.), 2u);
  EXPECT_EQ(a.events.rows.size(), b.events.rows.size());
  EXPECT_EQ(a.states(2.), b.states(2.));
  for (const std::string quantity : {"N", "T1", "gap", "slip1", "jump_n", "water_pressure"})
    EXPECT_LE(deviation(a.values(quantity, 2.), b.values(quantity, 2.)), 1e-9) << quantity;
  EXPECT_NEAR(a.resultant("N", 2.), a.resultant("water", 2.) - weight, 1e-10 * weight);
}

// The reservoir rises, the base cracks, the reservoir is emptied: closed elements carry no more
// water than at first.
TEST(UpliftScene, EmptiedReservoir)
{
  nlohmann::ordered_json scene     = dam(3000., 15., 3);
  const std::string table          = "1: 0; 2: 15; 3: 0";
  scene["Loads"]["water"]["Level"] = scene["Loads"]["uplift"]["Level"] = table;
  scene["Stages"]["down"] = {{"Loads", "water: 1"}, {"Levels", 3}};
  const SceneRun run      = run_dam(scene, 24);
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_GT(run.count("open", 2.), 0u);
  EXPECT_EQ(run.count("open", 3.), 0u);
  EXPECT_NEAR(run.resultant("N", 3.), -weight, 1e-10 * weight);
  EXPECT_NEAR(run.resultant("water", 3.), 0., 1e-12 * weight);
}

// USACE's diagram with drain and tailwater, while nothing is open.
TEST(UpliftScene, DrainAndTailwater)
{
  nlohmann::ordered_json scene                 = dam(3000., 10., 1);
  scene["Loads"]["uplift"]["Tailwater level"]  = 2;
  scene["Loads"]["uplift"]["Drain distance"]   = 2;
  scene["Loads"]["uplift"]["Drain efficiency"] = 0.5;
  // The tailwater stands there from the beginning: its load must grow from zero.
  scene["Stages"]["water"]["Loads"] = "water: 1; uplift: t";
  const SceneRun run                = run_dam(scene, 24);
  ASSERT_EQ(run.exit_code, 0);
  ASSERT_EQ(run.count("open", 2.), 0u);
  const double up = water * 10., down = water * 2., inside = down + 0.5 * 0.75 * (up - down);
  const double uplift = 2. * (up + inside) / 2. + 6. * (inside + down) / 2.;
  EXPECT_NEAR(run.resultant("water", 2.), uplift, 1e-12 * weight);
  EXPECT_NEAR(run.resultant("N", 2.), uplift - weight, 1e-10 * weight);
}
