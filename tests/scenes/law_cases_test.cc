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

// Law (9) as a tangent, by name and as expressions, which cancel near w = 0: the same pressures, to
// the 1e-12 by which step control lets energies differ times some 100, and in seconds.
TEST(LawCases, NoisyExpression)
{
  const std::string root             = "(w/0.003)^(1/3)";
  const std::vector<std::string> all = {
    "Mesh/File=../meshes/scene_g_9.msh", "Joints/base/Normal stiffness=", "Output/Fields=never"};
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
