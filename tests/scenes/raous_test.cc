// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"
#include "scenes/scene_model.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** Answers of verification.md, V9, for k_n = k_t = 1e5 E/L: u_x on the base in µm. */
  struct Block
  {
    int n;
    double u[5]; // at x = 0, 1.25, 5, 7.5, 11.25
    std::size_t n_open, n_slip, n_stick;
  };

  const Block blocks[]      = {{32, {28.594, 27.217, 22.850, 19.796, 15.406}, 3, 21, 9},
                               {64, {28.604, 27.227, 22.865, 19.806, 15.412}, 6, 42, 17}};
  const double abscissae[5] = {0., 1.25, 5., 7.5, 11.25};

  std::vector<std::string>
  with_mesh(const int n)
  {
    return {"Mesh/File=" + std::string(FUGA_SOURCE_DIR) + "/meshes/raous_" + std::to_string(n) +
            ".msh"};
  }

  double
  jump_at(const SceneRun &run, const double place)
  {
    const Vector x = run.values("x", 1.), jump = run.values("jump_t1", 1.);
    for (std::size_t k = 0; k < x.size(); ++k)
      if (std::abs(x[k] - place) < 1e-6)
        return jump[k];
    return std::nan("");
  }
} // namespace

// V9: u_x of the base (the plane is fixed, so this is the tangential jump) to the printed digits,
// half a unit of the last, and the states. The prototype counts the held corner node as sticking;
// here it is no contact element.
TEST(Raous, NearlyRigidJoint)
{
  for (const Block &block : blocks)
    {
      const SceneRun run = run_scene("raous_near_rigid.prm", with_mesh(block.n));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      for (unsigned int i = 0; i < 5; ++i)
        expect_answer(
          {"V9 Raous block",
           fmt::format("nearly rigid joint, n = {}: u_x at x = {} [µm]", block.n, abscissae[i]),
           block.u[i],
           "a prototype"},
          1e3 * jump_at(run, abscissae[i]),
          0.505e-3);
      EXPECT_EQ(run.count("open", 1.), block.n_open);
      EXPECT_EQ(run.count("slip", 1.), block.n_slip);
      EXPECT_EQ(run.count("stick", 1.) + 1, block.n_stick);
    }
}

// The exactly rigid joint differs by the order of its share of the flexibility, 1e-5 (times the
// displacement 28.6 µm: 3e-4; observed by the prototypes of V9 within 1e-3 µm), and the published
// values of the test (Raous et al., Code_Aster SSNV128) are met within their 5 %.
TEST(Raous, RigidJoint)
{
  const double published[5] = {28.6, 27.2, 22.8, 19.8, 15.0};
  for (const Block &block : blocks)
    {
      const SceneRun run = run_scene("raous_rigid.prm", with_mesh(block.n));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      for (unsigned int i = 0; i < 5; ++i)
        {
          const double u = 1e3 * jump_at(run, abscissae[i]);
          EXPECT_NEAR(u, block.u[i], 1.5e-3) << block.n << ' ' << i;
          expect_answer(
            {"V9 Raous block",
             fmt::format("rigid joint, n = {}: u_x at x = {} [µm]", block.n, abscissae[i]),
             published[i],
             "Raous et al., SSNV128 (5 %)"},
            u,
            0.05 * published[i]);
        }
      EXPECT_EQ(run.count("open", 1.), block.n_open);
      EXPECT_EQ(run.count("slip", 1.), block.n_slip);
      EXPECT_EQ(run.count("stick", 1.) + 1, block.n_stick);
    }
}

// V9, n = 64: ΣT = 1405.36 N/mm to its last digit. ΣN = 2000 = 50 MPa × 40 mm includes the reaction
// of the held corner (40, 0), which is no contact element: it comes from the nodal forces K u of
// the full model. Equilibrium by a direct solver: 1e-9 of 2000.
TEST(Raous, Resultants)
{
  const SceneRun run = run_scene("raous_near_rigid.prm", with_mesh(64));
  expect_answer({"V9 Raous block", "nearly rigid joint, n = 64: ΣT [N/mm]", 1405.36, "a prototype"},
                run.resultant("T", 1.),
                0.00505);

  const SceneModel model("raous_near_rigid.prm", with_mesh(64));
  const auto forces =
    model.system->nodal_forces(model.displacement(model.bars(run, 1., false), 1.));
  const auto &space        = model.system->discretization();
  const std::size_t corner = model.node_at({{40., 0.}});
  ASSERT_NEAR(space.position(corner)[0], 40., 1e-9);
  ASSERT_NEAR(space.position(corner)[1], 0., 1e-9);
  expect_answer({"V9 Raous block", "nearly rigid joint, n = 64: ΣN [N/mm]", 2000., "equilibrium"},
                -run.resultant("N", 1.) + forces[space.dof(corner, 1)],
                2e-6);
}
