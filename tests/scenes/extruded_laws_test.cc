// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// What a joint can do in the plane it does in space, from parameter file to results.

#include "scenes/grid_mesh.h"
#include "scenes/rough_blocks.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace fuga;
using namespace fuga::tests;
using Json = nlohmann::ordered_json;

namespace
{
  struct Law
  {
    std::string name;
    /** Entries that make it. */
    std::vector<std::string> entries;
  };

  std::ostream &
  operator<<(std::ostream &out, const Law &law)
  {
    return out << law.name;
  }

  class ExtrudedLaws : public testing::TestWithParam<Law>
  {
  };

  class ExtrudedBeyondLimit : public testing::TestWithParam<Law>
  {
  };
} // namespace

namespace
{
  /** Pressed, pushed until faces slide and open, and let go in part: in the plane, and two elements
   * deep between planes that hold both ends across (plane strain, with two tangents in the middle).
   */
  struct BothRuns
  {
    SceneRun flat, deep;
  };

  BothRuns
  run_both(const std::vector<std::string> &entries, const int levels)
  {
    const GmshMesh plane = two_blocks_mesh(uniform(0., 2., 6), uniform(0., 1., 3));
    Json scene           = rough_blocks();
    add_load(scene, "press", "pressure", "top", "1 + 0.3*x");
    add_load(scene, "push", "traction", "top", "0.45; 0.4*(1 - x)");
    scene["Stages"]["press"]["Loads"]  = "press: t";
    scene["Stages"]["push"]            = {{"Loads", "push: t"}, {"Levels", levels}};
    scene["Stages"]["let go"]["Loads"] = "push: 1 - 0.7*t";
    const std::string in_plane         = write_scene(plane, scene);
    SceneRun flat                      = run_scene(in_plane, entries);
    scene["Loads"]["push"]["Value"]    = "0.45; 0.4*(1 - x); 0";
    return {flat,
            run_scene(write_scene(extruded(plane, {0., 0.5, 1.}), in_space(scene, "z")), entries)};
  }
} // namespace

// 1e-9 of the largest value, and of a stage for the times; ten times that where a search drives the
// path, whose limit is a difference of nearly equal strengths and loads.
TEST_P(ExtrudedLaws, HaveTheEventsOfThePlane)
{
  const auto [flat, deep] = run_both(GetParam().entries, 3);
  EXPECT_EQ(flat.exit_code, deep.exit_code);
  EXPECT_LE(deep.certificate(), 1e-9);
  ASSERT_GT(flat.events.rows.size(), 2u); // the scene is worth comparing
  ASSERT_EQ(deep.events.rows.size(), 3 * flat.events.rows.size());
  const Vector flat_times = flat.event_times(0.), times = deep.event_times(0.);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], flat_times[i / 3], 1e-8) << i;
  EXPECT_NEAR(deep.last_t(), flat.last_t(), 1e-8);
  for (const char *column : {"N", "T1", "slip1", "jump_n", "jump_t1"})
    for (const double t : {1., 4. / 3., std::min(2., flat.last_t())})
      EXPECT_LE(difference_from_plane(deep, 3, flat, column, t, 1e-9), 1e-8)
        << column << " t = " << t;
}

// By one step per stage, found with every law.
TEST_P(ExtrudedLaws, HaveTheStepsOfThePlane)
{
  std::vector<std::string> entries = GetParam().entries;
  entries.push_back("Solver/Follow=stage ends");
  const auto [flat, deep] = run_both(entries, 1);
  EXPECT_EQ(flat.exit_code, deep.exit_code);
  EXPECT_LE(deep.certificate(), 1e-9);
  EXPECT_NEAR(deep.last_t(), flat.last_t(), 1e-8);
  const int steps = flat.summary.at("events").at("implicit_steps").get<int>();
  EXPECT_GE(steps, 2);
  EXPECT_EQ(deep.summary.at("events").at("implicit_steps").get<int>(), steps);
  for (const char *column : {"N", "T1", "slip1", "jump_n", "jump_t1"})
    for (const double t : {1., 2.})
      EXPECT_LE(difference_from_plane(deep, 3, flat, column, t, 1e-9), 1e-8)
        << column << " t = " << t;
}

INSTANTIATE_TEST_SUITE_P(
  Scenes,
  ExtrudedLaws,
  testing::Values(
    Law{"bond", {"Joints/joint/Cohesion=0.2", "Joints/joint/Tensile strength=0.05"}},
    Law{"brittle",
        {"Joints/joint/Cohesion=0.1",
         "Joints/joint/Tensile strength=0.05",
         "Joints/joint/Bond lost by=slip"}},
    Law{"residual", {"Joints/joint/Residual friction coefficient=0.35"}},
    Law{"envelope", {"Joints/joint/Envelope exponent=0.6", "Joints/joint/Envelope pressure=2"}},
    Law{"envelope_all",
        {"Joints/joint/Envelope exponent=0.7",
         "Joints/joint/Envelope pressure=2",
         "Joints/joint/Cohesion=0.1",
         "Joints/joint/Bond lost by=slip",
         "Joints/joint/Residual friction coefficient=0.4",
         "Joints/joint/Dilatancy angle=5",
         "Joints/joint/Normal law=hyperbolic",
         "Joints/joint/Normal closure limit=0.001"}},
    Law{"envelope_reduction",
        {"Safety/Strength reduction=yes",
         "Joints/joint/Envelope exponent=0.6",
         "Joints/joint/Envelope pressure=2"}},
    Law{"dilatancy", {"Joints/joint/Dilatancy angle=8", "Joints/joint/Dilation limit=0.00002"}},
    Law{"gap", {"Joints/joint/Initial gap=0.0001*(x > 1.5)"}},
    Law{"cubic_root", {"Joints/joint/Normal law=cubic root", "Joints/joint/Thickness=0.002"}},
    Law{"cubic_root_shear",
        {"Joints/joint/Normal law=cubic root",
         "Joints/joint/Shear law=cubic root",
         "Joints/joint/Thickness=0.01"}},
    Law{"hyperbolic",
        {"Joints/joint/Normal law=hyperbolic", "Joints/joint/Normal closure limit=0.001"}},
    Law{
      "coupled",
      {"Joints/joint/Shear stiffness grows with=pressure", "Joints/joint/Shear growth pressure=1"}},
    Law{"all",
        {"Joints/joint/Cohesion=0.1",
         "Joints/joint/Tensile strength=0.05",
         "Joints/joint/Bond lost by=slip",
         "Joints/joint/Residual friction coefficient=0.4",
         "Joints/joint/Dilatancy angle=5",
         "Joints/joint/Normal law=hyperbolic",
         "Joints/joint/Normal closure limit=0.001"}},
    Law{"strength_reduction", {"Safety/Strength reduction=yes", "Joints/joint/Cohesion=0.1"}},
    Law{"load_factor", {"Safety/Load factor=push"}}),
  [](const auto &one) { return one.param.name; });

// Pushed four times as far, the blocks slide, and the path goes on: at constant load, or, where
// strength is lost, as the load falls. The joint's resultants at the limit and at every step beyond
// it, to 1e-8 of the largest.
TEST_P(ExtrudedBeyondLimit, HaveThePathOfThePlane)
{
  std::vector<std::string> entries = GetParam().entries;
  for (const char *entry : {"Stages/push/Loads=push: 4*t",
                            "Stages/let go/Loads=push: 4 - 3*t",
                            "Solver/Beyond limit load=arc length",
                            "Solver/Largest jump beyond limit=0.002"})
    entries.push_back(entry);
  const auto [flat, deep] = run_both(entries, 3);
  EXPECT_EQ(flat.exit_code, 3);
  EXPECT_EQ(deep.exit_code, 3);
  EXPECT_LE(deep.certificate(), 1e-9);
  EXPECT_EQ(flat.summary.at("beyond_limit").at("end"), "largest jump");
  EXPECT_EQ(deep.summary.at("beyond_limit").at("end"), "largest jump");
  ASSERT_EQ(deep.events.rows.size(), 3 * flat.events.rows.size());
  const Vector flat_times = flat.event_times(0.), times = deep.event_times(0.);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], flat_times[i / 3], 1e-8) << i;
  ASSERT_EQ(deep.resultants.rows.size(), flat.resultants.rows.size());
  for (const char *column : {"t", "path_length", "N", "T", "dissipation", "largest_slip"})
    {
      double largest = 0.;
      for (std::size_t i = 0; i < flat.resultants.rows.size(); ++i)
        largest = std::max(largest, std::abs(flat.resultants.number(i, column)));
      for (std::size_t i = 0; i < flat.resultants.rows.size(); ++i)
        EXPECT_NEAR(
          deep.resultants.number(i, column), flat.resultants.number(i, column), 1e-8 * largest)
          << column << " in row " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         ExtrudedBeyondLimit,
                         testing::Values(Law{"friction", {}},
                                         Law{"residual",
                                             {"Joints/joint/Residual friction coefficient=0.35"}},
                                         Law{"brittle",
                                             {"Joints/joint/Cohesion=0.1",
                                              "Joints/joint/Tensile strength=0.05",
                                              "Joints/joint/Bond lost by=slip"}}),
                         [](const auto &one) { return one.param.name; });
