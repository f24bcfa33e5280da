// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Ground that goes on beside a model.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/incoming_wave.h"

#include <fuga/base/input_errors.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    constexpr double frequency = 5.; // Hz

    /** Soft ground, the body `upper`, on ground in which waves are twice as fast, `lower`; both 20
     * m high. Sides look along x turned by half a radian, and across. Inside of the layers the grid
     * lines rise by @p slope along the model. */
    GmshMesh
    layered_ground(const double slope)
    {
      constexpr double turn = 0.5, height = 20.;
      GmshMesh mesh =
        extruded(two_blocks_mesh(uniform(0., 4., 2), uniform(0., height, 20)), uniform(0., 2., 1));
      for (auto &[x, y, z] : mesh.vertices)
        {
          const double inside               = std::abs(y) / height * (1. - std::abs(y) / height);
          const std::array<double, 3> place = {{x, -z, y + slope * x * inside}};
          x                                 = std::cos(turn) * place[0] - std::sin(turn) * place[1];
          y                                 = std::sin(turn) * place[0] + std::cos(turn) * place[1];
          z                                 = place[2];
        }
      return mesh;
    }

    Json
    scene_in_space(const std::string &record, const double duration)
    {
      Json scene;
      scene["Dimension"]       = 3;
      scene["Bodies"]["upper"] = rock();
      scene["Bodies"]["lower"] = rock(2.);
      scene["Joints"]["bond"]  = {{"Line", "joint"},
                                  {"Plus body", "upper"},
                                  {"Minus body", "lower"},
                                  {"Normal stiffness", 1e5},
                                  {"Shear stiffness", 1e5},
                                  {"Cohesion", 1e3},
                                  {"Tensile strength", 1e3}};
      for (const char *side : {"left", "right", "front", "back", "top"})
        scene["Boundaries"][side]["Fixed"] = "free";
      scene["Boundaries"]["bottom"]["Fixed"] = "all";
      scene["Mesh"]["Polynomial degree"]     = 2;
      scene["Loads"]["none"]                 = {{"Type", "weight"}};
      scene["Stages"]["quake"]               = {{"Loads", "none: 0"}, {"Duration", duration}};
      scene["Dynamics"]                      = {{"Time step", 0.001}, {"Gravity", 10.}};
      scene["Earthquake"]                    = {{"Record x", record},
                                                {"Record y", record},
                                                {"Record z", record},
                                                {"Record unit", "length/s^2"},
                                                {"Record motion", "upward wave"},
                                                {"Compliant base", "bottom"},
                                                {"Free field", "left, right, front, back"}};
      scene["Monitors"]["surface"]["Point"]  = "0, 0, 20";
      return scene;
    }

    std::string
    message_of(const GmshMesh &mesh, const Json &scene)
    {
      try
        {
          run_scene(write_scene(mesh, scene));
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "none";
    }

    void
    expect_in(const std::string &part, const std::string &message)
    {
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
  } // namespace

  // The ground beside a block moves as the block would if it went on for ever: the surface has
  // twice the wave everywhere. Before, the sides are held and carry what the weight presses on
  // them.
  TEST(FreeField, InThePlane)
  {
    constexpr double height = 40., middle = 0.3, duration = 1.2;
    const std::string record = write_record(
      [](const double t) { return ricker_acceleration(t, frequency, middle); }, 0.0005, 1.);
    Json scene;
    scene["Bodies"]["block"]                = rock();
    scene["Boundaries"]["left"]["Fixed"]    = "x";
    scene["Boundaries"]["right"]["Fixed"]   = "x";
    scene["Boundaries"]["contact"]["Fixed"] = "all";
    scene["Boundaries"]["top"]["Fixed"]     = "free";
    scene["Boundaries"]["corner"]["Fixed"]  = "free";
    scene["Mesh"]["Polynomial degree"]      = 2;
    scene["Loads"]["weight"]                = {{"Type", "weight"}};
    scene["Stages"]["weight"]               = {{"Loads", "weight: t"}};
    scene["Stages"]["quake"]                = {{"Loads", "weight: 1"}, {"Duration", duration}};
    scene["Stages"]["rest"]                 = {{"Loads", "weight: 1"}};
    scene["Dynamics"]                       = {{"Time step", 0.0005}, {"Gravity", 10.}};
    scene["Earthquake"]                     = {{"Record x", record},
                                               {"Record y", record},
                                               {"Record unit", "length/s^2"},
                                               {"Record motion", "upward wave"},
                                               {"Compliant base", "contact"},
                                               {"Free field", "left, right"}};
    scene["Monitors"]["side"]["Point"]      = fmt::format("0, {}", height);
    scene["Monitors"]["middle"]["Point"]    = fmt::format("5, {}", height);
    const SceneRun run =
      run_scene(write_scene(block_mesh(uniform(0., 10., 4), uniform(0., height, 40), 10.), scene));
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    for (const char *monitor : {"side", "middle"})
      for (const bool shear : {true, false})
        {
          const double c       = shear_speed * (shear ? 1. : std::sqrt(3.));
          const double modulus = rock_density * c * c;
          const double settlement =
            shear ? 0. : -10. * rock_density * height * height / 2. / modulus;
          double worst = 0.;
          for (const auto &[t, u] : steps_of_monitor(run, monitor, shear ? "ux" : "uy", duration))
            worst = std::max(
              worst,
              std::abs(u - settlement - 2. * ricker(t - duration, frequency, middle + height / c)));
          expect_answer({"free field",
                         fmt::format("largest error of the {} wave at the surface, {} of the model",
                                     shear ? "shear" : "pressure",
                                     monitor),
                         0.,
                         "closed form (d'Alembert)"},
                        worst,
                        2e-3);
        }
  }

  // By d'Alembert's method a wave that comes up through ground of the impedance Z1 goes on into the
  // layer above, of Z2, with t = 2 Z1 / (Z1 + Z2) of its size, and what its surface throws back
  // comes up again with r = (Z2 - Z1) / (Z2 + Z1) of it: the surface has 2 t Σ r^n u(t - t1 -
  // (2n + 1) t2). The time step delays and widens the waves: (ωh)²/24 of their way.
  TEST(FreeField, InSpace)
  {
    constexpr double middle = 0.3, duration = 1.2, height = 20.;
    const Json scene = scene_in_space(
      write_record(
        [](const double t) { return ricker_acceleration(t, frequency, middle); }, 0.0005, 1.),
      duration);
    for (const double slope : {0., 0.3})
      {
        const SceneRun run = run_scene(write_scene(layered_ground(slope), scene));
        ASSERT_EQ(run.exit_code, 0);
        EXPECT_LE(run.certificate(), 1e-9);
        for (const char *component : {"ux", "uy", "uz"})
          {
            const double c = shear_speed * (component[1] == 'z' ? std::sqrt(3.) : 1.);
            double worst   = 0.;
            for (const auto &[t, u] : steps_of_monitor(run, "surface", component, duration))
              {
                double expected = 0., share = 8. / 3.;
                for (unsigned int n = 0; n < 8; ++n, share *= -1. / 3.)
                  expected +=
                    share *
                    ricker(t, frequency, middle + height / (2. * c) + (2 * n + 1) * height / c);
                worst = std::max(worst, std::abs(u - expected));
              }
            expect_answer({"free field",
                           fmt::format("largest error of {} at the surface of a layer in space, "
                                       "rows of faces that rise {:g} m",
                                       component,
                                       slope),
                           0.,
                           "closed form (d'Alembert)"},
                          worst,
                          slope == 0. ? 5e-3 : 1e-2);
          }
      }
  }

  // What is beside the model must be a column: a rectangle, of horizontal layers, on one ground.
  TEST(FreeField, NoColumn)
  {
    const Json scene = scene_in_space(write_record([](double) { return 0.1; }, 0.01, 0.1), 0.1);
    GmshMesh hole    = layered_ground(0.);
    const auto group = [&](const std::string &name) {
      for (const auto &[key, its_name] : hole.physical_names)
        if (its_name == name)
          return key.second;
      return -1;
    };
    const int left = group("left"), top = group("top");
    unsigned int n_of_side = 0;
    for (MeshEntity &face : hole.faces)
      if (face.physical_tag == left && ++n_of_side == 2)
        face.physical_tag = top;
    expect_in("cover 0.975 of the rectangle", message_of(hole, scene));

    // The section through the layers lies flat.
    const GmshMesh beside =
      extruded(two_blocks_mesh(uniform(0., 4., 2), uniform(0., 4., 2)), uniform(0., 20., 2));
    Json turned                            = scene;
    turned["Earthquake"]["Compliant base"] = "front";
    turned["Earthquake"]["Free field"]     = "left, right";
    turned["Monitors"]["surface"]["Point"] = "4, 4, 20";
    expect_in("is layered horizontally", message_of(beside, turned));

    Json rigid = scene;
    rigid["Earthquake"].erase("Compliant base");
    rigid["Earthquake"].erase("Record motion");
    rigid["Boundaries"]["bottom"]["Fixed"] = "x, y";
    expect_in("the free field has no foot", message_of(layered_ground(0.), rigid));
  }
} // namespace fuga::tests
