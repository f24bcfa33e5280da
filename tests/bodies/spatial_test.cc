// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Bodies in space: the two blocks of meshes/patch_3d.geo, 3 x 2 x 4 m, with a joint that rises by
// 0.3 in x and by 0.2 in y.

#include "block_mesh.h"
#include "spatial_patch.h"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/vector.h>

#include <fuga/base/errors.h>
#include <fuga/bodies/space/discretization.h>
#include <fuga/mesh/gmsh_mesh.h>
#include <gtest/gtest.h>
#include <lapacke.h>

#include <cmath>
#include <fmt/format.h>

using namespace fuga;
using namespace fuga::test;
using fuga::tests::all_patches;
using fuga::tests::Patch;

namespace
{
  constexpr double E = 3000.;

  class Spatial : public testing::TestWithParam<Patch>
  {
  protected:
    Spatial()
      : mesh(
          split_joints(read_gmsh_mesh(std::string(FUGA_SOURCE_DIR) + "/meshes/" + GetParam().mesh),
                       {{"joint", "joint", "upper", "lower", "", "", false}}))
    {
      model.dimension         = 3;
      model.polynomial_degree = GetParam().degree;
      for (const char *body : {"lower", "upper"})
        add_material(model, body, E, 0., 0.);
      refine(GetParam(), mesh, model);
    }

    JointedMesh mesh;
    ModelDefinition model;
  };

  const char *const sides[]    = {"bottom", "top", "front", "back", "left", "right"};
  const double directions[][3] = {
    {0., 0., -1.}, {0., 0., 1.}, {0., -1., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {1., 0., 0.}};
} // namespace

// V2, closed form: under a uniform stress (ν = 0) the bars carry A n·σn, A t1·σn, A t2·σn; with a
// layer of ρn, ρt in series their jumps are ρ times the stresses, and u = σx/E plus a rigid motion.
// The condensed equations S δ + p = f hold with these, and the recovered displacement of the lower
// block, which is held statically determinate at the origin, is σx/E.
TEST_P(Spatial, PatchTestWithShearInBothDirections)
{
  dealii::SymmetricTensor<2, 3> sigma;
  sigma[0][0] = -0.3, sigma[1][1] = 0.4, sigma[2][2] = -2.;
  sigma[0][1] = 0.2, sigma[0][2] = 0.5, sigma[1][2] = -0.6;
  for (unsigned int i = 0; i < 6; ++i)
    {
      std::vector<std::string> traction;
      for (unsigned int c = 0; c < 3; ++c)
        {
          double sum = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            sum += sigma[c][d] * directions[i][d];
          traction.push_back(fmt::format("{:.17g}", sum));
        }
      add_load(model, LoadKind::traction, {sides[i]}, traction);
    }
  // Three points, six components: no rigid motion is left.
  const double points[][3]  = {{0., 0., 0.}, {3., 0., 0.}, {0., 2., 0.}};
  const char *const names[] = {"lower_1", "lower_2", "lower_3"};
  const char *const held[]  = {"xyz", "yz", "z"};
  for (unsigned int k = 0; k < 3; ++k)
    {
      hold(model, names[k], held[k]);
      std::vector<std::string> values;
      for (unsigned int c = 0; c < 3; ++c)
        {
          double u = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            u += sigma[c][d] * points[k][d] / E;
          values.push_back(std::string(held[k]).find("xyz"[c]) == std::string::npos
                             ? ""
                             : fmt::format("{:.17g}", u));
        }
      add_load(model, LoadKind::displacement, {names[k]}, values);
    }

  CondensedSystem<3> system(mesh, model, {false});
  std::vector<LoadPattern> patterns(1);
  for (std::size_t i = 0; i < model.loads.size(); ++i)
    {
      const LoadPattern part = system.assemble_load(i, 0.);
      for (Vector LoadPattern::*field : {&LoadPattern::forces, &LoadPattern::prescribed})
        {
          Vector &sum = patterns[0].*field;
          sum.resize(std::max(sum.size(), (part.*field).size()), 0.);
          for (std::size_t k = 0; k < (part.*field).size(); ++k)
            sum[k] += (part.*field)[k];
        }
    }
  system.set_load_patterns(patterns);

  const double steepness = std::sqrt(1.13), rho[] = {1e-3, 2e-3, 2e-3};
  const dealii::Tensor<1, 3> n({-0.3 / steepness, -0.2 / steepness, 1. / steepness});
  Vector p(3 * system.elements().size()), jumps(p.size());
  double area = 0.;
  for (std::size_t k = 0; k < system.elements().size(); ++k)
    {
      const ContactElement &element = system.elements()[k];
      area += element.area;
      EXPECT_GT(element.area, 0.);
      const auto t                           = system.tangents(k);
      const std::array<double, 3> axes[]     = {system.normal(k), t[0], t[1]};
      const std::array<unsigned int, 3> bars = {
        {element.normal_bar, element.tangential_bar, element.second_tangential_bar}};
      dealii::Tensor<1, 3> axis[3];
      for (unsigned int i = 0; i < 3; ++i)
        {
          for (unsigned int c = 0; c < 3; ++c)
            axis[i][c] = axes[i][c];
          const double stress = axis[i] * (sigma * n);
          p[bars[i]]          = element.area * stress;
          jumps[bars[i]]      = rho[i] * stress;
        }
      EXPECT_NEAR((axis[0] - n).norm(), 0., 1e-13);
      EXPECT_NEAR((dealii::cross_product_3d(axis[1], axis[2]) - n).norm(), 0., 1e-13);
      EXPECT_NEAR(axis[1][0], std::sqrt(1. - n[0] * n[0]), 1e-13); // x in the plane of the joint
    }
  EXPECT_NEAR(area, 6. * steepness, 1e-12 * area);

  const DenseMatrix &S = system.stiffness(), &F = system.load_patterns();
  const Vector Sd = multiply(S, jumps);
  double largest  = 0.;
  for (std::size_t i = 0; i < p.size(); ++i)
    largest = std::max(largest, std::abs(p[i]));
  for (std::size_t i = 0; i < p.size(); ++i)
    EXPECT_NEAR(Sd[i] + p[i], F(i, 0), 1e-10 * largest) << i;

  const auto u           = system.recover({1.}, jumps);
  const auto &space      = system.discretization();
  const double magnitude = 2. * 4. / E;
  for (std::size_t node = 0; node < space.n_nodes(); ++node)
    {
      const auto &x = space.position(node);
      if (x[2] > 2. + 0.3 * (x[0] - 1.5) + 0.2 * (x[1] - 1.) - 1e-9)
        continue; // the joint and the upper block
      const auto expected = sigma * x / E;
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_NEAR(u[space.dof(node, c)], expected[c], 1e-10 * magnitude) << node;
    }
  const EquilibriumError error = system.equilibrium_error(u, p, {1.});
  EXPECT_LT(std::max(error.residual, error.resultant), 1e-11);
}


// The upper block on nothing but its joint: six rigid motions are null vectors of S, all else is
// positive.
TEST_P(Spatial, FloatingBody)
{
  hold(model, "bottom", "xyz");
  for (const char *side : {"top", "front", "back", "left", "right"})
    hold(model, side, "");
  const CondensedSystem<3> system(mesh, model, {false});
  DenseMatrix S = system.stiffness();
  ASSERT_EQ(system.rigid_motions().cols(), 6U);
  Vector values(S.rows());
  const int n = static_cast<int>(S.rows());
  LAPACKE_dsyev(LAPACK_COL_MAJOR, 'N', 'U', n, S.data(), n, values.data());
  EXPECT_LT(std::max(-values[0], values[5]), 1e-12 * values.back());
  EXPECT_GT(values[6], 1e-6 * values.back());
}


// Archimedes: still water all around lifts with the weight of what is under its level, through the
// center of that. Bodies of 3 x 2 m; the level in the air, within the blocks and under them.
TEST_P(Spatial, StillWaterAllAroundLifts)
{
  constexpr double gamma = 9.81;
  hold(model, "lower_1", "xyz");
  hold(model, "lower_2", "yz");
  hold(model, "lower_3", "z");
  add_load(model, LoadKind::depth_pressure, {}, {});
  model.loads.back().targets.assign(std::begin(sides), std::end(sides));
  model.loads.back().depth.gradient = gamma;
  for (const double level : {5., 2.7, 0.6, 0.})
    {
      model.loads.back().depth.level = fmt::format("{}", level);
      const CondensedSystem<3> system(mesh, model, {false}, Condensation::with_loads);
      const Vector forces = system.assemble_load(0, 0.).forces;
      const auto &space   = system.discretization();
      dealii::Tensor<1, 3> sum, moment;
      for (std::size_t node = 0; node < space.n_nodes(); ++node)
        {
          dealii::Tensor<1, 3> force;
          for (unsigned int c = 0; c < 3; ++c)
            force[c] = forces[node * 3 + c];
          sum += force;
          moment += dealii::cross_product_3d(dealii::Tensor<1, 3>(space.position(node)), force);
        }
      const double lift = gamma * 6. * std::min(level, 4.);
      for (unsigned int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(sum[c], c == 2 ? lift : 0., 1e-11) << level;
          EXPECT_NEAR(moment[c], c == 0 ? lift * 1. : c == 1 ? -lift * 1.5 : 0., 1e-10) << level;
        }
    }
}


INSTANTIATE_TEST_SUITE_P(Meshes, Spatial, all_patches());
