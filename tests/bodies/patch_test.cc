// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <deal.II/lac/vector.h>

#include <fuga/bodies/space/cell_values.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  class Patch : public testing::TestWithParam<Kind>
  {
  };

  // A column of width 2 with a joint through (1, 1) inclined by alpha, height 1 + 1.5 in the
  // middle. The division along x is not uniform, inner vertices are shaken.
  BlockMesh
  column(const Kind &kind, const double alpha)
  {
    const auto x     = [](const double s) { return 2. * (0.7 * s + 0.3 * s * s); };
    const auto joint = [=](const double s) { return 1. + std::tan(alpha) * (x(s) - 1.); };
    const auto shake = [](const double s, const double r) {
      return 0.08 * std::sin(M_PI * s) * std::sin(M_PI * r);
    };
    BlockMesh mesh(kind.triangles);
    mesh.add_block("lower",
                   4,
                   3,
                   [=](double s, double r) {
                     return std::array<double, 2>{{x(s) + shake(s, r), joint(s) * r + shake(s, r)}};
                   },
                   {{"bottom", "right", "J-", "left"}});
    mesh.add_block("upper",
                   4,
                   2,
                   [=](double s, double r) {
                     return std::array<double, 2>{
                       {x(s) - shake(s, r), joint(s) + (2.5 - joint(s)) * r + shake(s, r)}};
                   },
                   {{"J+", "right", "top", "left"}});
    mesh.add_joint("J", "J+", "J-");
    return mesh;
  }

  ModelDefinition
  column_model(const Kind &kind, const double E_lower, const double E_upper)
  {
    ModelDefinition model;
    model.polynomial_degree = kind.degree;
    add_material(model, "lower", E_lower, 0.);
    add_material(model, "upper", E_upper, 0.);
    hold(model, "bottom", "xy");
    return model;
  }

  double
  top_displacement(const CondensedSystem<2> &system,
                   const dealii::Vector<double> &u,
                   const unsigned int component)
  {
    const auto &space = system.discretization();
    for (unsigned int node = 0; node < space.n_nodes(); ++node)
      if (space.position(node).distance(dealii::Point<2>(2., 2.5)) < 1e-12)
        return u[space.dof(node, component)];
    return NAN;
  }
} // namespace


// The quadratures integrate 1 to the area of the column, 2 x 2.5, whatever the shape of the cells.
TEST_P(Patch, area_of_the_bodies)
{
  const BlockMesh mesh = column(GetParam(), 0.3);
  const Discretization<2> space(mesh.mesh, column_model(GetParam(), 1., 1.));
  CellValues<2> values(space);
  double area = 0.;
  for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
    {
      values.move_to(cell);
      for (std::size_t q = 0; q < values.n_points(); ++q)
        area += values.volume(q);
    }
  EXPECT_NEAR(area, 5., 1e-13);
}


// V2: u_top = -p (H1/E1 + H2/E2 + rho_n), N_k = -p A_k.
TEST_P(Patch, pressure_across_a_horizontal_joint)
{
  const BlockMesh mesh  = column(GetParam(), 0.);
  ModelDefinition model = column_model(GetParam(), 3000., 7000.);
  hold(model, "left", "");
  hold(model, "right", "");
  const double p = 2.5, rho = 1e-3;
  add_load(model, LoadKind::pressure, {"top"}, {"2.5"});
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const Solution solution = solve_linear(system, rho, 2. * rho);
  double area             = 0.;
  ASSERT_EQ(system.elements().size(), 4 * GetParam().degree + 1);
  for (const auto &element : system.elements())
    {
      EXPECT_NEAR(solution.p[element.normal_bar], -p * element.area, 1e-10 * p);
      EXPECT_NEAR(solution.p[element.tangential_bar], 0., 1e-10 * p);
      area += element.area;
    }
  EXPECT_NEAR(area, 2., 1e-13);
  const auto u = system.recover({1.}, solution.x);
  EXPECT_NEAR(top_displacement(system, u, 1), -p * (1. / 3000. + 1.5 / 7000. + rho), 1e-13);
  const auto error = system.equilibrium_error(u, solution.p, {1.});
  EXPECT_LT(error.residual, 1e-12);
  EXPECT_LT(error.resultant, 1e-12);
  EXPECT_EQ(error.body, "upper");
  // Strain energy of uniform stress: p² A H / 2E of each block.
  EXPECT_NEAR(strain_energy(system, u), p * p * (1. / 3000. + 1.5 / 7000.), 1e-12);
}


// The same stress -p across a joint inclined by alpha: N = -p cos² A, T = -p sin cos A, and the
// upper block moves by the jump N rho_n/A n + T rho_t/A t as a whole (one modulus in both blocks).
TEST_P(Patch, pressure_across_an_oblique_joint)
{
  const double alpha = 0.35, p = 2.5, rho_n = 1e-3, rho_t = 3e-3, E = 3000.;
  const BlockMesh mesh  = column(GetParam(), alpha);
  ModelDefinition model = column_model(GetParam(), E, E);
  hold(model, "left", "");
  hold(model, "right", "");
  add_load(model, LoadKind::pressure, {"top"}, {"p0"});
  model.constants["p0"] = p;
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const Solution solution = solve_linear(system, rho_n, rho_t);
  const double c = std::cos(alpha), s = std::sin(alpha);
  for (const auto &element : system.elements())
    {
      EXPECT_NEAR(solution.p[element.normal_bar], -p * c * c * element.area, 1e-10 * p);
      EXPECT_NEAR(solution.p[element.tangential_bar], -p * s * c * element.area, 1e-10 * p);
    }
  const auto u = system.recover({1.}, solution.x);
  EXPECT_NEAR(
    top_displacement(system, u, 1), -p * (2.5 / E + c * c * c * rho_n + s * s * c * rho_t), 1e-12);
  EXPECT_NEAR(top_displacement(system, u, 0), p * (c * c * s * rho_n - s * c * c * rho_t), 1e-12);
  EXPECT_LT(system.equilibrium_error(u, solution.p, {1.}).residual, 1e-12);
}


// Uniform shear tau by tractions on top and sides: T_k = tau A_k, u_x = tau y/G + tau rho_t above.
TEST_P(Patch, shear)
{
  const BlockMesh mesh  = column(GetParam(), 0.);
  ModelDefinition model = column_model(GetParam(), 3000., 3000.);
  add_load(model, LoadKind::traction, {"top"}, {"0.4", "0"});
  add_load(model, LoadKind::traction, {"right"}, {"0", "0.4"});
  add_load(model, LoadKind::traction, {"left"}, {"0", "-0.4"});
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const Solution solution = solve_linear(system, 1e-3, 2e-3);
  for (const auto &element : system.elements())
    {
      EXPECT_NEAR(solution.p[element.normal_bar], 0., 1e-11);
      EXPECT_NEAR(solution.p[element.tangential_bar], 0.4 * element.area, 1e-11);
    }
  const auto u = system.recover({1., 1., 1.}, solution.x);
  EXPECT_NEAR(top_displacement(system, u, 0), 0.4 * (2.5 / 1500. + 2e-3), 1e-13);
  EXPECT_LT(system.equilibrium_error(u, solution.p, {1., 1., 1.}).residual, 1e-12);
}


// Frictionless and held sideways by rollers: no tangential bars, same pressure.
TEST_P(Patch, frictionless)
{
  const BlockMesh mesh  = column(GetParam(), 0.);
  ModelDefinition model = column_model(GetParam(), 3000., 7000.);
  hold(model, "left", "x");
  hold(model, "right", "");
  add_load(model, LoadKind::pressure, {"top"}, {"2.5"});
  CondensedSystem<2> system(mesh.mesh, model, {true});
  set_all_loads(system, model);
  EXPECT_EQ(system.stiffness().rows(), system.elements().size());
  const Solution solution = solve_linear(system, 1e-3, 1.);
  for (const auto &element : system.elements())
    {
      EXPECT_FALSE(element.has_tangential_bar());
      EXPECT_NEAR(solution.p[element.normal_bar], -2.5 * element.area, 1e-10);
    }
  const auto u = system.recover({1.}, solution.x);
  EXPECT_NEAR(top_displacement(system, u, 1), -2.5 * (1. / 3000. + 1.5 / 7000. + 1e-3), 1e-13);
  EXPECT_LT(system.equilibrium_error(u, solution.p, {1.}).residual, 1e-12);
}


INSTANTIATE_TEST_SUITE_P(
  Elements,
  Patch,
  testing::Values(Kind{false, 1}, Kind{false, 2}, Kind{false, 3}, Kind{true, 1}, Kind{true, 2}),
  testing::PrintToStringParamName());


// Tributary areas of one face of length h: trapezoid, Simpson, Gauss-Lobatto with 4 points.
TEST(JointAreas, are_the_integrals_of_the_shape_functions)
{
  for (const auto &[triangles, degree, shares] :
       {std::tuple<bool, unsigned int, Vector>{false, 1, {1. / 2., 1. / 2.}},
        {false, 2, {1. / 6., 4. / 6., 1. / 6.}},
        {false, 3, {1. / 12., 5. / 12., 5. / 12., 1. / 12.}},
        {true, 1, {1. / 2., 1. / 2.}},
        {true, 2, {1. / 6., 4. / 6., 1. / 6.}}})
    {
      BlockMesh mesh(triangles);
      mesh.add_block("b", 1, 1, rectangle(0., 3., 0., 1.), {{"lip", "free", "free", "free"}});
      mesh.add_joint("J", "lip", "");
      ModelDefinition model;
      model.polynomial_degree = degree;
      model.thickness         = 2.;
      add_material(model, "b", 1., 0.2);
      hold(model, "free", "");
      const CondensedSystem<2> system(mesh.mesh, model, {false});
      ASSERT_EQ(system.elements().size(), shares.size());
      for (std::size_t i = 0; i < shares.size(); ++i)
        {
          EXPECT_NEAR(system.elements()[i].area, 6. * shares[i], 1e-13);
          EXPECT_EQ(system.elements()[i].number, i);
          EXPECT_DOUBLE_EQ(system.normal(i)[1], 1.);
        }
      EXPECT_DOUBLE_EQ(system.elements()[0].position[0], 0.);
    }
}
