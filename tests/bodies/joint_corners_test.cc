// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Where joints are split into straight parts: areas and normals by hand.

#include "bodies/block_mesh.h"
#include "bodies/spatial_meshes.h"
#include "random_refinement.h"

#include <fuga/bodies/joints/joint_corners.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  dealii::Tensor<1, 2>
  at_angle(const double degrees)
  {
    const double angle = degrees * std::acos(-1.) / 180.;
    return dealii::Tensor<1, 2>({std::cos(angle), std::sin(angle)});
  }

  /** A block above a step: from x = 0 to 1 at y = 1, down to y = 0, and on to x = 2. The lower side
   * is a rigid obstacle. */
  JointedMesh
  step(const unsigned int n)
  {
    BlockMesh mesh;
    mesh.add_block("left", n, n, rectangle(0., 1., 1., 2.), {{"J", "", "", ""}});
    mesh.add_block("low", n, n, rectangle(1., 2., 0., 1.), {{"J", "", "", "J"}});
    mesh.add_block("right", n, n, rectangle(1., 2., 1., 2.), {{"", "", "", ""}});
    mesh.add_joint("J", "J", "");
    return mesh.mesh;
  }

  /** Vertices at the same place become one, and cells one body. */
  JointedMesh
  welded(JointedMesh mesh)
  {
    std::vector<unsigned int> first(mesh.vertices.size());
    for (unsigned int i = 0; i < mesh.vertices.size(); ++i)
      for (first[i] = 0; first[i] < i; ++first[i])
        if (std::abs(mesh.vertices[i][0] - mesh.vertices[first[i]][0]) +
              std::abs(mesh.vertices[i][1] - mesh.vertices[first[i]][1]) <
            1e-12)
          break;
    for (auto &cell : mesh.cells)
      {
        cell.body = 0;
        for (unsigned int k = 0; k < 4; ++k)
          cell.vertices[k] = first[cell.vertices[k]];
      }
    for (auto &face : mesh.faces)
      for (unsigned int k = 0; k < 2; ++k)
        face.vertices[k] = first[face.vertices[k]];
    mesh.body_names = {"block"};
    return mesh;
  }

  ModelDefinition
  model_of_one_body(const unsigned int dim, const unsigned int degree)
  {
    ModelDefinition model;
    model.dimension         = dim;
    model.polynomial_degree = degree;
    add_material(model, "block", 1., 0.2);
    return model;
  }
} // namespace

// Chains of faces that turn by little are one part; numbers go by first faces.
TEST(JointCorners, StraightParts)
{
  using Parts      = std::vector<unsigned int>;
  const auto parts = [](const std::vector<double> &angles, const double limit) {
    std::vector<dealii::Tensor<1, 2>> normals;
    for (const double angle : angles)
      normals.push_back(at_angle(angle));
    return straight_parts(normals, limit);
  };
  EXPECT_EQ(parts({0., 90.}, 30.), (Parts{0, 1}));
  EXPECT_EQ(parts({0., 29.}, 30.), (Parts{0, 0}));
  EXPECT_EQ(parts({0., 30.}, 30.), (Parts{0, 0}));
  EXPECT_EQ(parts({0., 31.}, 30.), (Parts{0, 1}));
  EXPECT_EQ(parts({0., 40., 20.}, 30.), (Parts{0, 0, 0}));
  EXPECT_EQ(parts({0., 90., 10., 80.}, 30.), (Parts{0, 1, 0, 1}));
  EXPECT_EQ(parts({0., 180.}, 180.), (Parts{0, 0}));
  EXPECT_EQ(parts({0., 170.}, 169.), (Parts{0, 1}));
}

// A joint that runs round in 12 faces is smooth by default, in 11 it is not.
TEST(JointCorners, Polygons)
{
  for (const unsigned int n : {11, 12, 40})
    {
      BlockMesh ring;
      ring.add_block(
        "block",
        n,
        1,
        [](const double s, const double r) {
          const double angle = 2. * std::acos(-1.) * s;
          return std::array<double, 2>{{(2. - r) * std::cos(angle), (2. - r) * std::sin(angle)}};
        },
        {{"out", "", "J", ""}});
      ring.add_joint("J", "J", "");
      const JointedMesh mesh = welded(ring.mesh);
      const Discretization<2> space(mesh, model_of_one_body(2, 1));
      EXPECT_EQ(JointGeometry<2>(space, mesh).pairs().size(), n == 11 ? 2 * n : n);
    }
}

// Two elements at each of the two corners, each with half of a face of its own part. The numbers of
// elements follow the line.
TEST(JointCorners, Step)
{
  for (const unsigned int degree : {1, 2, 3})
    {
      const JointedMesh mesh = welded(step(2));
      const Discretization<2> space(mesh, model_of_one_body(2, degree));
      const JointGeometry<2> geometry(space, mesh);
      ASSERT_EQ(geometry.pairs().size(), 6 * degree + 1 + 2);
      dealii::Tensor<1, 2> sum;
      unsigned int n_upright = 0;
      for (const auto &pair : geometry.pairs())
        {
          const bool upright = std::abs(pair.normal[0]) > 0.5;
          n_upright += upright;
          EXPECT_LE((pair.normal - (upright ? at_angle(0.) : at_angle(90.))).norm(), 1e-14);
          EXPECT_EQ(pair.part,
                    pair.position.distance({1., 1.}) < 1e-12 && upright    ? 1u
                    : pair.position.distance({1., 0.}) < 1e-12 && !upright ? 1u
                                                                           : 0u);
          sum += pair.area * pair.normal;
        }
      EXPECT_EQ(n_upright, 2 * degree + 1);
      EXPECT_NEAR(sum[0], 1., 1e-14);
      EXPECT_NEAR(sum[1], 2., 1e-14);
      const auto report = corner_report(geometry.pairs(), mesh);
      ASSERT_EQ(report.size(), 1u);
      EXPECT_NE(report[0].find("2 corners"), std::string::npos) << report[0];
      EXPECT_NE(report[0].find("(1, 1), (1, 0)"), std::string::npos) << report[0];
    }
}

// The same in space, with cells refined by chance: nodes that hang on an edge give what they have
// of each part to the element of this part. Areas of the parts by hand.
TEST(JointCorners, RefinedInSpace)
{
#ifdef DEBUG
  GTEST_SKIP() << "deal.II 9.4.1 stops at satisfies_level1_at_vertex_rule while it refines this "
                  "mesh; to be understood";
#endif
  const JointedMesh mesh = extruded(welded(step(2)), 3);
  for (const unsigned int degree : {1, 2, 3})
    {
      std::size_t n_hanging = 0;
      for (const unsigned int seed : {1, 2, 3, 4})
        {
          ModelDefinition model = model_of_one_body(3, degree);
          tests::refine_at_random<3>(mesh, model, seed, 2);
          const Discretization<3> space(mesh, model);
          const JointGeometry<3> geometry(space, mesh);
          double level = 0., upright = 0.;
          for (const auto &pair : geometry.pairs())
            {
              const bool is_upright = pair.normal[0] > 0.5;
              EXPECT_NEAR(pair.normal[is_upright ? 0 : 1], 1., 1e-14) << pair.position;
              (is_upright ? upright : level) += pair.area;
              if (!pair.masters.empty() && std::abs(pair.position[0] - 1.) < 1e-12)
                ++n_hanging;
              dealii::Point<3> position;
              for (const auto &[master, weight] : pair.masters)
                {
                  position += weight * geometry.pairs()[master].position;
                  EXPECT_LE((geometry.pairs()[master].normal - pair.normal).norm(), 1e-13);
                }
              if (!pair.masters.empty())
                {
                  EXPECT_LE(position.distance(pair.position), 1e-13);
                }
            }
          EXPECT_NEAR(level, 3., 1e-12);
          EXPECT_NEAR(upright, 1.5, 1e-12);
        }
      EXPECT_GT(n_hanging, 10u);
    }
}
