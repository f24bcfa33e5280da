// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// V8: a flat rigid punch, half-width a = 1, half model, ν = 0.3.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr const char *problem = "V8 flat punch";
  constexpr double nu = 0.3, half_load = 1.;

  SceneRun
  run_punch(const Axis &xs,
            const Axis &ys,
            const unsigned int degree,
            const double friction,
            const int n_levels = 1)
  {
    const double size = xs.back();
    nlohmann::ordered_json scene;
    scene["Mesh"]["Polynomial degree"] = degree;
    scene["Bodies"]["block"]           = {{"Young modulus", 1000.}, {"Poisson ratio", nu}};
    scene["Joints"]["punch"]           = {
                {"Plus lip", "contact"}, {"Minus lip", "rigid"}, {"Normal law", "rigid"}};
    if (friction > 0.)
      {
        scene["Joints"]["punch"]["Shear law"]            = "rigid";
        scene["Joints"]["punch"]["Friction coefficient"] = friction;
      }
    scene["Boundaries"]["left"]["Fixed"] = "x";
    for (const char *side : {"right", "bottom_free", "corner"})
      scene["Boundaries"][side]["Fixed"] = "free";
    scene["Loads"]["press"] = {
      {"Type", "pressure"}, {"Boundaries", "top"}, {"Value", half_load / size}};
    scene["Stages"]["press"] = {{"Loads", "press: t"}, {"Levels", n_levels}};
    const SceneRun run       = run_scene(write_scene(block_mesh(xs, ys, 1.), scene));
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    return run;
  }
} // namespace

// c/a of a half-plane by an independent code, to ±0.002 (its elements). The zone is decided
// at the first load and does not depend on P. A body of 4000 a counts as half-plane (its lateral
// strain is of the order a/size of that under the punch). Quadratic elements of 1/256, so nodes
// 1/512 apart: c is seen to half of that.
TEST(LargePunch, StickZone)
{
  const double size = 4000., h = 1. / 256.;
  const Axis ys = growing(0., size, h, 1.15);
  const Axis xs = joined(uniform(0., 1., 256), growing(1., size, h, 1.15));
  for (const double f : {0.2, 0.3, 0.5})
    {
      const SceneRun run = run_punch(xs, ys, 2, f, 10);
      const auto states  = run.states(1.);
      for (int i = 1; i < 10; ++i)
        EXPECT_EQ(run.states(0.1 * i), states) << i;
      for (const double t : run.event_times(-1.))
        EXPECT_EQ(t, 0.);
      const auto first_slip = std::find(states.begin(), states.end(), "slip");
      ASSERT_NE(first_slip, states.begin());
      ASSERT_NE(first_slip, states.end());
      EXPECT_TRUE(std::all_of(
        first_slip, states.end(), [](const std::string &state) { return state == "slip"; }));
      const auto k   = static_cast<std::size_t>(first_slip - states.begin());
      const Vector x = run.values("x", 1.);
      const double c = independent_answers().at("punch").at(fmt::format("{}", f));
      expect_answer({problem, fmt::format("c/a, f = {}", f), c, independent_code},
                    0.5 * (x[k - 1] + x[k]),
                    0.002 + 0.25 * h);
    }
}

// Pressure without friction, p = P/(π√(1 - x²)), and of the bonded punch,
//     [2(1-ν)/√(3-4ν)] P/(π√(1 - x²)) (cos, sin)(η ln((1+x)/(1-x))),  η = ln(3-4ν)/2π,
// for p and q; there q/p < tan(η ln(2/h)) < 2 = f, so every element sticks. Relative L2 error over
// x ≤ 0.8. The edge is singular, and its error does not stay there: the mesh is graded towards it,
// in each refinement with half the interval and the root of the growth, so that the error falls by
// two at least (quadratic elements; four where only the smooth part counts).
TEST(LargePunch, PressureOfFrictionlessAndBonded)
{
  const double size = 40000.;
  for (const double f : {0., 2.})
    {
      double last_error = 1.;
      double growth     = 1.69;
      for (const int n : {32, 64, 128})
        {
          const double h = 1. / n;
          Axis edge      = growing(0., 1., h, growth);
          for (double &x : edge)
            x = 1. - x;
          std::reverse(edge.begin(), edge.end());
          const Axis ys      = growing(0., size, h, growth);
          const SceneRun run = run_punch(joined(edge, growing(1., size, h, growth)), ys, 2, f);
          const Vector x = run.values("x", 1.), A = run.values("area", 1.),
                       p = run.values("pressure", 1.), q = run.values("shear1", 1.);
          EXPECT_EQ(run.count("stick", 1.), x.size());
          const double eta    = std::log(3. - 4. * nu) / (2. * M_PI);
          const double bonded = 2. * (1. - nu) / std::sqrt(3. - 4. * nu);
          double difference = 0., norm = 0.;
          for (std::size_t i = 0; i < x.size() && x[i] <= 0.8; ++i)
            {
              const double flat    = 2. * half_load / (M_PI * std::sqrt(1. - x[i] * x[i]));
              const double angle   = eta * std::log((1. + x[i]) / (1. - x[i]));
              const double p_exact = f > 0. ? bonded * flat * std::cos(angle) : flat;
              const double q_exact = f > 0. ? bonded * flat * std::sin(angle) : 0.;
              difference +=
                A[i] * (std::pow(p[i] - p_exact, 2) + std::pow(std::abs(q[i]) - q_exact, 2));
              norm += A[i] * (p_exact * p_exact + q_exact * q_exact);
            }
          const double error = std::sqrt(difference / norm);
          EXPECT_LE(error, 0.5 * last_error);
          expect_answer({problem,
                         fmt::format("L2 error of the stresses, {}, smallest interval a/{}",
                                     f > 0. ? "bonded" : "frictionless",
                                     n),
                         0.,
                         "closed form"},
                        error,
                        0.02 * 32. / n);
          last_error = error;
          growth     = std::sqrt(growth);
        }
    }
}
