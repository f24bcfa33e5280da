// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/mesh/gmsh_mesh.h>

#include "mesh_builder.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <random>

using namespace fuga;
using namespace fuga_tests;

namespace
{
  /** One unit square of body "soil: 5 m", its lower edge "base", its upper edge in no group, a
   * point.
   */
  const std::string square_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n3\n0 3 \"corner\"\n1 7 \"base\"\n2 5 \"soil: 5 m\"\n"
    "$EndPhysicalNames\n"
    "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n9 8 8 8\n$EndNodes\n"
    "$Elements\n4\n1 15 2 3 1 1\n2 1 2 7 1 1 2\n3 1 2 0 3 3 4\n"
    "4 3 2 5 1 1 2 3 4\n$EndElements\n";

  /** The same in format 4.1, with what else Gmsh may write. */
  const std::string square_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nby hand\n$EndComments\n"
    "$PhysicalNames\n3\n0 3 \"corner\"\n1 7 \"base\"\n2 5 \"soil: 5 m\"\n$EndPhysicalNames\n"
    "$Entities\n1 2 1 0\n1 0 0 0 1 3 \n1 0 0 0 1 0 0 1 7 2 1 -2 \n3 0 1 0 1 1 0 0 2 3 -4 \n"
    "1 0 0 0 1 1 0 1 5 4 1 2 3 4 \n$EndEntities\n"
    "$Nodes\n3 5 1 90\n0 1 0 1\n1\n0 0 0\n1 1 1 1\n2\n1 0 0 1.\n2 1 0 3\n3\n4\n90\n1 1 0\n0 1 0\n8 "
    "8 8\n"
    "$EndNodes\n"
    "$Elements\n4 4 1 4\n0 1 15 1\n1 1 \n1 1 1 1\n2 1 2 \n1 3 1 1\n3 3 4 \n2 1 3 1\n4 1 2 3 4 \n"
    "$EndElements\n$Periodic\n0\n$EndPeriodic\n";

  std::string
  with(std::string text, const std::string &old_part, const std::string &new_part)
  {
    const std::size_t place = text.find(old_part);
    EXPECT_NE(place, std::string::npos) << old_part;
    return text.replace(place, old_part.size(), new_part);
  }

  void
  expect_complaint(const std::string &text, const std::vector<std::string> &parts)
  {
    expect_parts(complaint([&] { parse_gmsh_mesh(text, "m.msh"); }), parts);
  }

  void
  expect_square(const GmshMesh &mesh)
  {
    EXPECT_EQ(mesh.dimension, 2U);
    ASSERT_EQ(mesh.vertices.size(), 4U);
    EXPECT_EQ(mesh.vertices[2], (std::array<double, 3>{{1., 1., 0.}}));
    ASSERT_EQ(mesh.cells.size(), 1U);
    EXPECT_EQ(mesh.cells[0].shape, CellShape::quadrilateral);
    EXPECT_EQ(mesh.cells[0].vertices, (std::array<unsigned int, 8>{{0, 1, 2, 3, 0, 0, 0, 0}}));
    ASSERT_EQ(mesh.faces.size(), 1U);
    EXPECT_EQ(mesh.faces[0].vertices[1], 1U);
    ASSERT_EQ(mesh.points.size(), 1U);
    EXPECT_EQ(mesh.physical_names.at({2, 5}), "soil: 5 m");
    EXPECT_EQ(mesh.physical_names.at({1, 7}), "base");
  }
} // namespace


// Counts: the texts above, written by hand; node 9 (90) is in no cell and goes, the edge without
// group too.
TEST(GmshMesh, ReadsBothFormats)
{
  expect_square(parse_gmsh_mesh(square_2, "m.msh"));
  expect_square(parse_gmsh_mesh(square_4, "m.msh"));
}


// Counts as before: neither line ends nor blank lines, gaps in the node numbers nor partitions
// matter.
TEST(GmshMesh, ToleratesOtherWriters)
{
  std::string windows;
  for (const char c : square_4)
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_square(parse_gmsh_mesh(windows, "m.msh"));
  expect_square(
    parse_gmsh_mesh(with(square_2, "2 1 0 0\n", "\n  2 +1. 0e5\t1e-400 \n\n"), "m.msh"));
  expect_square(parse_gmsh_mesh(with(square_2, "4 3 2 5 1 1", "4 3 4 5 1 1 1 1"), "m.msh"));
  // a node number far away must not cost memory
  expect_square(parse_gmsh_mesh(with(square_2, "9 8 8 8", "9000000000000000000 8 8 8"), "m.msh"));
}


// By definition: a group of negative tag holds its line in the reverse direction.
TEST(GmshMesh, NegativeGroupReversesFaces)
{
  for (const std::string &text : {with(square_2, "2 1 2 7 1 1 2", "2 1 2 -7 1 1 2"),
                                  with(square_4, "1 0 0 0 1 0 0 1 7", "1 0 0 0 1 0 0 1 -7")})
    {
      const GmshMesh mesh = parse_gmsh_mesh(text, "m.msh");
      EXPECT_EQ(mesh.faces.at(0).physical_tag, 7);
      EXPECT_EQ(mesh.faces.at(0).vertices[0], 1U);
      EXPECT_EQ(mesh.faces.at(0).vertices[1], 0U);
    }
}


// Line numbers: counted in square_2.
TEST(GmshMesh, ComplainsAboutTheFile)
{
  expect_parts(complaint([] { read_gmsh_mesh("not/there.msh"); }),
               {"not/there.msh", "cannot be opened", "check the name"});
  expect_parts(complaint([] { read_gmsh_mesh(FUGA_SOURCE_DIR); }), {"directory"});
  expect_complaint("", {"m.msh:1: ", "empty"});
  expect_complaint("# vtk DataFile\n", {"m.msh:1: ", "$MeshFormat", "gmsh FILE -save"});
  expect_complaint(with(square_2, "2.2 0", "4.0 0"),
                   {"m.msh:2: ", "'4.0'", "2.2 and 4.1", "-format msh41"});
  expect_complaint(with(square_2, "2.2 0", "2.2 1"), {"m.msh:2: ", "binary", "Mesh.Binary 0"});
  expect_complaint(with(square_2, "$EndMeshFormat\n", ""), {"m.msh:3: ", "$EndMeshFormat"});
  expect_complaint(square_2 + "junk\n", {"m.msh:25: ", "beginning of a section", "'junk'"});
  expect_complaint(square_2 + "$Foo\n1\n2\n", {"m.msh:27: ", "ends in the middle", "$EndFoo"});
  expect_complaint(square_2.substr(0, square_2.find("$Nodes")), {"no section $Nodes", "gmsh -2"});
  expect_complaint(square_2.substr(0, square_2.find("$Elements")), {"no section $Elements"});
  expect_complaint(square_2.substr(0, square_2.find("4 0 1 0")),
                   {"m.msh:14: ", "ends in the middle"});
  expect_complaint(with(square_4, "$Nodes", "$PartitionedEntities\n$Nodes"), {"partitioned"});
}


// Line numbers: counted in square_2.
TEST(GmshMesh, ComplainsAboutNames)
{
  expect_complaint(with(square_2, "\"base\"", "base"), {"m.msh:7: ", "not in quotes"});
  expect_complaint(with(square_2, "\"base\"", "\" \""), {"m.msh:7: ", "empty name"});
  expect_complaint(with(square_2, "1 7 \"", "1 -7 \""),
                   {"m.msh:7: ", "tag -7", "'base'", "positive"});
  expect_complaint(with(square_2, "0 3 \"corner\"", "1 7 \"corner\""), {"named twice"});
  expect_complaint(with(square_2, "0 3 \"corner\"", "1 3 \"base\""),
                   {"same name 'base'", "3 and 7"});
  expect_complaint(with(square_2, "2 5 \"soil", "2 6 \"soil"),
                   {"m.msh:23: ", "group 5", "no name", "Physical Surface(\"name\", 5) = {1}"});
  expect_complaint(with(square_2, "1 7 \"", "1 8 \""),
                   {"m.msh:21: ", "group 7", "Physical Curve(\"name\", 7)"});
  expect_complaint(with(square_2, "0 3 \"", "0 4 \""),
                   {"m.msh:20: ", "Physical Point(\"name\", 3)"});
  expect_complaint(with(square_2, "$PhysicalNames\n3", "$PhysicalNames\n-3"), {"m.msh:5: ", "-3"});
}


// Line numbers: counted in square_2 and square_4.
TEST(GmshMesh, ComplainsAboutNodes)
{
  expect_complaint(with(square_2, "3 1 1 0", "3 1 nan 0"), {"m.msh:14: ", "finite", "'nan'"});
  expect_complaint(with(square_2, "3 1 1 0", "3 1 1e400 0"), {"m.msh:14: ", "finite"});
  expect_complaint(with(square_2, "3 1 1 0", "3 1 1,5 0"), {"m.msh:14: ", "'1,5'", "not a number"});
  expect_complaint(with(square_2, "3 1 1 0", "3 1 1"), {"m.msh:14: ", "line ends"});
  expect_complaint(with(square_2, "3 1 1 0", "3 1 1 0 0"), {"m.msh:14: ", "more in this line"});
  expect_complaint(with(square_2, "3 1 1 0", "2 1 1 0"), {"m.msh:14: ", "node 2", "twice"});
  expect_complaint(with(with(square_2, "9 8 8 8", "9000000000000 8 8 8"), "3 1 1 0", "2 1 1 0"),
                   {"m.msh:14: ", "node 2", "twice"});
  expect_complaint(with(square_2, "3 1 1 0", "0 1 1 0"), {"m.msh:14: ", "number of a node is 0"});
  expect_complaint(with(square_2, "3 1 1 0", "3 1 1 0.5"), {"m.msh:23: ", "z = const", "0.5"});
  expect_complaint(with(square_2, "$Nodes\n5", "$Nodes\n4"), {"m.msh:16: ", "$EndNodes"});
  expect_complaint(with(square_2, "$Nodes\n5", "$Nodes\n9999999999999999"), {"m.msh:17: "});
  expect_complaint(with(square_2, "$Nodes\n5", "$Nodes\n99999999999999999999"), {"not an integer"});
  expect_complaint(with(square_4, "$Nodes\n3 5", "$Nodes\n3 6"), {"m.msh:21: ", "6 nodes", "5"});
  const std::string nodes =
    square_2.substr(square_2.find("$Nodes"), square_2.find("$Elements") - square_2.find("$Nodes"));
  expect_complaint(with(square_2, "$Elements", nodes + "$Elements"), {"second section $Nodes"});
}


// Line numbers: counted in square_2 and square_4.
TEST(GmshMesh, ComplainsAboutElements)
{
  const std::string cell = "4 3 2 5 1 1 2 3 4";
  expect_complaint(with(square_2, cell, "4 3 2 5 1 1 2 3 6"),
                   {"m.msh:23: ", "node 6", "not in $Nodes"});
  expect_complaint(with(square_2, cell, "4 3 2 5 1 1 2 3 3"),
                   {"m.msh:23: ", "node 3 twice", "degenerate"});
  expect_complaint(
    with(square_2, cell, "4 10 2 5 1 1 2 3 4 1 2 3 4 5"),
    {"m.msh:23: ", "second or higher order", "Mesh.ElementOrder=1", "parameter file"});
  expect_complaint(with(square_2, cell, "4 7 2 5 1 1 2 3 4 9"), {"m.msh:23: ", "pyramids"});
  expect_complaint(with(square_2, cell, "4 999 2 5 1 1"), {"m.msh:23: ", "type 999", "unknown"});
  expect_complaint(with(square_2, cell, "4 3 2 0 1 1 2 3 4"),
                   {"m.msh:23: ", "no physical group", "Physical Surface(\"name\") = {1}"});
  expect_complaint(with(square_2, cell, "4 3 0 1 2 3 4"), {"m.msh:23: ", "no physical group"});
  expect_complaint(with(square_2, cell, "4 1 2 7 1 2 3"), {"no cells", "gmsh -2"});
  expect_complaint(with(square_2, "1 15 2 3 1 1", "1 15 2 3 1 9"),
                   {"m.msh:20: ", "'corner'", "(8, 8, 8)"});
  expect_complaint(with(square_2, "3 1 2 0 3 3 4", "3 1 2 5 3 1 2"), {"m.msh:22: ", "group 5"});
  expect_complaint(with(square_2, "3 1 2 0 3 3 4", "3 2 2 5 1 1 2 3"),
                   {"mixes triangles and quad", "Recombine"});
  expect_complaint(with(square_2, "3 1 2 0 3 3 4", "3 3 2 5 1 4 3 2 1"),
                   {"m.msh:23: ", "same nodes", "line 22"});
  expect_complaint(with(square_4, "1 0 0 0 1 1 0 1 5 4", "1 0 0 0 1 1 0 2 5 6 4"),
                   {"m.msh:44: ", "entity 1", "2 physical groups (5, 6)", "allowed is one"});
  expect_complaint(with(square_4, "1 0 0 0 1 1 0 1 5", "1 0 0 0 1 1 0 1 0"),
                   {"m.msh:18: ", "group 0"});
  expect_complaint(with(square_4, "$Elements\n4 4", "$Elements\n4 5"),
                   {"m.msh:37: ", "5 elements", "4"});
  expect_complaint(with(square_4, "2 1 3 1\n", "2 1 1 1\n"),
                   {"m.msh:44: ", "dimension 2", "dimension 1"});
}


// No number is expected: whatever is done to a file, it is read or refused with a sentence.
TEST(GmshMesh, SurvivesMutations)
{
  std::mt19937 random(1);
  const auto below = [&random](const std::size_t n) {
    return static_cast<std::size_t>(random()) % n;
  };
  unsigned int n_refused = 0;
  for (unsigned int i = 0; i < 4000; ++i)
    {
      std::string text = i % 2 == 0 ? square_2 : square_4;
      for (std::size_t changes = 1 + below(4); changes > 0; --changes)
        {
          const std::size_t at = below(text.size());
          if (below(3) == 0)
            text.erase(at, 1 + below(20));
          else
            text[at] = "0123456789-. \n$e\"\0"[below(19)];
          if (text.empty())
            text = "$";
        }
      try
        {
          split_joints(parse_gmsh_mesh(text, "m.msh"), {});
        }
      catch (const InputError &error)
        {
          ++n_refused;
          EXPECT_EQ(std::string(error.what()).find("m.msh"), 0U) << error.what();
        }
    }
  EXPECT_GT(n_refused, 1000U);
}
