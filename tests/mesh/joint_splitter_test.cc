// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "mesh_builder.h"

#include <algorithm>

using namespace fuga;
using namespace fuga_tests;

namespace
{
  /** Mean y of the cells whose edge is the first face with this label: tells above from below. */
  double
  side_of(const JointedMesh &mesh, const std::string &label)
  {
    for (const auto &face : mesh.faces)
      if (mesh.label_names[face.label] == label)
        for (const auto &cell : mesh.cells)
          {
            const auto begin = cell.vertices.begin(), end = begin + n_vertices(cell.shape);
            const auto first = std::find(begin, end, face.vertices[0]);
            if (first != end && cell.vertices[static_cast<std::size_t>(first - begin + 1) %
                                              n_vertices(cell.shape)] == face.vertices[1])
              {
                double y = 0;
                for (auto v = begin; v != end; ++v)
                  y += mesh.vertices[*v][1] / n_vertices(cell.shape);
                return y;
              }
          }
    ADD_FAILURE() << "no cell has the face " << label << " in its own direction";
    return 0;
  }
} // namespace


// Counted by hand: 3 x 2 squares have 12 vertices, 4 of them on the joint; the outer boundary has
// 10 faces.
TEST(JointSplitter, OpensALineBetweenTwoBodies)
{
  MeshBuilder builder = two_rows(3, 2);
  builder.chain("base", 11, {4, 5, 6, 7});
  builder.chain("bottom", 12, {0, 1, 2, 3});
  const JointedMesh mesh = split_joints(builder.mesh, {line_joint("base", "upper", "lower")});

  EXPECT_EQ(mesh.vertices.size(), 16U);
  EXPECT_EQ(mesh.body_names, (std::vector<std::string>{"lower", "upper"}));
  EXPECT_EQ(mesh.label_names, (std::vector<std::string>{"bottom", "base+", "base-"}));
  EXPECT_EQ(mesh.faces.size(), 9U);
  EXPECT_EQ(mesh.unlabelled_faces.size(), 7U);
  EXPECT_EQ(n_faces_labelled(mesh, "base+"), 3U);
  EXPECT_EQ(n_faces_labelled(mesh, "base-"), 3U);
  ASSERT_EQ(mesh.joints.size(), 1U);
  EXPECT_EQ(mesh.joints[0].plus_label, 1U);
  EXPECT_EQ(mesh.joints[0].minus_label, 2U);
  EXPECT_DOUBLE_EQ(side_of(mesh, "base+"), 1.5);
  EXPECT_DOUBLE_EQ(side_of(mesh, "base-"), 0.5);
  EXPECT_EQ(
    mesh.report.at(0),
    "joint 'base': opened 3 faces, length 3, 4 vertices doubled, 0 tips inside a body, normal "
    "from lower to "
    "upper");
}


// By definition: the k-th faces of both lips lie on each other, with their directions opposite.
TEST(JointSplitter, LipsAreInTheSameOrder)
{
  MeshBuilder builder = two_rows(3, 2);
  builder.chain("base", 11, {4, 5, 6, 7});
  const JointedMesh mesh = split_joints(builder.mesh, {line_joint("base", "lower", "upper")});
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 2; ++i)
      {
        const unsigned int plus  = mesh.faces[k].vertices[i],
                           minus = mesh.faces[k + 3].vertices[1 - i];
        EXPECT_NE(plus, minus);
        EXPECT_EQ(mesh.vertices[plus], mesh.vertices[minus]);
      }
}


// Counted by hand: of the crack's vertices 6, 7, 8 only the middle one is doubled. Left of the
// drawing is plus.
TEST(JointSplitter, CrackWithTwoTips)
{
  MeshBuilder builder = MeshBuilder::grid(4, 2);
  builder.chain("crack", 11, {6, 7, 8});
  JointedMesh mesh = split_joints(builder.mesh, {line_joint("crack", "plate", "plate")});
  EXPECT_EQ(mesh.vertices.size(), 16U);
  EXPECT_DOUBLE_EQ(side_of(mesh, "crack+"), 1.5);
  EXPECT_EQ(
    mesh.report.at(0),
    "joint 'crack': opened 2 faces, length 2, 1 vertex doubled, 2 tips inside a body, normal to "
    "the left of the "
    "line");

  MeshBuilder backwards = MeshBuilder::grid(4, 2);
  backwards.chain("crack", 11, {8, 7, 6});
  mesh = split_joints(backwards.mesh, {line_joint("crack", "plate", "plate")});
  EXPECT_DOUBLE_EQ(side_of(mesh, "crack+"), 0.5);
}


// Counted by hand: the crack starts on the left boundary; vertices 5 and 6 are doubled, 7 is the
// tip.
TEST(JointSplitter, CrackFromTheBoundary)
{
  MeshBuilder builder = MeshBuilder::grid(4, 2);
  builder.chain("crack", 11, {5, 6, 7});
  const JointedMesh mesh = split_joints(builder.mesh, {line_joint("crack", "plate", "plate")});
  EXPECT_EQ(mesh.vertices.size(), 17U);
  expect_parts(mesh.report.at(0), {"2 vertices doubled, 1 tip inside"});
}


// Counted by hand: 9 vertices; three ends are doubled, the centre becomes three: 9 + 3 + 2.
TEST(JointSplitter, TJunction)
{
  MeshBuilder builder                = four_blocks();
  builder.mesh.cells[1].physical_tag = 1;
  builder.chain("left", 11, {3, 4});
  builder.chain("right", 12, {4, 5});
  builder.chain("between", 13, {4, 7});
  const JointedMesh mesh = split_joints(
    builder.mesh,
    {line_joint("left", "c", "a"), line_joint("right", "d", "a"), line_joint("between", "c", "d")});
  EXPECT_EQ(mesh.vertices.size(), 14U);
  EXPECT_EQ(mesh.faces.size(), 6U);
  EXPECT_EQ(mesh.unlabelled_faces.size(), 8U);
  for (const std::string &line : mesh.report)
    expect_parts(line, {"1 vertex doubled, 1 branch point shared", "0 tips"});
  // the foundation keeps one vertex at the centre: its two cells still hang together there
  EXPECT_EQ(mesh.cells[0].vertices[2], mesh.cells[1].vertices[3]);
}


// Counted by hand: nothing hangs together any more, every cell has its own four vertices: 16.
TEST(JointSplitter, XJunction)
{
  MeshBuilder builder = four_blocks();
  builder.chain("ab", 11, {1, 4});
  builder.chain("cd", 12, {4, 7});
  builder.chain("ac", 13, {3, 4});
  builder.chain("bd", 14, {4, 5});
  const JointedMesh mesh = split_joints(builder.mesh,
                                        {line_joint("ab", "a", "b"),
                                         line_joint("cd", "c", "d"),
                                         line_joint("ac", "c", "a"),
                                         line_joint("bd", "d", "b")});
  EXPECT_EQ(mesh.vertices.size(), 16U);
  std::vector<unsigned int> seen(16, 0);
  for (const auto &cell : mesh.cells)
    for (unsigned int i = 0; i < 4; ++i)
      ++seen[cell.vertices[i]];
  EXPECT_EQ(seen, std::vector<unsigned int>(16, 1));
}


// Counted by hand: 6 triangles around vertex 0. k cut spokes leave max(1, k) fans at the centre (k
// = 1: a tip) and double k vertices on the rim.
TEST(JointSplitter, CountsFans)
{
  for (unsigned int k = 1; k <= 3; ++k)
    {
      MeshBuilder builder;
      const std::vector<std::array<double, 3>> rim{
        {{2, 0, 0}}, {{1, 2, 0}}, {{-1, 2, 0}}, {{-2, 0, 0}}, {{-1, -2, 0}}, {{1, -2, 0}}};
      builder.mesh.vertices = {{{0, 0, 0}}};
      builder.mesh.vertices.insert(builder.mesh.vertices.end(), rim.begin(), rim.end());
      for (unsigned int i = 0; i < 6; ++i)
        builder.cell(CellShape::triangle, {0, 1 + i, 1 + (i + 1) % 6}, 1);
      builder.mesh.physical_names[{2, 1}] = "plate";
      std::vector<JointDefinition> joints;
      for (unsigned int i = 0; i < k; ++i)
        {
          builder.chain("spoke" + std::to_string(i), 11 + static_cast<int>(i), {0, 1 + 2 * i});
          joints.push_back(line_joint("spoke" + std::to_string(i), "plate", "plate"));
        }
      EXPECT_EQ(split_joints(builder.mesh, joints).vertices.size(), 7 + (std::max(1U, k) - 1) + k);
    }
}


// Counted by hand: two parallel lines across 2 x 3 squares (12 vertices) double 3 vertices each.
TEST(JointSplitter, TwoJoints)
{
  MeshBuilder builder = two_rows(2, 3);
  builder.chain("first", 11, {3, 4, 5});
  builder.chain("second", 12, {6, 7, 8});
  const JointedMesh mesh = split_joints(
    builder.mesh, {line_joint("first", "upper", "lower"), line_joint("second", "upper", "upper")});
  EXPECT_EQ(mesh.vertices.size(), 18U);
  EXPECT_EQ(mesh.label_names, (std::vector<std::string>{"first+", "first-", "second+", "second-"}));
  EXPECT_EQ(mesh.joints[1].plus_label, 2U);
}


// Counted by hand: nothing is doubled; the lip has 3 faces of length 1.
TEST(JointSplitter, OneLipAgainstARigidObstacle)
{
  MeshBuilder builder = MeshBuilder::grid(3, 1);
  builder.chain("contact", 11, {0, 1, 2, 3});
  const JointedMesh mesh = split_joints(builder.mesh, {lip_joint("floor", "contact", "")});
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.joints.at(0).plus_label, 0U);
  EXPECT_EQ(mesh.joints.at(0).minus_label, JointedMesh::no_label);
  EXPECT_EQ(
    mesh.report.at(0),
    "joint 'floor': lip 'contact' against a rigid obstacle, 3 faces, length 3, normal into the "
    "body");
}


// Counted by hand: the mesh is open already, all stays; lips keep the names of their groups.
TEST(JointSplitter, OpenMesh)
{
  const JointedMesh mesh = split_joints(open_pair(1).mesh, {lip_joint("joint", "base", "top")});
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.label_names.at(mesh.joints.at(0).plus_label), "base");
  EXPECT_EQ(mesh.label_names.at(mesh.joints.at(0).minus_label), "top");
  EXPECT_EQ(
    mesh.report.at(0),
    "joint 'joint': open in the mesh between lip 'base' (1 face, length 1) and lip 'top' (1 "
    "face, length 1), "
    "normal from top to base");

  expect_joint_complaint(open_pair(1.000001),
                         {lip_joint("joint", "base", "top")},
                         {"do not match", "1.000001", "length 1"});
  JointDefinition wrong_body = lip_joint("joint", "base", "top");
  wrong_body.plus_body       = "lower";
  expect_joint_complaint(open_pair(1),
                         {wrong_body},
                         {"'base' belongs to the body 'upper'", "(0.5, 1)", "not to 'lower'"});
}


// By definition: clockwise cells are turned, so that the area (cross product of the diagonals) is
// positive.
TEST(JointSplitter, OrientsCells)
{
  MeshBuilder builder = MeshBuilder::grid(2, 1);
  std::reverse(builder.mesh.cells[0].vertices.begin(), builder.mesh.cells[0].vertices.begin() + 4);
  const JointedMesh mesh = split_joints(builder.mesh, {});
  const auto &v          = mesh.cells[0].vertices;
  const auto x = [&](const unsigned int i, const unsigned int d) { return mesh.vertices[v[i]][d]; };
  EXPECT_GT((x(2, 0) - x(0, 0)) * (x(3, 1) - x(1, 1)) - (x(2, 1) - x(0, 1)) * (x(3, 0) - x(1, 0)),
            0);

  MeshBuilder flat      = MeshBuilder::grid(2, 1);
  flat.mesh.vertices[4] = {{1., 0., 0.}};
  expect_joint_complaint(flat, {}, {"hand.msh", "'plate'", "(1, 0)", "degenerate"});
  MeshBuilder concave      = MeshBuilder::grid(1, 1);
  concave.mesh.vertices[3] = {{0.2, 0.2, 0.}};
  expect_joint_complaint(concave, {}, {"(0.2, 0.2)", "not convex"});
  // All bad cells at once: the vertices 3 and 5 of two cells side by side are moved inwards.
  MeshBuilder two      = MeshBuilder::grid(2, 1);
  two.mesh.vertices[3] = {{0.8, 0.2, 0.}};
  two.mesh.vertices[5] = {{1.2, 0.2, 0.}};
  expect_joint_complaint(two, {}, {"(0.8, 0.2)", "(1.2, 0.2)", "2 errors"});
  MeshBuilder twice = MeshBuilder::grid(2, 1);
  twice.cell(CellShape::quadrilateral, {0, 1, 4, 3}, 1);
  expect_joint_complaint(twice, {}, {"overlap", "'plate'", "look for surfaces drawn twice"});
}


// Counted by hand: the tip 6 stays one vertex and may have a name, the doubled vertex 7 may not.
TEST(JointSplitter, NamedPoints)
{
  MeshBuilder builder = MeshBuilder::grid(4, 2);
  builder.chain("crack", 11, {6, 7, 8});
  builder.point("tip", 21, 6);
  const JointedMesh mesh = split_joints(builder.mesh, {line_joint("crack", "plate", "plate")});
  ASSERT_EQ(mesh.points.size(), 1U);
  EXPECT_EQ(mesh.points[0].vertex, 6U);
  EXPECT_EQ(mesh.points[0].name, "tip");
  builder.point("middle", 22, 7);
  expect_joint_complaint(
    builder, {line_joint("crack", "plate", "plate")}, {"'middle'", "(2, 1)", "2 vertices"});
}
