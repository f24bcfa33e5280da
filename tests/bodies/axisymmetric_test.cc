// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <deal.II/lac/vector.h>

#include <fuga/base/errors.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  class Axisymmetric : public testing::TestWithParam<Kind>
  {
  protected:
    ModelDefinition
    model_of(const std::vector<std::string> &bodies, const double nu) const
    {
      ModelDefinition model;
      model.assumption        = PlaneAssumption::axisymmetric;
      model.polynomial_degree = GetParam().degree;
      for (const auto &body : bodies)
        add_material(model, body, E, nu, 0.024);
      return model;
    }

    static constexpr double E = 3000.;
  };

  /** Cylinders of radius 2 about x = 0, heights 1 and 1.5, joint at y = 1; cells are shaken. */
  BlockMesh
  cylinders(const bool triangles)
  {
    const auto radius = [](const double s) { return 2. * (0.7 * s + 0.3 * s * s); };
    const auto shake  = [](const double s, const double r) {
      return 0.08 * std::sin(M_PI * s) * std::sin(M_PI * r);
    };
    BlockMesh mesh(triangles);
    for (const bool upper : {false, true})
      mesh.add_block(
        upper ? "upper" : "lower",
        4,
        3,
        [=](double s, double r) {
          return std::array<double, 2>{
            {radius(s) + shake(s, r), (upper ? 1. + 1.5 * r : r) - shake(s, r)}};
        },
        upper ? std::array<std::string, 4>{{"J+", "rim", "top", "axis"}}
              : std::array<std::string, 4>{{"bottom", "rim", "J-", "axis"}});
    mesh.add_joint("J", "J+", "J-");
    return mesh;
  }
} // namespace


// Uniform pressure p: N_k = -p A_k, ΣA = πR²; σ_z = -p alone, so u_r = ν p r/E and u_z = -p z/E and
// the closure. Nothing holds the upper body but the joint. The elements are those of all nodes but
// the one on the axis, which has no area for degrees above 1.
TEST_P(Axisymmetric, pressure_across_a_horizontal_joint)
{
  const double nu = 0.3, p = 2.5, rho = 1e-3;
  const BlockMesh mesh  = cylinders(GetParam().triangles);
  ModelDefinition model = model_of({"lower", "upper"}, nu);
  hold(model, "bottom", "y");
  hold(model, "rim", "");
  hold(model, "axis", "");
  add_load(model, LoadKind::pressure, {"top"}, {"2.5"});
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const unsigned int degree = GetParam().degree;
  ASSERT_EQ(system.elements().size(), 4 * degree + (degree == 1 ? 1 : 0));
  const Solution solution = solve_linear(system, rho, 2. * rho);
  double area             = 0.;
  for (const auto &element : system.elements())
    {
      EXPECT_GT(element.area, 0.);
      EXPECT_NEAR(solution.p[element.normal_bar], -p * element.area, 1e-10 * p * element.area);
      if (element.has_tangential_bar())
        {
          EXPECT_NEAR(solution.p[element.tangential_bar], 0., 1e-10 * p);
        }
      area += element.area;
    }
  EXPECT_NEAR(area, M_PI * 4., 1e-12);
  EXPECT_EQ(system.rigid_motions().cols(), 1u);
  const auto u      = system.recover({1.}, solution.x);
  const auto &space = system.discretization();
  for (unsigned int node = 0; node < space.n_nodes(); ++node)
    {
      const auto &x      = space.position(node);
      const double shift = u[space.dof(node, 1)] + p * x[1] / E;
      EXPECT_NEAR(u[space.dof(node, 0)], nu * p * x[0] / E, 1e-13);
      EXPECT_NEAR(std::min(std::abs(shift), std::abs(shift + p * rho)), 0., 1e-13);
    }
  const auto error = system.equilibrium_error(u, solution.p, {1.});
  EXPECT_LT(error.residual, 1e-12);
  EXPECT_LT(error.resultant, 1e-12);
}


// Axial forces of weight, of water on a cone and of a traction: full circle.
TEST_P(Axisymmetric, resultants_of_loads)
{
  BlockMesh mesh(GetParam().triangles);
  // Frustum: r = 3 - y up to y = 2.
  mesh.add_block("body",
                 4,
                 3,
                 [](double s, double r) {
                   return std::array<double, 2>{{s * (3. - 2. * r), 2. * r}};
                 },
                 {{"bottom", "face", "top", "axis"}});
  ModelDefinition model = model_of({"body"}, 0.2);
  hold(model, "bottom", "xy");
  hold(model, "axis", "x");
  add_load(model, LoadKind::weight, {}, {});
  add_load(model, LoadKind::traction, {"top"}, {"0", "-3"});
  add_load(model, LoadKind::depth_pressure, {"face"}, {});
  model.loads.back().depth.level    = "1.3";
  model.loads.back().depth.gradient = 9.81;
  const CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
  const auto sum = [&](const std::size_t load, const unsigned int c) {
    const Vector forces = system.assemble_load(load, 0.).forces;
    double result       = 0.;
    for (std::size_t i = c; i < forces.size(); i += 2)
      result += forces[i];
    return result;
  };
  EXPECT_NEAR(sum(0, 1), -0.024 * M_PI * 2. / 3. * (9. + 3. + 1.), 1e-12);
  EXPECT_NEAR(sum(1, 1), -3. * M_PI, 1e-12);
  // The cone rises inwards at 45°: radial and axial force alike, 2π γ ∫ (h - y)(3 - y) dy.
  const double h = 1.3, force = 2. * M_PI * 9.81 * (3. * h * h / 2. - h * h * h / 6.);
  EXPECT_NEAR(sum(2, 1), -force, 1e-11);
  EXPECT_NEAR(sum(2, 0), -force, 1e-11);
}


// A free body of revolution grows by α ΔT without forces.
TEST_P(Axisymmetric, free_thermal_expansion)
{
  const BlockMesh mesh  = cylinders(GetParam().triangles);
  ModelDefinition model = model_of({"lower", "upper"}, 0.3);
  for (auto &material : model.materials)
    material.thermal_expansion = 1e-5;
  hold(model, "bottom", "y");
  hold(model, "rim", "");
  hold(model, "top", "");
  hold(model, "axis", "");
  add_load(model, LoadKind::temperature, {}, {"25"});
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const Solution solution = solve_linear(system, 1e-3, 1e-3);
  for (const double force : solution.p)
    EXPECT_NEAR(force, 0., 1e-11 * E * 2.5e-4);
  const auto u = system.recover({1.}, solution.x);
  for (unsigned int node = 0; node < system.discretization().n_nodes(); ++node)
    for (unsigned int c = 0; c < 2; ++c)
      EXPECT_NEAR(u[system.discretization().dof(node, c)],
                  2.5e-4 * system.discretization().position(node)[c],
                  1e-15);
}


INSTANTIATE_TEST_SUITE_P(
  Elements,
  Axisymmetric,
  testing::Values(Kind{false, 1}, Kind{false, 2}, Kind{false, 3}, Kind{true, 1}, Kind{true, 2}),
  testing::PrintToStringParamName());


// ∫ N 2πr over one face from the axis to r = h: πh²/3 (1, 2); with three nodes (0, 2, 1); with the
// four of Gauss and Lobatto their weights (1, 5, 5, 1)/12 times 2πr h.
TEST(AxisymmetricAreas, are_the_integrals_of_the_shape_functions)
{
  const double h = 3., third = M_PI * h * h / 3., s = (1. - std::sqrt(0.2)) / 2.;
  for (const auto &[triangles, degree, areas] :
       {std::tuple<bool, unsigned int, Vector>{false, 1, {third, 2. * third}},
        {false, 2, {2. * third, third}},
        {false, 3, {5. / 2. * third * s, 5. / 2. * third * (1. - s), third / 2.}},
        {true, 1, {third, 2. * third}},
        {true, 2, {2. * third, third}}})
    {
      BlockMesh mesh(triangles);
      mesh.add_block("b", 1, 1, rectangle(0., h, 0., 1.), {{"lip", "free", "free", "free"}});
      mesh.add_joint("J", "lip", "");
      ModelDefinition model;
      model.assumption        = PlaneAssumption::axisymmetric;
      model.polynomial_degree = degree;
      add_material(model, "b", 1., 0.2);
      hold(model, "free", "");
      const CondensedSystem<2> system(mesh.mesh, model, {false});
      ASSERT_EQ(system.elements().size(), areas.size());
      for (std::size_t i = 0; i < areas.size(); ++i)
        EXPECT_NEAR(system.elements()[i].area, areas[i], 1e-12);
      EXPECT_EQ(system.joint_faces().front().shares.size(), degree + 1);
    }
}


// Lamé: thick-walled cylinder 1 <= r <= 2 under inner pressure p, no axial strain:
// u = (1 + ν)/E p a²/(b² - a²) ((1 - 2ν) r + b²/r) (Timoshenko & Goodier, Theory of Elasticity,
// §28). Cubic elements: the error of u falls as h⁴, 16 elements: below 1e-6.
TEST(AxisymmetricCylinder, Lame)
{
  BlockMesh mesh;
  mesh.add_block("pipe", 16, 1, rectangle(1., 2., 0., 0.1), {{"ends", "rim", "ends", "bore"}});
  ModelDefinition model;
  model.assumption        = PlaneAssumption::axisymmetric;
  model.polynomial_degree = 3;
  const double E = 3000., nu = 0.3, p = 1.7;
  add_material(model, "pipe", E, nu);
  hold(model, "ends", "y");
  hold(model, "rim", "");
  add_load(model, LoadKind::pressure, {"bore"}, {"1.7"});
  CondensedSystem<2> system(mesh.mesh, model, {});
  set_all_loads(system, model);
  const auto u      = system.recover({1.}, {});
  const auto &space = system.discretization();
  for (unsigned int node = 0; node < space.n_nodes(); ++node)
    {
      const double r     = space.position(node)[0];
      const double exact = (1. + nu) / E * p / 3. * ((1. - 2. * nu) * r + 4. / r);
      EXPECT_NEAR(u[space.dof(node, 0)], exact, 1e-6 * exact);
    }
  // Work of the pressure: π a p u(a) per length.
  EXPECT_NEAR(
    strain_energy(system, u), 0.1 * M_PI * p * (1. + nu) / E * p / 3. * (1. - 2. * nu + 4.), 1e-8);
}


TEST(AxisymmetricChecks, messages)
{
  ModelDefinition model;
  model.assumption = PlaneAssumption::axisymmetric;
  add_material(model, "b", 1., 0.2);
  hold(model, "base", "x");
  hold(model, "free", "");
  BlockMesh beyond;
  beyond.add_block("b", 2, 1, rectangle(-0.5, 1., 0., 1.), {{"base", "free", "free", "free"}});
  expect_message(message_of(beyond.mesh, model), {"(-0.5, 0)", "axis", "plane strain"});
  // A ring that is held radially can still move along the axis, and in no other way.
  BlockMesh ring;
  ring.add_block("b", 2, 1, rectangle(0.5, 1., 0., 1.), {{"base", "free", "free", "free"}});
  expect_message(message_of(ring.mesh, model), {"Body 'b'", "free to move in y."});
  model.boundary_conditions[0].fixed = {{false, true, false}};
  EXPECT_EQ(message_of(ring.mesh, model), "");
}
