// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/warnings/dynamic_data.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

using namespace fuga;

namespace
{
  const double pi = std::acos(-1.);

  /** Ricker's wavelet of the frequency 4 Hz and the peak 0.3 g: velocity and displacement come back
   * to zero. */
  GroundMotion
  wavelet()
  {
    GroundMotion motion;
    motion.step = 0.005;
    for (unsigned int i = 0; i <= 400; ++i)
      {
        const double x = std::pow(pi * 4. * (i * motion.step - 1.), 2);
        motion.accelerations.push_back(0.3 * 9.81 * (1. - 2. * x) * std::exp(-x));
      }
    return motion;
  }

  /** A block and a rock without mass that an earthquake shakes for 2 s. */
  Parameters
  shaken_block()
  {
    Parameters parameters;
    Material block, rock;
    block.body             = "block";
    block.weight_density   = 0.024;
    rock.body              = "rock";
    ModelDefinition &model = parameters.model;
    model.materials        = {block, rock};
    model.stages.resize(2);
    model.stages[1].name            = "quake";
    model.stages[1].duration        = 2.;
    model.dynamics.massless_bodies  = {"rock"};
    model.dynamics.time_step        = 0.005;
    model.dynamics.earthquake_stage = 1;
    model.dynamics.ground[0]        = wavelet();
    model.dynamics.damping_ratio    = 0.05;
    return parameters;
  }

  struct Mistake
  {
    std::string name;
    std::function<void(ModelDefinition &)> make;
    std::vector<std::string> words;
  };

  void
  multiply_record(ModelDefinition &model, const double factor)
  {
    for (double &a : model.dynamics.ground[0].accelerations)
      a *= factor;
  }
} // namespace

TEST(DynamicData, NothingIsSaidOfUsualData)
{
  EXPECT_EQ(implausible_dynamics(shaken_block()), std::vector<std::string>{});
  EXPECT_EQ(implausible_dynamics(Parameters()), std::vector<std::string>{});
  EXPECT_EQ(ground_motion_echo(Parameters()), std::vector<std::string>{});
}

TEST(DynamicData, OneWarningPerMistake)
{
  const std::vector<Mistake> mistakes = {
    {"no inertia",
     [](ModelDefinition &model) { model.dynamics.massless_bodies.clear(); },
     {"Bodies/rock/Weight density = 0", "no inertia", "Dynamics/Massless bodies"}},
    {"damping in percent",
     [](ModelDefinition &model) { model.dynamics.damping_ratio = 0.5; },
     {"Dynamics/Damping ratio = 0.5", "at most 0.2"}},
    {"m/s2 for g",
     [](ModelDefinition &model) { multiply_record(model, 9.81); },
     {"Earthquake/Record x", "2.943 g", "0.005 g to 2 g", "Record unit"}},
    {"g for m/s2",
     [](ModelDefinition &model) { multiply_record(model, 0.01); },
     {"0.003 g", "0.005 g to 2 g"}},
    // 0.01 g more for 2 s: 0.196 m/s and 0.196 m at the end.
    {"baseline",
     [](ModelDefinition &model) {
       for (double &a : model.dynamics.ground[0].accelerations)
         a += 0.01 * 9.81;
     },
     {"velocity of 0.196 m/s", "and 0.196 m from", "parabolic, or keep"}},
    {"time step",
     [](ModelDefinition &model) { model.dynamics.time_step = 0.05; },
     {"Dynamics/Time step = 0.05 s", "Record x", "at most 0.0"}},
    {"short stage",
     [](ModelDefinition &model) { model.stages[1].duration = 1.; },
     {"Record x", "after the end of the stage 'quake', 1 s", "lasts 2 s", "Duration"}},
    {"second order of nothing",
     [](ModelDefinition &model) {
       model.dynamics.second_order = SecondOrder::weight;
       model.stages.erase(model.stages.begin());
       model.dynamics.earthquake_stage = 0;
     },
     {"Dynamics/Second order = weight", "nothing stresses", "stage 'quake'"}}};
  for (const Mistake &mistake : mistakes)
    {
      Parameters parameters = shaken_block();
      mistake.make(parameters.model);
      const std::vector<std::string> warnings = implausible_dynamics(parameters);
      ASSERT_EQ(warnings.size(), 1u) << mistake.name << testing::PrintToString(warnings);
      for (const std::string &word : mistake.words)
        EXPECT_NE(warnings[0].find(word), std::string::npos) << word << " in\n" << warnings[0];
      // A slow stage has no records.
      parameters.model.stages.back().duration = 0.;
      EXPECT_TRUE(implausible_dynamics(parameters).empty());
    }
}

TEST(DynamicData, ALostBaselineMayBeMeant)
{
  Parameters parameters                             = shaken_block();
  parameters.model.dynamics.ground[0].accelerations = Vector(401, 1.);
  EXPECT_EQ(implausible_dynamics(parameters).size(), 1u);
  parameters.model.dynamics.baseline = Baseline::keep;
  EXPECT_TRUE(implausible_dynamics(parameters).empty());
}

// A constant acceleration of 1 m/s² for 2 s: v = 2 m/s, u = 2 m.
TEST(DynamicData, TheMotionOfTheGroundIsTold)
{
  Parameters parameters                             = shaken_block();
  parameters.model.dynamics.gravity                 = 10.;
  parameters.model.dynamics.ground[0].accelerations = Vector(401, 1.);
  const std::vector<std::string> lines              = ground_motion_echo(parameters);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "Motion of the ground from the beginning of stage 'quake'");
  std::istringstream cells(lines[2]);
  std::string cell;
  for (const char *expected : {"x", "401", "0.005", "2", "inf", "0.1", "2", "2", "2", "2"})
    {
      cells >> cell;
      EXPECT_EQ(cell, expected);
    }
}
