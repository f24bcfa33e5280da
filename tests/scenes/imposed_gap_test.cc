// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Sawing and jacking of joints: a gap that is imposed as a load.

#include "scenes/blocks_mesh.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;
using Json = nlohmann::ordered_json;

namespace
{
  constexpr double E = 1000., height = 2., rho = 1e-3, pressed = 0.02, kerf = 0.05;

  /** A bar of two blocks, 1 wide and 2 high, ν = 0, between supports; the joint in the middle. */
  Json
  bar(const double compliance)
  {
    Json p;
    for (const char *body : {"lower", "upper"})
      p["Bodies"][body] = {{"Young modulus", E}, {"Poisson ratio", 0.}};
    p["Joints"]["cut"]        = {{"Line", "cut"},
                                 {"Plus body", "upper"},
                                 {"Minus body", "lower"},
                                 {"Normal compliance", compliance},
                                 {"Shear compliance", compliance},
                                 {"Friction coefficient", 0.5}};
    p["Boundaries"]["bottom"] = {{"Fixed", "all"}};
    p["Boundaries"]["top"]    = {{"Fixed", "all"}};
    p["Boundaries"]["left"]   = {{"Fixed", "free"}};
    p["Boundaries"]["right"]  = {{"Fixed", "free"}};
    p["Output"]               = {{"Log", "quiet"}, {"Fields", "end"}};
    return p;
  }

  std::string
  bar_scene(const Json &parameters)
  {
    return write_scene(
      blocks_mesh({0., 1.}, {0., 1., 2.}, 4, {{"lower"}, {"upper"}}, {{"cut", true, 1, 0, 1}}),
      parameters);
  }

  /** Pressed by `pressed`, then sawn. */
  SceneRun
  sawn_bar(const double compliance, const std::string &value, const unsigned int levels)
  {
    Json p               = bar(compliance);
    p["Loads"]["press"]  = {{"Type", "displacement"}, {"Boundaries", "top"}, {"Value", "; -0.02"}};
    p["Loads"]["saw"]    = {{"Type", "imposed gap"}, {"Joints", "cut"}, {"Value", value}};
    p["Stages"]["press"] = {{"Loads", "press: t"}};
    p["Stages"]["saw"]   = {{"Loads", "saw: t"}, {"Levels", levels}};
    return run_scene(bar_scene(p));
  }
} // namespace

// Pressure (pressed - kerf t)/(height/E + ρ), open from kerf t = pressed on. Exact for bilinear
// elements; 1e-9 of the first pressure and of the kerf.
TEST(ImposedGap, SawnBar)
{
  for (const double compliance : {rho, 0.})
    {
      const SceneRun run = sawn_bar(compliance, "0.05", 10);
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
      const double stiffness = 1. / (height / E + compliance);
      for (const double fraction : {0.1, 0.3, 0.5, 1.})
        {
          const double closed = pressed - kerf * fraction;
          for (const double value : run.values("pressure", 1. + fraction))
            EXPECT_NEAR(value, std::max(closed, 0.) * stiffness, 1e-9 * pressed * stiffness);
          for (const double value : run.values("gap", 1. + fraction))
            EXPECT_NEAR(value, std::max(-closed, 0.), 1e-9 * kerf);
        }
      ASSERT_FALSE(run.event_times(1.).empty());
      for (const double t : run.event_times(1.))
        EXPECT_NEAR(t, 1. + pressed / kerf, 1e-9);
      // In the end nothing is stored; the ledger leaves out what the bonded bar would store, E
      // u²/2L.
      const double bonded = 0.5 * E / height * pressed * pressed;
      EXPECT_NEAR(run.resultant("external_work", 2.), bonded, 1e-9 * bonded);
      EXPECT_NEAR(run.resultant("energy_bodies", 2.), bonded, 1e-9 * bonded);
      EXPECT_NEAR(run.resultant("energy_layer", 2.), 0., 1e-9 * bonded);
    }
}

// A jack of 0.03 (an imposed gap of -0.03) in the bar between fixed supports.
TEST(ImposedGap, JackedBar)
{
  Json p              = bar(rho);
  p["Loads"]["jack"]  = {{"Type", "imposed gap"}, {"Joints", "cut"}, {"Value", "-0.03"}};
  p["Stages"]["jack"] = {{"Loads", "jack: t"}, {"Levels", 2}};
  const SceneRun run  = run_scene(bar_scene(p));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  for (const double t : {0.5, 1.})
    for (const double value : run.values("pressure", t))
      EXPECT_NEAR(value, 0.03 * t / (height / E + rho), 1e-9 * 0.03 / (height / E + rho));
  // ∫ -p dg, half of it in the joint's share ρ/(height/E + ρ) of the compliance.
  const double work = 0.5 * 0.03 * 0.03 / (height / E + rho);
  EXPECT_NEAR(run.resultant("external_work", 1.), work, 1e-9 * work);
  EXPECT_NEAR(run.resultant("energy_layer", 1.), work * rho / (height / E + rho), 1e-9 * work);
}

// A wedge-shaped cut opens the joint element by element, and the lips slide as the pressure moves:
// the path does not know the levels.
TEST(ImposedGap, LevelsDoNotMatter)
{
  const SceneRun one = sawn_bar(rho, "0.1*x^2", 1), many = sawn_bar(rho, "0.1*x^2", 97);
  EXPECT_LE(one.certificate(), 1e-9);
  EXPECT_LE(many.certificate(), 1e-9);
  EXPECT_GE(one.events.rows.size(), 3u);
  EXPECT_GT(one.count("open", 2.), 0u);
  for (const char *name : {"N", "T1", "gap", "slip1"})
    EXPECT_LE(deviation(one.values(name, 2.), many.values(name, 2.)), 1e-9) << name;
}

// Where joints cross, the jumps are not the coordinates of the bodies (B is not the identity): four
// blocks, pressed on all sides, of which the left and the lower pair are put apart by wedges. With
// the same wedges everywhere the pressures are those of one bar each.
TEST(ImposedGap, CrossingJoints)
{
  Json p;
  for (const char *body : {"a", "b", "c", "d"})
    p["Bodies"][body] = {{"Young modulus", E}, {"Poisson ratio", 0.}};
  const auto joint = [&](const char *name, const char *plus, const char *minus) {
    p["Joints"][name] = {{"Line", name},
                         {"Plus body", plus},
                         {"Minus body", minus},
                         {"Normal compliance", rho},
                         {"Shear compliance", rho},
                         {"Friction coefficient", 0.5}};
  };
  joint("ab", "b", "a");
  joint("cd", "d", "c");
  joint("ac", "c", "a");
  joint("bd", "d", "b");
  p["Boundaries"]["bottom"] = p["Boundaries"]["top"] = {{"Fixed", "y"}};
  p["Boundaries"]["left"] = p["Boundaries"]["right"] = {{"Fixed", "x"}};
  p["Loads"]["wedge"] = {{"Type", "imposed gap"}, {"Joints", "ab, cd, ac, bd"}, {"Value", "-0.01"}};
  p["Stages"]["wedge"] = {{"Loads", "wedge: t"}, {"Levels", 2}};
  p["Output"]          = {{"Log", "quiet"}, {"Fields", "levels"}};
  const SceneRun run   = run_scene(write_scene(blocks_mesh({0., 1., 2.},
                                                         {0., 1., 2.},
                                                         2,
                                                         {{"a", "b"}, {"c", "d"}},
                                                         {{"ab", false, 1, 0, 1},
                                                            {"cd", false, 1, 1, 2},
                                                            {"ac", true, 1, 0, 1},
                                                            {"bd", true, 1, 1, 2}}),
                                             p));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
  for (const double value : run.values("pressure", 1.))
    EXPECT_NEAR(value, 0.01 / (height / E + rho), 1e-9 * 0.01 / (height / E + rho));
}

TEST(ImposedGap, UnknownJoint)
{
  Json p               = bar(rho);
  p["Loads"]["saw"]    = {{"Type", "imposed gap"}, {"Joints", "cot"}, {"Value", "0.1"}};
  p["Stages"]["saw"]   = {{"Loads", "saw: t"}};
  const ProgramRun run = run_program({bar_scene(p)});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("there is no joint 'cot'"), std::string::npos) << run.err;
}
