// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// V7, two like spheres as bodies with the sum of their curvatures as initial gap.

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
  using Json                    = nlohmann::ordered_json;
  constexpr const char *problem = "V7 sphere";
  constexpr double E = 1000., R = 50., f = 0.3, size = 16.;
  constexpr int n_levels = 5;

  /**
   * Halves of two blocks, 32 x 16 x 16 with a contact of the radius 1, moved towards and then along
   * each other by their outer ends, mirror-symmetric: P causes no tangential jump and Q no normal
   * one. Plane of symmetry `front`. Quadratic elements of the size h = 1/@p level under the
   * contact, growing by 1.8^(4/level) from one to the next.
   */
  SceneRun
  run_spheres(const int level)
  {
    const double h = 1. / level, growth = std::pow(1.8, 4. / level);
    const std::size_t n_fine = static_cast<std::size_t>(5 * level + 3) / 4;
    const double fine        = h * static_cast<double>(n_fine);
    const Axis half          = joined(uniform(0., fine, n_fine), growing(fine, size, h, growth));
    Json scene;
    scene["Dimension"]                    = 3;
    scene["Mesh"]["Polynomial degree"]    = 2;
    scene["Bodies"]["upper"]              = {{"Young modulus", E}, {"Poisson ratio", 0}};
    scene["Bodies"]["lower"]              = {{"Young modulus", E}, {"Poisson ratio", 0}};
    scene["Joints"]["spheres"]            = {{"Line", "joint"},
                                             {"Plus body", "upper"},
                                             {"Minus body", "lower"},
                                             {"Normal law", "rigid"},
                                             {"Shear law", "rigid"},
                                             {"Friction coefficient", f},
                                             {"Initial gap", "(x^2 + z^2)/100"}};
    scene["Boundaries"]["front"]["Fixed"] = "z";
    for (const char *side : {"left", "right", "back"})
      scene["Boundaries"][side]["Fixed"] = "free";
    for (const char *end : {"bottom", "top"})
      scene["Boundaries"][end]["Fixed"] = "all";
    const auto move = [&](const char *name, const char *boundary, const char *value) {
      scene["Loads"][name] = {{"Type", "displacement"}, {"Boundaries", boundary}, {"Value", value}};
    };
    move("down", "top", "0; -0.0102; 0");
    move("up", "bottom", "0; 0.0102; 0");
    move("right", "top", "0.0022; 0; 0");
    move("left", "bottom", "-0.0022; 0; 0");
    scene["Stages"]["press"]["Loads"] = "down: t; up: t";
    scene["Stages"]["shear"]          = {{"Loads", "right: t; left: t"}, {"Levels", n_levels}};
    return run_scene(write_scene(
      extruded(two_blocks_mesh(both_sides(half), growing(0., size, h, growth)), half), scene));
  }

  double
  hemisphere(const double r, const double c)
  {
    return std::sqrt(std::max(0., 1. - r * r / (c * c)));
  }

  /** Hertz's contact for the force of a run. */
  struct Contact
  {
    Contact(const SceneRun &run)
      : P(-2. * run.resultant("N", 1.))
      , a(std::cbrt(0.75 * P * R / (0.5 * E)))
      , p0(1.5 * P / (M_PI * a * a))
      , x(run.values("x", 1.))
      , z(run.values("z", 1.))
      , area(run.values("area", 1.))
    {
    }

    double
    radius(const std::size_t k) const
    {
      return std::hypot(x[k], z[k]);
    }

    /** Σ F_k r_k² of the half model: of a pressure P that grows inwards like √(1 - r²/c²) over c
     * it is P c²/5. */
    double
    second_moment(const Vector &forces) const
    {
      double sum = 0.;
      for (std::size_t k = 0; k < x.size(); ++k)
        sum += forces[k] * radius(k) * radius(k);
      return sum;
    }

    double P, a, p0;
    Vector x, z, area;
  };

  /** The shear of one level; returns the error of its distribution, root of mean square. */
  double
  check_ring(const SceneRun &run, const Contact &contact, const int level, const int step)
  {
    const double t = 1. + static_cast<double>(step) / n_levels, h = 1. / level;
    EXPECT_NEAR(-2. * run.resultant("N", t), contact.P, 1e-9 * contact.P);
    const double share = 2. * run.resultant("T", t) / (f * contact.P);
    const double c = std::cbrt(1. - share), q0 = f * contact.p0; // c: over a
    const auto states = run.states(t);
    const Vector T = run.values("T1", t), q = run.values("shear1", t), q2 = run.values("shear2", t);
    double difference = 0., norm = 0.;
    for (std::size_t k = 0; k < T.size(); ++k)
      {
        const double r = contact.radius(k) / contact.a;
        if (states[k] == "stick")
          {
            EXPECT_LE(r, c + 0.5 * h) << t;
          }
        if (states[k] == "slip")
          {
            EXPECT_GE(r, c - 0.5 * h) << t;
          }
        EXPECT_LE(std::abs(q2[k]), 0.02 * q0) << t;
        const double exact = q0 * (hemisphere(r, 1.) - c * hemisphere(r, c));
        difference += contact.area[k] * std::pow(q[k] - exact, 2);
        norm += contact.area[k] * exact * exact;
      }
    // Of f times the pressure over a, less f times that over c with the force c³ P.
    const double moment = contact.second_moment(T) / (0.2 * f * contact.P * contact.a * contact.a);
    expect_answer({problem,
                   fmt::format("c/a at Q = {:.3f} fP, finite elements, h = a/{}", share, level),
                   c,
                   "Cattaneo, Mindlin"},
                  std::pow(1. - moment, 0.2),
                  0.06 * h * h);
    return std::sqrt(difference / norm);
  }
} // namespace

// Hertz: E* = E/2 of both, a³ = 3PR/(4E*), p0 = 3P/(2πa²). Cattaneo and Mindlin, P first and then
// Q: c/a = (1 - Q/fP)^{1/3}, q = f p0 √(1 - r²/a²) - f p0 c/a √(1 - r²/c²) along x, nothing across;
// with ν = 0 this is exact (a tangential load then gives no displacement across it, and the same
// compliance as a normal one). P and Q are read from the results, radii from second moments.
// Errors are of second order in h/a, because rims lie between nodes, with a quarter for the mesh of
// half the cells; 0.02, 0.15, 0.06 of (h/a)² are no theory but bounds for the size of such errors.
// The stick zone is seen to the distance h/2 of the nodes; distributions, √-shaped at two rims, are
// between first and second order. The boundary adds (a/16)³ = 2e-4.
TEST(LargeSpheres, CattaneoMindlin)
{
  double last_p0 = 0.;
  Vector last_errors;
  for (const int level : {2, 4})
    {
      const SceneRun run = run_spheres(level);
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-8);
      EXPECT_EQ(run.count("slip", 1.), 0u);
      const Contact contact(run);
      const double h         = 1. / level;
      const std::string mesh = fmt::format(", two bodies, h = a/{}", level);
      expect_answer({problem, "a" + mesh, contact.a, "Hertz"},
                    std::sqrt(-5. * contact.second_moment(run.values("N", 1.)) / contact.P),
                    0.02 * h * h * contact.a);
      const Vector p   = run.values("pressure", 1.);
      const double top = *std::max_element(p.begin(), p.end());
      expect_answer({problem, "p0" + mesh, contact.p0, "Hertz"}, top, 0.15 * h * h * contact.p0);
      Vector errors;
      for (int step = 1; step <= n_levels; ++step)
        errors.push_back(check_ring(run, contact, level, step));
      if (level > 2)
        {
          EXPECT_NEAR(last_p0 / (top / contact.p0 - 1.), 4., 1.5);
          for (int i = 0; i < n_levels; ++i)
            EXPECT_GT(last_errors[i], 1.5 * errors[i]) << i;
        }
      last_p0     = top / contact.p0 - 1.;
      last_errors = errors;
    }
}
