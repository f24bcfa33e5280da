// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// A block in a groove whose faces meet at a corner: closed forms of the wedge.

#include "scenes/keyed_blocks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json = nlohmann::ordered_json;

  constexpr double weight_density = 0.02;

  /** Faces of the groove rise by this angle on both sides: the angle β between face and axis is its
   * complement. */
  const double slope        = 25. * std::acos(-1.) / 180.;
  constexpr double friction = 0.3;

  /** A block 2 wide and @p height high in a groove as wide. */
  GmshMesh
  groove(const std::size_t n, const double height)
  {
    GmshMesh mesh = two_blocks_mesh(uniform(-1., 1., 2 * n), uniform(0., height, n));
    for (auto &vertex : mesh.vertices)
      vertex[1] += std::abs(vertex[0]) * std::tan(slope);
    return mesh;
  }
} // namespace

// A block W in a smooth groove: both faces carry W/(2 sin β).
TEST(Grooves, Smooth)
{
  for (const std::size_t n : {1, 2, 5})
    {
      Json scene                                       = keyed_blocks({{0., 0.}});
      scene["Joints"]["joint"]["Friction coefficient"] = 0.;
      scene["Boundaries"]["top"]["Fixed"]              = "free";
      scene["Loads"].erase("push");
      scene["Stages"].erase("push");
      const SceneRun run = run_scene(write_scene(groove(n, 1.), scene));
      double sum         = 0.;
      for (const double N : run.values("N", 1.))
        sum += N;
      const double W = 2. * weight_density;
      EXPECT_NEAR(sum, -W / std::cos(slope), 1e-12 * W);
      EXPECT_NEAR(run.resultant("N", 1.), -W, 1e-12 * W);
      EXPECT_NEAR(run.resultant("T", 1.), 0., 1e-12 * W);
    }
}

// Pushed across, the block slides up the right face when P = W tan(slope + φ), and the left face
// opens. With this height the resultant stands in the middle of the right face. The corner has an
// element on the right face that slips and one on the left that is open; with one for both the
// limit on the coarsest mesh would be half as high.
TEST(Grooves, WithFriction)
{
  const double ratio = std::tan(slope + std::atan(friction)), W = 2. * weight_density;
  for (const std::size_t n : {1, 2, 5})
    {
      // The top has the length 2/cos(slope); the load grows to 5/4 of the limit.
      Json scene = keyed_blocks({{1.25 * ratio * W * std::cos(slope) / 2., 0.}});
      scene["Joints"]["joint"]["Friction coefficient"] = friction;
      const double height                              = 0.5 / ratio;
      scene["Bodies"]["upper"]["Weight density"]       = weight_density / height;
      const SceneRun run = run_scene(write_scene(groove(n, height), scene));
      EXPECT_EQ(run.exit_code, 3);
      EXPECT_LE(run.certificate(), 1e-9);
      EXPECT_NEAR(run.summary.at("limit_load").at("t").get<double>(), 1.8, 1e-9);
      EXPECT_EQ(run.count("open", run.last_t()), n + 1);
      EXPECT_NEAR(run.resultant("T", run.last_t()), ratio * W, 1e-11 * W);
      EXPECT_NEAR(run.resultant("N", run.last_t()), -W, 1e-11 * W);
    }
}

// A block in a groove that is pushed along it slides at f W/sin β. The layer hardly carries shear
// across the groove (ρn/ρt = 1e-6), which would change N by that share.
TEST(Grooves, Along)
{
  const double W = 2. * weight_density, limit = friction * W / std::cos(slope);
  Json scene                                       = deep_blocks({{0., 0.}});
  scene["Joints"]["joint"]["Friction coefficient"] = friction;
  scene["Joints"]["joint"]["Shear compliance"]     = 100.;
  const double height                              = 0.1;
  scene["Bodies"]["upper"]["Weight density"]       = weight_density / height;
  // The top has the area 2/cos(slope); the load grows to 5/4 of the limit.
  scene["Loads"]["push"]["Value"] =
    fmt::format("0; 0; {:.17g}", 1.25 * limit * std::cos(slope) / 2.);
  const SceneRun run = run_scene(write_scene(extruded(groove(2, height), {0., 0.5, 1.}), scene));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_NEAR(run.summary.at("limit_load").at("t").get<double>(), 1.8, 1e-5);
}

// The groove of the plane, one element deep between planes that hold both ends.
TEST(Grooves, WithFrictionInSpace)
{
  const double ratio = std::tan(slope + std::atan(friction)), W = 2. * weight_density;
  Json scene = deep_blocks({{1.25 * ratio * W * std::cos(slope) / 2., 0.}});
  scene["Joints"]["joint"]["Friction coefficient"] = friction;
  const double height                              = 0.5 / ratio;
  scene["Bodies"]["upper"]["Weight density"]       = weight_density / height;
  for (const char *end : {"front", "back"})
    scene["Boundaries"][end]["Fixed"] = "z";
  const SceneRun run = run_scene(write_scene(extruded(groove(2, height), {0., 1.}), scene));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NEAR(run.summary.at("limit_load").at("t").get<double>(), 1.8, 1e-9);
  EXPECT_EQ(run.count("open", run.last_t()), 2u * 3u);
}
