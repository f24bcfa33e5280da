// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <deal.II/lac/vector.h>

#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::test;

namespace
{
  constexpr double modulus = 1024., height = 4096.;
} // namespace


// A tower of the width 1, whose cells are 1024 high, turns by one and is stretched across by e: all
// coordinates and displacements are short binary fractions. The turn causes no force; the stress E
// e (ν = 0) acts on the two sides. If K took the turn for its own, its rounding would be 1e-6 of
// that.
TEST(SlenderBodies, a_turn_causes_no_force)
{
  BlockMesh mesh;
  mesh.add_block("tower", 4, 4, rectangle(0., 1., 0., height), {{"base", "side", "side", "side"}});
  ModelDefinition model;
  add_material(model, "tower", modulus, 0.);
  hold(model, "base", "xy");
  hold(model, "side", "");
  const CondensedSystem<2> system(mesh.mesh, model, {});
  const auto &space = system.discretization();
  const double e    = 0x1p-20;
  Vector u(space.n_dofs());
  for (unsigned int node = 0; node < space.n_nodes(); ++node)
    {
      u[2 * node]     = e * space.position(node)[0] - space.position(node)[1];
      u[2 * node + 1] = space.position(node)[0];
    }
  const Vector forces = system.elastic_bodies().forces(u);
  for (unsigned int node = 0; node < space.n_nodes(); ++node)
    {
      const double x = space.position(node)[0], y = space.position(node)[1];
      const double of_height = y == 0. || y == height ? height / 8. : height / 4.;
      const double side      = x == 0. ? -1. : x == 1. ? 1. : 0.;
      EXPECT_NEAR(forces[2 * node], side * modulus * e * of_height, 1e-13 * modulus * e * height);
      EXPECT_NEAR(forces[2 * node + 1], 0., 1e-13 * modulus * e * height);
    }
}
