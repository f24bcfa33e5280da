// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <deal.II/lac/vector.h>

#include <fuga/base/errors.h>
#include <fuga/bodies/program/monitor.h>
#include <fuga/bodies/space/discretization.h>
#include <gtest/gtest.h>

#include <random>

using namespace fuga;
using namespace fuga::test;

namespace
{
  MonitorDefinition
  at(const double x, const double y, const std::string &body = "")
  {
    MonitorDefinition definition;
    definition.name        = "m";
    definition.coordinates = {{x, y, 0.}};
    definition.body        = body;
    definition.origin      = "f.prm:7";
    return definition;
  }

  Vector
  random_vector(const std::size_t n, const unsigned int seed)
  {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Vector result(n);
    for (double &value : result)
      value = uniform(generator);
    return result;
  }

  /**
   * At every node (for those on joints by the functional itself): what the monitor says for any
   * coordinates and factors is the recovered field. Both come from refined solutions: 1e-12.
   */
  void
  expect_recovered(const JointedMesh &mesh,
                   const ModelDefinition &model,
                   const std::size_t n_joints)
  {
    CondensedSystem<2> system(mesh, model, std::vector<bool>(n_joints, false));
    set_all_loads(system, model);
    const Vector x    = random_vector(system.stiffness().rows(), 1);
    const Vector a    = random_vector(model.loads.size(), 2);
    const auto u      = system.recover(a, x);
    const auto &space = system.discretization();
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      for (unsigned int c = 0; c < 2; ++c)
        {
          Vector force(space.n_dofs(), 0.);
          force[node * 2 + c] = 1.;
          EXPECT_NEAR(
            system.response(force).value(x, a), u[space.dof(node, c)], 1e-12 * u.linfty_norm())
            << space.position(node) << ' ' << c;
        }
  }

  std::string
  complaint(const CondensedSystem<2> &system,
            const JointedMesh &mesh,
            const MonitorDefinition &definition)
  {
    try
      {
        MonitorPoint<2>(system.discretization(), mesh, definition);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

// A body on nothing but its joint; settlements and supports included.
TEST(Monitor, EqualsTheRecoveredField)
{
  for (const bool triangles : {false, true})
    for (const unsigned int degree : {1u, 2u})
      {
        BlockMesh mesh(triangles);
        mesh.add_block("lower", 3, 1, rectangle(-1., 2., -1., 0.), {{"base", "side", "L", "side"}});
        mesh.add_block("upper", 3, 2, rectangle(-1., 2., 0., 2.), {{"U", "free", "top", "free"}});
        mesh.add_joint("joint", "U", "L");
        ModelDefinition model;
        model.polynomial_degree = degree;
        add_material(model, "lower", 1000., 0.3);
        add_material(model, "upper", 100., 0.2, 0.024);
        hold(model, "base", "xy");
        hold(model, "side", "x");
        hold(model, "free", "");
        add_load(model, LoadKind::weight, {"upper"}, {"0", "-1"});
        add_load(model, LoadKind::traction, {"top"}, {"0.3", "-0.1*x"});
        add_load(model, LoadKind::displacement, {"base"}, {"0.001", "0.002*x"});
        expect_recovered(mesh.mesh, model, 1);
      }
}

// Where joints cross, coordinates are not jumps; without joints there are none.
TEST(Monitor, CrossingJointsAndNone)
{
  BlockMesh mesh;
  mesh.add_block("sw", 2, 2, rectangle(-1., 0., -1., 0.), {{"base", "W-", "S-", "o"}});
  mesh.add_block("se", 2, 2, rectangle(0., 1., -1., 0.), {{"base", "o", "T-", "W+"}});
  mesh.add_block("nw", 2, 2, rectangle(-1., 0., 0., 1.), {{"S+", "E-", "top", "o"}});
  mesh.add_block("ne", 2, 2, rectangle(0., 1., 0., 1.), {{"T+", "o", "top", "E+"}});
  mesh.add_joint("west", "S+", "S-");
  mesh.add_joint("east", "T+", "T-");
  mesh.add_joint("south", "W+", "W-");
  mesh.add_joint("north", "E+", "E-");
  ModelDefinition model;
  for (const std::string body : {"sw", "se", "nw", "ne"})
    add_material(model, body, 1000., 0.2, 0.024);
  hold(model, "base", "xy");
  hold(model, "o", "");
  add_load(model, LoadKind::traction, {"top"}, {"0.3", "-1"});
  expect_recovered(mesh.mesh, model, 4);

  BlockMesh one;
  one.add_block("block", 3, 3, rectangle(0., 1., 0., 1.), {{"base", "o", "top", "o"}});
  ModelDefinition plain;
  add_material(plain, "block", 1000., 0.2);
  hold(plain, "base", "xy");
  hold(plain, "o", "");
  add_load(plain, LoadKind::traction, {"top"}, {"0.3", "-1"});
  add_load(plain, LoadKind::displacement, {"base"}, {"0", "0.01*x"});
  expect_recovered(one.mesh, plain, 0);
}

// The shares of a unit force inside a cell: they sum to one and have the moment of the point, on
// quadrilaterals that are no parallelograms, triangles, and of second degree.
TEST(Monitor, PointInACell)
{
  for (const bool triangles : {false, true})
    for (const unsigned int degree : {1u, 2u})
      {
        BlockMesh mesh(triangles);
        mesh.add_block("block",
                       3,
                       2,
                       [](const double s, const double r) {
                         return std::array<double, 2>{{3. * s + 0.3 * r * s, 2. * r + 0.4 * s * r}};
                       },
                       {{"base", "o", "o", "o"}});
        ModelDefinition model;
        model.polynomial_degree = degree;
        add_material(model, "block", 1000., 0.2);
        hold(model, "base", "xy");
        hold(model, "o", "");
        const CondensedSystem<2> system(mesh.mesh, model, {});
        const auto &space = system.discretization();
        for (const auto &[x, y] :
             {std::pair(0.7, 0.4), {1.37, 1.2}, {2.9, 1.9}, {0., 0.}, {0.5, 0.}})
          {
            const Vector f = MonitorPoint<2>(space, mesh.mesh, at(x, y)).unit_force(1);
            double sum = 0., sum_x = 0., sum_y = 0.;
            for (std::size_t node = 0; node < space.n_nodes(); ++node)
              {
                EXPECT_EQ(f[2 * node], 0.);
                sum += f[2 * node + 1];
                sum_x += f[2 * node + 1] * space.position(node)[0];
                sum_y += f[2 * node + 1] * space.position(node)[1];
              }
            EXPECT_NEAR(sum, 1., 1e-12);
            EXPECT_NEAR(sum_x, x, 1e-12);
            EXPECT_NEAR(sum_y, y, 1e-12);
          }
      }
}

// Messages say where, what and what to do; on a joint the body decides, at a tip there is one node.
TEST(Monitor, Complaints)
{
  BlockMesh mesh              = two_blocks();
  const ModelDefinition model = two_block_model();
  mesh.name_point("corner", 2., 2.);
  const CondensedSystem<2> system(mesh.mesh, model, {false});
  expect_message(complaint(system, mesh.mesh, at(5., 2.)),
                 {"f.prm:7: monitor 'm'", "(5, 2) lies outside of all bodies", "(2, 2)"});
  const std::string first = mesh.mesh.body_names[0], second = mesh.mesh.body_names[1];
  double x = 0., y = 0.; // on the joint
  for (const ContactElement &element : system.elements())
    if (element.number == 1)
      {
        x = element.position[0];
        y = element.position[1];
      }
  expect_message(complaint(system, mesh.mesh, at(x, y)), {"lies on a joint", "Body"});
  EXPECT_EQ(complaint(system, mesh.mesh, at(x, y, first)), "");
  EXPECT_EQ(complaint(system, mesh.mesh, at(x, y, second)), "");
  expect_message(complaint(system, mesh.mesh, at(x, y - 0.5, "upper")),
                 {"outside of body 'upper'"});
  MonitorDefinition named = at(0., 0.);
  named.point_name        = "corner";
  EXPECT_EQ(complaint(system, mesh.mesh, named), "");
  named.point_name = "cornr";
  expect_message(complaint(system, mesh.mesh, named), {"no point 'cornr'", "corner"});
}
