// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <deal.II/lac/vector.h>

#include <fuga/base/errors.h>
#include <fuga/bodies/space/discretization.h>
#include <gtest/gtest.h>
#include <lapacke.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  ModelDefinition
  crossing_model()
  {
    ModelDefinition model;
    for (const std::string body : {"a", "b", "c", "d"})
      add_material(model, body, 1000., 0.2, 0.024);
    hold(model, "b", "xy");
    hold(model, "l", "");
    hold(model, "r", "");
    add_load(model, LoadKind::traction, {"t"}, {"0.3", "-1"});
    return model;
  }

} // namespace


// A body on nothing but its joint: its rigid motions are null vectors of S, all else is positive.
TEST(CondensedSystem, stiffness_of_a_floating_body)
{
  const BlockMesh mesh        = two_blocks();
  const ModelDefinition model = two_block_model();
  const CondensedSystem<2> system(mesh.mesh, model, {false});
  DenseMatrix S = system.stiffness();
  double size   = 0.;
  for (Eigen::Index i = 0; i < S.rows(); ++i)
    for (Eigen::Index j = 0; j < S.rows(); ++j)
      {
        EXPECT_EQ(S(i, j), S(j, i));
        size = std::max(size, std::abs(S(i, j)));
      }
  ASSERT_EQ(system.rigid_motions().cols(), 3U);
  const DenseMatrix forces = multiply(S, system.rigid_motions());
  for (Eigen::Index i = 0; i < S.rows(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(forces(i, k), 0., 1e-12 * size);

  Vector values(S.rows());
  const int n = static_cast<int>(S.rows());
  LAPACKE_dsyev(LAPACK_COL_MAJOR, 'N', 'U', n, S.data(), n, values.data());
  EXPECT_GT(values[0], -1e-12 * size);
  EXPECT_LT(values[2], 1e-12 * size);
  EXPECT_GT(values[3], 1e-6 * size);
}


// Weight 0.024 x area 6 and the resultants of the tractions over -1 < x < 2: ∫0.01x = 0.015,
// -∫0.02(x+2) = -0.15; moments about the middle (0.5, 1): -∫0.02(x+2)(x-0.5) = -0.045, -0.015 x 1.
// The rotation is that which moves the farthest corner by one.
TEST(CondensedSystem, equilibrium_of_a_floating_body)
{
  const BlockMesh mesh        = two_blocks();
  const ModelDefinition model = two_block_model();
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const DenseMatrix &work = system.rigid_motion_loads();
  EXPECT_NEAR(work(0, 0), 0., 1e-14);
  EXPECT_NEAR(work(1, 0), -0.144, 1e-14);
  EXPECT_NEAR(work(2, 0), 0., 1e-14);
  EXPECT_NEAR(work(0, 1), 0.015, 1e-14);
  EXPECT_NEAR(work(1, 1), -0.15, 1e-14);
  EXPECT_NEAR(work(2, 1), -0.06 / std::hypot(1.5, 1.), 1e-14);

  const Solution solution = solve_linear(system, 1e-3, 1e-3);
  const Vector sums       = multiply_transposed(system.rigid_motions(), solution.p);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(sums[k], work(k, 0) + work(k, 1), 1e-12);
  const auto u     = system.recover({1., 1.}, solution.x);
  const auto error = system.equilibrium_error(u, solution.p, {1., 1.});
  EXPECT_LT(error.residual, 1e-12);
  EXPECT_LT(error.resultant, 1e-12);
  const Vector jumps = system.jumps(u);
  for (std::size_t i = 0; i < jumps.size(); ++i)
    EXPECT_NEAR(jumps[i], solution.jumps[i], 1e-14);
}


// What soft joints let a body do far more than it deforms: the rigid part of interface coordinates
// is found, and what is left is what was added. 1e9 times the deformation costs the residual of the
// full model no digits (to 1e-12 of the forces; it would be 1e-7 if K acted on the whole of u).
TEST(CondensedSystem, rigid_part_keeps_the_digits_of_the_deformation)
{
  const BlockMesh mesh        = two_blocks();
  const ModelDefinition model = two_block_model();
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  const DenseMatrix &motions = system.rigid_motions();
  ASSERT_EQ(motions.cols(), 3U);
  Vector x(motions.rows(), 0.);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = 2. * motions(i, 0) - 3. * motions(i, 1) + 0.5 * motions(i, 2);
  const auto rigid = system.rigid_part(x);
  for (const double rest : rigid.remainder)
    EXPECT_NEAR(rest, 0., 1e-14);
  const Vector jumps = system.jumps(rigid.motion);
  for (std::size_t i = 0; i < jumps.size(); ++i)
    EXPECT_NEAR(jumps[i], x[i], 1e-14);

  const Solution soft = solve_linear(system, 1e5, 1e5);
  const auto split    = system.rigid_part(soft.x);
  const auto deformed = system.recover({1., 1.}, split.remainder);
  const Vector far    = system.jumps(split.motion);
  EXPECT_GT(max_abs(far), 1e3 * max_abs(split.remainder));
  EXPECT_LT(system.equilibrium_error(deformed, soft.p, {1., 1.}, split.motion).residual, 1e-12);
}


// Where four bodies meet, every jump of the recovered displacement is B x, and equilibrium holds.
TEST(CondensedSystem, crossing)
{
  const BlockMesh mesh        = blocks_round_a_crossing(2);
  const ModelDefinition model = crossing_model();
  CondensedSystem<2> system(mesh.mesh, model, std::vector<bool>(4, false));
  set_all_loads(system, model);
  // Per joint 3 elements of 2 bars, but the lowest pair is held by the base; at the crossing there
  // are 4 pairs with only 3 independent offsets.
  ASSERT_EQ(system.elements().size(), 11U);
  ASSERT_EQ(system.jump_operator().n_rows(), 22U);
  ASSERT_EQ(system.jump_operator().n_columns(), 20U);
  const Solution solution = solve_linear(system, 1e-3, 2e-3);
  const auto u            = system.recover({1.}, solution.x);
  const Vector jumps      = system.jumps(u);
  for (std::size_t i = 0; i < jumps.size(); ++i)
    EXPECT_NEAR(jumps[i], solution.jumps[i], 1e-14);
  const auto error = system.equilibrium_error(u, solution.p, {1.});
  EXPECT_LT(error.residual, 1e-12);
  EXPECT_LT(error.resultant, 1e-12);
  EXPECT_EQ(system.rigid_motions().cols(), 6U); // the upper two float

  double N = 0.; // vertical force through the horizontal joints: 2 x 1
  for (const auto &element : system.elements())
    if (element.joint < 2)
      N += solution.p[element.normal_bar];
  EXPECT_NEAR(N, -2., 1e-12);
}


// Lips that were moved by e, without motion of the bodies, are found out of balance and moved back:
// by the jumps of e, to where the forces of the bars had them.
TEST(CondensedSystem, lips_out_of_balance_are_moved_back)
{
  for (const bool crossing : {false, true})
    {
      const BlockMesh mesh        = crossing ? blocks_round_a_crossing(2) : two_blocks();
      const ModelDefinition model = crossing ? crossing_model() : two_block_model();
      CondensedSystem<2> system(mesh.mesh, model, std::vector<bool>(crossing ? 4 : 1, false));
      set_all_loads(system, model);
      const Vector a(crossing ? 1 : 2, 1.);
      const Solution solution = solve_linear(system, 1e-3, 2e-3);
      Vector e(solution.x.size(), 0.);
      e[2]              = 1e-4;
      e                 = system.rigid_part(e).remainder;
      Vector x          = solution.x;
      double moved      = 0.;
      const Vector jump = multiply(system.jump_operator(), e);
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += e[i];
      for (const double value : jump)
        moved = std::max(moved, std::abs(value));
      auto u = system.recover(a, x);
      EXPECT_GT(system.equilibrium_error(u, solution.p, a).residual, 1e-4);
      EXPECT_NEAR(system.balance_lips(solution.p, a, u), moved, 1e-10 * moved);
      EXPECT_LT(system.equilibrium_error(u, solution.p, a).residual, 1e-12);
      const Vector jumps = system.jumps(u);
      for (std::size_t i = 0; i < jumps.size(); ++i)
        EXPECT_NEAR(jumps[i], solution.jumps[i], 1e-13);
    }
}


// A block on a rigid plane, one side on rollers, its corner held: the pair at the corner carries no
// element. With only the rollers it keeps its normal bar. The plane carries the weight.
TEST(CondensedSystem, rigid_obstacle_and_supports_at_its_end)
{
  BlockMesh mesh;
  mesh.add_block("block", 4, 4, rectangle(0., 1., 0., 1.), {{"lip", "side", "free", "free"}});
  mesh.add_joint("J", "lip", "");
  mesh.name_point("corner", 1., 0.);
  ModelDefinition model;
  add_material(model, "block", 1000., 0.2, 0.5);
  hold(model, "side", "x");
  hold(model, "free", "");
  add_load(model, LoadKind::weight, {"block"}, {});
  {
    CondensedSystem<2> system(mesh.mesh, model, {false});
    set_all_loads(system, model);
    ASSERT_EQ(system.elements().size(), 5U);
    EXPECT_FALSE(system.elements().back().has_tangential_bar());
    const Solution solution = solve_linear(system, 1e-3, 1e-3);
    double N                = 0.;
    for (const auto &element : system.elements())
      N += solution.p[element.normal_bar];
    EXPECT_NEAR(N, -0.5, 1e-13);
    EXPECT_LT(system.equilibrium_error(system.recover({1.}, solution.x), solution.p, {1.}).residual,
              1e-12);
  }
  hold(model, "corner", "xy");
  const CondensedSystem<2> system(mesh.mesh, model, {false});
  EXPECT_EQ(system.elements().size(), 4U);
  expect_message(system.report().front(), {"joint 'J': 1 node pair(s)"});
}


// A settlement of the base by -0.1 takes everything along without any force, also where the support
// holds one lip or the other of the joint's ends.
TEST(CondensedSystem, settlement)
{
  for (const std::string held : {"base", "lower_corner", "upper_corner"})
    {
      BlockMesh mesh = two_blocks();
      mesh.name_point("upper_corner", -1., 0.);
      mesh.mesh.points.push_back({14, "lower_corner"}); // row 2 of the lower block begins with 14
      ModelDefinition model = two_block_model();
      model.loads.clear();
      hold(model, "top", "");
      add_load(model, LoadKind::displacement, {"base"}, {"", "-0.1"});
      if (held != "base")
        {
          hold(model, held, "y");
          model.loads[0].targets.push_back(held);
        }
      CondensedSystem<2> system(mesh.mesh, model, {false});
      set_all_loads(system, model);
      const Solution solution = solve_linear(system, 1e-3, 1e-3);
      const auto u            = system.recover({1.}, solution.x);
      const auto &space       = system.discretization();
      for (unsigned int node = 0; node < space.n_nodes(); ++node)
        {
          EXPECT_NEAR(u[space.dof(node, 0)], 0., 1e-13);
          EXPECT_NEAR(u[space.dof(node, 1)], -0.1, 1e-13);
        }
    }
}


// No joint at all: one linear solution. A bar under its end pressure: u = -p L/E (nu = 0).
TEST(CondensedSystem, no_joint)
{
  BlockMesh mesh;
  mesh.add_block("bar", 2, 5, rectangle(0., 1., 0., 4.), {{"base", "free", "top", "free"}});
  ModelDefinition model;
  model.refinements = 1;
  add_material(model, "bar", 1000., 0.);
  hold(model, "base", "xy");
  hold(model, "free", "");
  add_load(model, LoadKind::pressure, {"top"}, {"3"});
  CondensedSystem<2> system(mesh.mesh, model, {});
  set_all_loads(system, model);
  const auto u = system.recover({1.}, {});
  EXPECT_NEAR(u.linfty_norm(), 3. * 4. / 1000., 1e-14);
  EXPECT_LT(system.equilibrium_error(u, {}, {1.}).residual, 1e-12);
}


// Elements count from the end with the smaller x, or y on a vertical joint, however the mesh was
// made.
TEST(CondensedSystem, numbering_along_the_joint)
{
  BlockMesh mesh;
  mesh.add_block("left",
                 2,
                 4,
                 [](double s, double r) {
                   return std::array<double, 2>{{s, 1. - r}};
                 },
                 {{"top", "J-", "base", "free"}});
  mesh.add_block("right", 2, 4, rectangle(1., 2., 0., 1.), {{"base", "free", "top", "J+"}});
  mesh.add_joint("J", "J+", "J-");
  ModelDefinition model;
  model.polynomial_degree = 2;
  add_material(model, "left", 1., 0.2);
  add_material(model, "right", 1., 0.2);
  hold(model, "top", "");
  hold(model, "free", "x");
  hold(model, "base", "xy");
  const CondensedSystem<2> system(mesh.mesh, model, {false});
  ASSERT_EQ(system.elements().size(), 8U); // the lowest pair is held
  for (std::size_t i = 0; i < 8; ++i)
    {
      EXPECT_NEAR(system.elements()[i].position[1], 0.125 * static_cast<double>(i + 1), 1e-14);
      EXPECT_NEAR(system.normal(i)[0], 1., 1e-14);
    }
  ASSERT_EQ(system.joint_faces().size(), 4U);
  EXPECT_TRUE(system.joint_faces()[0].shares[0].empty());
  EXPECT_EQ(system.joint_faces()[0].shares[1].at(0).first, 0U);
  EXPECT_EQ(system.joint_faces()[3].shares[2].at(0).first, 7U);
}


TEST(CondensedSystem, frictionless_joint_that_alone_holds_a_body)
{
  const BlockMesh mesh        = two_blocks();
  const ModelDefinition model = two_block_model();
  const CondensedSystem<2> system(mesh.mesh, model, {true});
  EXPECT_TRUE(system.elements().front().has_tangential_bar());
  expect_message(system.report().front(), {"the normal bars alone do not hold"});
}


// A crack that ends inside a body: its tip is one node and carries no element.
TEST(CondensedSystem, tip_inside_a_body)
{
  BlockMesh mesh;
  mesh.add_block("b", 2, 2, rectangle(0., 2., 0., 2.), {{"base", "free", "top", "free"}});
  // Copy vertex 3 at (0, 1) for the two upper cells on the left; the tip is vertex 4 at (1, 1).
  mesh.mesh.vertices.push_back(mesh.mesh.vertices[3]);
  mesh.mesh.cells[2].vertices[0] = 9;
  for (auto &face : mesh.mesh.faces)
    if (face.vertices[0] == 3 && face.vertices[1] == 6)
      face.vertices[0] = 9;
  for (const auto &[first, label] : {std::pair<unsigned int, const char *>{9, "C+"}, {3, "C-"}})
    {
      JointedMesh::Face face;
      face.vertices = {{first, 4, 0, 0}};
      face.label    = mesh.label(label);
      mesh.mesh.faces.push_back(face);
    }
  mesh.add_joint("crack", "C+", "C-");
  ModelDefinition model;
  add_material(model, "b", 1000., 0.2);
  hold(model, "base", "xy");
  hold(model, "free", "");
  add_load(model, LoadKind::pressure, {"top"}, {"1+x"});
  CondensedSystem<2> system(mesh.mesh, model, {false});
  set_all_loads(system, model);
  ASSERT_EQ(system.elements().size(), 1U);
  EXPECT_DOUBLE_EQ(system.elements()[0].area, 0.5);
  EXPECT_DOUBLE_EQ(system.normal(0)[1], 1.);
  EXPECT_TRUE(system.joint_faces()[0].shares[1].empty());
  EXPECT_EQ(system.rigid_motions().cols(), 0U);
  const Solution solution = solve_linear(system, 1e-3, 1e-3);
  const auto u            = system.recover({1.}, solution.x);
  EXPECT_LT(system.equilibrium_error(u, solution.p, {1.}).residual, 1e-12);
}


// One joint given in two parts: the node pair where they meet belongs to both, with its share of
// the area in each, and the bars of both see the same jump. Uniform pressure 2 over a width of 3.
TEST(CondensedSystem, joint_in_two_parts)
{
  BlockMesh mesh = two_blocks();
  mesh.add_joint("K", "K+", "K-");
  for (auto &face : mesh.mesh.faces)
    for (const std::string lip : {"J+", "J-"})
      if (face.label == mesh.label(lip) && mesh.mesh.vertices[face.vertices[0]][0] > 0.4)
        face.label = mesh.label(lip == "J+" ? "K+" : "K-");
  ModelDefinition model = two_block_model();
  for (auto &material : model.materials)
    material.poisson_ratio = 0.;
  model.loads.clear();
  add_load(model, LoadKind::pressure, {"top"}, {"2"});
  CondensedSystem<2> system(mesh.mesh, model, {false, false});
  set_all_loads(system, model);
  ASSERT_EQ(system.elements().size(), 8U);
  EXPECT_EQ(system.jump_operator().n_columns() + 2, system.jump_operator().n_rows());
  const Solution solution = solve_linear(system, 1e-3, 1e-3);
  for (const auto &element : system.elements())
    EXPECT_NEAR(solution.p[element.normal_bar], -2. * element.area, 1e-11);
  const auto u = system.recover({1.}, solution.x);
  EXPECT_LT(system.equilibrium_error(u, solution.p, {1.}).residual, 1e-12);
}


// Where joints cross, the interface coordinates are offsets in global directions. Conjugate
// gradients and factors eliminate the same matrix; columns of S have relative residuals of 1e-11.
TEST(CondensedSystem, iterative_elimination_at_a_crossing)
{
  const BlockMesh mesh  = blocks_round_a_crossing(2);
  ModelDefinition model = crossing_model();
  std::vector<DenseMatrix> S, F;
  for (const BodySolver solver : {BodySolver::direct, BodySolver::iterative})
    {
      model.body_solver = solver;
      CondensedSystem<2> system(mesh.mesh, model, {false, false, false, false});
      system.set_load_patterns({system.assemble_load(0, 0.)});
      S.push_back(system.stiffness());
      F.push_back(system.load_patterns());
    }
  const double stiffness = S[0](0, 0), load = 1.;
  for (Eigen::Index j = 0; j < S[0].cols(); ++j)
    for (Eigen::Index i = 0; i < S[0].rows(); ++i)
      EXPECT_NEAR(S[1](i, j), S[0](i, j), 1e-10 * stiffness);
  for (Eigen::Index i = 0; i < F[0].rows(); ++i)
    EXPECT_NEAR(F[1](i, 0), F[0](i, 0), 1e-12 * load);
}
