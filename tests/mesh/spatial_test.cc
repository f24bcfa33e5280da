// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "mesh_builder.h"

#include <algorithm>

using namespace fuga;
using namespace fuga_tests;

namespace
{
  /** 2 x 1 x 2 unit cubes: the lower two are body "lower", the upper two "upper". */
  MeshBuilder
  four_cubes()
  {
    MeshBuilder builder;
    builder.mesh.dimension = 3;
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int j = 0; j < 2; ++j)
        for (unsigned int i = 0; i < 3; ++i)
          builder.mesh.vertices.push_back({{double(i), double(j), double(k)}});
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int i = 0; i < 2; ++i)
        {
          const unsigned int v = 6 * k + i;
          builder.cell(CellShape::hexahedron,
                       {v, v + 1, v + 4, v + 3, v + 6, v + 7, v + 10, v + 9},
                       int(k) + 1);
        }
    builder.mesh.physical_names[{3, 1}] = "lower";
    builder.mesh.physical_names[{3, 2}] = "upper";
    builder.mesh.physical_names[{2, 9}] = "base";
    builder.mesh.faces.push_back(MeshBuilder::entity(CellShape::quadrilateral, {6, 7, 10, 9}, 9));
    return builder;
  }

  /** z of (b - a) x (c - a) of a face. */
  double
  normal_z(const JointedMesh &mesh, const JointedMesh::Face &face)
  {
    const auto x = [&](const unsigned int i, const unsigned int d) {
      return mesh.vertices[face.vertices[i]][d] - mesh.vertices[face.vertices[0]][d];
    };
    return x(1, 0) * x(2, 1) - x(1, 1) * x(2, 0);
  }
} // namespace


// Counted by hand: 18 vertices, 6 on the joint; 16 outer faces. The lips look away from their
// cubes.
TEST(JointSplitter3D, OpensASurface)
{
  MeshBuilder builder = four_cubes();
  builder.mesh.faces.push_back(MeshBuilder::entity(CellShape::quadrilateral, {7, 8, 11, 10}, 9));
  // one cube numbered the wrong way round is turned
  std::swap_ranges(builder.mesh.cells[3].vertices.begin(),
                   builder.mesh.cells[3].vertices.begin() + 4,
                   builder.mesh.cells[3].vertices.begin() + 4);
  const JointedMesh mesh = split_joints(builder.mesh, {line_joint("base", "upper", "lower")});
  EXPECT_EQ(mesh.vertices.size(), 24U);
  EXPECT_EQ(mesh.unlabelled_faces.size(), 16U);
  ASSERT_EQ(mesh.faces.size(), 4U);
  for (const auto &face : mesh.faces)
    EXPECT_DOUBLE_EQ(normal_z(mesh, face), mesh.label_names[face.label] == "base+" ? -1. : 1.);
  EXPECT_EQ(
    mesh.report.at(0),
    "joint 'base': opened 2 faces, area 2, 6 vertices doubled, 0 tips inside a body, normal from "
    "lower to "
    "upper");
}


// Counted by hand: one of two faces is cut; its vertices at x = 0 are doubled, those at x = 1 are
// tips. Inside one body the plus side is where the drawn normal (here +z) points.
TEST(JointSplitter3D, CrackFront)
{
  MeshBuilder builder = four_cubes();
  for (auto &cell : builder.mesh.cells)
    cell.physical_tag = 1;
  const JointedMesh mesh = split_joints(builder.mesh, {line_joint("base", "lower", "lower")});
  EXPECT_EQ(mesh.vertices.size(), 20U);
  expect_parts(mesh.report.at(0),
               {"area 1, 2 vertices doubled, 2 tips", "normal as that of the drawn surface"});
  EXPECT_DOUBLE_EQ(normal_z(mesh, mesh.faces.at(0)), -1.);
}


// Counted by hand: two tetrahedra on both sides of a triangle in the plane x = 0; three vertices
// doubled.
TEST(JointSplitter3D, Tetrahedra)
{
  const std::string text =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n3\n2 3 \"j\"\n3 1 \"a\"\n3 2 \"b\"\n$EndPhysicalNames\n"
    "$Nodes\n5\n1 0 0 0\n2 0 1 0\n3 0 0 1\n4 1 0 0\n5 -1 0 0\n$EndNodes\n"
    "$Elements\n4\n1 1 2 7 1 1 2\n2 2 2 3 1 1 2 3\n3 4 2 1 1 1 2 3 4\n4 4 2 2 2 1 2 3 5\n"
    "$EndElements\n";
  const JointedMesh mesh =
    split_joints(parse_gmsh_mesh(text, "tets.msh"), {line_joint("j", "a", "b")});
  EXPECT_EQ(mesh.dimension, 3U);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.unlabelled_faces.size(), 6U);
  expect_parts(mesh.report.at(0),
               {"opened 1 face, area 0.5, 3 vertices doubled, 0 tips", "from b to a"});
}
