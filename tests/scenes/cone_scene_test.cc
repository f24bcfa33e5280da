// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Friction in two directions of slip, from parameter file to results.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <fuga/base/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json = nlohmann::ordered_json;

  /** A block on a body, rough in two directions. */
  Json
  rough_scene()
  {
    Json scene;
    scene["Bodies"]["upper"]               = {{"Young modulus", 1000.}, {"Poisson ratio", 0.2}};
    scene["Bodies"]["lower"]               = {{"Young modulus", 500.}, {"Poisson ratio", 0.3}};
    scene["Joints"]["joint"]               = {{"Line", "joint"},
                                              {"Plus body", "upper"},
                                              {"Minus body", "lower"},
                                              {"Normal compliance", 1e-4},
                                              {"Shear compliance", 2e-4},
                                              {"Friction coefficient", 0.5}};
    scene["Boundaries"]["bottom"]["Fixed"] = "all";
    for (const char *side : {"left", "right"})
      scene["Boundaries"][side]["Fixed"] = "free";
    return scene;
  }

  void
  add_top_load(Json &scene, const char *name, const char *type, const std::string &value)
  {
    scene["Loads"][name] = {{"Type", type}, {"Boundaries", "top"}, {"Value", value}};
  }

  Json
  in_space(Json scene, const char *front, const char *back)
  {
    scene["Dimension"]                    = 3;
    scene["Boundaries"]["front"]["Fixed"] = front;
    scene["Boundaries"]["back"]["Fixed"]  = back;
    return scene;
  }
} // namespace

// Two elements deep between planes that hold both ends across: plane strain. The bars in the middle
// have two tangents, and carry half of the force, those at the ends one and a quarter. 1e-9 of the
// largest value.
TEST(ConeScenes, ExtrudedSceneEqualsThePlaneOne)
{
  const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 8), uniform(0., 1., 4));
  Json scene           = rough_scene();
  add_top_load(scene, "press", "pressure", "1 + 0.3*x");
  add_top_load(scene, "push", "traction", "1; 0.4*(1 - x)");
  scene["Stages"]["press"]["Loads"] = "press: t";
  scene["Stages"]["push"]           = {{"Loads", "push: t"}, {"Levels", 3}};
  const SceneRun flat               = run_scene(write_scene(plane, scene));

  scene["Loads"]["push"]["Value"] = "1; 0.4*(1 - x); 0";
  const SceneRun deep =
    run_scene(write_scene(extruded(plane, {0., 0.5, 1.}), in_space(scene, "z", "z")));
  EXPECT_EQ(flat.exit_code, deep.exit_code);
  EXPECT_LE(deep.certificate(), 1e-8);
  ASSERT_GT(flat.events.rows.size(), 3u); // the scene is worth comparing
  ASSERT_EQ(deep.events.rows.size(), 3 * flat.events.rows.size());
  Vector flat_times = flat.event_times(0.), times = deep.event_times(0.);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], flat_times[i / 3], 1e-9);
  EXPECT_NEAR(deep.last_t(), flat.last_t(), 1e-9);
  for (const char *column : {"N", "T1", "pressure", "shear1", "slip1", "jump_n", "jump_t1", "T2"})
    for (const double t : {1., 4. / 3., flat.last_t()})
      {
        const bool is_force      = column[0] == 'N' || column[0] == 'T';
        const Vector flat_values = flat.values(column, t);
        const Vector values      = deep.values(column, t == flat.last_t() ? deep.last_t() : t);
        ASSERT_EQ(values.size(), 3 * flat_values.size());
        double largest = column == std::string("T2") ? 0.1 : 1e-9; // of the forces
        for (const double value : flat_values)
          largest = std::max(largest, std::abs(value));
        for (std::size_t k = 0; k < values.size(); ++k)
          EXPECT_NEAR(values[k],
                      (!is_force    ? 1.
                       : k % 3 == 1 ? 0.5
                                    : 0.25) *
                        flat_values[k / 3],
                      1e-9 * largest)
            << column << " " << k << " t = " << t;
      }
}

// A block is pressed and then pushed obliquely by a traction on its top. The pressure moves along
// the push, so that friction f N in its direction has no moment about the resultant: it slides as a
// whole at |H| = f P, whatever the elastic bodies do before; 5e-8 is the share of a stage below the
// limit at which a path that approaches it exponentially ends.
TEST(ConeScenes, BlockSlidesInTheDirectionOfThePush)
{
  const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 4), uniform(0., 0.5, 2));
  Json scene           = in_space(rough_scene(), "free", "free");
  add_top_load(scene, "press", "pressure", "1");
  add_top_load(scene, "push", "traction", "0.8; 0; 0.4");
  scene["Stages"]["press"]["Loads"] = "press: t";
  scene["Stages"]["push"]           = {{"Loads", "push: t"}, {"Levels", 10}};
  const SceneRun run = run_scene(write_scene(extruded(plane, uniform(0., 1.5, 3)), scene));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.summary.at("verdict"), "limit load");
  EXPECT_EQ(run.summary.at("limit_load").at("mechanism"), "sliding");
  EXPECT_LE(run.certificate(), 1e-8);
  expect_answer({"Block pushed obliquely", "push at sliding / f P", 1., "equilibrium"},
                (run.last_t() - 1.) * std::hypot(0.8, 0.4) / 0.5,
                1e-6);
  const double end = run.last_t();
  const double T = run.resultant("T", end), T2 = run.resultant("T2", end);
  EXPECT_NEAR(std::hypot(T, T2), 0.5 * -run.resultant("N", end), 2e-6);
}

// What friction in two directions cannot do is refused before anything is computed, by name.
TEST(ConeScenes, WhatIsNotAvailableIsRefused)
{
  const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 2), uniform(0., 1., 1));
  Json scene           = in_space(rough_scene(), "free", "free");
  add_top_load(scene, "press", "pressure", "1");
  scene["Stages"]["press"]["Loads"] = "press: t";
  const std::string file            = write_scene(extruded(plane, {0., 1.}), scene);
  using Overrides                   = std::vector<std::string>;
  for (const auto &[overrides, message] :
       {std::pair(Overrides{"Joints/joint/Cohesion=0.1"}, "cohesion"),
        {{"Solver/Beyond limit load=arc length"}, "beyond the limit load"},
        {{"Joints/joint/Normal law=hyperbolic", "Joints/joint/Normal closure limit=0.01"},
         "layers other than rigid and linear"}})
    {
      std::string complaint = "none";
      try
        {
          run_scene(file, overrides);
        }
      catch (const InputError &error)
        {
          complaint = error.what();
        }
      EXPECT_NE(complaint.find(message), std::string::npos) << complaint;
      EXPECT_NE(complaint.find("joint 'joint'"), std::string::npos) << complaint;
    }
}
