// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// V7 with finite elements: two bodies 400 half-widths large and high, with the cylinder as initial
// gap. The boundary adds a curvature of the order of (a/L)²/R = 6e-6/R to that of half-planes.

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
  constexpr const char *problem = "V7 line contact";
  using Json                    = nlohmann::ordered_json;

  /** Fine up to 1.25 a with intervals a/level, then growing. */
  Axis
  contact_axis(const double a, const double size, const int level)
  {
    const double h = a / level;
    return joined(uniform(0., 1.25 * a, static_cast<std::size_t>(5 * level / 4)),
                  growing(1.25 * a, size, h, 1.3));
  }

  double
  ellipse(const double x, const double c)
  {
    return std::sqrt(std::max(0., 1. - x * x / (c * c)));
  }

  struct Roller
  {
    static constexpr double R = 50., half_load = 17500., nu = 0.3, E_upper = 210000.,
                            E_lower = 70000.;
    const double modulus            = 1. / ((1. - nu * nu) * (1. / E_upper + 1. / E_lower));
    const double a                  = std::sqrt(4. * 2. * half_load * R / (M_PI * modulus));
    const double p0                 = 2. * 2. * half_load / (M_PI * a);
  };

  /** a from the second moment, ∫p x² dx = P a²/4, and p0 at the middle, relative to Hertz. */
  std::pair<double, double>
  run_roller(const unsigned int degree, const int level)
  {
    const Roller roller;
    const double size = 400. * roller.a;
    Json scene;
    scene["Mesh"]["Polynomial degree"] = degree;
    scene["Bodies"]["upper"]  = {{"Young modulus", roller.E_upper}, {"Poisson ratio", roller.nu}};
    scene["Bodies"]["lower"]  = {{"Young modulus", roller.E_lower}, {"Poisson ratio", roller.nu}};
    scene["Joints"]["roller"] = {{"Line", "joint"},
                                 {"Plus body", "upper"},
                                 {"Minus body", "lower"},
                                 {"Normal law", "rigid"},
                                 {"Initial gap", "x^2/100"}};
    scene["Boundaries"]["left"]["Fixed"]   = "x";
    scene["Boundaries"]["right"]["Fixed"]  = "free";
    scene["Boundaries"]["bottom"]["Fixed"] = "all";
    scene["Loads"]["press"]                = {
                     {"Type", "pressure"}, {"Boundaries", "top"}, {"Value", roller.half_load / size}};
    scene["Stages"]["press"]["Loads"] = "press: t";
    const SceneRun run =
      run_scene(write_scene(two_blocks_mesh(contact_axis(roller.a, size, level),
                                            growing(0., size, roller.a / level, 1.3)),
                            scene));
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_LE(run.certificate(), 1e-9);
    const Vector x = run.values("x", 1.), N = run.values("N", 1.);
    double moment = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      moment -= N[i] * x[i] * x[i];
    return {2. * std::sqrt(moment / roller.half_load) / roller.a,
            run.values("pressure", 1.)[0] / roller.p0};
  }
} // namespace

// The NAFEMS roller: E = 210000 on 70000, ν = 0.3, R = 50, half load 17500 N/mm, half model without
// friction. Closed forms of Hertz, with their numbers: E* = 57692.3, a = 6.2146, p0 =
// 3585.36. Quadratic elements: both are of second order in h/a (the position of the rim between two
// nodes), p0 with a quarter of the error for half of h; the factors 0.01 and 0.07 of (h/a)² are no
// theory but bounds for the size of a smooth second-order error. Cubic elements at h = a/16: three
// times the effect of the boundary.
TEST(LargeLineContact, NafemsRoller)
{
  const Roller roller;
  EXPECT_NEAR(roller.modulus, 57692.3, 0.05);
  EXPECT_NEAR(roller.a, 6.2146, 0.5e-4);
  EXPECT_NEAR(roller.p0, 3585.36, 0.05);
  double last_error = 0.;
  for (const auto &[degree, level] : {std::pair(2u, 4), {2u, 8}, {2u, 16}, {3u, 16}})
    {
      const auto [a, p0]       = run_roller(degree, level);
      const double h           = 1. / level;
      const std::string mesh   = fmt::format("degree {}, h = a/{}", degree, level);
      const double a_tolerance = degree == 2 ? 0.01 * h * h : 2e-5;
      const double p_tolerance = degree == 2 ? 0.07 * h * h : 2e-5;
      expect_answer({problem, "NAFEMS roller, a [mm], " + mesh, roller.a, "Hertz; NAFEMS"},
                    a * roller.a,
                    a_tolerance * roller.a);
      expect_answer({problem, "NAFEMS roller, p0 [MPa], " + mesh, roller.p0, "Hertz; NAFEMS"},
                    p0 * roller.p0,
                    p_tolerance * roller.p0);
      if (degree == 2 && level > 4)
        {
          EXPECT_NEAR(last_error / (p0 - 1.), 4., 0.5);
        }
      last_error = p0 - 1.;
    }
}

// Cattaneo and Mindlin: two like bodies, moved towards each other and then along each other by
// their outer boundaries, mirror-symmetric, so that P causes no tangential jump and Q no normal one
// (so P stays, to rounding). P and Q are read from the results; c is seen to one interval h = a/16.
TEST(LargeLineContact, CattaneoMindlin)
{
  const double size = 100., R = 50., E = 70000., f = 0.3;
  const double modulus = E / (2. * 0.91);
  const int level      = 16;
  Json scene;
  const Json material                = {{"Young modulus", E}, {"Poisson ratio", 0.3}};
  scene["Mesh"]["Polynomial degree"] = 2;
  scene["Bodies"]["upper"]           = material;
  scene["Bodies"]["lower"]           = material;
  scene["Joints"]["roller"]          = {{"Line", "joint"},
                                        {"Plus body", "upper"},
                                        {"Minus body", "lower"},
                                        {"Normal law", "rigid"},
                                        {"Shear law", "rigid"},
                                        {"Friction coefficient", f},
                                        {"Initial gap", "x^2/100"}};
  for (const char *side : {"left", "right"})
    scene["Boundaries"][side]["Fixed"] = "free";
  for (const char *end : {"bottom", "top"})
    scene["Boundaries"][end]["Fixed"] = "all";
  const auto move = [&](const char *name, const char *boundary, const std::string &value) {
    scene["Loads"][name] = {{"Type", "displacement"}, {"Boundaries", boundary}, {"Value", value}};
  };
  const double down = 0.0325, along = 0.011;
  move("down", "top", fmt::format("0; {}", -down));
  move("up", "bottom", fmt::format("0; {}", down));
  move("right", "top", fmt::format("{}; 0", along));
  move("left", "bottom", fmt::format("{}; 0", -along));
  scene["Stages"]["press"]["Loads"] = "down: t; up: t";
  scene["Stages"]["shear"]          = {{"Loads", "right: t; left: t"}, {"Levels", 10}};
  const SceneRun run                = run_scene(write_scene(
    two_blocks_mesh(both_sides(contact_axis(1., size, level)), growing(0., size, 1. / level, 1.3)),
    scene));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  const double P = -run.resultant("N", 1.), a = std::sqrt(4. * P * R / (M_PI * modulus));
  EXPECT_EQ(run.count("slip", 1.), 0u);
  for (int i = 1; i <= 10; ++i)
    {
      const double t = 1. + 0.1 * i;
      EXPECT_NEAR(-run.resultant("N", t), P, 1e-9 * P);
      const double share = run.resultant("T", t) / (f * P), c = std::sqrt(1. - share);
      // Between the outermost element that sticks and the next one.
      const auto states     = run.states(t);
      const Vector x        = run.values("x", t);
      std::size_t outermost = 0;
      for (std::size_t k = 0; k < x.size(); ++k)
        if (states[k] == "stick")
          outermost = k;
      const double found = 0.5 * (x[outermost] + x[outermost + 1]) / a;
      if (i % 5 == 0)
        expect_answer({problem,
                       fmt::format("c/a at Q = {:.3f} fP, finite elements, h = a/{}", share, level),
                       c,
                       "Cattaneo, Mindlin"},
                      found,
                      1. / level);
      else
        EXPECT_NEAR(found, c, 1. / level) << t;
    }
  const double share = run.resultant("T", 2.) / (f * P), c = std::sqrt(1. - share);
  const double q0 = f * 2. * P / (M_PI * a);
  const Vector x = run.values("x", 2.), q = run.values("shear1", 2.), A = run.values("area", 2.);
  double difference = 0., norm = 0.;
  for (std::size_t k = 0; k < x.size(); ++k)
    {
      const double exact = q0 * (ellipse(x[k], a) - c * ellipse(x[k], c * a));
      difference += A[k] * std::pow(q[k] - exact, 2);
      norm += A[k] * exact * exact;
    }
  // As wide as √-shaped rims of q are wrong, of first order in h/a: a quarter of it.
  EXPECT_LE(std::sqrt(difference / norm), 0.25 / level);
}
