// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Friction in two directions of slip, from parameter file to results.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/rough_blocks.h"
#include "scenes/scene_run.h"

#include <fuga/base/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

using namespace fuga;
using namespace fuga::tests;
using Json = nlohmann::ordered_json;

// Two elements deep between planes that hold both ends across: plane strain. The bars in the middle
// have two tangents, and carry half of the force, those at the ends one and a quarter. 1e-9 of the
// largest value.
TEST(ConeScenes, ExtrudedSceneEqualsThePlaneOne)
{
  const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 8), uniform(0., 1., 4));
  Json scene           = rough_blocks();
  add_load(scene, "press", "pressure", "top", "1 + 0.3*x");
  add_load(scene, "push", "traction", "top", "1; 0.4*(1 - x)");
  scene["Stages"]["press"]["Loads"] = "press: t";
  scene["Stages"]["push"]           = {{"Loads", "push: t"}, {"Levels", 3}};
  const SceneRun flat               = run_scene(write_scene(plane, scene));

  scene["Loads"]["push"]["Value"] = "1; 0.4*(1 - x); 0";
  const SceneRun deep =
    run_scene(write_scene(extruded(plane, {0., 0.5, 1.}), in_space(scene, "z")));
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
        const double least = column == std::string("T2") ? 0.1 : 1e-9; // of the forces
        EXPECT_LE(difference_from_plane(deep, 3, flat, column, t, least), 1e-9)
          << column << " t = " << t;
      }
}

// A block is pressed and then pushed obliquely by a traction on its top. The pressure moves along
// the push, so that friction f N in its direction has no moment about the resultant: it slides as a
// whole at |H| = f P, whatever the elastic bodies do before; 5e-8 is the share of a stage below the
// limit at which a path that approaches it exponentially ends.
TEST(ConeScenes, BlockSlidesInTheDirectionOfThePush)
{
  const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 4), uniform(0., 0.5, 2));
  Json scene           = in_space(rough_blocks(), "free");
  add_load(scene, "press", "pressure", "top", "1");
  add_load(scene, "push", "traction", "top", "0.8; 0; 0.4");
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

namespace
{
  /** The block of BlockSlidesInTheDirectionOfThePush under half of the push it can bear. */
  std::string
  pushed_block()
  {
    const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 4), uniform(0., 0.5, 2));
    Json scene           = in_space(rough_blocks(), "free");
    add_load(scene, "press", "pressure", "top", "1");
    add_load(scene, "push", "traction", "top", "0.2; 0; -0.15");
    scene["Stages"]["press"]["Loads"] = "press: t";
    scene["Stages"]["push"]           = {{"Loads", "push: t"}, {"Levels", 2}};
    return write_scene(extruded(plane, uniform(0., 1.5, 3)), scene);
  }
} // namespace

// Factor of safety of a load: by equilibrium the block slides at |push| = f p, as above; from
// |push| = p/4 on that is the factor 2. Its last state has the forces of that load.
TEST(ConeScenes, LoadFactorOfSafety)
{
  const SceneRun run = run_scene(pushed_block(), {"Safety/Load factor=push"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.summary.at("t"), 2.);
  EXPECT_LE(run.certificate(), 1e-8);
  const auto &found = run.summary.at("safety").at("load_factor");
  EXPECT_EQ(found.at("verdict"), "limit load");
  EXPECT_EQ(found.at("mechanism"), "sliding");
  expect_answer({"Block pushed obliquely", "load factor of safety", 2., "equilibrium"},
                found.at("factor").get<double>(),
                2e-6);
  EXPECT_NEAR(run.resultant("T", 2.), 0.2 * 3., 1e-9);
  EXPECT_NEAR(run.resultant("T2", 2.), 0.15 * 3., 1e-9); // t2 = n x t1 = -z
  EXPECT_NEAR(run.resultant("T", run.last_t()), 0.4 * 3., 2e-6);
  EXPECT_NEAR(run.resultant("T2", run.last_t()), 0.3 * 3., 2e-6);
}

// A sweep over the friction: what is below |push|/p = 1/4 slides at the load f p of its stage, what
// is above bears the whole push.
TEST(ConeScenes, SweepOverFriction)
{
  const std::string folder = temporary_directory();
  const ProgramRun run     = run_program({pushed_block(),
                                          "--output-dir",
                                          folder,
                                          "--set",
                                          "Sweep/Friction coefficient=0.1 : 0.1 : 0.4"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const CsvTable table = parse_csv(file_text(folder + "/sweep.csv"));
  ASSERT_EQ(table.rows.size(), 4u);
  for (std::size_t row = 0; row < 4; ++row)
    {
      const double f = 0.1 * static_cast<double>(row + 1);
      EXPECT_NEAR(table.number(row, "Friction coefficient"), f, 1e-15);
      EXPECT_EQ(table.text(row, "verdict"), f < 0.25 ? "limit load" : "done");
      EXPECT_NEAR(table.number(row, "t"), 1. + std::min(1., f / 0.25), 1e-6);
    }
}

// Pressed, tilted and pushed to and fro: elements open, close, slip and stick again. Two elements
// deep between planes that hold both ends across, as above; 1e-9 of the largest value.
TEST(ConeScenes, ExtrudedCycleEqualsThePlaneOne)
{
  const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 8), uniform(0., 1., 4));
  Json scene           = rough_blocks();
  add_load(scene, "press", "pressure", "top", "1");
  add_load(scene, "push", "traction", "top", "0.4; 0");
  scene["Stages"]["press"]["Loads"] = "press: t";
  scene["Stages"]["push"]           = {{"Loads", "push: t"}, {"Levels", 2}};
  scene["Stages"]["back"]           = {{"Loads", "push: 1 - 2*t"}, {"Levels", 4}};
  scene["Stages"]["again"]          = {{"Loads", "push: 2*t - 1"}, {"Levels", 4}};
  const SceneRun flat               = run_scene(write_scene(plane, scene));

  scene["Loads"]["push"]["Value"] = "0.4; 0; 0";
  const SceneRun deep =
    run_scene(write_scene(extruded(plane, {0., 0.5, 1.}), in_space(scene, "z")));
  EXPECT_EQ(flat.exit_code, 0);
  EXPECT_EQ(deep.exit_code, 0);
  EXPECT_LE(deep.certificate(), 1e-8);
  // The scene is worth comparing.
  for (const auto &[from, to] :
       {std::pair("stick", "slip"), {"slip", "stick"}, {"slip", "open"}, {"open", "stick"}})
    {
      std::size_t n = 0;
      for (std::size_t row = 0; row < flat.events.rows.size(); ++row)
        n += flat.events.text(row, "from") == from && flat.events.text(row, "to") == to ? 1 : 0;
      EXPECT_GT(n, 0u) << from << " to " << to;
    }
  const Vector flat_times = flat.event_times(0.), times = deep.event_times(0.);
  ASSERT_EQ(times.size(), 3 * flat_times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], flat_times[i / 3], 1e-9);
  double worst = 0.;
  for (const char *column : {"N", "T1", "pressure", "slip1", "gap", "jump_n", "jump_t1"})
    for (const double t : {1.5, 2., 2.25, 2.5, 2.75, 3., 3.25, 3.5, 3.75, 4.})
      worst = std::max(worst, difference_from_plane(deep, 3, flat, column, t, 1e-9));
  expect_answer({"Extruded scene against the plane one",
                 fmt::format("cycle of {} events, largest difference", flat_times.size()),
                 0.,
                 "the plane run"},
                worst,
                1e-9);
}
