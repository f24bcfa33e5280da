// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Hexahedra that are refined here and there: a vertex of a lip hangs together with the one it
// faces, and the areas are those of the shape functions with their constraints.

#include "block_mesh.h"
#include "random_refinement.h"
#include "spatial_meshes.h"

#include <fuga/bodies/joints/joint_geometry.h>
#include <fuga/bodies/space/serial_cell_id.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  /** The cell with this center. */
  std::vector<CellKey>
  cell_at(const dealii::Point<3> &center, const JointedMesh &mesh, const ModelDefinition &model)
  {
    std::vector<CellKey> found;
    const Discretization<3> coarse(mesh, model);
    for (const auto &cell : coarse.triangulation().active_cell_iterators())
      if (cell->center().distance(center) < 1e-12)
        found.push_back(serial_cell_id(cell).to_binary<3>());
    return found;
  }

  /** Refines by chance and checks the pairs of lips of the area @p area. Returns how many hang. */
  std::size_t
  check_lips(const JointedMesh &mesh,
             const unsigned int degree,
             const unsigned int seed,
             const double area)
  {
    ModelDefinition model;
    model.dimension         = 3;
    model.polynomial_degree = degree;
    tests::refine_at_random<3>(mesh, model, seed, 3);
    const Discretization<3> space(mesh, model);
    const JointGeometry<3> geometry(space, mesh);
    const auto &hanging   = space.hanging_nodes();
    std::size_t n_hanging = 0;
    double sum            = 0.;
    for (const auto &pair : geometry.pairs())
      {
        EXPECT_EQ(hanging.contain(pair.plus_node), !pair.masters.empty());
        EXPECT_EQ(hanging.contain(pair.plus_node), hanging.contain(pair.minus_node));
        EXPECT_LT(space.position(pair.plus_node).distance(space.position(pair.minus_node)), 1e-14);
        EXPECT_EQ(pair.area > 0., pair.masters.empty()) << pair.position;
        dealii::Point<3> position;
        for (const auto &[master, weight] : pair.masters)
          {
            EXPECT_TRUE(geometry.pairs()[master].masters.empty());
            EXPECT_EQ(geometry.pairs()[master].joint, pair.joint);
            position += weight * geometry.pairs()[master].position;
          }
        if (!pair.masters.empty())
          {
            ++n_hanging;
            EXPECT_LT(position.distance(pair.position), 1e-13);
          }
        sum += pair.area;
      }
    EXPECT_NEAR(sum, area, 1e-12 * area);
    return n_hanging;
  }
} // namespace


// Whatever is marked. The position of a hanging node is the mean of those of its masters by its
// weights, since edges are straight; forces lie on it as on them.
TEST(SpatialRefinement, LipsStayAlike)
{
  const JointedMesh crossing = extruded(blocks_round_a_crossing(2).mesh, 2);
  for (const unsigned int degree : {1, 2, 3})
    {
      std::size_t n_hanging = 0;
      for (const unsigned int seed : {1, 2, 3})
        n_hanging +=
          check_lips(crossing, degree, seed, 4.) + check_lips(narrow_block(), degree, seed, 1.5);
      EXPECT_GT(n_hanging, 50u);
    }
}


// One refined cell at the end of the upper lip: the edge at the end of the lower one belongs to a
// cell beside the joint too, which has to follow.
TEST(SpatialRefinement, CellsBesideTheJointFollow)
{
  const JointedMesh mesh = narrow_block();
  ModelDefinition model;
  model.dimension                   = 3;
  const std::vector<CellKey> marked = cell_at(dealii::Point<3>(0.25, 0.25, 0.75), mesh, model);
  ASSERT_EQ(marked.size(), 1u);
  model.local_refinements.push_back(marked);
  const Discretization<3> space(mesh, model);
  // It, the cell below, and the one beside that.
  EXPECT_EQ(space.n_cells(), mesh.cells.size() + 3 * 7);
  const JointGeometry<3> geometry(space, mesh);
  for (const auto &pair : geometry.pairs())
    EXPECT_EQ(space.hanging_nodes().contain(pair.plus_node),
              space.hanging_nodes().contain(pair.minus_node));
}


// The areas of a refined face among others, 1 x 1 with nodes at distances 1/4, by hand: its middle
// has 1/4 of a small face four times, a vertex of it what is its own and half of those of two
// hanging nodes beside it.
TEST(SpatialRefinement, AreasByHand)
{
  BlockMesh plane;
  plane.add_block("a", 6, 2, rectangle(-1., 2., -1., 0.), {{"b", "r", "J-", "l"}});
  plane.add_block("b", 6, 2, rectangle(-1., 2., 0., 1.), {{"J+", "r", "t", "l"}});
  plane.add_joint("J", "J+", "J-");
  const JointedMesh mesh = extruded(plane.mesh, 3);
  ModelDefinition model;
  model.dimension                   = 3;
  const std::vector<CellKey> marked = cell_at(dealii::Point<3>(0.25, 0.25, 0.75), mesh, model);
  model.local_refinements.push_back(marked);
  const Discretization<3> space(mesh, model);
  EXPECT_EQ(space.n_cells(), mesh.cells.size() + 2 * 7);
  const JointGeometry<3> geometry(space, mesh);
  constexpr double large = 0.25, small = large / 4.; // faces
  std::size_t n_found = 0;
  for (const auto &pair : geometry.pairs())
    {
      const auto distance = pair.position - dealii::Point<3>(0.25, 0., 0.75);
      const double x = std::abs(distance[0]), z = std::abs(distance[2]);
      if (x > 0.3 || z > 0.3)
        continue;
      ++n_found;
      const double expected = x < 0.01 && z < 0.01   ? small
                              : x > 0.01 && z > 0.01 ? 0.25 * (3. * large + small) + 0.5 * small
                                                     : 0.;
      EXPECT_NEAR(pair.area, expected, 1e-14) << pair.position;
    }
  EXPECT_EQ(n_found, 9u);
}
