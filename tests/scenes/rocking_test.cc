// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// A slender block that rocks: the arm of its weight shrinks as it turns.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace fuga::tests
{
  namespace
  {
    constexpr double width = 1., height = 4., gravity = 9.81, weight_density = 0.024;
    /** Then the forces on every node and body are judged as well. */
    const std::vector<std::string> with_fields = {"Output/Fields=levels"};
    constexpr double pulse = 0.5, length_of_pulse = 0.3, sample = 0.001;
    // The record falls to zero within a sample: as if it did in its middle.
    constexpr double end_of_pulse = length_of_pulse + 0.5 * sample;

    /** Of the rotation about a corner, m (b² + h²)/3 θ̈ = m g (h/2) (θ - b/h) [1/s]. */
    double
    rate()
    {
      return std::sqrt(1.5 * gravity * height / (width * width + height * height));
    }

    /** Under a pulse of the acceleration A g by the linear equation of G. W. Housner (The behavior
     * of inverted pendulum structures during earthquakes, Bull. Seism. Soc. Am. 53, 1963), whose
     * cosines are one: θ̈ = p²(θ - b/h + A) from rest, then p²(θ - b/h). */
    double
    rotation(const double time)
    {
      const double p = rate(), alpha = width / height;
      const double during = std::min(time, end_of_pulse), after = time - during;
      const double theta = (pulse - alpha) * (std::cosh(p * during) - 1.);
      const double speed = (pulse - alpha) * p * std::sinh(p * during);
      return alpha + (theta - alpha) * std::cosh(p * after) + speed / p * std::sinh(p * after);
    }

    /** The same if the arm of the weight remains: θ̈ = p²(A - b/h), then -p² b/h. */
    double
    rotation_of_first_order(const double time)
    {
      const double p = rate(), alpha = width / height;
      const double during = std::min(time, end_of_pulse), after = time - during;
      return p * p *
             ((pulse - alpha) * during * (0.5 * during + after) - 0.5 * alpha * after * after);
    }

    /** Two stages, 'weight' and 'pulse', the second one 1 s long. */
    nlohmann::ordered_json
    rocking_block(const std::string &record)
    {
      nlohmann::ordered_json scene;
      scene["Bodies"]["block"] = {
        {"Young modulus", 1e8}, {"Poisson ratio", 0.}, {"Weight density", weight_density}};
      scene["Joints"]["ground"] = {{"Plus lip", "contact"},
                                   {"Minus lip", "rigid"},
                                   {"Normal stiffness", 1e9},
                                   {"Shear stiffness", 1e9},
                                   {"Friction coefficient", 2.}};
      for (const char *side : {"left", "right", "top", "corner"})
        scene["Boundaries"][side]["Fixed"] = "free";
      scene["Loads"]["weight"]  = {{"Type", "weight"}, {"Value", "0; -1"}};
      scene["Stages"]["weight"] = {{"Loads", "weight: t"}, {"Levels", 1}};
      scene["Stages"]["pulse"]  = {{"Loads", "weight: 1"}, {"Duration", 1.}, {"Levels", 10}};
      scene["Dynamics"]         = {{"Spectral radius", 0.8}};
      scene["Earthquake"]       = {{"Record x", record}, {"Baseline", "keep"}};
      scene["Monitors"]["top"]  = {{"Point", "0, 4"}};
      scene["Mesh"]["Polynomial degree"] = 2;
      return scene;
    }

    std::string
    pulse_record()
    {
      const std::string name = temporary_directory() + "/pulse.txt";
      std::ofstream file(name);
      for (int i = 0; i <= 1000; ++i)
        file << fmt::format("{} {}\n", i * sample, i * sample <= length_of_pulse ? pulse : 0.);
      return name;
    }
  } // namespace

  /** With what second order, in how many dimensions. */
  class Rocking : public testing::TestWithParam<std::pair<std::string, int>>
  {
  };

  // The block takes 0.07 ms to stand on its corner alone. By then it has 0.87/s² times that of
  // speed too much, as its weight has less of an arm while it stands on more: 1e-4 rad in the end.
  TEST_P(Rocking, UnderAPulse)
  {
    const auto [second_order, dimension] = GetParam();
    nlohmann::ordered_json scene         = rocking_block(pulse_record());
    scene["Dynamics"]["Second order"]    = second_order;
    GmshMesh mesh = block_mesh(uniform(-width / 2., width / 2., 2), uniform(0., height, 8), 0.5);
    if (dimension == 3)
      {
        mesh               = extruded(mesh, {0., 0.5});
        scene["Dimension"] = 3;
        for (const char *side : {"back", "front"})
          scene["Boundaries"][side]["Fixed"] = "free";
        scene["Boundaries"].erase("corner");
        scene["Monitors"]["top"]["Point"] = "0, 4, 0.5";
        scene["Loads"]["weight"]["Value"] = "0; -1; 0";
      }
    const SceneRun run = run_scene(write_scene(mesh, scene), with_fields);
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    constexpr double tolerance = 1.2e-4;
    const auto exact           = second_order == "weight" ? rotation : rotation_of_first_order;
    double found               = 0.;
    for (std::size_t row = 0; row < run.monitors.rows.size(); ++row)
      if (const double time = run.monitors.number(row, "t") - 1.; time > 0.)
        {
          found = -run.monitors.number(row, "ux") / height;
          EXPECT_NEAR(found, exact(time), tolerance) << time;
        }
    expect_answer({"D9 rocking block",
                   fmt::format("rotation 1 s after the pulse began, in {}D{}",
                               dimension,
                               second_order == "weight" ? "" : ", of first order"),
                   exact(1.),
                   "closed form (Housner 1963)"},
                  found,
                  tolerance);
  }

  namespace
  {
    /** What a block does that a pulse tilts, that turns, falls back and rocks about its other
     * corner. */
    struct Rock
    {
      double largest = 0., turns_at = 0., strikes_at = 0.;
      /** Behind the strike, to the other side. */
      double largest_behind = 0.;
    };

    constexpr double alpha = width / height;

    /** On @p xs, with an initial gap. */
    Rock
    rock_of(const Axis &xs, const std::string &gap)
    {
      constexpr double duration                = 2.;
      nlohmann::ordered_json scene             = rocking_block(pulse_record());
      scene["Dynamics"]["Second order"]        = "weight";
      scene["Stages"]["pulse"]["Duration"]     = duration;
      scene["Joints"]["ground"]["Initial gap"] = gap;
      const SceneRun run =
        run_scene(write_scene(block_mesh(xs, uniform(0., height, 8), 0.5), scene), with_fields);
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      Rock rock;
      for (std::size_t row = 0; row < run.monitors.rows.size(); ++row)
        {
          const double time  = (run.monitors.number(row, "t") - 1.) * duration;
          const double theta = -run.monitors.number(row, "ux") / height;
          if (theta > rock.largest)
            {
              rock.largest  = theta;
              rock.turns_at = time;
            }
          if (theta < 0. && rock.strikes_at == 0. && rock.largest > 0.01)
            rock.strikes_at = time;
          rock.largest_behind = std::max(rock.largest_behind, -theta);
        }
      return rock;
    }
  } // namespace

  // From its largest rotation θ0 the block reaches the ground after arcosh(1/(1 - θ0/α))/p (Housner
  // 1963, his quarter period). The rows are a step of 1 ms apart.
  TEST(RockingBlock, FallsBack)
  {
    const Rock rock = rock_of(uniform(-width / 2., width / 2., 2), "0");
    expect_answer({"D9 rocking block",
                   "quarter period [s]",
                   std::acosh(1. / (1. - rock.largest / alpha)) / rate(),
                   "closed form (Housner 1963)"},
                  rock.strikes_at - rock.turns_at,
                  1.5e-3);
  }

  // A rigid block that strikes with its corner alone, as its base is hollow, keeps the moment of
  // momentum about it, and e = 1 - 3/2 sin²(arctan α) of its speed, so that it turns next at
  // (1 - θ1/α)² = 1 - e² (1 - (1 - θ0/α)²). This elastic one springs back a little.
  TEST(RockingBlock, Strikes)
  {
    const Rock rock     = rock_of({-0.5, -0.48, 0.48, 0.5}, "if(abs(x) < 0.49, 0.01, 0)");
    const double before = 1. - rock.largest / alpha;
    const double behind = 1. - rock.largest_behind / alpha;
    expect_answer({"D9 rocking block",
                   "share of the speed that a strike leaves",
                   1. - 1.5 * width * width / (width * width + height * height),
                   "closed form for a rigid block (Housner 1963)"},
                  std::sqrt((1. - behind * behind) / (1. - before * before)),
                  0.02);
  }

  INSTANTIATE_TEST_SUITE_P(All,
                           Rocking,
                           testing::Values(std::pair<std::string, int>("none", 2),
                                           std::pair<std::string, int>("weight", 2),
                                           std::pair<std::string, int>("weight", 3)));
} // namespace fuga::tests
