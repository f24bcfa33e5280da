// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/mesh_variants.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** One square element on a rigid plane, its left lower corner held in x: with the plane it is a
   * hinge. */
  std::string
  block_mesh()
  {
    GmshMesh mesh;
    mesh.dimension      = 2;
    mesh.physical_names = {
      {{2, 1}, "block"}, {{1, 2}, "base"}, {{1, 3}, "top"}, {{1, 4}, "sides"}, {{0, 5}, "corner"}};
    for (const auto &corner : {std::array<double, 2>{{0., 0.}}, {{1., 0.}}, {{1., 1.}}, {{0., 1.}}})
      mesh.vertices.push_back({{corner[0], corner[1], 0.}});
    mesh.cells.push_back({CellShape::quadrilateral, {{0, 1, 2, 3}}, 1});
    mesh.faces.push_back({CellShape::line, {{0, 1}}, 2});
    mesh.faces.push_back({CellShape::line, {{2, 3}}, 3});
    mesh.faces.push_back({CellShape::line, {{1, 2}}, 4});
    mesh.faces.push_back({CellShape::line, {{3, 0}}, 4});
    mesh.points.push_back({CellShape::point, {{0}}, 5});
    return write_mesh(mesh);
  }

  /** A run of the block with these @p entries of the joint, free @p boundaries, @p loads,
   * @p stages and entries of the @p solver. */
  SceneRun
  run_block(const std::string &entries,
            const std::string &boundaries,
            const std::string &loads,
            const std::string &stages,
            const std::string &solver = "")
  {
    const std::string name = temporary_directory() + "/hinge.prm";
    std::ofstream(name) << "subsection Mesh\nset File = " << block_mesh()
                        << "\nend\nsubsection Bodies\nsubsection block\nset Young modulus = 4.8\n"
                           "set Poisson ratio = 0.36\nset Weight density = 1\nend\nend\n"
                           "subsection Joints\nsubsection base\nset Plus lip = base\n"
                           "set Minus lip = rigid\nset Normal law = rigid\n"
                           "set Shear law = linear\nset Shear compliance = 1e-9\n"
                           "set Friction coefficient = 1.6\n"
                        << entries
                        << "end\nend\nsubsection Boundaries\nsubsection corner\nset Fixed = x\n"
                           "end\nsubsection sides\nset Fixed = free\nend\n"
                        << boundaries << "end\nsubsection Loads\n"
                        << loads << "end\nsubsection Stages\n"
                        << stages << "end\nsubsection Solver\n"
                        << solver << "end\n";
    return run_scene(name);
  }
} // namespace

// Pressed by 1 and pulled to the left by t at its upper side, the block turns about its left corner
// at t = 1/2. Nothing but rounding then resists the opening of the right corner, which must not be
// taken for a stiffness: the block would open by 1e11 m.
TEST(HingedBlock, TurnsOver)
{
  const SceneRun run = run_block(
    "",
    "",
    "subsection press\nset Type = pressure\nset Boundaries = top\nset Value = 1\nend\n"
    "subsection pull\nset Type = traction\nset Boundaries = top\nset Value = -1; 0\nend\n",
    "subsection first\nset Loads = press: t\nend\nsubsection second\nset Loads = pull: t\nend\n");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.summary.at("verdict"), "limit load");
  EXPECT_NEAR(run.summary.at("t").get<double>(), 1.5, 1e-12);
  EXPECT_LE(run.certificate(), 1e-12);
}

// A block that hangs a millimetre above its base falls at once, straight down: the motion without
// resistance is one of two, with that about the corner, and the weight drives this one. It comes to
// rest on the base, so that there is no limit load, but a jump. A millionth of the weight, 1 MN,
// falls by the gap, and there rests on the base and deforms the block, by 1e-6 MN / 4.8 MPa.
TEST(HingedBlock, FallsOntoItsBase)
{
  const auto run = [](const std::string &solver) {
    return run_block("set Initial gap = 1e-3\n",
                     "subsection top\nset Fixed = free\nend\n",
                     "subsection weight\nset Type = weight\nset Bodies = block\nend\n",
                     "subsection first\nset Loads = weight: t\nend\n",
                     solver);
  };
  constexpr double gap = 1e-3, deformation = 1e-6;
  const SceneRun stopped     = run("");
  const nlohmann::json &jump = stopped.summary.at("events").at("jump");
  EXPECT_EQ(stopped.exit_code, 3);
  EXPECT_EQ(stopped.summary.at("verdict"), "no continuation");
  EXPECT_EQ(stopped.summary.at("t"), 0.);
  EXPECT_EQ(jump.at("mechanism"), "closing");
  EXPECT_EQ(jump.at("motion"), "'base' closes");
  EXPECT_NEAR(jump.at("size").get<double>(), gap, deformation);
  EXPECT_NEAR(jump.at("size_with_hundredth_of_load").get<double>(), gap, deformation);
  EXPECT_NEAR(jump.at("released_energy").get<double>(), 1e-6 * gap, 1e-6 * deformation);

  const SceneRun followed = run("set No continuation = jump\n");
  EXPECT_EQ(followed.exit_code, 0);
  EXPECT_EQ(followed.summary.at("events").at("jump").at("followed"), 1);
  EXPECT_LE(followed.certificate(), 1e-12);
  EXPECT_NEAR(followed.resultants.number(followed.resultants.rows.size() - 1, "N"), -1., 1e-12);
}
