// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <fuga/base/errors.h>
#include <fuga/bodies/program/load_program.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  constexpr double height = 10., slope = 0.4, crest = 3.;

  /** A dam whose face x = 0.4 y the water presses down; the crest is 3 m wide. Seven faces. */
  BlockMesh
  dam_mesh(const bool triangles)
  {
    BlockMesh mesh(triangles);
    mesh.add_block("dam",
                   3,
                   7,
                   [](double s, double r) {
                     const double y = height * r * (0.6 + 0.4 * r), right = 9. - 0.2 * y;
                     return std::array<double, 2>{{slope * y + (right - slope * y) * s, y}};
                   },
                   {{"base", "downstream", "crest", "face"}});
    return mesh;
  }

  ModelDefinition
  dam_model(const unsigned int degree, const std::vector<std::string> &wet)
  {
    ModelDefinition model;
    model.polynomial_degree = degree;
    add_material(model, "dam", 3000., 0.2, 24.);
    hold(model, "base", "xy");
    hold(model, "downstream", "");
    LoadDefinition load;
    load.name    = "water";
    load.kind    = LoadKind::depth_pressure;
    load.targets = wet;
    model.loads.push_back(load);
    if (wet.size() == 1)
      hold(model, "crest", "");
    return model;
  }

  /** Force and moment about the origin of nodal forces. */
  std::array<double, 3>
  resultant(const CondensedSystem<2> &system, const Vector &forces)
  {
    std::array<double, 3> sum{};
    for (unsigned int node = 0; node < system.discretization().n_nodes(); ++node)
      {
        const auto &x = system.discretization().position(node);
        sum[0] += forces[2 * node];
        sum[1] += forces[2 * node + 1];
        sum[2] += x[0] * forces[2 * node + 1] - x[1] * forces[2 * node];
      }
    return sum;
  }

  class WaterOnSlope : public testing::TestWithParam<Kind>
  {
  protected:
    const BlockMesh mesh = dam_mesh(GetParam().triangles);

    /** Against ∫ p dy and ∫ p y dy: on the slope dF = p (1, -0.4) dy at (0.4 y, y). */
    void
    expect(const DepthPressure &pressure, const double force, const double first_moment) const
    {
      ModelDefinition model = dam_model(GetParam().degree, {"face"});
      model.loads[0].depth  = pressure;
      const CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
      const auto sum = resultant(system, system.assemble_load(0, 0.).forces);
      // Rounding of sums of a few hundred terms.
      const double tolerance = 1e-12 * (std::abs(force) + std::abs(first_moment));
      EXPECT_NEAR(sum[0], force, tolerance) << pressure.level;
      EXPECT_NEAR(sum[1], -slope * force, tolerance) << pressure.level;
      EXPECT_NEAR(sum[2], -(1. + slope * slope) * first_moment, tolerance) << pressure.level;
    }
  };
} // namespace


// Level below the base, at it, inside faces, at a vertex (r = 4/7), at the crest, above it.
TEST_P(WaterOnSlope, still_water)
{
  const double vertex = height * 4. / 7. * (0.6 + 0.4 * 4. / 7.);
  for (const double h : {-1., 0., 0.3, 3.3, vertex, 9.99, 10., 12.5})
    {
      DepthPressure pressure;
      pressure.level     = std::to_string(h);
      pressure.gradient  = 9.81;
      const double level = std::stod(pressure.level), wet = std::min(std::max(level, 0.), height);
      expect(pressure,
             9.81 * (level * wet - wet * wet / 2.),
             9.81 * (level * wet * wet / 2. - wet * wet * wet / 3.));
    }
}


TEST_P(WaterOnSlope, earth_with_surcharge)
{
  const double K = 0.5, gamma = 20., q = 15., h = 7.123;
  DepthPressure pressure;
  pressure.level     = "7.123";
  pressure.gradient  = K * gamma;
  pressure.surcharge = K * q;
  expect(pressure, K * (gamma * h * h / 2. + q * h), K * (gamma * h * h * h / 6. + q * h * h / 2.));
}


// ∫ √(h-y) dy = 2/3 h^3/2 and ∫ √(h-y) y dy = 4/15 h^5/2, times √H with the bottom 2 m below.
TEST_P(WaterOnSlope, westergaard)
{
  const double r = 7. / 8. * 0.1 * 9.81;
  for (const double h : {0.3, 6.789})
    {
      DepthPressure pressure;
      pressure.level  = h < 1. ? "0.3" : "6.789";
      pressure.root   = r;
      pressure.bottom = -2.;
      expect(pressure,
             r * std::sqrt(h + 2.) * 2. / 3. * std::pow(h, 1.5),
             r * std::sqrt(h + 2.) * 4. / 15. * std::pow(h, 2.5));
    }
}


INSTANTIATE_TEST_SUITE_P(
  Elements,
  WaterOnSlope,
  testing::Values(Kind{false, 1}, Kind{false, 2}, Kind{false, 3}, Kind{true, 1}, Kind{true, 2}),
  testing::PrintToStringParamName());


namespace
{
  /** The dam with water in the second stage, whose level is @p table. */
  ModelDefinition
  rising_model(const std::vector<std::array<double, 2>> &table, const std::string &expression = "")
  {
    ModelDefinition model            = dam_model(1, {"face", "crest"});
    model.loads[0].depth.level_table = table;
    model.loads[0].depth.level       = expression;
    model.loads[0].depth.gradient    = 9.81;
    add_load(model, LoadKind::weight, {}, {});
    model.stages = {{"before", {{1, "t"}}, 1, ""}, {"filling", {{0, "1"}}, 1, ""}};
    return model;
  }

  Vector
  forces_at(const LoadProgram &program, const double t)
  {
    const Vector a = program.history.factors(t);
    Vector sum(program.patterns.front().forces.size(), 0.);
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += a[j] * program.patterns[j].forces[i];
    return sum;
  }
} // namespace


// The level passes the crest at 1.5: 9 uniform knots below, none above, where the pressure is
// linear. Horizontal resultants: γh²/2 at the knots; half-way the chord of a parabola is above it
// by γΔh²/8, the bound of the theory.
TEST(RisingWater, knots)
{
  const BlockMesh mesh        = dam_mesh(false);
  const ModelDefinition model = rising_model({{{1., 0.}}, {{1.5, 10.}}, {{2., 14.}}});
  const CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
  const LoadProgram program = make_load_program(model, system);

  std::vector<double> corners;
  for (double t = 0.; t < 2.; corners.push_back(t))
    t = program.history.next_corner(t);
  ASSERT_EQ(corners.size(), 1u + 9u + 2u);
  EXPECT_EQ(program.patterns.size(), 1u + 11u);
  EXPECT_DOUBLE_EQ(corners[0], 1.);
  EXPECT_DOUBLE_EQ(corners[10], 1.5);
  const double dh = 1.;
  for (unsigned int k = 0; k < 10; ++k)
    {
      const double h = k * dh, t = 1. + 0.05 * k;
      EXPECT_NEAR(resultant(system, forces_at(program, t))[0], 9.81 * h * h / 2., 1e-10);
      EXPECT_NEAR(resultant(system, forces_at(program, t + 0.025))[0],
                  9.81 * ((h + dh / 2.) * (h + dh / 2.) / 2. + dh * dh / 8.),
                  1e-10);
    }
  // Above the crest: exact everywhere, with the water on the crest; 60 m² of dam.
  for (const double t : {1.5, 1.61803, 1.99})
    {
      const double h = 10. + 8. * (t - 1.5);
      const auto sum = resultant(system, forces_at(program, t));
      EXPECT_NEAR(sum[0], 9.81 * (10. * h - 50.), 1e-10);
      EXPECT_NEAR(sum[1] + 24. * 60., -9.81 * (slope * (10. * h - 50.) + crest * (h - 10.)), 1e-10);
    }
  ASSERT_EQ(program.report.size(), 2u);
  expect_message(program.report[0], {"stage 'filling'", "12 knots"});
  expect_message(program.report[1], {"load 'water'", "11 patterns"});
}


// The same knots and loads from an expression; a level that stands still is one pattern.
TEST(RisingWater, expression_and_constant)
{
  const BlockMesh mesh  = dam_mesh(false);
  ModelDefinition model = rising_model({}, "20*(t - 1)");
  const CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
  const LoadProgram program = make_load_program(model, system);
  EXPECT_EQ(program.patterns.size(), 1u + 11u);
  EXPECT_NEAR(resultant(system, forces_at(program, 1.25))[0], 9.81 * 12.5, 1e-10);

  // Not linear: 20 knots and the one where 12 sin(π/2 (t - 1)) passes the crest.
  model.loads[0].depth.level = "12*sin(pi/2*(t - 1))";
  const LoadProgram curved   = make_load_program(model, system);
  const double at_crest      = 1. + 2. / M_PI * std::asin(10. / 12.);
  EXPECT_EQ(curved.patterns.size(), 1u + 21u);
  EXPECT_NEAR(curved.history.next_corner(at_crest - 1e-3), at_crest, 1e-12);

  model.loads[0].depth.level   = "7";
  model.stages[1].histories[0] = {0, "t"};
  const LoadProgram constant   = make_load_program(model, system);
  EXPECT_EQ(constant.patterns.size(), 2u);
  EXPECT_DOUBLE_EQ(constant.history.next_corner(1.), 2.);
  EXPECT_TRUE(constant.report.empty());
}


// Water that stands 5 m high at once is a jump; a level that has reached its height stays one
// pattern in later stages.
TEST(RisingWater, jumps_and_rest)
{
  const BlockMesh mesh  = dam_mesh(false);
  ModelDefinition model = rising_model({{{1., 5.}}, {{2., 8.}}});
  const CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
  try
    {
      make_load_program(model, system);
      ADD_FAILURE() << "accepted";
    }
  catch (const InputError &error)
    {
      expect_message(error.what(),
                     {"load 'water' jumps",
                      "stage 'filling'",
                      "At load time 1 its level is 5:",
                      "begins with '1: LEVEL'"});
    }
  // A table that begins later: its first level holds before.
  model.loads[0].depth.level_table = {{{1.5, 3.}}, {{2., 8.}}};
  try
    {
      make_load_program(model, system);
      ADD_FAILURE() << "accepted";
    }
  catch (const InputError &error)
    {
      expect_message(
        error.what(),
        {"load 'water' jumps",
         "At load time 1 its level is 3, the first one of the table, which begins only "
         "at 1.5:"});
    }
  // A level that stands still, with a history that begins with 1.
  model.loads[0].depth.level_table.clear();
  model.loads[0].depth.level = "7";
  try
    {
      make_load_program(model, system);
      ADD_FAILURE() << "accepted";
    }
  catch (const InputError &error)
    {
      expect_message(error.what(), {"At load time 1 its level is 7:", "for example 'water: t'"});
    }
  model.loads[0].depth.level.clear();
  model.loads[0].depth.level_table = {{{1., 0.}}, {{2., 8.}}};
  model.stages.push_back({"rest", {{1, "1"}}, 1, ""});
  const LoadProgram program = make_load_program(model, system);
  EXPECT_EQ(program.patterns.size(), 1u + 20u);
  EXPECT_DOUBLE_EQ(program.history.next_corner(2.), 3.);
  EXPECT_NEAR(resultant(system, forces_at(program, 2.7))[0], 9.81 * 32., 1e-10);
}


// Above the crest the pressure is linear, but a factor that changes makes it a parabola: knots
// again.
TEST(RisingWater, changing_factor)
{
  const BlockMesh mesh         = dam_mesh(false);
  ModelDefinition model        = rising_model({{{1., 10.}}, {{2., 14.}}});
  model.stages[1].histories[0] = {0, "t"};
  const CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
  const LoadProgram program = make_load_program(model, system);
  EXPECT_DOUBLE_EQ(program.history.next_corner(1.), 1.05);
  EXPECT_NEAR(resultant(system, forces_at(program, 1.5))[0], 0.5 * 9.81 * (10. * 12. - 50.), 1e-10);
}
