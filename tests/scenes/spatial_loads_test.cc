// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Every type of load on a block in space: what the joint under it carries, by statics.

#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json = nlohmann::ordered_json;

  constexpr double Lx = 2., Ly = 1.5, H = 3., gamma_block = 100.;

  /** Force and moments about the middle of the base, on the block. */
  struct Wrench
  {
    double Fx = 0., Fy = 0., Fz = 0., Mx = 0., My = 0., Mz = 0.;
  };

  /** A force at a place. */
  Wrench
  at(const std::array<double, 3> &place, const std::array<double, 3> &F)
  {
    const double x = place[0] - Lx / 2., y = place[1] - Ly / 2., z = place[2];
    return {F[0], F[1], F[2], y * F[2] - z * F[1], z * F[0] - x * F[2], x * F[1] - y * F[0]};
  }

  /** A load, and what it does. */
  struct Case
  {
    const char *name;
    Json load;
    Wrench wrench;
  };

  std::vector<Case>
  cases()
  {
    constexpr double volume = Lx * Ly * H, gamma = 9.81, h = 2.4;
    const std::array<double, 3> centre = {{Lx / 2., Ly / 2., H / 2.}};
    const double water                 = gamma * h * h / 2. * Ly,
                 wave                  = 7. / 8. * 0.2 * gamma * 2. / 3. * h * h * Lx;
    const double earth = 0.4 * gamma * h * h / 2. * Ly, surcharge = 0.4 * 3. * h * Ly;
    // ∫(1 + x + 2y) over the top, and its first moments.
    const double force = Lx * Ly * (1. + Lx / 2. + Ly);
    const double x_top = Lx * Ly * (Lx / 2. + Lx * Lx / 3. + Ly * Lx / 2.) / force;
    const double y_top = Lx * Ly * (Ly / 2. + Lx * Ly / 4. + 2. * Ly * Ly / 3.) / force;
    const double A     = Lx * Ly;
    const Json sea     = {{"Level", h}, {"Unit weight", gamma}};
    const auto on      = [](Json load, const char *type, const char *boundary) {
      load["Type"]       = type;
      load["Boundaries"] = boundary;
      return load;
    };
    Json ground = on(sea, "earth pressure", "right"), shaken = on(sea, "westergaard", "contact");
    ground["Earth pressure coefficient"] = 0.4;
    ground["Surcharge"]                  = 3.;
    shaken["Horizontal coefficient"]     = 0.2;
    shaken["Bottom level"]               = 0.;
    Json uplift                          = {
                               {"Type", "uplift"}, {"Joints", "base"}, {"Upstream end", "left"}, {"Cracks", "unchanged"}};
    uplift.update(sea);
    const Wrench soil = at({{Lx, Ly / 2., h / 3.}}, {{-earth, 0., 0.}});
    const Wrench more = at({{Lx, Ly / 2., h / 2.}}, {{-surcharge, 0., 0.}});
    return {
      {"weight",
       {{"Type", "weight"}, {"Value", "0.1; 0.2; -1"}},
       at(centre,
          {{0.1 * gamma_block * volume, 0.2 * gamma_block * volume, -gamma_block * volume}})},
      {"seismic",
       {{"Type", "seismic"}, {"Horizontal coefficient", 0.1}, {"Vertical coefficient", -0.05}},
       at(centre, {{0.1 * gamma_block * volume, 0., -0.05 * gamma_block * volume}})},
      {"temperature", {{"Type", "temperature"}, {"Value", 20}}, {}},
      {"pressure",
       on({{"Value", "1 + x + 2*y"}}, "pressure", "back"),
       at({{x_top, y_top, H}}, {{0., 0., -force}})},
      {"hydrostatic",
       on(sea, "hydrostatic", "left"),
       at({{0., Ly / 2., h / 3.}}, {{water, 0., 0.}})},
      {"earth pressure",
       ground,
       {soil.Fx + more.Fx, 0., 0., 0., soil.My + more.My, soil.Mz + more.Mz}},
      {"westergaard", shaken, at({{Lx / 2., 0., 0.4 * h}}, {{0., wave, 0.}})},
      {"uplift", uplift, at({{Lx / 3., Ly / 2., 0.}}, {{0., 0., gamma * h * A / 2.}})},
      {"traction",
       on({{"Value", "1; -2; 3"}}, "traction", "back"),
       at({{Lx / 2., Ly / 2., H}}, {{A, -2. * A, 3. * A}})},
      {"point force",
       {{"Type", "point force"}, {"Point", "2, 1.5, 3"}, {"Value", "2; 3; -4"}},
       at({{2., 1.5, 3.}}, {{2., 3., -4.}})},
      {"imposed gap", {{"Type", "imposed gap"}, {"Joints", "base"}, {"Value", 0.01}}, {}}};
  }

  /** The block on a rough rigid plane, 2 x 2 x 3 elements. */
  std::string
  block(const Json &weight, const Json &load)
  {
    Json scene;
    scene["Dimension"]       = 3;
    scene["Bodies"]["block"] = {{"Young modulus", 1e5},
                                {"Poisson ratio", 0.2},
                                {"Weight density", gamma_block},
                                {"Thermal expansion", 1e-4}};
    scene["Joints"]["base"]  = {{"Plus lip", "front"},
                                {"Minus lip", "rigid"},
                                {"Normal compliance", 1e-5},
                                {"Shear compliance", 1e-5},
                                {"Friction coefficient", 2}};
    const std::string loaded = load.value("Boundaries", "");
    for (const char *side : {"left", "right", "contact", "top", "back"})
      if (side != loaded)
        scene["Boundaries"][side]["Fixed"] = "free";
    scene["Loads"]["own"]             = weight;
    scene["Loads"]["more"]            = load;
    scene["Stages"]["own"]["Loads"]   = "own: t";
    scene["Stages"]["more"]["Loads"]  = "more: t";
    scene["Monitors"]["top"]["Point"] = "1, 0.75, 3";
    return write_scene(
      extruded(block_mesh(uniform(0., Lx, 2), uniform(0., Ly, 2), Lx), uniform(0., H, 3)), scene);
  }
} // namespace

// 1e-9 of the weight, 900, or its moment. The load of an earthquake's water, √-shaped, is
// integrated by a rule: exact to 1e-6.
TEST(SpatialLoads, ResultantsByStatics)
{
  const Json weight = {{"Type", "weight"}, {"Value", "0; 0; -1"}};
  for (const Case &c : cases())
    {
      SCOPED_TRACE(c.name);
      const SceneRun run = run_scene(block(weight, c.load));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      const auto added = [&](const char *column) {
        return run.resultant(column, 2.) - run.resultant(column, 1.);
      };
      const double tolerance = c.name == std::string("westergaard") ? 1e-6 : 1e-9 * 900.;
      EXPECT_NEAR(added("N"), c.wrench.Fz, tolerance);
      EXPECT_NEAR(added("T"), c.wrench.Fx, tolerance);
      EXPECT_NEAR(added("T2"), c.wrench.Fy, tolerance);
      // M is about -t2, and all are of what the joint does to the block.
      EXPECT_NEAR(added("M"), c.wrench.My, 3. * tolerance);
      EXPECT_NEAR(added("M1"), -c.wrench.Mx, 3. * tolerance);
      EXPECT_NEAR(added("Mn"), -c.wrench.Mz, 3. * tolerance);
    }
}

// Free of forces: a gap that is sawn off lowers the block by it; a block that is heated by 20 K
// grows by α ΔT H.
TEST(SpatialLoads, FreeMotions)
{
  const Json weight = {{"Type", "weight"}, {"Value", "0; 0; -1"}};
  for (const Case &c : cases())
    {
      const bool heated = c.name == std::string("temperature");
      if (!heated && c.name != std::string("imposed gap"))
        continue;
      const SceneRun run =
        run_scene(block(weight, c.load), {"Joints/base/Friction coefficient=1e-6"});
      const std::size_t last = run.monitors.rows.size() - 1;
      EXPECT_NEAR(run.monitors.number(last, "uz") - run.monitors.number(last - 1, "uz"),
                  heated ? 1e-4 * 20. * H : -0.01,
                  1e-6);
    }
}
