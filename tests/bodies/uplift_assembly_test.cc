// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <fuga/base/errors.h>
#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/bodies/program/load_program.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace fuga;
using namespace fuga::test;

namespace
{
  /** A block on a rigid plane that falls from (0, 2) to (6, 0.5); five faces of different lengths.
   */
  class WaterInJoint : public testing::TestWithParam<Kind>
  {
  protected:
    static constexpr double top = 2., bottom = 0.5, gamma = 9.81;
    const double length = std::hypot(6., top - bottom);
    BlockMesh mesh{GetParam().triangles};
    ModelDefinition model;

    WaterInJoint()
    {
      mesh.add_block("block",
                     5,
                     2,
                     [](double s, double r) {
                       const double x = 6. * s * (0.7 + 0.3 * s);
                       return std::array<double, 2>{{x, top - (top - bottom) * x / 6. + 4. * r}};
                     },
                     {{"lip", "free", "free", "free"}});
      mesh.add_joint("base", "lip", "");
      model.polynomial_degree = GetParam().degree;
      model.thickness         = 2.;
      add_material(model, "block", 3000., 0.2, 24.);
      hold(model, "free", "");
      LoadDefinition load;
      load.name           = "uplift";
      load.kind           = LoadKind::uplift;
      load.targets        = {"base"};
      load.depth.gradient = gamma;
      model.loads.push_back(load);
    }

    LoadDefinition &
    load()
    {
      return model.loads[0];
    }

    /** Σ w and Σ w s of forces per bar, s the distance from (0, 2). */
    static std::array<double, 2>
    sums(const CondensedSystem<2> &system, const Vector &forces)
    {
      std::array<double, 2> sum{};
      for (const ContactElement &element : system.elements())
        {
          sum[0] += forces[element.normal_bar];
          sum[1] +=
            forces[element.normal_bar] * std::hypot(element.position[0], element.position[1] - top);
        }
      return sum;
    }
  };
} // namespace


// Trapezoids: u from γ(h - 2) to the tailwater's γ(1.3 - 0.5), and by the drain at 1.5 m in
// between.
TEST_P(WaterInJoint, closed)
{
  load().depth.level            = "7";
  load().uplift.has_tailwater   = true;
  load().uplift.tailwater.level = "1.3";
  for (const double drain : {0., 1.5})
    {
      load().uplift.drain_distance   = drain;
      load().uplift.drain_efficiency = 0.6;
      const CondensedSystem<2> system(mesh.mesh, model, {false}, Condensation::with_loads);
      const LoadPattern pattern = system.assemble_load(0, 0.);
      const double up = gamma * 5., down = gamma * 0.8;
      const double inside           = down + 0.4 * (1. - drain / length) * (up - down);
      const std::array<double, 3> s = {{0., drain, length}};
      const std::array<double, 3> u = {{up, drain > 0. ? inside : up, down}};
      double force = 0., moment = 0.;
      for (unsigned int i = 0; i < 2; ++i)
        {
          const double l = s[i + 1] - s[i];
          force += 2. * l * (u[i] + u[i + 1]) / 2.;
          moment += 2. * l * (s[i] * (u[i] + u[i + 1]) / 2. + l * (u[i] / 6. + u[i + 1] / 3.));
        }
      const auto sum = sums(system, pattern.closed_water);
      EXPECT_NEAR(sum[0], force, 1e-12 * force) << drain;
      EXPECT_NEAR(sum[1], moment, 1e-12 * moment) << drain;
      // On the bodies it acts along the normal (1.5, 6)/length, upwards.
      double x = 0., y = 0.;
      for (std::size_t i = 0; i < pattern.forces.size(); i += 2)
        {
          x += pattern.forces[i];
          y += pattern.forces[i + 1];
        }
      EXPECT_NEAR(x, force * 1.5 / length, 1e-12 * force);
      EXPECT_NEAR(y, force * 6. / length, 1e-12 * force);
    }
}


// A load that jumps says which of its waters stands above the joint, which falls from 2 to 0.5.
TEST_P(WaterInJoint, jumps)
{
  load().uplift.has_tailwater = true;
  model.stages                = {{"water", {{0, "1"}}, 1, ""}};
  struct Case
  {
    std::string level, tailwater, told, not_told;
  };
  for (const auto &[level, tailwater, told, not_told] :
       {Case{"0.4 + 4*t", "0.3", "", "jumps"},
        Case{"0.4 + 4*t", "1.3", "its tailwater stands at 1.3: what lies below", "its level is"},
        Case{"7", "0.3", "its level is 7: what lies below", "its tailwater stands"},
        Case{"7 + t",
             "1.3",
             "its level is 7, and its tailwater stands at 1.3",
             "'Level' that begins"}})
    {
      load().depth.level            = level;
      load().uplift.tailwater.level = tailwater;
      const CondensedSystem<2> system(mesh.mesh, model, {false}, Condensation::with_loads);
      std::string message;
      try
        {
          make_load_program(model, system);
        }
      catch (const InputError &error)
        {
          message = error.what();
        }
      EXPECT_EQ(message.empty(), told.empty()) << message;
      EXPECT_NE(message.find(told), std::string::npos) << message;
      EXPECT_EQ(message.find(not_told), std::string::npos) << message;
    }
}


// A level inside the joint, and no tailwater: nothing where it is closed; where it is open the
// triangle of still water in the wet part, which ends within a face.
TEST_P(WaterInJoint, opening)
{
  load().depth.level = "1.123";
  const CondensedSystem<2> system(mesh.mesh, model, {false}, Condensation::with_loads);
  const LoadPattern pattern = system.assemble_load(0, 0.);
  EXPECT_EQ(sums(system, pattern.closed_water)[0], 0.);
  const double d = 1.123 - bottom, wet = d * length / (top - bottom);
  const double force = 2. * gamma * d * wet / 2.;
  const auto sum     = sums(system, pattern.opening_water);
  // Shape functions of degree 2 and 3 are negative in a part of the face at the water line. No
  // element gets a negative force: the sum is too large by a share of what acts on this one face.
  const double excess = GetParam().degree == 1 ? 1e-12 : 0.02;
  EXPECT_GE(sum[0], force * (1. - 1e-12));
  EXPECT_LE(sum[0], force * (1. + excess));
  EXPECT_NEAR(sum[1], force * (length - wet / 3.), excess * force * length);
  EXPECT_EQ(system.uplift(0).levels_of_kinks(), (std::vector<double>{bottom, top}));
}


// Both together are the pressure of the reservoir wherever that is more, as here everywhere.
TEST_P(WaterInJoint, full)
{
  load().depth.level    = "7";
  load().uplift.profile = {{{0., 1.}}, {{0.3, 0.2}}, {{1., 0.1}}};
  const CondensedSystem<2> system(mesh.mesh, model, {false}, Condensation::with_loads);
  LoadPattern pattern = system.assemble_load(0, 0.);
  for (std::size_t i = 0; i < pattern.closed_water.size(); ++i)
    pattern.opening_water[i] += pattern.closed_water[i];
  const double u0 = gamma * 5., u1 = gamma * 6.5, l = length;
  const auto sum = sums(system, pattern.opening_water);
  EXPECT_NEAR(sum[0], 2. * l * (u0 + u1) / 2., 1e-11 * l * u1);
  EXPECT_NEAR(sum[1], 2. * l * l * (u0 / 6. + u1 / 3.), 1e-11 * l * l * u1);
}


TEST_P(WaterInJoint, errors)
{
  load().depth.level             = "7";
  load().uplift.drain_distance   = 6.5;
  load().uplift.drain_efficiency = 0.5;
  const CondensedSystem<2> system(mesh.mesh, model, {false}, Condensation::with_loads);
  try
    {
      system.assemble_load(0, 0.);
      ADD_FAILURE() << "no message";
    }
  catch (const InputError &error)
    {
      expect_message(error.what(), {"'uplift'", "drain", "6.5", "'base'", "6.18466"});
    }
  model.loads[0].targets = {"bsae"};
  expect_message(message_of(mesh.mesh, model), {"no joint 'bsae'", "base"});
}


INSTANTIATE_TEST_SUITE_P(
  Kinds,
  WaterInJoint,
  testing::Values(Kind{false, 1}, Kind{false, 2}, Kind{false, 3}, Kind{true, 1}, Kind{true, 2}));
