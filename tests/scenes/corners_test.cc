// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Joints with corners. What is known by hand: all that the joint carries, from the equilibrium of
// the upper block, on every mesh; the wedge in a groove.

#include "scenes/keyed_blocks.h"
#include "scenes/mesh_variants.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json  = nlohmann::ordered_json;
  using Plane = std::array<double, 2>;

  /** Force on the upper block at a place. */
  struct Force
  {
    Plane force, place;
  };

  /** What the joint has to carry of @p loads, in the frame of its chord from (0, 3/2) to (3, end). */
  struct Carried
  {
    double N = 0., T = 0., M = 0.;

    Carried(const std::vector<Force> &loads, const double end, const Plane &center)
    {
      const double length = std::hypot(3., end - 1.5);
      const Plane t = {{3. / length, (end - 1.5) / length}}, n = {{-t[1], t[0]}};
      for (const auto &[f, place] : loads)
        {
          N += f[0] * n[0] + f[1] * n[1];
          T += f[0] * t[0] + f[1] * t[1];
          M -= (place[0] - center[0]) * f[1] - (place[1] - center[1]) * f[0];
        }
    }
  };

  struct Block
  {
    Profile profile;
    /** Of the upper block, by rectangles; and the middle of the line of the joint. */
    double area;
    Plane center, middle;
    double end;
    std::size_t n_corners;
  };

  const std::vector<Block> blocks = {
    {Profile::step,
     4.,
     {{(3. * 1.5 + 1. * 2.) / 4., (3. * 2. + 1. * 1.25) / 4.}},
     {{(0.5 + 0.5 * 1. + 2. * 2.) / 3.5, (1.5 + 0.5 * 1.25 + 2. * 1.) / 3.5}},
     1.,
     2},
    {Profile::key,
     3.5,
     {{1.5, (3. * 2. + 0.5 * 1.25) / 3.5}},
     {{1.5, (2. * 1.5 + 2. * 0.5 * 1.25 + 1. * 1.) / 4.}},
     1.5,
     4}};

  constexpr double weight_density = 0.02;

  /** Forces and the moment of the joint against those by hand. The tolerance is the rounding of the
   * condensation, relative to all that is carried. */
  void
  expect_carried(const SceneRun &run,
                 const Block &block,
                 const Plane &traction,
                 const double rounding = 1e-12)
  {
    const Force weight = {{{0., -weight_density * block.area}}, block.center};
    for (const double t : {1., 2.})
      {
        std::vector<Force> loads = {weight};
        if (t > 1.)
          loads.push_back({{{3. * traction[0], 3. * traction[1]}}, {{1.5, 2.5}}});
        const Carried expected(loads, block.end, block.middle);
        const double tolerance = rounding * std::hypot(expected.N, expected.T);
        EXPECT_NEAR(run.resultant("N", t), expected.N, tolerance) << t;
        EXPECT_NEAR(run.resultant("T", t), expected.T, tolerance) << t;
        EXPECT_NEAR(run.resultant("M", t), expected.M, 3. * tolerance) << t;
      }
  }

  constexpr Plane traction = {{0.012, -0.006}};
} // namespace

// On three meshes, with friction, slip and openings, and of degree 2.
TEST(Corners, Equilibrium)
{
  for (const Block &block : blocks)
    for (const std::size_t n : {1, 2, 4})
      for (const int degree : {1, 2})
        {
          SCOPED_TRACE(fmt::format("{} corners, n = {}, degree {}", block.n_corners, n, degree));
          const SceneRun run =
            run_scene(write_scene(keyed_mesh(block.profile, n), keyed_blocks(traction)),
                      {fmt::format("Mesh/Polynomial degree={}", degree)});
          EXPECT_EQ(run.exit_code, 0);
          EXPECT_LE(run.certificate(), 1e-9);
          expect_carried(run, block, traction);
          // One element more at every corner: the nodes of the line are 2n per unit length.
          const double length = block.profile == Profile::key ? 4. : 3.5;
          const auto n_nodes  = static_cast<std::size_t>(std::lround(length * 2. * double(n)));
          EXPECT_EQ(run.values("N", 1.).size(),
                    n_nodes * std::size_t(degree) + 1 + block.n_corners);
          EXPECT_GT(run.count("open", 2.), 0u);
        }
}

// Rigid layers, whose bars repeat each other at the corners: how the two elements share the force
// is the program's choice, which it states; all that the joint carries is not. The compliance that
// it chooses, 1e-4 of that of the bodies, costs one digit of the equilibrium.
TEST(Corners, RigidLayer)
{
  for (const Block &block : blocks)
    for (const std::size_t n : {1, 2, 4})
      {
        Json scene                             = keyed_blocks(traction);
        scene["Joints"]["joint"]["Normal law"] = "rigid";
        scene["Joints"]["joint"]["Shear law"]  = "rigid";
        scene["Joints"]["joint"].erase("Normal compliance");
        scene["Joints"]["joint"].erase("Shear compliance");
        const SceneRun run = run_scene(write_scene(keyed_mesh(block.profile, n), scene));
        EXPECT_EQ(run.exit_code, 0);
        EXPECT_LE(run.certificate(), 1e-9);
        expect_carried(run, block, traction, 1e-11);
      }
}

// The same scene in another direction: forces, events and states are the same, also where all
// normals are oblique. 1e-9, as other invariances (invariance_test.cc).
TEST(Corners, Turned)
{
  for (const Block &block : blocks)
    {
      const GmshMesh mesh     = keyed_mesh(block.profile, 2);
      const SceneRun straight = run_scene(write_scene(mesh, keyed_blocks(traction)));
      for (const double angle : {0.3, 1.2})
        {
          const SceneRun run =
            run_scene(write_scene(turned(mesh, angle), keyed_blocks(traction, angle)));
          const Vector times = straight.event_times(0.), others = run.event_times(0.);
          ASSERT_EQ(times.size(), others.size());
          EXPECT_GT(times.size(), 3u);
          for (std::size_t i = 0; i < times.size(); ++i)
            EXPECT_NEAR(times[i], others[i], 1e-9);
          for (const char *name : {"N", "T", "M", "share_open", "share_slip", "largest_gap"})
            EXPECT_NEAR(run.resultant(name, 2.),
                        straight.resultant(name, 2.),
                        1e-9 * std::abs(straight.resultant(name, 2.)))
              << name;
        }
    }
}

// What is said before anything is computed, and in the log; 180 degrees is one element per place.
TEST(Corners, AreTold)
{
  const std::string file = write_scene(keyed_mesh(Profile::key, 1), keyed_blocks(traction));
  const ProgramRun split = run_program({"--check", file});
  EXPECT_EQ(split.exit_code, 0) << split.err;
  EXPECT_NE(split.out.find("joint 'joint': split at 4 corners, where faces meet at more than 30 "
                           "degrees, (1, 1.5), (1, 1), (2, 1), (2, 1.5)"),
            std::string::npos)
    << split.out;
  const std::vector<std::string> off = {"--set", "Joints/joint/Corner angle=180"};
  const ProgramRun whole             = run_program({"--check", file, off[0], off[1]});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.out.find("split at"), std::string::npos) << whole.out;
  EXPECT_EQ(run_scene(file, {off[1]}).values("N", 1.).size(), 9u);
  EXPECT_EQ(run_scene(file).values("N", 1.).size(), 13u);
}

// A stage of construction that has nothing to do with the joint: its elements, two of them at every
// corner, find their states again.
TEST(Corners, NextPhase)
{
  Json scene                        = keyed_blocks(traction);
  scene["Stages"]["push"]["Levels"] = 2;
  const auto with_bank              = [](GmshMesh mesh) {
    mesh.physical_names[{2, 90}] = "bank";
    const auto first             = static_cast<unsigned int>(mesh.vertices.size());
    for (const std::array<double, 3> &vertex :
         {std::array<double, 3>{{4., 0., 0.}}, {{5., 0., 0.}}, {{5., 1., 0.}}, {{4., 1., 0.}}})
      mesh.vertices.push_back(vertex);
    MeshEntity cell;
    cell.shape        = CellShape::quadrilateral;
    cell.physical_tag = 90;
    cell.vertices     = {{first, first + 1, first + 2, first + 3}};
    mesh.cells.push_back(cell);
    mesh.physical_names[{1, 91}] = "bank sides";
    for (unsigned int k = 0; k < 4; ++k)
      {
        MeshEntity side;
        side.shape        = CellShape::line;
        side.physical_tag = 91;
        side.vertices     = {{first + k, first + (k + 1) % 4}};
        mesh.faces.push_back(side);
      }
    return mesh;
  };
  scene["Bodies"]["bank"]                   = {{"Young modulus", 100.}, {"Poisson ratio", 0.}};
  scene["Boundaries"]["bank sides"]         = {{"Fixed", "all"}};
  scene["Stages"]["rest"]                   = {{"Loads", "push: 1-t"}};
  const GmshMesh mesh                       = with_bank(keyed_mesh(Profile::key, 2));
  const SceneRun whole                      = run_scene(write_scene(mesh, scene));
  scene["Bodies"]["bank"]["Built at stage"] = "rest";
  const SceneRun parts                      = run_scene(write_scene(mesh, scene));
  EXPECT_EQ(parts.exit_code, 0);
  for (const double t : {2., 3.})
    for (const char *name : {"N", "T1", "slip1", "gap"})
      EXPECT_LE(deviation(parts.values(name, t), whole.values(name, t)), 1e-9) << name << t;
  EXPECT_EQ(parts.states(3.), whole.states(3.));
}

// Around an axis: the key is a ring. What the joint carries along the axis is the weight of the
// upper body and the pressure on its top; friction gives way at the sides of the key.
TEST(Corners, AroundAnAxis)
{
  constexpr double pressure = 0.006, volume = M_PI * (9. * 1. + (4. - 1.) * 0.5);
  for (const std::size_t n : {1, 2, 4})
    for (const int degree : {1, 2})
      {
        SCOPED_TRACE(fmt::format("n = {}, degree {}", n, degree));
        Json scene                           = keyed_blocks({{0., -pressure}});
        scene["Boundaries"]["left"]["Fixed"] = "x";
        const SceneRun run                   = run_scene(
          write_scene(keyed_mesh(Profile::key, n), scene),
          {"Mesh/Assumption=axisymmetric", fmt::format("Mesh/Polynomial degree={}", degree)});
        EXPECT_EQ(run.exit_code, 0);
        EXPECT_LE(run.certificate(), 1e-9);
        const double weight = weight_density * volume, push = M_PI * 9. * pressure;
        EXPECT_NEAR(run.resultant("N", 1.), -weight, 1e-12 * weight);
        EXPECT_NEAR(run.resultant("N", 2.), -weight - push, 1e-12 * (weight + push));
        // One element more at every corner; with degree 2 the node on the axis has no area.
        EXPECT_EQ(run.values("N", 1.).size(),
                  8 * n * std::size_t(degree) + (degree == 1 ? 1 : 0) + 4);
      }
}

// In space, with a push along the edges too: all six resultants by hand.
TEST(Corners, EquilibriumInSpace)
{
  const double across = 0.004;
  for (const Block &block : blocks)
    for (const std::size_t n : {1, 2})
      {
        Json scene = deep_blocks(traction);
        scene["Loads"]["push"]["Value"] =
          fmt::format("{}; {}; {}", traction[0], traction[1], across);
        const SceneRun run =
          run_scene(write_scene(extruded(keyed_mesh(block.profile, n), {0., 0.5, 1.}), scene));
        EXPECT_EQ(run.exit_code, 0);
        EXPECT_LE(run.certificate(), 1e-9);
        expect_carried(run, block, traction);
        // The force 3 across, at the height 5/2 - y of the middle and at the distance 3/2 - x.
        const double length = std::hypot(3., block.end - 1.5), F = 3. * across,
                     x = 1.5 - block.middle[0], y = 2.5 - block.middle[1], t_x = 3. / length,
                     t_y       = (block.end - 1.5) / length;
        const double tolerance = 1e-12 * 3. * std::hypot(traction[0], traction[1], across);
        EXPECT_NEAR(run.resultant("T2", 2.), -F, tolerance);
        EXPECT_NEAR(run.resultant("M1", 2.), -(y * F * t_x - x * F * t_y), 3. * tolerance);
        EXPECT_NEAR(run.resultant("Mn", 2.), -(-y * F * t_y - x * F * t_x), 3. * tolerance);
      }
}
