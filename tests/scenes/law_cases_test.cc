// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Small scenes that laws together have ended wrongly: peak friction that is lost at the apex of its
// cone, gaps of rounding, soft feet of a power law, the noise of an expression.

#include "judges/judges.h"
#include "scenes/grid_mesh.h"
#include "scenes/scene_model.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json = nlohmann::ordered_json;

  Json
  rigid_joint(const double friction)
  {
    return {{"Plus lip", "contact"},
            {"Minus lip", "rigid"},
            {"Normal law", "rigid"},
            {"Shear law", "rigid"},
            {"Friction coefficient", friction}};
  }

  void
  press(Json &scene, const std::string &load, const std::string &boundary, const double value)
  {
    scene["Loads"][load] = {{"Type", "pressure"}, {"Boundaries", boundary}, {"Value", value}};
  }
} // namespace

// A block on a rough rigid base, pressed from above by 1 and from the left by 0.5, both growing
// from nothing: what slides, slides from the apex with what is left of its friction, 0.3, and what
// sticks has 0.5. Given which elements ever slid, that is a problem with one coefficient for each,
// which the independent Newton solves in one step from nothing; its residual is below 1e-11. No
// stuck element is beyond its own cone there, and the sums are those of the loads, -2 and 0.5.
TEST(LawCases, FrictionLostAtTheApex)
{
  Json scene;
  scene["Bodies"]["block"] = {{"Young modulus", 100.}, {"Poisson ratio", 0.3}};
  scene["Joints"]["j"]     = rigid_joint(0.5);
  scene["Joints"]["j"]["Residual friction coefficient"] = 0.3;
  for (const char *side : {"right", "corner"})
    scene["Boundaries"][side]["Fixed"] = "free";
  press(scene, "p", "top", 1.);
  press(scene, "q", "left", 0.5);
  scene["Stages"]["s"] = {{"Loads", "p: t; q: t"}, {"Levels", 2}};
  const std::string file =
    write_scene(block_mesh(uniform(0., 2., 8), uniform(0., 1., 4), 2.), scene);
  const SceneRun run = run_scene(file);
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_NEAR(run.resultant("N", 1.), -2., 1e-12);
  EXPECT_NEAR(run.resultant("T", 1.), 0.5, 1e-12);

  const SceneModel model(file);
  judges::JudgeProblem problem = model.judge_problem();
  std::size_t n_slid           = 0;
  for (std::size_t r = 0; r < run.events.rows.size(); ++r)
    if (run.events.text(r, "to") == "slip")
      {
        double &f =
          problem.elements[static_cast<std::size_t>(run.events.number(r, "element"))].friction;
        n_slid += f == 0.3 ? 0 : 1;
        f = 0.3;
      }
  EXPECT_GE(n_slid, 1u);
  EXPECT_LT(n_slid, problem.elements.size());
  const auto step =
    judges::semismooth_newton_step(problem, judges::no_slip(problem), model.judge_load(1.));
  ASSERT_TRUE(step.converged);
  EXPECT_LE(deviation(model.bars(run, 1., true), step.solution.forces), 1e-9);
  EXPECT_LE(deviation(model.bars(run, 1., false), step.solution.jumps), 1e-9);
}

// A cylinder of radius 100 on a rough rigid plane, whose mesh lies 1e-13 beside the axis: the gap
// x²/200 of its first node, 5e-29, is none. The answer is that of the mesh on the axis, but for the
// perturbation of the data, 1e-13 of a length of 1, times some 10.
TEST(LawCases, GapOfRounding)
{
  std::vector<Vector> pressures;
  for (const double beside : {0., 1e-13})
    {
      Json scene;
      scene["Bodies"]["block"]             = {{"Young modulus", 1000.}, {"Poisson ratio", 0.3}};
      scene["Joints"]["j"]                 = rigid_joint(0.5);
      scene["Joints"]["j"]["Initial gap"]  = "x^2/(2*100.0)";
      scene["Boundaries"]["left"]["Fixed"] = "x";
      for (const char *side : {"right", "corner"})
        scene["Boundaries"][side]["Fixed"] = "free";
      press(scene, "p", "top", 1.);
      scene["Stages"]["s"] = {{"Loads", "p: t"}, {"Levels", 2}};
      Axis xs              = uniform(0., 1., 10);
      xs[0]                = beside;
      const SceneRun run   = run_scene(write_scene(block_mesh(xs, uniform(0., 1., 10), 1.), scene));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      EXPECT_NEAR(run.resultant("N", 1.), -1., 1e-12);
      pressures.push_back(run.values("pressure", 1.));
    }
  EXPECT_LE(deviation(pressures[1], pressures[0]), 1e-11);
}

// Scene G on a power law of exponent 2, whose foot is 4000 times as soft as the layer under the
// weight: gaps are judged by the jumps, not by what the foot would deform. The base carries the
// weight 24·20·40 and the water 9.81·40²/2.
TEST(LawCases, SoftFootOfAPowerLaw)
{
  const SceneRun run = run_scene("scene_g_f06.prm",
                                 {"Joints/base/Normal stiffness=",
                                  "Joints/base/Normal law=power",
                                  "Joints/base/Normal reference closure=0.001",
                                  "Joints/base/Normal reference stress=1000",
                                  "Joints/base/Normal exponent=2"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  const double t = run.last_t();
  EXPECT_NEAR(run.resultant("N", t), -19200., 19200. * 1e-9);
  EXPECT_NEAR(run.resultant("T", t), 7848., 7848. * 1e-9);
}

// Law (9) as a tangent, by name and as expressions, which cancel near w = 0: the same pressures, to
// the 1e-12 by which step control lets energies differ times some 100, and in seconds.
TEST(LawCases, NoisyExpression)
{
  const std::string root             = "((w/0.003)^(1/3))";
  const std::vector<std::string> all = {"Mesh/File=../meshes/scene_g_9.msh",
                                        "Joints/base/Normal stiffness="};
  std::vector<std::string> named = all, expressions = all;
  for (const char *entry :
       {"Normal law=cubic root tangent", "Normal compliance=1e-6", "Thickness=0.003"})
    named.push_back(std::string("Joints/base/") + entry);
  for (const std::string &entry : {std::string("Normal law=expression"),
                                   "Normal stress expression=3*0.003/1e-06*(-" + root + "^2/2 - " +
                                     root + " - ln(1 - " + root + "))",
                                   "Normal tangent expression=1/(1e-06*(1 - " + root + "))",
                                   std::string("Normal closure limit=0.003")})
    expressions.push_back("Joints/base/" + entry);
  const SceneRun one = run_scene("scene_g_f06.prm", named),
                 two = run_scene("scene_g_f06.prm", expressions);
  for (const SceneRun *run : {&one, &two})
    {
      EXPECT_EQ(run->exit_code, 0);
      EXPECT_LE(run->certificate(), 1e-9);
    }
  EXPECT_EQ(one.events.rows.size(), two.events.rows.size());
  EXPECT_LE(deviation(two.values("N", one.last_t()), one.values("N", one.last_t())), 1e-10);
}
