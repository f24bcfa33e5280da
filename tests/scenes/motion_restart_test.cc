// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Restarts within stages in which bodies move: the oracle is the unbroken run, the tolerance is no
// byte.

#include "scenes/grid_mesh.h"
#include "scenes/restarts.h"
#include "scenes/scene_run.h"

#include <fuga/input/read/read_parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace fuga::tests
{
  namespace
  {
    /** Accelerations of a few periods in a quarter of a second [m/s²]. */
    std::string
    write_shaking()
    {
      const std::string file = temporary_directory() + "/shaking.txt";
      std::ofstream stream(file);
      for (int i = 0; i <= 50; ++i)
        stream << fmt::format("{} {}\n", 0.005 * i, 6. * std::sin(0.5 * i));
      return file;
    }

    /** A stiff block that stands on a frictional joint, slides, rocks and swings. */
    std::string
    block_on_joint()
    {
      nlohmann::ordered_json scene;
      scene["Bodies"]["block"] = {
        {"Young modulus", 1e3}, {"Poisson ratio", 0.2}, {"Weight density", 0.024}};
      scene["Joints"]["ground"] = {{"Plus lip", "contact"},
                                   {"Minus lip", "rigid"},
                                   {"Normal law", "rigid"},
                                   {"Shear law", "rigid"},
                                   {"Friction coefficient", 0.3}};
      for (const char *side : {"left", "right", "top", "corner"})
        scene["Boundaries"][side]["Fixed"] = "free";
      scene["Loads"]["weight"]  = {{"Type", "weight"}};
      scene["Stages"]["weight"] = {{"Loads", "weight: t"}};
      scene["Stages"]["quake"]  = {{"Loads", "weight: 1"}, {"Duration", 0.25}, {"Levels", 5}};
      scene["Stages"]["rest"]   = {{"Loads", "weight: 1"}};
      scene["Dynamics"]         = {{"Time step", 0.01},
                                   {"Gravity", 9.81},
                                   {"Damping ratio", 0.02},
                                   {"Damping frequencies", "5; 50"}};
      scene["Earthquake"]       = {{"Record x", write_shaking()}, {"Record unit", "length/s^2"}};
      scene["Monitors"]["top"]["Point"] = "0, 4";
      scene["Output"]                   = {{"Response spectra", "true"}, {"Field interval", 0.03}};
      return write_scene(block_mesh(uniform(0., 2., 4), uniform(0., 4., 4), 2.), scene);
    }

    /** Ground between two columns of a free field over a compliant base. */
    std::string
    ground_in_free_field()
    {
      nlohmann::ordered_json scene;
      scene["Bodies"]["block"] = {
        {"Young modulus", 100.}, {"Poisson ratio", 0.25}, {"Weight density", 0.02}};
      scene["Boundaries"]["left"]["Fixed"]    = "x";
      scene["Boundaries"]["right"]["Fixed"]   = "x";
      scene["Boundaries"]["contact"]["Fixed"] = "all";
      scene["Boundaries"]["top"]["Fixed"]     = "free";
      scene["Boundaries"]["corner"]["Fixed"]  = "free";
      scene["Loads"]["weight"]                = {{"Type", "weight"}};
      scene["Stages"]["weight"]               = {{"Loads", "weight: t"}};
      scene["Stages"]["quake"]                = {{"Loads", "weight: 1"}, {"Duration", 0.25}};
      scene["Dynamics"]                       = {{"Time step", 0.01}, {"Gravity", 9.81}};
      scene["Earthquake"]                     = {{"Record x", write_shaking()},
                                                 {"Record y", write_shaking()},
                                                 {"Record unit", "length/s^2"},
                                                 {"Record motion", "upward wave"},
                                                 {"Compliant base", "contact"},
                                                 {"Free field", "left, right"}};
      scene["Monitors"]["top"]["Point"]       = "5, 10";
      return write_scene(block_mesh(uniform(0., 10., 4), uniform(0., 10., 4), 10.), scene);
    }
  } // namespace

  // Every step has a checkpoint, and events halve some.
  TEST(MotionRestart, BlockThatSlides)
  {
    EXPECT_GT(restart_everywhere(block_on_joint(), {}, 12), 25u);
  }

  // At levels only; what is after the last one is done again.
  TEST(MotionRestart, FromLevels)
  {
    Parameters parameters =
      read_parameters(block_on_joint(), {"Output/Log=quiet", "Output/Checkpoint=levels"});
    const std::string directory = parameters.output.directory = temporary_directory();
    const auto run                                            = [&]() {
      return run_all_phases<2>(std::make_unique<const Model<2>>(parameters));
    };
    EXPECT_EQ(run(), ExitCode::done);
    const Results expected = results(directory);
    for (std::size_t level = 2; level <= 5; ++level)
      {
        run_until(parameters, level);
        EXPECT_EQ(run_rest(parameters), ExitCode::done);
        EXPECT_EQ(differences(expected, results(directory)), "") << "level " << level;
      }
  }

  // How long steps along curves may be depends on what the path has stored and lost before.
  TEST(MotionRestart, NonlinearLayer)
  {
    EXPECT_GT(restart_everywhere(block_on_joint(),
                                 {"Joints/ground/Normal law=cubic root",
                                  "Joints/ground/Thickness=1e-3",
                                  "Joints/ground/Normal compliance=1e-3"},
                                 12),
              25u);
  }

  // The columns of the free field go on as well.
  TEST(MotionRestart, FreeField)
  {
    EXPECT_GT(restart_everywhere(ground_in_free_field(), {}, 6), 25u);
  }
} // namespace fuga::tests
