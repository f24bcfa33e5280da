// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Paths through phases of construction: levels, restarts, mistakes in the input.

#include "scenes/blocks_mesh.h"
#include "scenes/construction_data.h"
#include "scenes/restarts.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** A wall that is built upon rock and pushed, and on which a second block is built, joints with
   * friction that open and slip, then grouting, more push, and removal. */
  std::string
  wall(const unsigned int levels)
  {
    Json p                                  = common();
    p["Bodies"]["rock"]                     = {{"Young modulus", E}, {"Poisson ratio", 0.2}};
    p["Bodies"]["wall"]                     = body("wall", 0.2);
    p["Bodies"]["cap"]                      = body("cap", 0.2);
    p["Bodies"]["fill"]                     = body("fill", 0.2);
    p["Bodies"]["fill"]["Removed at stage"] = "dig";
    p["Joints"]["base"]                     = joint("base", "wall", "rock", 0.4);
    p["Joints"]["bed"]                      = joint("bed", "cap", "wall", 0.4);
    p["Joints"]["back"]                     = joint("back", "fill", "wall", 0.4);
    p["Joints"]["back of cap"]              = joint("back of cap", "fill", "cap", 0.4);
    p["Loads"]["push"] = {{"Type", "weight"}, {"Bodies", "wall, cap"}, {"Value", "0.3; 0"}};
    p["Loads"]["turn"] = {{"Type", "weight"}, {"Bodies", "cap"}, {"Value", "0.35*(y-2); 0"}};
    const auto stage   = [&](const char *name, const char *loads) {
      p["Stages"][name] = {{"Loads", loads}, {"Levels", levels}};
    };
    stage("rock", "weight: t");
    stage("wall", "weight: 1");
    stage("push", "push: t");
    stage("cap", "push: 1");
    stage("fill", "turn: t");
    stage("grout", "turn: 1-0.8*t; push: 1-t");
    stage("dig", "push: -0.5*t");
    p["Stages"]["grout"]["Grouted joints"] = "base, bed";
    return write_scene(blocks_mesh({0., 1., 2.},
                                   {0., 1., 2., 3.},
                                   3,
                                   {{"rock", "rock"}, {"wall", "fill"}, {"cap", "fill"}},
                                   {{"base", true, 1, 0, 1},
                                    {"bed", true, 2, 0, 1},
                                    {"back", false, 1, 1, 2},
                                    {"back of cap", false, 1, 2, 3}}),
                       p);
  }
} // namespace

// What lies between is followed by events, also from phase to phase: 1 and 97 levels a stage.
TEST(Construction, LevelsDoNotMatter)
{
  const SceneRun one = run_scene(wall(1)), many = run_scene(wall(97));
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_EQ(many.exit_code, 0);
  EXPECT_LE(one.certificate(), 1e-9) << one.summary.at("certificate").dump(1);
  EXPECT_LE(many.certificate(), 1e-9) << many.summary.at("certificate").dump(1);
  EXPECT_EQ(one.events.rows.size(), many.events.rows.size());
  EXPECT_GE(one.events.rows.size(), 10u);
  for (const double t : {2., 3., 4., 5., 6., 7.})
    for (const char *name : {"N", "T1", "gap", "slip1", "jump_t1"})
      {
        ASSERT_EQ(one.values(name, t).size(), many.values(name, t).size());
        EXPECT_LE(deviation(one.values(name, t), many.values(name, t)), 1e-9) << name << ' ' << t;
      }
}

// A restart from checkpoints in all phases ends in the files of the unbroken run, byte for byte.
TEST(Construction, Restart)
{
  EXPECT_GT(restart_everywhere(wall(2), {"Output/Fields=levels"}, 7), 14u);
}

// Mistakes are named before anything is computed.
TEST(Construction, Mistakes)
{
  const auto expect = [](const std::string &setting, const std::string &words) {
    const ProgramRun run = run_program({wall(1), "--check", "--set", setting});
    EXPECT_EQ(run.exit_code, 1) << setting;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
  };
  expect("Bodies/cap/Built at stage=coap", "there is no stage 'coap'");
  expect("Bodies/fill/Removed at stage=wall", "removed before it has stood");
  expect("Stages/dig/Grouted joints=bed, bod", "there is no joint 'bod'");
  expect("Stages/rock/Grouted joints=bed", "nothing has opened");
  expect("Sweep/Friction coefficient=0.1, 0.2",
         "sweeps are of structures that are there from the start");
}
