// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"
#include "spatial_meshes.h"

#include <fuga/bodies/condensed/model_sizes.h>
#include <fuga/bodies/program/load_resultant.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::test;

namespace
{
  /** Rounding of sums of a few hundred terms of the size of ten. */
  constexpr double tolerance = 1e-11;

  /** A trapezoid, 18 wide at its base, 4 at its crest, 30 high, with an upright face x = 0. */
  BlockMesh
  trapezoid(const bool triangles)
  {
    BlockMesh mesh(triangles);
    mesh.add_block("dam",
                   3,
                   5,
                   [](const double s, const double r) {
                     return std::array<double, 2>{{s * (18. - 14. * r), 30. * r}};
                   },
                   {{"base", "downstream", "crest", "upstream"}});
    return mesh;
  }

  ModelDefinition
  trapezoid_model(const unsigned int degree)
  {
    ModelDefinition model;
    model.polynomial_degree = degree;
    model.thickness         = 2.;
    add_material(model, "dam", 3000., 0.2, 24.);
    hold(model, "base", "xy");
    hold(model, "downstream", "");
    hold(model, "crest", "");
    add_load(model, LoadKind::weight, {}, {});
    LoadDefinition water;
    water.name           = "water";
    water.kind           = LoadKind::depth_pressure;
    water.targets        = {"upstream"};
    water.depth.level    = "28";
    water.depth.gradient = 9.81;
    model.loads.push_back(water);
    return model;
  }

  template <int dim>
  CondensedSystem<dim>
  open_system(const JointedMesh &mesh, const ModelDefinition &model)
  {
    return {mesh, model, std::vector<bool>(mesh.joints.size(), false), Condensation::never};
  }
} // namespace


// By hand: area (18 + 4)/2 30 = 330; centroid (18² + 18·4 + 4²)/(3·22) = 412/66 from the face and
// 10 (18 + 2·4)/22 above the base; water γ H²/2 at H/3 of H = 28; all times a thickness of 2.
TEST(ModelSizes, DamInThePlane)
{
  for (const bool triangles : {false, true})
    for (const unsigned int degree : {1u, 2u})
      {
        const BlockMesh mesh        = trapezoid(triangles);
        const ModelDefinition model = trapezoid_model(degree);
        const auto system           = open_system<2>(mesh.mesh, model);
        const auto &space           = system.discretization();
        const auto sizes            = body_sizes(space, mesh.mesh);
        EXPECT_EQ(sizes[0].n_cells, triangles ? 30u : 15u);
        EXPECT_NEAR(sizes[0].volume, 660., tolerance);
        EXPECT_NEAR(sizes[0].centroid[0], 412. / 66., tolerance);
        EXPECT_NEAR(sizes[0].centroid[1], 260. / 22., tolerance);
        for (std::size_t label = 0; label < mesh.mesh.label_names.size(); ++label)
          {
            const double length = mesh.mesh.label_names[label] == "base"    ? 18.
                                  : mesh.mesh.label_names[label] == "crest" ? 4.
                                  : mesh.mesh.label_names[label] == "downstream"
                                    ? std::hypot(14., 30.)
                                    : 30.;
            EXPECT_NEAR(
              boundary_area(space, static_cast<unsigned int>(label)), 2. * length, tolerance);
          }

        LoadResultant<2> weight = resultant_of(space, system.assemble_load(0, 0.).forces);
        EXPECT_EQ(weight.force(0), 0.);
        EXPECT_NEAR(weight.force(1), -660. * 24., 1e3 * tolerance);
        EXPECT_NEAR(weight.place(1, 0), 412. / 66., tolerance);
        LoadResultant<2> water = resultant_of(space, system.assemble_load(1, 0.).forces);
        const double force     = 9.81 * 28. * 28.; // γ H²/2, twice
        EXPECT_NEAR(water.force(0), force, 1e3 * tolerance);
        EXPECT_EQ(water.force(1), 0.);
        EXPECT_NEAR(water.place(0, 1), 28. / 3., tolerance);
        EXPECT_EQ(water.couple()[2], 0.);
        weight.scale(0.5);
        water.add(weight);
        EXPECT_NEAR(water.force(0), force, 1e3 * tolerance);
        EXPECT_NEAR(water.force(1), -330. * 24., 1e3 * tolerance);
        EXPECT_NEAR(water.place(1, 0), 412. / 66., tolerance);
      }
}


// A joint 3 long under a block 3 x 2; in space 1.5 wide. A pair of forces ±2 with the lever 3 is a
// couple of 6: its sign about z, and in space about every axis, by the right-hand rule.
TEST(ModelSizes, JointsAndCouples)
{
  const BlockMesh mesh  = two_blocks();
  ModelDefinition model = two_block_model();
  const auto plane      = open_system<2>(mesh.mesh, model);
  const auto joint      = joint_sizes(plane.discretization(), plane.joint_geometry(), 1)[0];
  EXPECT_NEAR(joint.area, 3., tolerance);
  EXPECT_EQ(joint.n_faces, 6u);
  EXPECT_EQ(joint.distance, 0.);
  EXPECT_NEAR(joint.normal[1], 1., tolerance);
  EXPECT_NEAR(joint.normal[0], 0., tolerance);

  model.dimension = 3;
  model.loads.clear();
  hold(model, "side", "xz");
  const JointedMesh in_space = extruded(mesh.mesh, 3);
  ModelDefinition of_space   = two_block_model();
  of_space.dimension         = 3;
  of_space.loads.clear();
  of_space.boundary_conditions.clear();
  hold(of_space, "base", "xyz");
  hold(of_space, "side", "xz");
  hold(of_space, "free", "");
  hold(of_space, "top", "");
  JointedMesh held = in_space;
  const Discretization<3> space(held, of_space);
  const JointGeometry<3> geometry(space, held);
  const auto in_area = joint_sizes(space, geometry, 1)[0];
  EXPECT_NEAR(in_area.area, 4.5, tolerance);
  EXPECT_NEAR(in_area.normal[1], 1., tolerance);
  const auto sizes = body_sizes(space, held);
  EXPECT_NEAR(sizes[1].volume, 9., tolerance);
  EXPECT_NEAR(sizes[1].centroid[2], 0.75, tolerance);

  LoadResultant<2> couple;
  couple.add(dealii::Point<2>(3., 7.), dealii::Tensor<1, 2>({0., 2.}));
  couple.add(dealii::Point<2>(0., 7.), dealii::Tensor<1, 2>({0., -2.}));
  EXPECT_EQ(couple.force(1), 0.);
  EXPECT_FALSE(couple.is_empty());
  EXPECT_NEAR(couple.couple()[2], 6., tolerance);
  for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const unsigned int arm = (axis + 1) % 3, along = (axis + 2) % 3;
      LoadResultant<3> turning;
      dealii::Point<3> place;
      dealii::Tensor<1, 3> force;
      place[arm]   = 3.;
      force[along] = 2.;
      turning.add(place, force);
      turning.add(dealii::Point<3>(), -force);
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_NEAR(turning.couple()[c], c == axis ? 6. : 0., tolerance) << axis << c;
    }
}


// A cone of radius 3 and height 4 about x = 0, of one triangle: π r² h/3, its centroid on the axis
// at h/4.
TEST(ModelSizes, Cone)
{
  JointedMesh mesh;
  mesh.dimension   = 2;
  mesh.vertices    = {{{0., 0., 0.}}, {{3., 0., 0.}}, {{0., 4., 0.}}};
  mesh.body_names  = {"cone"};
  mesh.label_names = {"base", "side", "axis"};
  JointedMesh::Cell cell;
  cell.shape    = CellShape::triangle;
  cell.vertices = {{0, 1, 2}};
  mesh.cells.push_back(cell);
  for (unsigned int i = 0; i < 3; ++i)
    {
      JointedMesh::Face face;
      face.vertices = {{i, (i + 1) % 3, 0, 0}};
      face.label    = i;
      mesh.faces.push_back(face);
    }
  ModelDefinition model;
  model.assumption = PlaneAssumption::axisymmetric;
  add_material(model, "cone", 3000., 0.2, 24.);
  hold(model, "base", "xy");
  const Discretization<2> space(mesh, model);
  const auto size = body_sizes(space, mesh)[0];
  EXPECT_NEAR(size.volume, M_PI * 12., tolerance);
  EXPECT_EQ(size.centroid[0], 0.);
  EXPECT_NEAR(size.centroid[1], 1., tolerance);
  EXPECT_NEAR(boundary_area(space, 0), M_PI * 9., tolerance);
  EXPECT_NEAR(boundary_area(space, 1), M_PI * 3. * 5., tolerance);
}
