// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Meshes that are refined here and there: lips stay alike, and what linear elements hold exactly is
// held exactly across hanging nodes.

#include "block_mesh.h"
#include "random_refinement.h"

#include <deal.II/lac/vector.h>

#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/joints/joint_geometry.h>
#include <fuga/bodies/program/monitor.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  constexpr unsigned int n_rounds = 4;

  // Width 2, a joint through (1, 1) inclined by alpha, heights 1 and 1.5 in the middle.
  BlockMesh
  column(const double alpha)
  {
    const auto joint = [=](const double s) { return 1. + std::tan(alpha) * (2. * s - 1.); };
    BlockMesh mesh;
    mesh.add_block("lower",
                   4,
                   3,
                   [=](double s, double r) {
                     return std::array<double, 2>{{2. * s, joint(s) * r}};
                   },
                   {{"bottom", "right", "J-", "left"}});
    mesh.add_block("upper",
                   4,
                   2,
                   [=](double s, double r) {
                     return std::array<double, 2>{{2. * s, joint(s) + (2.5 - joint(s)) * r}};
                   },
                   {{"J+", "right", "top", "left"}});
    mesh.add_joint("J", "J+", "J-");
    return mesh;
  }

  class Hanging : public testing::TestWithParam<unsigned int>
  {
  };
} // namespace


// V2 on a mesh with hanging nodes: the stress is -p everywhere, N = -p cos² A, T = -p sin cos A,
// and the upper block moves by the jump as a whole. Displacements are linear in both blocks, so
// that a monitor in any place gives them exactly.
TEST_P(Hanging, pressure_across_an_oblique_joint)
{
  const double alpha = 0.35, p = 2.5, rho_n = 1e-3, rho_t = 3e-3, E = 3000.;
  const BlockMesh mesh = column(alpha);
  ModelDefinition model;
  model.polynomial_degree = GetParam();
  add_material(model, "lower", E, 0.);
  add_material(model, "upper", E, 0.);
  hold(model, "bottom", "xy");
  hold(model, "left", "");
  hold(model, "right", "");
  add_load(model, LoadKind::pressure, {"top"}, {"2.5"});
  const double c = std::cos(alpha), s = std::sin(alpha);
  for (const unsigned int seed : {1, 2})
    {
      model.local_refinements.clear();
      tests::refine_at_random<2>(mesh.mesh, model, seed, n_rounds);
      CondensedSystem<2> system(mesh.mesh, model, {false});
      EXPECT_GT(system.discretization().hanging_nodes().masters().size(), 20);
      set_all_loads(system, model);
      const Solution solution = solve_linear(system, rho_n, rho_t);
      double area             = 0.;
      for (const auto &element : system.elements())
        {
          EXPECT_NEAR(solution.p[element.normal_bar], -p * c * c * element.area, 1e-10 * p);
          EXPECT_NEAR(solution.p[element.tangential_bar], -p * s * c * element.area, 1e-10 * p);
          area += element.area;
        }
      EXPECT_NEAR(area, 2. / c, 1e-12);
      const auto u     = system.recover({1.}, solution.x);
      const auto error = system.equilibrium_error(u, solution.p, {1.});
      EXPECT_LT(error.residual, 1e-12);
      EXPECT_LT(error.resultant, 1e-12);
      EXPECT_NEAR(strain_energy(system, u), p * p * 5. / E / 2., 1e-12);
      Vector forces = system.elastic_bodies().forces(system.discretization().by_nodes(u));
      system.discretization().hanging_nodes().move_to_masters(forces);
      double reaction = 0.;
      for (unsigned int node = 0; node < system.discretization().n_nodes(); ++node)
        if (system.discretization().position(node)[1] == 0.)
          reaction += forces[node * 2 + 1];
      EXPECT_NEAR(reaction, 2. * p, 1e-11);

      const double jump_x = p * (c * c * s * rho_n - s * c * c * rho_t),
                   jump_y = -p * (c * c * c * rho_n + s * s * c * rho_t);
      for (unsigned int node = 0; node < system.discretization().n_nodes(); node += 197)
        {
          const auto &at     = system.discretization().position(node);
          const double above = at[1] - (1. + std::tan(alpha) * (at[0] - 1.));
          if (std::abs(above) < 1e-6)
            continue;
          MonitorDefinition definition;
          definition.name        = "M";
          definition.coordinates = {{at[0], at[1], 0.}};
          const MonitorPoint<2> point(system.discretization(), mesh.mesh, definition);
          const auto moved =
            Monitor(definition, point, model, system).displacement(solution.x, {1.});
          EXPECT_NEAR(moved[0], above > 0. ? jump_x : 0., 1e-11);
          EXPECT_NEAR(moved[1], -p / E * at[1] + (above > 0. ? jump_y : 0.), 1e-11);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Hanging, testing::Values(1, 2, 3));


// Four blocks round a crossing: whatever is marked, every face of a lip has its partner (or the
// geometry would throw), of the same level; and no node of a lip hangs.
TEST(RandomRefinement, keeps_lips_alike)
{
  const BlockMesh mesh = blocks_round_a_crossing(3);
  ModelDefinition model;
  for (const char *body : {"a", "b", "c", "d"})
    add_material(model, body, 1., 0.2);
  for (const unsigned int seed : {1, 2, 3, 4, 5, 6, 7, 8})
    {
      model.local_refinements.clear();
      tests::refine_at_random<2>(mesh.mesh, model, seed, n_rounds);
      const Discretization<2> space(mesh.mesh, model);
      const JointGeometry<2> geometry(space, mesh.mesh);
      EXPECT_GT(space.hanging_nodes().masters().size(), 10);
      for (const auto &pair : geometry.pairs())
        {
          EXPECT_FALSE(space.hanging_nodes().contain(pair.plus_node));
          EXPECT_FALSE(space.hanging_nodes().contain(pair.minus_node));
          EXPECT_LT(space.position(pair.plus_node).distance(space.position(pair.minus_node)),
                    1e-14);
        }
      double length = 0.;
      for (const auto &pair : geometry.pairs())
        length += pair.area;
      EXPECT_NEAR(length, 4., 1e-12);
    }
}


// The mesh of all rounds is found again from the lists of marks, whatever their order; and a round
// without marks changes nothing.
TEST(RandomRefinement, is_reproducible)
{
  const BlockMesh mesh = column(0.);
  ModelDefinition model;
  add_material(model, "lower", 1., 0.2);
  add_material(model, "upper", 1., 0.2);
  tests::refine_at_random<2>(mesh.mesh, model, 5, n_rounds);
  ModelDefinition other = model;
  for (auto &marked : other.local_refinements)
    std::reverse(marked.begin(), marked.end());
  other.local_refinements.emplace_back();
  const Discretization<2> space(mesh.mesh, model), again(mesh.mesh, other);
  ASSERT_EQ(space.n_nodes(), again.n_nodes());
  for (unsigned int node = 0; node < space.n_nodes(); ++node)
    EXPECT_EQ(space.position(node), again.position(node));
}
