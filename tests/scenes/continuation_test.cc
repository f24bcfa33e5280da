// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Blocks that lose their equilibrium and move on (Solver/Beyond limit load = dynamic), by whole
// runs of the program. The weight of the blocks is 1 MN, g = 10 m/s², and they are so stiff that
// they move as rigid bodies do, with the damping α M of Rayleigh's α = 4π ζ f1 f2/(f1 + f2).

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/restarts.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    constexpr double pi = 3.14159265358979324, mass = 0.1, gravity = 10.;
    constexpr const char *problem     = "continuation beyond a limit load";
    constexpr const char *rigid_block = "motion of a rigid block";

    /** 2 m long and 0.5 m high, @p depth m across. */
    GmshMesh
    long_block()
    {
      return block_mesh(uniform(0., 2., 8), uniform(0., 0.5, 2), 2.);
    }

    /** The block on its base, whose strength is @p strength; first the weight, then a pull by as
     * much, both along the axes given. */
    Json
    sliding_block(const Json &strength, const std::string &down, const std::string &along)
    {
      Json scene;
      scene["Bodies"]["block"] = {
        {"Young modulus", 1e6}, {"Poisson ratio", 0.}, {"Weight density", 1.}};
      scene["Joints"]["base"] = {{"Plus lip", "contact"},
                                 {"Minus lip", "rigid"},
                                 {"Normal stiffness", 1e5},
                                 {"Shear stiffness", 1e4}};
      scene["Joints"]["base"].update(strength);
      for (const char *side : {"left", "right", "top", "corner"})
        scene["Boundaries"][side]["Fixed"] = "free";
      scene["Loads"]["weight"]             = {{"Type", "weight"}, {"Value", down}};
      scene["Loads"]["pull"]               = {{"Type", "weight"}, {"Value", along}};
      scene["Stages"]["weight"]            = {{"Loads", "weight: t"}};
      scene["Stages"]["pull"]              = {{"Loads", "pull: t"}, {"Levels", 4}};
      scene["Solver"]["Beyond limit load"] = "dynamic";
      scene["Dynamics"]                    = {{"Time step", 0.002},
                                              {"Gravity", gravity},
                                              {"Damping ratio", 0.001},
                                              {"Damping frequencies", "1; 9"},
                                              {"Excess load", 0.1},
                                              {"Longest continuation", 1.}};
      scene["Output"]["Fields"]            = "never";
      return scene;
    }

    double
    mass_damping(const double ratio)
    {
      return 4. * pi * ratio * 1. * 9. / (1. + 9.);
    }

    /** The way to where a block comes to rest that a force pushes, with damping α m v, and a
     * spring holds behind a gap: classical Runge-Kutta, with steps of its own. */
    double
    way_to_rest(const double push, const double alpha, const double gap, const double spring)
    {
      const auto acceleration = [&](const double x, const double v) {
        return (push - (x > gap ? spring * (x - gap) : 0.)) / mass - alpha * v;
      };
      constexpr double h = 1e-5;
      double x = 0., v = 0.;
      do
        {
          const double v2 = v + 0.5 * h * acceleration(x, v), x2 = x + 0.5 * h * v;
          const double v3 = v + 0.5 * h * acceleration(x2, v2), x3 = x + 0.5 * h * v2;
          const double v4 = v + h * acceleration(x3, v3), x4 = x + h * v3;
          const double dv = acceleration(x, v) + 2. * acceleration(x2, v2) +
                            2. * acceleration(x3, v3) + acceleration(x4, v4);
          x += h / 6. * (v + 2. * v2 + 2. * v3 + v4);
          v += h / 6. * dv;
        }
      while (v > 0.);
      return x;
    }

    /** Its own terms, each computed independently of the others, leave nothing but rounding, and
     * the integration in time takes no more than this share of the largest. */
    void
    expect_closed_ledger(const nlohmann::json &motion, const double tolerance)
    {
      const double largest = motion.at("largest_energy");
      EXPECT_LT(std::abs(motion.at("numerical").get<double>()), tolerance * largest);
      EXPECT_LT(std::abs(motion.at("not_accounted_for").get<double>()), 1e-9 * largest);
    }

    double
    of_joint(const SceneRun &run,
             const std::string &joint,
             const std::string &column,
             const double t)
    {
      for (std::size_t row = 0; row < run.resultants.rows.size(); ++row)
        if (run.resultants.text(row, "joint") == joint && run.resultants.number(row, "t") == t)
          return run.resultants.number(row, column);
      return std::nan("");
    }

    void
    expect_sliding(const SceneRun &run, const double drive)
    {
      ASSERT_EQ(run.exit_code, 3);
      EXPECT_EQ(run.summary.at("verdict"), "limit load");
      EXPECT_LE(run.certificate(), 1e-9);
      const double alpha = mass_damping(0.001), T = 1., a = drive * gravity;
      const nlohmann::json &motion = run.summary.at("continuations").at(0);
      EXPECT_FALSE(motion.at("comes_to_rest"));
      EXPECT_NEAR(motion.at("seconds").get<double>(), T, 1e-9);
      // What the joint's springs and the bodies swing is thousandths.
      expect_answer({problem,
                     "velocity of the slide that does not end [m/s]",
                     a / alpha * (1. - std::exp(-alpha * T)),
                     rigid_block},
                    motion.at("largest_velocity_at_end"),
                    3e-3 * a * T);
      expect_answer({problem,
                     "its slip [m]",
                     a / alpha * (T - (1. - std::exp(-alpha * T)) / alpha),
                     rigid_block},
                    motion.at("largest_slip"),
                    3e-3 * a * T * T / 2.);
      expect_closed_ledger(motion, 1e-3);
    }
  } // namespace

  // P = 0.5 is the limit, and P = 0.6 acts: a = (P - fN)/m.
  TEST(Continuation, SlideThatDoesNotEnd)
  {
    const SceneRun run = run_scene(
      write_scene(long_block(), sliding_block({{"Friction coefficient", 0.5}}, "0; -1", "1; 0")));
    EXPECT_NEAR(run.summary.at("t").get<double>(), 1.5, 1e-9);
    expect_sliding(run, 0.1);
  }

  // In space, on an incline: g (sin a - f cos a) along it, oblique to the axes of the mesh. The
  // weight turns out of the normal of the base.
  TEST(Continuation, SlideDownAnIncline)
  {
    const GmshMesh mesh =
      extruded(block_mesh(uniform(0., 2., 3), uniform(0., 0.5, 1), 2.), uniform(0., 1., 2));
    Json scene = sliding_block({{"Friction coefficient", 0.5}}, "0; -0.8; 0", "0.6; 0; 0");
    scene["Loads"]["pull"]["Value"] = "0.36; 0; 0.48";
    scene["Boundaries"].erase("corner");
    scene["Dimension"]                    = 3;
    scene["Boundaries"]["front"]["Fixed"] = "free";
    scene["Boundaries"]["back"]["Fixed"]  = "free";
    scene["Dynamics"]["Excess load"]      = 1. / 12.;
    const SceneRun run                    = run_scene(write_scene(mesh, scene));
    // Where directions of slip may turn the path ends 2e-6 of a stage before its limit.
    EXPECT_NEAR(run.summary.at("t").get<double>(), 1. + 2. / 3., 2e-6);
    expect_sliding(run, 0.6 * 0.75 - 0.5 * 0.8);
  }

  /** The same block before a spring of 20 MN/m in a gap of 0.05 m. */
  Json
  block_before_a_spring(const Json &strength)
  {
    Json scene              = sliding_block(strength, "0; -1", "1; 0");
    scene["Joints"]["stop"] = {{"Plus lip", "right"},
                               {"Minus lip", "rigid"},
                               {"Normal stiffness", 20. / 0.5},
                               {"Initial gap", 0.05}};
    scene["Boundaries"].erase("right");
    scene["Dynamics"]["Damping ratio"]        = 0.2;
    scene["Dynamics"]["Longest continuation"] = 30.;
    return scene;
  }

  // It slides to the spring, compresses it and sticks there: what the load has done, friction,
  // damping and the spring have.
  TEST(Continuation, SlideOntoASpring)
  {
    const SceneRun run =
      run_scene(write_scene(long_block(), block_before_a_spring({{"Friction coefficient", 0.5}})));
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    const nlohmann::json &motion = run.summary.at("continuations").at(0);
    EXPECT_TRUE(motion.at("comes_to_rest"));
    const double slip = way_to_rest(0.6 - 0.5, mass_damping(0.2), 0.05, 20.);
    expect_answer({problem, "slip onto a spring [m]", slip, rigid_block},
                  motion.at("largest_slip"),
                  3e-3 * slip);
    EXPECT_NEAR(motion.at("friction_work").get<double>(), 0.5 * slip, 3e-3 * 0.5 * slip);
    expect_closed_ledger(motion, 1e-3);
    const auto &kinds = run.summary.at("events").at("by_kind");
    EXPECT_EQ(kinds.at("equilibrium -> motion until rest"), 1);
    EXPECT_EQ(kinds.at("motion until rest -> equilibrium"), 1);
  }

  // Its bond breaks at a pull of 0.5, and nothing is left of its strength: the spring alone carries
  // the pull then, 0.6 at first and 1 at the end of the stage.
  TEST(Continuation, BondThatBreaks)
  {
    const SceneRun run = run_scene(write_scene(
      long_block(), block_before_a_spring({{"Cohesion", 0.25}, {"Bond lost by", "slip"}})));
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    ASSERT_EQ(run.summary.at("continuations").size(), 1u);
    const nlohmann::json &motion = run.summary.at("continuations").at(0);
    EXPECT_TRUE(motion.at("comes_to_rest"));
    EXPECT_NEAR(
      motion.at("t").get<double>(), 1.5, 2e-3); // the ends of the bond break a little earlier
    EXPECT_NEAR(motion.at("friction_work").get<double>(), 0., 1e-3);
    expect_closed_ledger(motion, 1e-3);
    // The bodies shorten by 1e-6 of their length.
    expect_answer({problem,
                   "slip after a bond has broken, under the whole pull [m]",
                   0.05 + 1. / 20.,
                   "statics"},
                  of_joint(run, "base", "largest_slip", 2.),
                  1e-5);
    // Equilibrium alone says this.
    EXPECT_NEAR(of_joint(run, "stop", "N", 2.), -1., 1e-9);
    EXPECT_NEAR(of_joint(run, "base", "T", 2.), 0., 1e-9);
  }

  // A push of 0.6 for 0.2 s leaves the block with a velocity, and on its way to the spring; the
  // slow stage that follows begins when it rests, with the same pull.
  TEST(Continuation, MotionBehindADynamicStage)
  {
    Json scene = block_before_a_spring({{"Friction coefficient", 0.5}});
    scene["Stages"].erase("pull");
    scene["Stages"]["push"]          = {{"Loads", "pull: 0.6"}, {"Duration", 0.2}};
    scene["Stages"]["pull"]          = {{"Loads", "pull: 0.6"}};
    scene["Dynamics"]["Excess load"] = 1e-3;
    const SceneRun run               = run_scene(write_scene(long_block(), scene));
    ASSERT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    const nlohmann::json &motion = run.summary.at("continuations").at(0);
    EXPECT_EQ(motion.at("cause"), "dynamic stage");
    EXPECT_TRUE(motion.at("comes_to_rest"));
    const double slip = way_to_rest(0.6 - 0.5, mass_damping(0.2), 0.05, 20.);
    // The force comes at once: before it slips the block moves on the springs of its base, and N
    // swings.
    expect_answer({problem, "slip in a dynamic stage and after it [m]", slip, rigid_block},
                  of_joint(run, "base", "largest_slip", 3.),
                  6e-3 * slip);
  }

  // A pull of 0.6 that comes at once, in two stages of half a second: the slide of one second from
  // rest, but for the velocity √((0.6² - 0.1²)/(k m)) = 0.013 that the block has when the springs k
  // of its base have come to their strength.
  TEST(Continuation, OneMotionThroughTwoStages)
  {
    Json scene = sliding_block({{"Friction coefficient", 0.5}}, "0; -1", "1; 0");
    scene["Solver"].erase("Beyond limit load");
    scene["Stages"].erase("pull");
    for (const char *stage : {"first", "second"})
      scene["Stages"][stage] = {{"Loads", "pull: 0.6"}, {"Duration", 0.5}};
    const SceneRun run = run_scene(write_scene(long_block(), scene));
    ASSERT_EQ(run.exit_code, 0);
    const double alpha = mass_damping(0.001), a = 0.1 * gravity;
    expect_answer({problem,
                   "slip in two dynamic stages [m]",
                   a / alpha * (1. - (1. - std::exp(-alpha)) / alpha),
                   rigid_block},
                  of_joint(run, "base", "largest_slip", 3.),
                  0.02);
  }

  TEST(Continuation, Restart)
  {
    const std::string file =
      write_scene(long_block(), block_before_a_spring({{"Friction coefficient", 0.5}}));
    EXPECT_GT(restart_everywhere(file, {}, 6), 20u);
  }
} // namespace fuga::tests
