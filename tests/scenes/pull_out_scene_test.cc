// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// V5 with finite elements: a bar of one row of cells on a rigid base.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr double EA = 1000., k = 4., q = 2., f = 0.5, bar_length = 200.;
} // namespace

// The chain of tests/contact/pull_out_test.cc as one row of linear elements 0.002 high (ν = 0,
// plane stress), pressed by a uniform pressure and pulled in the direction -x. The shear at the
// base acts 0.001 below the middle of the bar, which moves pressure by λ·height = 1.3e-4 of it at
// most; with that the errors of W and u0 are those of the chain (reference/README.md, and (λh)²).
TEST(PullOutScene, LossPerCycle)
{
  const double height = 0.002, lambda = std::sqrt(k / EA);
  const double first_slip = q / lambda, P0 = 3. * first_slip;
  const double W  = 2. * std::pow(P0 - first_slip, 2) * (P0 + 2. * first_slip) / (3. * EA * q);
  const double u0 = P0 * P0 / (2. * EA * q) + q / (2. * k), a = P0 / q - 1. / lambda;
  for (const auto &[n, printed_error] : {std::pair(100, 7.6e-4), {200, 3.3e-4}, {400, 5.8e-5}})
    {
      nlohmann::ordered_json scene;
      scene["Mesh"]["Assumption"]   = "plane stress";
      scene["Bodies"]["block"]      = {{"Young modulus", EA / height}, {"Poisson ratio", 0.}};
      scene["Joints"]["base"]       = {{"Plus lip", "contact"},
                                       {"Minus lip", "rigid"},
                                       {"Normal law", "rigid"},
                                       {"Shear stiffness", k},
                                       {"Friction coefficient", f}};
      scene["Boundaries"]["right"]  = {{"Fixed", "free"}};
      scene["Boundaries"]["corner"] = {{"Fixed", "free"}};
      scene["Loads"]["press"] = {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", q / f}};
      scene["Loads"]["pull"]  = {
         {"Type", "pressure"}, {"Boundaries", "left"}, {"Value", -P0 / height}};
      scene["Stages"]["press"]["Loads"] = "press: t";
      scene["Stages"]["pull"]["Loads"]  = "pull: t";
      scene["Stages"]["back"]["Loads"]  = "pull: 1-2*t";
      scene["Stages"]["forth"]["Loads"] = "pull: 2*t-1";
      const SceneRun run                = run_scene(write_scene(
        block_mesh(uniform(0., bar_length, static_cast<std::size_t>(n)), {0., height}, bar_length),
        scene));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);

      const double digit     = std::pow(10., std::floor(std::log10(printed_error)) - 1.);
      const double tolerance = printed_error + 0.5 * digit + lambda * height;
      const double first = run.resultant("dissipation", 2.), h = bar_length / n;
      const auto expect =
        [&](const char *quantity, const double known, const double ours, const double bound) {
          expect_answer({"V5 pull-out of a bar",
                         fmt::format("{}, finite elements, n = {}", quantity, n),
                         known,
                         "closed form"},
                        ours,
                        bound);
        };
      expect("W per cycle", W, run.resultant("dissipation", 4.) - first, tolerance * W);
      expect("loss of the first loading", W / 4., first, tolerance * W / 4.);
      expect("u0 at 3 P_e",
             u0,
             -run.values("jump_t1", 2.)[0],
             u0 * (std::pow(lambda * h, 2) + lambda * height));
      expect("slip length a at 3 P_e",
             a,
             (static_cast<double>(run.count("slip", 2.)) - 0.5) * h,
             0.5 * h);
      EXPECT_EQ(run.count("slip", 3.), run.count("slip", 2.));
    }
}
