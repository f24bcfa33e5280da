// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Slip in two directions under driven bodies: the tractrix, and torsion of a circular stamp.

#include "known_answer.h"
#include "scenes/disc_mesh.h"
#include "scenes/grid_mesh.h"
#include "scenes/rough_blocks.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fuga;
using namespace fuga::tests;

using Json = nlohmann::ordered_json;

// A bar that was stressed along z until it slipped and is then driven along x: the slip follows
// the tractrix, tan(φ/2) = tan(φ0/2) e^{-x/r}, r = f p/k_t. The upper block, 1 high, ν = 0, is held
// vertically at its sides, so that it shears as a whole, 1/k_t = ρt + 1/G; it is pressed by
// u_y = -δ - p y/E at its sides and its top, δ = p(ρn + 1/E_lower). The lower block is stiff; what
// its sides, which are free, take from the uniform shear is of the order of E/E_lower. Tolerance:
// that, and 1e-9, a hundred times the error of a step of the integrator.
TEST(TurningSlip, BlockFollowsTheTractrix)
{
  constexpr double E = 40., E_lower = 1e10 * E, rho_n = 0.01, rho_t = 0.05, p = 3., f = 0.4;
  constexpr double k_t = 1. / (rho_t + 2. / E), r = f * p / k_t, tolerance = 1e-9;
  for (const auto &[n, degree] : {std::pair(1u, 1u), {3u, 1u}, {2u, 2u}})
    {
      GmshMesh mesh =
        extruded(two_blocks_mesh(uniform(0., 1., n), uniform(0., 1., n)), uniform(0., 1.5, n));
      for (const char *side : {"left", "right", "front", "back"})
        part_above(mesh, side, std::string("upper_") + side);
      Json scene;
      scene["Dimension"]                 = 3;
      scene["Mesh"]["Polynomial degree"] = degree;
      scene["Bodies"]["upper"]           = {{"Young modulus", E}, {"Poisson ratio", 0}};
      scene["Bodies"]["lower"]           = {{"Young modulus", E_lower}, {"Poisson ratio", 0}};
      scene["Joints"]["joint"]           = {{"Line", "joint"},
                                            {"Plus body", "upper"},
                                            {"Minus body", "lower"},
                                            {"Normal compliance", rho_n},
                                            {"Shear compliance", rho_t},
                                            {"Friction coefficient", f}};
      for (const char *side : {"left", "right", "front", "back"})
        {
          scene["Boundaries"][side]["Fixed"]                         = "free";
          scene["Boundaries"][std::string("upper_") + side]["Fixed"] = "y";
        }
      for (const char *end : {"bottom", "top"})
        scene["Boundaries"][end]["Fixed"] = "all";
      const double delta = p * (rho_n + 1. / E_lower);
      add_load(scene,
               "press",
               "displacement",
               "upper_left, upper_right, upper_front, upper_back, top",
               fmt::format("; {:.17g} - {:.17g}*y; ", -delta, p / E));
      add_load(scene, "along_z", "displacement", "top", fmt::format("; ; {:.17g}", -2. * r));
      add_load(scene, "along_x", "displacement", "top", fmt::format("{:.17g}; ; ", 6. * r));
      scene["Stages"]["press"]["Loads"] = "press: t";
      scene["Stages"]["stress"]         = {{"Loads", "along_z: t"}, {"Levels", 4}};
      scene["Stages"]["turn"]           = {{"Loads", "along_x: t"}, {"Levels", 12}};
      const SceneRun run                = run_scene(write_scene(mesh, scene));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-8);
      // Half of the way along z is elastic; t2 = n x t1 = -z.
      const std::size_t n_elements = run.values("N", 1.).size();
      EXPECT_EQ(run.count("stick", 1.25), n_elements);
      const Vector events = run.event_times(0.);
      ASSERT_GE(events.size(), n_elements);
      for (std::size_t k = 0; k < n_elements; ++k)
        EXPECT_NEAR(events[k], 1.5, tolerance);
      double worst = 0.;
      for (int i = 0; i <= 12; ++i)
        {
          const double t = 2. + i / 12., x = 6. * r * i / 12.;
          const double phi = 2. * std::atan(std::exp(-x / r));
          const Vector A = run.values("area", t), N = run.values("N", t), T1 = run.values("T1", t),
                       T2 = run.values("T2", t), slip1 = run.values("slip1", t),
                       slip2 = run.values("slip2", t);
          for (std::size_t k = 0; k < A.size(); ++k)
            worst = std::max({worst,
                              std::abs(N[k] / A[k] + p) / p,
                              std::abs(std::hypot(T1[k], T2[k]) / A[k] - f * p) / p,
                              std::abs(std::atan2(T2[k], T1[k]) - phi),
                              std::abs(slip1[k] - (x - r * std::cos(phi))) / r,
                              std::abs(slip2[k] - (2. * r - r * std::sin(phi))) / r});
          if (i % 4 == 0 && n == 3)
            expect_answer({"Tractrix of a driven block",
                           fmt::format("φ at x = {} r, finite elements", 6 * i / 12),
                           phi,
                           "closed form"},
                          std::atan2(T2[0], T1[0]),
                          tolerance);
        }
      EXPECT_LE(worst, tolerance) << n << " " << degree;
    }
}

namespace
{
  constexpr double a = 2., p_stamp = 3., f_stamp = 0.4, rho_t_stamp = 0.01, H = 1.;

  /** A circular stamp, a wide and H high with ν = 0, pressed with p and turned by @p theta at its
   * top, on a rigid plane. */
  SceneRun
  run_stamp(const double modulus,
            const unsigned int n,
            const unsigned int n_high,
            const double theta,
            const unsigned int levels)
  {
    Json scene;
    scene["Dimension"]                   = 3;
    scene["Bodies"]["stamp"]             = {{"Young modulus", modulus}, {"Poisson ratio", 0}};
    scene["Joints"]["base"]              = {{"Plus lip", "front"},
                                            {"Minus lip", "rigid"},
                                            {"Normal compliance", 0.005},
                                            {"Shear compliance", rho_t_stamp},
                                            {"Friction coefficient", f_stamp}};
    scene["Boundaries"]["back"]["Fixed"] = "x, y";
    scene["Boundaries"]["side"]["Fixed"] = "free";
    scene["Loads"]["press"] = {{"Type", "pressure"}, {"Boundaries", "back"}, {"Value", p_stamp}};
    add_load(
      scene, "turn", "displacement", "back", fmt::format("{:.17g}*y; {:.17g}*x; ", -theta, theta));
    scene["Stages"]["press"]["Loads"] = "press: t";
    scene["Stages"]["turn"]           = {{"Loads", "turn: t"}, {"Levels", levels}};
    return run_scene(write_scene(extruded(disc_mesh(a, n), uniform(0., H, n_high)), scene));
  }

  /** ∫ r min(θ r/ρt, f p) dA over the disc. */
  double
  moment(const double theta)
  {
    const double b = f_stamp * p_stamp * rho_t_stamp / theta;
    return b >= a ? M_PI / 2. * std::pow(a, 4) * theta / rho_t_stamp
                  : 2. * M_PI * f_stamp * p_stamp * (a * a * a / 3. - b * b * b / 12.);
  }
} // namespace

// A stiff stamp turns as a whole: at the angle θ an element at the distance r from the axis carries
// T = A min(θ r/ρt, f p) across its radius, with N = pA; the outermost ones, all at r = a, slip
// first and together, at θ = f p ρt/a. Over the disc M(θ) = 2πfp(a³/3 - b³/12), b = fpρt/θ < a: the
// mesh differs from that with the square of its cells (an inscribed polygon of 8n sides lacks
// 0.1/n² of the area). The body is not rigid: k_t H/G = 2H/(ρt E) = 2e-8 of θ, and about as much
// from cell to cell.
TEST(LargeTorsion, StiffStamp)
{
  constexpr double modulus = 1e8 * H / rho_t_stamp, tolerance = 5e-8;
  const double first = f_stamp * p_stamp * rho_t_stamp / a, theta = 4. * first;
  double last_error = 0.;
  for (const unsigned int n : {2u, 4u})
    {
      const SceneRun run = run_stamp(modulus, n, 1, theta, 8);
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-8);
      const Vector events = run.event_times(0.);
      ASSERT_GE(events.size(), 8u * n);
      for (std::size_t i = 0; i < 8u * n; ++i)
        EXPECT_NEAR((events[i] - 1.) * theta, first, tolerance * first);
      for (int i = 1; i <= 8; ++i)
        {
          const double t = 1. + i / 8., angle = theta * i / 8.;
          const Vector A = run.values("area", t), N = run.values("N", t), x = run.values("x", t),
                       y = run.values("y", t), T1 = run.values("T1", t), T2 = run.values("T2", t);
          double M = 0.;
          for (std::size_t k = 0; k < A.size(); ++k)
            {
              const double radius = std::hypot(x[k], y[k]);
              const double q      = std::min(angle * radius / rho_t_stamp, f_stamp * p_stamp);
              const double c      = radius > 0. ? x[k] / radius : 0.,
                           s      = radius > 0. ? y[k] / radius : 0.;
              EXPECT_NEAR(N[k] / A[k], -p_stamp, tolerance * p_stamp);
              EXPECT_NEAR(T1[k] / A[k], -q * s, tolerance * p_stamp) << k;
              EXPECT_NEAR(T2[k] / A[k], q * c, tolerance * p_stamp) << k;
              M += x[k] * T2[k] - y[k] * T1[k];
            }
          EXPECT_NEAR(-run.resultant("Mn", t), M, 1e-9 * M);
          if (i % 4 == 0)
            expect_answer({"Torsion of a circular stamp",
                           fmt::format("M at θ = {} fpρt/a, stiff, {} cells around", i / 2, 8 * n),
                           moment(angle),
                           "closed form"},
                          M,
                          0.1 / (n * n) * moment(angle));
          if (i == 8)
            {
              const double error = M / moment(angle) - 1.;
              if (n > 2)
                {
                  EXPECT_NEAR(last_error / error, 4., 1.);
                }
              last_error = error;
            }
        }
    }
}

// An elastic stamp as a circular shaft, G = k_t H: until the first slip it twists uniformly, and
// half of the angle of its top is in the joint: first slip at θ = (1 + k_t H/G) f p ρt/a = 2
// fpρt/a. The rim, where it begins, is a polygon on the mesh: errors between first and second
// order, a third at most for half of the cells; the factor 0.2 of 1/n² is a bound for their size.
TEST(LargeTorsion, FirstSlipOfAnElasticShaft)
{
  constexpr double modulus = 2. * H / rho_t_stamp;
  const double first       = 2. * f_stamp * p_stamp * rho_t_stamp / a;
  double last_error        = 0.;
  for (const unsigned int n : {1u, 2u, 4u})
    {
      const SceneRun run  = run_stamp(modulus, n, 2 * n, 1.5 * first, 2);
      const Vector events = run.event_times(0.);
      ASSERT_FALSE(events.empty());
      const double found = (events[0] - 1.) * 1.5 * first;
      expect_answer({"Torsion of a circular stamp",
                     fmt::format("θ of the first slip, elastic, {} cells around", 8 * n),
                     first,
                     "closed form"},
                    found,
                    0.2 / (n * n) * first);
      if (n > 1)
        {
          EXPECT_GT(last_error / (found - first), 3.);
        }
      last_error = found - first;
    }
}

// So stiff a stamp that the digits do not suffice for following its curve: what is written up to
// there obeys Coulomb's law all the same, and nothing is written behind.
TEST(TurningSlip, NothingIsWrittenBehindAFailure)
{
  const SceneRun run =
    run_stamp(1e10 * H / rho_t_stamp, 1, 1, 4. * f_stamp * p_stamp * rho_t_stamp / a, 8);
  for (std::size_t row = 0; row < run.history.rows.size(); ++row)
    {
      const double N = run.history.number(row, "N"), T1 = run.history.number(row, "T1"),
                   T2 = run.history.number(row, "T2");
      EXPECT_LE(std::hypot(T1, T2), f_stamp * std::abs(N) + 1e-6 * p_stamp)
        << run.history.text(row, "t");
    }
}
