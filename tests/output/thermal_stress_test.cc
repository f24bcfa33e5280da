// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "bodies/block_mesh.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/vector.h>

#include <fuga/bodies/program/load_program.h>
#include <fuga/output/fields/stress_postprocessor.h>
#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::test;

namespace
{
  constexpr double E = 30000., nu = 0.2, alpha = 1e-5, dT = 25.;

  struct Case
  {
    bool triangles;
    unsigned int degree;
    PlaneAssumption assumption;
  };

  std::ostream &
  operator<<(std::ostream &out, const Case &kind)
  {
    return out << (kind.triangles ? "P" : "Q") << kind.degree
               << (kind.assumption == PlaneAssumption::plane_strain ? "Strain" : "Stress");
  }

  class ThermalStress : public testing::TestWithParam<Case>
  {
  protected:
    const bool is_plane_stress = GetParam().assumption == PlaneAssumption::plane_stress;

    ThermalStress() : mesh(GetParam().triangles)
    {
      mesh.add_block("bar",
                     4,
                     2,
                     [](double s, double r) {
                       return std::array<double, 2>{{3. * s + 0.1 * s * r * (1. - s),
                                                     0.5 * r + 0.05 * s * (1. - s) * r * (1. - r)}};
                     },
                     {{"bottom", "right", "top", "left"}});
      mesh.name_point("origin", 0., 0.);
      mesh.name_point("end", 3., 0.);
      model.polynomial_degree = GetParam().degree;
      model.assumption        = GetParam().assumption;
      model.thickness         = 0.7;
      add_material(model, "bar", E, nu);
      model.materials[0].thermal_expansion = alpha;
      hold(model, "top", "");
    }

    /** Solves for the temperature and compares: stresses (x, y, xy, von Mises), displacements. */
    void
    expect(const std::string &temperature,
           const std::array<double, 4> &stress,
           const std::function<std::array<double, 2>(double, double)> &displacement)
    {
      add_load(model, LoadKind::temperature, {}, {temperature});
      model.stages = {{"heat", {{0, "2*t"}}, 1, ""}};
      CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
      const LoadProgram program = make_load_program(model, system);
      system.set_load_patterns(program.patterns);
      const double t    = 0.5; // half of a factor 2
      const auto u      = system.recover(program.history.factors(t), {});
      const auto &space = system.discretization();
      for (unsigned int node = 0; node < space.n_nodes(); ++node)
        {
          const auto at     = space.position(node);
          const auto wanted = displacement(at[0], at[1]);
          for (unsigned int c = 0; c < 2; ++c)
            EXPECT_NEAR(u[space.dof(node, c)], wanted[c], 1e-12 * 3. * alpha * dT + 1e-16);
        }
      const auto field = program.temperature<2>(model, mesh.mesh.body_names, t);
      const StressPostprocessor<2> postprocessor(model, mesh.mesh.body_names, field);
      const auto points = GetParam().triangles ? dealii::Quadrature<2>(dealii::Point<2>(0.2, 0.3))
                                               : dealii::Quadrature<2>(dealii::Point<2>(0.2, 0.9));
      dealii::FEValues<2> values(space.mapping(),
                                 space.dof_handler().get_fe(),
                                 points,
                                 dealii::update_gradients | dealii::update_quadrature_points);
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        {
          values.reinit(cell);
          dealii::DataPostprocessorInputs::Vector<2> inputs;
          inputs.set_cell<2>(cell);
          inputs.solution_gradients = {std::vector<dealii::Tensor<1, 2>>(2)};
          values.get_function_gradients(u, inputs.solution_gradients);
          inputs.evaluation_points = values.get_quadrature_points();
          std::vector<dealii::Vector<double>> result(1, dealii::Vector<double>(7));
          postprocessor.evaluate_vector_field(inputs, result);
          const double tolerance = 1e-11 * E * alpha * dT;
          EXPECT_NEAR(result[0](0), stress[0], tolerance);
          EXPECT_NEAR(result[0](3), stress[1], tolerance);
          EXPECT_NEAR(result[0](1), stress[2], tolerance);
          EXPECT_NEAR(result[0](6), stress[3], tolerance);
        }
    }

    BlockMesh mesh;
    ModelDefinition model;
  };
} // namespace


// u = α ΔT x without stress in the plane; plane strain: (1 + ν) α ΔT x, and -E α ΔT across.
TEST_P(ThermalStress, free_expansion)
{
  hold(model, "bottom", "y");
  hold(model, "left", "x");
  hold(model, "right", "");
  const double strain = (is_plane_stress ? 1. : 1. + nu) * alpha * dT;
  expect("25", {{0., 0., 0., is_plane_stress ? 0. : E * alpha * dT}}, [=](double x, double y) {
    return std::array<double, 2>{{strain * x, strain * y}};
  });
}


// Both ends held: σx = -E α ΔT, in plane strain -E α ΔT/(1 - ν) along and across.
TEST_P(ThermalStress, restrained_bar)
{
  hold(model, "bottom", "y");
  hold(model, "left", "x");
  hold(model, "right", "x");
  const double stress = -E * alpha * dT / (is_plane_stress ? 1. : 1. - nu);
  const double strain = alpha * dT * (1. + nu) / (is_plane_stress ? 1. : 1. - nu);
  expect("25", {{stress, 0., 0., -stress}}, [=](double x, double y) {
    return std::array<double, 2>{{0. * x, strain * y}};
  });
}


// A temperature that is linear in the place bends a free body without stress (plane stress):
// ΔT = 20 y gives u = k (x y, (y² - x²)/2), k = 20 α. The two points are those of a simple beam.
TEST_P(ThermalStress, bending_without_stress)
{
  if (!is_plane_stress || GetParam().degree == 1)
    GTEST_SKIP() << "needs quadratic displacements, and no stress across";
  hold(model, "bottom", "");
  hold(model, "left", "");
  hold(model, "right", "");
  hold(model, "origin", "xy");
  hold(model, "end", "y");
  const double k = 20. * alpha;
  expect("20*y", {{0., 0., 0., 0.}}, [=](double x, double y) {
    // The rigid rotation 3k/2 brings the far end back to y = 0.
    return std::array<double, 2>{{k * x * y - 1.5 * k * y, k * (y * y - x * x) / 2. + 1.5 * k * x}};
  });
}


INSTANTIATE_TEST_SUITE_P(Elements,
                         ThermalStress,
                         testing::Values(Case{false, 1, PlaneAssumption::plane_strain},
                                         Case{false, 1, PlaneAssumption::plane_stress},
                                         Case{false, 2, PlaneAssumption::plane_strain},
                                         Case{true, 1, PlaneAssumption::plane_strain},
                                         Case{true, 2, PlaneAssumption::plane_stress}),
                         testing::PrintToStringParamName());


// A temperature that changes with time: field and loads are interpolated between the same knots.
// t² with two knots per stage: at 0.25 the chord gives 0.125.
TEST(ThermalField, between_knots)
{
  BlockMesh mesh;
  mesh.add_block("a", 1, 1, rectangle(0., 1., 0., 1.), {{"base", "free", "free", "free"}});
  ModelDefinition model;
  model.load_knots = 2;
  add_material(model, "a", E, nu);
  model.materials[0].thermal_expansion = alpha;
  hold(model, "base", "xy");
  hold(model, "free", "");
  add_load(model, LoadKind::temperature, {"a"}, {"100*t^2*x"});
  model.stages = {{"heat", {{0, "1"}}, 1, ""}};
  CondensedSystem<2> system(mesh.mesh, model, {}, Condensation::with_loads);
  const LoadProgram program = make_load_program(model, system);
  const dealii::Point<2> at(0.5, 0.3);
  for (const auto &[t, wanted] : {std::pair(0., 0.), {0.25, 0.125}, {0.5, 0.25}, {1., 1.}})
    EXPECT_NEAR(program.temperature<2>(model, mesh.mesh.body_names, t).strain(at, 0),
                alpha * 50. * wanted,
                1e-18);
}
