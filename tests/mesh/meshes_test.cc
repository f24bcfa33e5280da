// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "mesh_builder.h"

#include <cmath>

using namespace fuga;
using namespace fuga_tests;

namespace
{
  GmshMesh
  read(const std::string &name)
  {
    return read_gmsh_mesh(FUGA_SOURCE_DIR "/meshes/" + name);
  }

  double
  area(const JointedMesh &mesh, const std::string &body)
  {
    double sum = 0;
    for (const auto &cell : mesh.cells)
      if (mesh.body_names[cell.body] == body)
        for (unsigned int i = 0, n = n_vertices(cell.shape); i < n; ++i)
          {
            const auto &a = mesh.vertices[cell.vertices[i]];
            const auto &b = mesh.vertices[cell.vertices[(i + 1) % n]];
            sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
          }
    return sum;
  }

  /** Splits and checks the sizes, and that every face of the open boundary has a name. */
  JointedMesh
  expect_sizes(const std::string &name,
               const std::vector<JointDefinition> &joints,
               const std::size_t n_vertices,
               const std::size_t n_cells)
  {
    const JointedMesh mesh = split_joints(read(name), joints);
    EXPECT_EQ(mesh.vertices.size(), n_vertices) << name;
    EXPECT_EQ(mesh.cells.size(), n_cells) << name;
    EXPECT_EQ(mesh.unlabelled_faces.size(), 0U) << name;
    return mesh;
  }
} // namespace


// Counted by hand: foundation 40 x 12 squares, structure 8 x 24: 41*13 + 9*25 vertices, 480 + 192
// cells.
TEST(Meshes, S0)
{
  const JointDefinition base = line_joint("base", "structure", "foundation");
  for (const JointedMesh &mesh :
       {expect_sizes("s0.msh", {base}, 758, 672),
        expect_sizes("s0_tri.msh", {base}, 758, 1344),
        expect_sizes(
          "s0_split.msh", {lip_joint("base", "structure_base", "foundation_contact")}, 758, 672)})
    {
      EXPECT_NEAR(area(mesh, "structure"), 48., 1e-9);
      EXPECT_NEAR(area(mesh, "foundation"), 120., 1e-9);
      for (const auto &[label, n] :
           std::vector<std::pair<std::string, unsigned int>>{{"upstream", 24},
                                                             {"downstream", 24},
                                                             {"crest", 8},
                                                             {"foundation_top", 32},
                                                             {"foundation_bottom", 40},
                                                             {"foundation_sides", 24}})
        EXPECT_EQ(n_faces_labelled(mesh, label), n) << label;
    }
}


// Counted by hand: n x n squares of a block 40 x 40, the corner at (40, 0).
TEST(Meshes, Raous)
{
  for (const unsigned int n : {32U, 64U})
    {
      const JointedMesh mesh = expect_sizes("raous_" + std::to_string(n) + ".msh",
                                            {lip_joint("floor", "contact", "")},
                                            (n + 1) * (n + 1),
                                            n * n);
      EXPECT_NEAR(area(mesh, "block"), 1600., 1e-9);
      EXPECT_EQ(n_faces_labelled(mesh, "contact"), n);
      ASSERT_EQ(mesh.points.size(), 1U);
      EXPECT_EQ(mesh.points[0].name, "corner");
      EXPECT_DOUBLE_EQ(mesh.vertices[mesh.points[0].vertex][0], 40.);
      EXPECT_DOUBLE_EQ(mesh.vertices[mesh.points[0].vertex][1], 0.);
    }
}


// Degrees of freedom (two per vertex): printed with the reference solutions of scene G, where ndof
// is 2028, 5036 and 18936; cells (first row): 40 x 20 + 8 x 16 squares of 2.5.
TEST(Meshes, SceneG)
{
  const JointDefinition base = line_joint("base", "block", "foundation");
  expect_sizes("scene_g_9.msh", {base}, 2028 / 2, 928);
  const JointedMesh mesh = expect_sizes("scene_g_33.msh", {base}, 5036 / 2, 2368);
  EXPECT_NEAR(area(mesh, "block"), 800., 1e-9);
  EXPECT_NEAR(area(mesh, "foundation"), 5000., 1e-9);
  EXPECT_EQ(split_joints(read("scene_g_129.msh"), {base}).vertices.size(), 18936U / 2);
}


// Areas by hand: each block is 3 wide and 2 high in the mean. The joint is 3 / cos 20° long.
TEST(Meshes, Patch)
{
  for (const std::string name : {"patch_quad.msh", "patch_tri.msh"})
    {
      const JointedMesh mesh = split_joints(read(name), {line_joint("joint", "upper", "lower")});
      EXPECT_EQ(mesh.unlabelled_faces.size(), 0U);
      EXPECT_NEAR(area(mesh, "lower"), 6., 1e-9);
      EXPECT_NEAR(area(mesh, "upper"), 6., 1e-9);
      EXPECT_EQ(mesh.cells[0].shape,
                name == "patch_quad.msh" ? CellShape::quadrilateral : CellShape::triangle);
      double length = 0;
      for (const auto &face : mesh.faces)
        if (mesh.label_names[face.label] == "joint+")
          length +=
            std::hypot(mesh.vertices[face.vertices[0]][0] - mesh.vertices[face.vertices[1]][0],
                       mesh.vertices[face.vertices[0]][1] - mesh.vertices[face.vertices[1]][1]);
      EXPECT_NEAR(length, 3.1925333, 1e-6);
    }
}


// Counted by hand: crack 9 x 9 vertices and 3 doubled; cross four blocks of 3 x 3 vertices, none
// shared; wall foundation 13 x 5 vertices and two blocks of 3 x 5.
TEST(Meshes, CracksAndJunctions)
{
  expect_sizes("crack.msh", {line_joint("crack", "plate", "plate")}, 84, 64);
  expect_sizes("cross.msh",
               {line_joint("j_ab", "a", "b"),
                line_joint("j_cd", "c", "d"),
                line_joint("j_ac", "c", "a"),
                line_joint("j_bd", "d", "b")},
               36,
               16);
  expect_sizes("wall.msh",
               {line_joint("left_base", "left_block", "foundation"),
                line_joint("right_base", "right_block", "foundation"),
                line_joint("between", "left_block", "right_block")},
               95,
               64);
}
