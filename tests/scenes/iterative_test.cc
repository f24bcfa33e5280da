// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Bodies eliminated by conjugate gradients with multigrid against the direct solver: another
// algorithm for the same equations, so everything agrees but for the tolerance.

#include "scenes/blocks_mesh.h"
#include "scenes/keyed_blocks.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  SceneRun
  run_with(const std::string &solver, const std::string &scene, std::vector<std::string> overrides)
  {
    overrides.push_back("Solver/Bodies=" + solver);
    return run_scene(scene, overrides);
  }

  // Columns of S have residuals of 1e-11, which the path passes on with a factor of ten or so.
  void
  expect_same_path(const SceneRun &a, const SceneRun &b)
  {
    EXPECT_EQ(a.exit_code, b.exit_code);
    EXPECT_EQ(a.summary.at("work").at("bodies").at("solver"), "direct");
    EXPECT_EQ(b.summary.at("work").at("bodies").at("solver"), "iterative");
    EXPECT_LE(b.certificate(), 1e-9);
    ASSERT_EQ(a.events.rows.size(), b.events.rows.size());
    for (std::size_t i = 0; i < a.events.rows.size(); ++i)
      {
        EXPECT_NEAR(a.events.number(i, "t"), b.events.number(i, "t"), 1e-9) << i;
        for (const char *column : {"element", "from", "to"})
          EXPECT_EQ(a.events.text(i, column), b.events.text(i, column)) << i;
      }
    ASSERT_EQ(a.history.rows.size(), b.history.rows.size());
    for (const char *column : {"N", "T1", "gap", "jump_t1"})
      {
        Vector left, right;
        for (std::size_t i = 0; i < a.history.rows.size(); ++i)
          {
            left.push_back(a.history.number(i, column));
            right.push_back(b.history.number(i, column));
          }
        EXPECT_LE(deviation(right, left), 1e-9) << column;
      }
  }

  // Of both stages.
  void
  expect_same_end(const SceneRun &steps, const SceneRun &other)
  {
    EXPECT_EQ(steps.exit_code, 0);
    EXPECT_LE(steps.certificate(), 1e-9);
    EXPECT_EQ(steps.states(2.), other.states(2.));
    for (const char *column : {"N", "T1"})
      EXPECT_LE(deviation(steps.values(column, 2.), other.values(column, 2.)), 1e-9) << column;
  }

  // The ends of monotone stages are the states to which the events lead; @p one_level of the
  // second. Returns the run without events.
  SceneRun
  expect_ends_of_events(const std::string &file, const std::string &one_level)
  {
    const SceneRun events = run_with("direct", file, {one_level});
    SceneRun steps =
      run_with("iterative matrix-free", file, {one_level, "Solver/Follow=stage ends"});
    expect_same_end(steps, events);
    return steps;
  }

  // From level to level, with the stiffness of the interface and without it. Returns the run
  // without.
  SceneRun
  expect_same_steps(const std::string &file, std::vector<std::string> settings)
  {
    settings.push_back("Solver/Follow=stage ends");
    SceneRun steps = run_with("iterative matrix-free", file, settings);
    expect_same_end(steps, run_with("direct", file, settings));
    return steps;
  }
} // namespace

// 30 events in the plane; two stages; every field with its certificate.
TEST(Iterative, SameEventsInThePlane)
{
  expect_same_path(run_with("direct", "scene_g_f06.prm", {}),
                   run_with("iterative", "scene_g_f06.prm", {}));
}

// Arch and abutments: bodies that only their rigid or soft joints hold, one after the other.
TEST(Iterative, SameEventsOfFloatingBodies)
{
  expect_same_path(run_with("direct", "arch.prm", {}), run_with("iterative", "arch.prm", {}));
}

// Hexahedra, circular cones, water in the joint.
TEST(Iterative, LargeSameEventsInSpace)
{
  expect_same_path(run_with("direct", "dam_block_3d.prm", {}),
                   run_with("iterative", "dam_block_3d.prm", {}));
}

// Quadratic elements on a locally refined mesh: hanging nodes.
TEST(Iterative, SameContactOnHangingNodes)
{
  const std::vector<std::string> few = {"Target accuracy/Largest number of rounds=2"};
  const SceneRun direct              = run_with("direct", "punch_adaptive.prm", few);
  const SceneRun iterative           = run_with("iterative", "punch_adaptive.prm", few);
  EXPECT_EQ(direct.summary.at("sizes"), iterative.summary.at("sizes"));
  EXPECT_LE(iterative.certificate(), 1e-9);
  EXPECT_LE(deviation(iterative.values("N", 1.), direct.values("N", 1.)), 1e-9);
}

// Without the stiffness of the interface: the state at the ends of monotone stages is that to which
// the events lead, in the plane (30 events) and on cones in space.
TEST(Iterative, MatrixFreeStageEnds)
{
  const SceneRun steps = expect_ends_of_events("scene_g_f06.prm", "Stages/water/Levels=1");
  EXPECT_EQ(steps.summary.at("work").at("bodies").at("solver"), "iterative matrix-free");
  EXPECT_EQ(steps.summary.at("events").at("implicit_steps"), 2);
}

// The paper's third variant: a joint of law (9).
TEST(Iterative, MatrixFreeStageEndsOfLawNine)
{
  expect_ends_of_events("paper_3_cubic_root.prm", "Stages/push/Levels=1");
}

// The paper's first variant: a rigid joint.
TEST(Iterative, MatrixFreeStageEndsOfRigidJoints)
{
  expect_ends_of_events("paper_1_rigid.prm", "Stages/push/Levels=1");
}

// Bonds that break with the first slip, lips that rise, friction that falls.
TEST(Iterative, MatrixFreeStepsWithBonds)
{
  expect_same_steps("scene_g_f06.prm",
                    {"Joints/base/Cohesion=100",
                     "Joints/base/Tensile strength=50",
                     "Joints/base/Bond lost by=slip",
                     "Joints/base/Residual friction coefficient=0.5",
                     "Joints/base/Dilatancy angle=3"});
}

// Strength along a curve over the pressure.
TEST(Iterative, MatrixFreeStepsWithCurvedEnvelope)
{
  expect_same_steps("scene_g_f06.prm",
                    {"Joints/base/Envelope exponent=0.6", "Joints/base/Envelope pressure=1000"});
}

// Water follows the crack that is open at the end of a step, until it opens no more.
TEST(Iterative, MatrixFreeWaterComesIn)
{
  const SceneRun steps = expect_ends_of_events("dam.prm", "Stages/reservoir/Levels=2");
  EXPECT_GT(steps.count("open", 2.), 0u);
}

// More bars than coordinates: at the corners of a key, and where the joints of four blocks cross.
// Slips there depend on the way, so the same steps are taken with the stiffness of the interface.
TEST(Iterative, MatrixFreeStepsOfCornersAndCrossings)
{
  expect_same_steps(write_scene(keyed_mesh(Profile::key, 2), keyed_blocks({{0.012, -0.006}})), {});

  nlohmann::ordered_json scene      = rough_blocks();
  const nlohmann::ordered_json body = scene["Bodies"]["upper"], joint = scene["Joints"]["joint"];
  scene.erase("Bodies");
  scene.erase("Joints");
  for (const char *name : {"a", "b", "c", "d"})
    scene["Bodies"][name] = body;
  const std::vector<std::array<std::string, 3>> joints = {
    {{"lower", "b", "a"}}, {{"upper", "d", "c"}}, {{"west", "c", "a"}}, {{"east", "d", "b"}}};
  for (const auto &[line, plus, minus] : joints)
    {
      scene["Joints"][line] = joint;
      scene["Joints"][line].update({{"Line", line}, {"Plus body", plus}, {"Minus body", minus}});
    }
  add_load(scene, "press", "traction", "top", "0; -1");
  add_load(scene, "push", "traction", "top", "0.4; 0");
  scene["Stages"]["press"] = {{"Loads", "press: t"}};
  scene["Stages"]["push"]  = {{"Loads", "push: t"}};
  const GmshMesh mesh      = blocks_mesh({0., 1., 2.},
                                    {0., 1., 2.},
                                    3,
                                    {{"a", "b"}, {"c", "d"}},
                                    {{"lower", false, 1, 0, 1},
                                          {"upper", false, 1, 1, 2},
                                          {"west", true, 1, 0, 1},
                                          {"east", true, 1, 1, 2}});
  const SceneRun steps     = expect_same_steps(write_scene(mesh, scene), {});
  EXPECT_GT(steps.count("open", 2.) + steps.count("slip", 2.), 0u);
}

// Cells of 1 x 1/11 and 1 x 1/9: diagonals over short edges of 11.05 and 9.06.
TEST(Iterative, LongCellsAreMentioned)
{
  nlohmann::ordered_json scene = rough_blocks();
  add_load(scene, "press", "traction", "top", "0; -1");
  scene["Stages"]["press"] = {{"Loads", "press: t"}};
  const auto warnings      = [&](const double width, const std::string &solver) {
    const GmshMesh mesh =
      blocks_mesh({0., width}, {0., 1., 2.}, 3, {{"lower"}, {"upper"}}, {{"joint", true, 1, 0, 1}});
    return run_with(solver, write_scene(mesh, scene), {}).summary.at("warnings");
  };
  ASSERT_EQ(warnings(11., "iterative").size(), 1u);
  EXPECT_NE(warnings(11., "iterative").dump().find("up to 11 times as long"), std::string::npos);
  EXPECT_EQ(warnings(11., "direct").size(), 0u);
  EXPECT_EQ(warnings(9., "iterative").size(), 0u);
}

// On cones the slips turn while the load grows, and a step takes their last direction: the scheme
// is that of the events, forces are close (every step less is an error of first order in a slip of
// a few elements), and all conditions hold to the bound of the certificate.
TEST(Iterative, LargeMatrixFreeStageEndsInSpace)
{
  std::vector<std::string> settings = {"Stages/reservoir/Levels=1", "Solver/Load knots=1"};
  const SceneRun events             = run_with("direct", "dam_block_3d.prm", settings);
  settings.push_back("Solver/Follow=stage ends");
  const SceneRun steps = run_with("iterative matrix-free", "dam_block_3d.prm", settings);
  EXPECT_EQ(steps.exit_code, 0);
  EXPECT_LE(steps.certificate(), 1e-9);
  EXPECT_EQ(steps.states(2.), events.states(2.));
  EXPECT_LE(deviation(steps.values("N", 2.), events.values("N", 2.)), 1e-5);
  EXPECT_LE(deviation(steps.values("T1", 2.), events.values("T1", 2.)), 1e-4);
}

// One cell between a sole and a roof that settles by s: every unknown is a jump, and nothing is
// left to eliminate. Two springs in series, pressure s / (h/E + rho) = 1e-3 / (1e-3 + 1e-4);
// rounding only.
TEST(Iterative, NothingToEliminate)
{
  const std::string directory = temporary_directory();
  std::ofstream(directory + "/slab.msh") << R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
1 11 "sole"
1 14 "roof"
1 15 "sides"
2 1 "slab"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
5
1 1 2 11 11 1 2
2 1 2 14 14 3 4
3 1 2 15 15 2 3
4 1 2 15 15 4 1
5 3 2 1 1 1 2 3 4
$EndElements
)";
  std::ofstream(directory + "/slab.prm") << R"(subsection Mesh
  set File = slab.msh
end
subsection Bodies
  subsection slab
    set Young modulus = 1000
    set Poisson ratio = 0
  end
end
subsection Joints
  subsection sole
    set Plus lip  = sole
    set Minus lip = rigid
    set Normal compliance = 1e-4
    set Shear compliance = 1e-4
    set Friction coefficient = 0.5
  end
end
subsection Boundaries
  subsection roof
    set Fixed = all
  end
  subsection sides
    set Fixed = free
  end
end
subsection Loads
  subsection settle
    set Type       = displacement
    set Boundaries = roof
    set Value      = 0; -0.001
  end
end
subsection Stages
  subsection settle
    set Loads = settle: t
  end
end
)";
  const auto check = [&](const std::string &solver, const std::vector<std::string> &settings) {
    const SceneRun run = run_with(solver, directory + "/slab.prm", settings);
    EXPECT_EQ(run.exit_code, 0) << solver;
    EXPECT_NEAR(run.resultants.number(run.resultants.rows.size() - 1, "N"), -1. / 1.1, 1e-14)
      << solver;
  };
  check("direct", {});
  check("iterative", {});
  check("iterative matrix-free", {"Solver/Follow=stage ends"});
  std::filesystem::remove_all(directory);
}

TEST(Iterative, MatrixFreeRefusesWhatNeedsTheStiffness)
{
  const ProgramRun run = run_program(
    {parameter_path("scene_g_f06.prm"), "--check", "--set", "Solver/Bodies=iterative matrix-free"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("Follow = events"), std::string::npos) << run.err;
}
