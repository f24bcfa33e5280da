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


// A tower on ground ten thousand times softer, which turns with every lip that moves alone: what S
// says of the forces of the lips holds the full model in equilibrium. As elimination leaves S, its
// rounding is 3e-6 of the largest force.
TEST(SlenderBodies, condensed_stiffness_is_that_of_the_full_model)
{
  BlockMesh mesh;
  mesh.add_block("ground", 16, 2, rectangle(0., 1., -1., 0.), {{"base", "side", "J-", "side"}});
  mesh.add_block("tower", 16, 8, rectangle(0., 1., 0., 64.), {{"J+", "free", "free", "free"}});
  mesh.add_joint("J", "J+", "J-");
  ModelDefinition model;
  add_material(model, "ground", 1e-4 * modulus, 0.2);
  add_material(model, "tower", modulus, 0.2);
  hold(model, "base", "xy");
  hold(model, "side", "x");
  hold(model, "free", "");
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const DenseMatrix &S = system.stiffness();
  for (std::size_t bar = 0; bar < S.n_rows(); ++bar)
    {
      Vector x(S.n_rows(), 0.);
      x[bar]   = 1.;
      x        = system.rigid_part(x).remainder;
      Vector p = multiply(S, x);
      for (double &force : p)
        force *= -1.;
      EXPECT_LT(system.equilibrium_error(system.recover({}, x), p, {}).residual, 1e-10);
    }
}
