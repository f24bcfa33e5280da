// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// A column under uniaxial strain on a rigid obstacle: all of its contact is lost, and found again,
// at one load.

#include "scenes/grid_mesh.h"
#include "scenes/scene_run.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  using Json = nlohmann::ordered_json;

  constexpr double width = 2., height = 3., E = 1000., nu = 0.2;
  /** Pressure per strain with both sides held, E (1-ν)/((1+ν)(1-2ν)). */
  const double modulus = E * (1. - nu) / ((1. + nu) * (1. - 2. * nu));

  struct LawCase
  {
    const char *name;
    Json layer;
    /** The law by itself. */
    std::function<double(double)> stress;
    /** How far the top is moved down first, and up after the contact, as a share of it [m]. */
    double down, up;
  };

  std::ostream &
  operator<<(std::ostream &out, const LawCase &law)
  {
    return out << law.name;
  }

  // A law without stiffness at the touch. How far up the top goes says how the load of the landing
  // is rounded: it is a little short of the touch, or behind it.
  LawCase
  power_2(const char *name, const double up)
  {
    return {name,
            {{"Normal law", "power"},
             {"Normal reference closure", 0.001},
             {"Normal reference stress", 2.},
             {"Normal exponent", 2.}},
            [](const double w) { return 2. * std::pow(w / 1e-3, 2); },
            2e-3,
            up};
  }

  // The table is a straight line below its first inner point, and the top goes no further.
  const LawCase laws[] = {
    {"power_0_5",
     {{"Normal law", "power"},
      {"Normal reference closure", 0.001},
      {"Normal reference stress", 2.},
      {"Normal exponent", 0.5}},
     [](const double w) { return 2. * std::sqrt(w / 1e-3); },
     1e-3,
     0.5},
    power_2("power_2", 0.1),
    power_2("power_2_higher", 0.6),
    {"table",
     {{"Normal law", "tabular"},
      {"Normal table", "0: 0; 1e-3: 1; 3e-3: 7"},
      {"Normal interpolation", "piecewise linear"}},
     [](const double w) { return 1e3 * w; },
     1e-3,
     3.},
    {"expression",
     {{"Normal law", "expression"},
      {"Normal stress expression", "5*(sqrt(1 + w/1e-3) - 1)"},
      {"Normal tangent expression", "2500/sqrt(1 + w/1e-3)"}},
     [](const double w) { return 5. * (std::sqrt(1. + w / 1e-3) - 1.); },
     1e-3,
     1.},
    // Without shear both layers of a coupled one are those of the normal law; the elements at the
    // held sides have no shear bar to be coupled with.
    {"coupled_by_closure",
     {{"Normal stiffness", 1e3},
      {"Shear stiffness grows with", "closure"},
      {"Shear growth closure", 0.01}},
     [](const double w) { return 1e3 * w; },
     1e-3,
     1.},
    {"coupled_by_pressure",
     {{"Normal stiffness", 1e3},
      {"Shear stiffness grows with", "pressure"},
      {"Shear growth pressure", 0.1}},
     [](const double w) { return 1e3 * w; },
     1e-3,
     1.},
    {"cubic_root_tangent",
     {{"Normal law", "cubic root tangent"}, {"Normal compliance", 1e-4}, {"Thickness", 1e-3}},
     [](const double w) {
       const double q = std::cbrt(w / 1e-3);
       return 30. * (-std::log1p(-q) - q - q * q / 2.);
     },
     2e-3,
     1.}};

  /** The closure under which layer and column, in series, are shortened by @p down. */
  double
  closure_of(const LawCase &law, const double down)
  {
    boost::math::tools::eps_tolerance<double> tolerance(50);
    std::uintmax_t n_iterations = 200;
    const auto miss = [&](const double w) { return w + law.stress(w) * height / modulus - down; };
    const double end =
      std::min(down, law.name == std::string("cubic_root_tangent") ? 0.999e-3 : down);
    const auto root = boost::math::tools::toms748_solve(miss, 0., end, tolerance, n_iterations);
    return 0.5 * (root.first + root.second);
  }

  Json
  column(const Json &layer)
  {
    Json scene;
    scene["Bodies"]["block"]                     = {{"Young modulus", E}, {"Poisson ratio", nu}};
    scene["Joints"]["j"]                         = layer;
    scene["Joints"]["j"]["Plus lip"]             = "contact";
    scene["Joints"]["j"]["Minus lip"]            = "rigid";
    scene["Joints"]["j"]["Shear stiffness"]      = 500.;
    scene["Joints"]["j"]["Friction coefficient"] = 0.5;
    for (const char *side : {"left", "right"})
      scene["Boundaries"][side]["Fixed"] = "x";
    scene["Boundaries"]["corner"]["Fixed"] = "free";
    return scene;
  }

  GmshMesh
  column_mesh()
  {
    return block_mesh(uniform(0., width, 3), uniform(0., height, 3), width);
  }

  /** Loads at which an element takes the state; where coupled layers share a load, one may pass
   * through slip at the apex of its cone on the way, at the same load. */
  Vector
  times_of(const SceneRun &run, const std::string &state)
  {
    Vector result;
    for (std::size_t i = 0; i < run.events.rows.size(); ++i)
      if (run.events.text(i, "to") == state)
        result.push_back(run.events.number(i, "t"));
    return result;
  }

  /** Every other event of the run is at one of these loads. */
  void
  expect_no_other_loads(const SceneRun &run, const Vector &loads)
  {
    for (std::size_t i = 0; i < run.events.rows.size(); ++i)
      {
        double nearest = 1.;
        for (const double load : loads)
          nearest = std::min(nearest, std::abs(run.events.number(i, "t") - load));
        EXPECT_LE(nearest, 1e-11);
      }
  }

  class HeldColumn : public testing::TestWithParam<LawCase>
  {
  };
} // namespace

// The top is moved down by u, up by more, and down again. All four elements open as it passes zero
// upwards and close as it passes zero downwards. Pressures: the series of layer and column, solved
// by Boost; the energy of the layer likewise by quadrature, on the way down equal to that on the
// way up (a table's corner is rounded beyond where the top goes). 1e-9 of the stress: the
// certificate's bound; event loads are known to the rounding of the largest displacement.
TEST_P(HeldColumn, LiftsOffAndComesDown)
{
  const LawCase &law                  = GetParam();
  Json scene                          = column(law.layer);
  scene["Boundaries"]["top"]["Fixed"] = "all";
  scene["Loads"]["u"]                 = {
                    {"Type", "displacement"}, {"Boundaries", "top"}, {"Value", fmt::format("; {}", -law.down)}};
  scene["Stages"]["down"]  = {{"Loads", "u: t"}, {"Levels", 10}};
  scene["Stages"]["up"]    = {{"Loads", fmt::format("u: 1 - {}*t", 1. + law.up)}, {"Levels", 10}};
  scene["Stages"]["again"] = {{"Loads", fmt::format("u: {}*(t - 1) + t", law.up)}, {"Levels", 10}};
  const SceneRun run       = run_scene(write_scene(column_mesh(), scene));
  ASSERT_EQ(run.exit_code, 0) << run.summary.dump();
  EXPECT_LE(run.certificate(), 1e-9);

  const double lifts = 1. + 1. / (1. + law.up), lands = 2. + law.up / (1. + law.up);
  EXPECT_EQ(times_of(run, "open").size(), 4u);
  EXPECT_EQ(times_of(run, "stick").size(), 4u);
  for (const double t : times_of(run, "open"))
    EXPECT_NEAR(t, lifts, 1e-11);
  for (const double t : times_of(run, "stick"))
    EXPECT_NEAR(t, lands, 1e-11);
  expect_no_other_loads(run, {lifts, lands});
  EXPECT_EQ(run.count("open", 2.), 4u);
  for (const double g : run.values("gap", 2.))
    EXPECT_NEAR(g, law.up * law.down, 1e-12 * law.down);
  const double w = closure_of(law, law.down), stress = law.stress(w);
  for (const double t : {1., 3.})
    for (const double p : run.values("pressure", t))
      EXPECT_NEAR(p, stress, 1e-9 * stress) << t;
  // Below 1e-6 of its reference closure a root has a polynomial foot, with less energy than σ w
  // there.
  const double foot   = width * law.stress(1e-9) * 1e-9;
  const double stored = width * boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
                                  law.stress, 0., w, 15, 1e-13);
  for (const double t : {1., 3.})
    EXPECT_NEAR(run.resultant("energy_layer", t), stored, 1e-9 * stored + foot) << t;
}

INSTANTIATE_TEST_SUITE_P(Laws, HeldColumn, testing::ValuesIn(laws), [](const auto &law) {
  return law.param.name;
});

namespace
{
  class UnheldColumn : public testing::TestWithParam<LawCase>
  {
  };
} // namespace

// Pressed by p = 0.4 on its top the column sinks by p H/M + w(p); the pressure is taken away, and
// as it turns into a pull nothing holds the column: the limit load is zero, and all four elements
// open.
TEST_P(UnheldColumn, IsLiftedAtNoLoad)
{
  const LawCase &law       = GetParam();
  Json scene               = column(law.layer);
  scene["Loads"]["p"]      = {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", "0.4"}};
  scene["Stages"]["press"] = {{"Loads", "p: t"}, {"Levels", 10}};
  scene["Stages"]["pull"]  = {{"Loads", "p: 1 - 1.01*t"}, {"Levels", 10}};
  const SceneRun run       = run_scene(write_scene(column_mesh(), scene));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.summary.at("verdict"), "limit load");
  EXPECT_NEAR(run.summary.at("t").get<double>(), 1. + 1. / 1.01, 1e-11);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_EQ(times_of(run, "open").size(), 4u);
  expect_no_other_loads(run, {1. + 1. / 1.01});
  for (const double jump : run.values("jump_n", 1.))
    EXPECT_NEAR(law.stress(-jump), 0.4, 1e-9 * 0.4);
}

INSTANTIATE_TEST_SUITE_P(Laws, UnheldColumn, testing::ValuesIn(laws), [](const auto &law) {
  return law.param.name;
});

namespace
{
  // Pressed without shear the layer closes by w = p/k_n = 4e-4 t, to its shear growth closure 2e-4
  // at t = 1/2, where the law ends.
  Json
  pressed_to_the_end_of_its_law()
  {
    Json scene               = column({{"Normal stiffness", 1e3},
                                       {"Shear stiffness grows with", "closure"},
                                       {"Shear growth closure", 2e-4}});
    scene["Loads"]["p"]      = {{"Type", "pressure"}, {"Boundaries", "top"}, {"Value", "0.4"}};
    scene["Stages"]["press"] = {{"Loads", "p: t"}, {"Levels", 10}};
    return scene;
  }

  void
  expect_end_of_law(const SceneRun &run, const double tolerance)
  {
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NEAR(run.summary.at("t").get<double>(), 0.5, tolerance);
    EXPECT_LE(run.certificate(), 1e-9);
    const std::string message = run.summary.at("message");
    for (const char *part :
         {"outside of the law", "element 1 of joint 'j'", "'Shear growth closure' of 0.0002 "})
      EXPECT_NE(message.find(part), message.npos) << message;
  }
} // namespace

// The path follows it until steps of 1e-9 of the stage are too long.
TEST(CoupledColumn, EndsWhereTheLawDoes)
{
  expect_end_of_law(run_scene(write_scene(column_mesh(), pressed_to_the_end_of_its_law())), 4e-9);
}

// The closure w grows steadily beside a free vibration that the beginning of the load leaves, of
// the amplitude w'/omega: the end moves by 1/omega at most, 2e-4 s with the whole mass on the
// layer.
TEST(CoupledColumn, InMotionEndsWhereTheLawDoes)
{
  Json scene                                 = pressed_to_the_end_of_its_law();
  scene["Bodies"]["block"]["Weight density"] = 1e-4;
  scene["Stages"]["press"]["Duration"]       = 1.;
  scene["Dynamics"]                          = {{"Time step", 0.05}, {"Gravity", 10.}};
  expect_end_of_law(run_scene(write_scene(column_mesh(), scene)), 1e-3);
}
