// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"
#include "scenes/scene_model.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** What an independent code found with n squares per side and k_n = k_t = 1e5 E/L. */
  const nlohmann::json &
  answers_of(const int n)
  {
    for (const nlohmann::json &answers : independent_answers().at("Raous"))
      if (answers.at("n") == n)
        return answers;
    throw std::runtime_error("no answers");
  }

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
// half a unit of the last, and the states. The held corner node is no contact element.
TEST(Raous, NearlyRigidJoint)
{
  for (const int n : {32, 64})
    {
      const SceneRun run = run_scene("raous_near_rigid.prm", with_mesh(n));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      for (unsigned int i = 0; i < 5; ++i)
        expect_answer(
          {"V9 Raous block",
           fmt::format("nearly rigid joint, n = {}: u_x at x = {} [µm]", n, abscissae[i]),
           answers_of(n).at("u [um]").at(i),
           independent_code},
          1e3 * jump_at(run, abscissae[i]),
          0.505e-3);
      EXPECT_EQ(run.count("open", 1.), answers_of(n).at("open"));
      EXPECT_EQ(run.count("slip", 1.), answers_of(n).at("slip"));
      EXPECT_EQ(run.count("stick", 1.), answers_of(n).at("stick"));
    }
}

// The exactly rigid joint differs by the order of its share of the flexibility, 1e-5 (times the
// displacement 28.6 µm: 3e-4; within 1e-3 µm), and the published
// values of the test (Raous et al., Code_Aster SSNV128) are met within their 5 %.
TEST(Raous, RigidJoint)
{
  const double published[5] = {28.6, 27.2, 22.8, 19.8, 15.0};
  for (const int n : {32, 64})
    {
      const SceneRun run = run_scene("raous_rigid.prm", with_mesh(n));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      for (unsigned int i = 0; i < 5; ++i)
        {
          const double u = 1e3 * jump_at(run, abscissae[i]);
          EXPECT_NEAR(u, answers_of(n).at("u [um]").at(i), 1.5e-3) << n << ' ' << i;
          expect_answer({"V9 Raous block",
                         fmt::format("rigid joint, n = {}: u_x at x = {} [µm]", n, abscissae[i]),
                         published[i],
                         "Raous et al., SSNV128 (5 %)"},
                        u,
                        0.05 * published[i]);
        }
      EXPECT_EQ(run.count("open", 1.), answers_of(n).at("open"));
      EXPECT_EQ(run.count("slip", 1.), answers_of(n).at("slip"));
      EXPECT_EQ(run.count("stick", 1.), answers_of(n).at("stick"));
    }
}

// V9, n = 64: ΣT of an independent code, to its last digit. ΣN = 2000 = 50 MPa × 40 mm includes the
// reaction of the held corner (40, 0), which is no contact element: it comes from the nodal forces
// K u of the full model. Equilibrium by a direct solver: 1e-9 of 2000.
TEST(Raous, Resultants)
{
  const SceneRun run = run_scene("raous_near_rigid.prm", with_mesh(64));
  expect_answer({"V9 Raous block",
                 "nearly rigid joint, n = 64: ΣT [N/mm]",
                 answers_of(64).at("T [N/mm]"),
                 independent_code},
                run.resultant("T", 1.),
                0.00505);

  const SceneModel model("raous_near_rigid.prm", with_mesh(64));
  const auto &space        = model.system->discretization();
  const auto u             = model.displacement(model.bars(run, 1., false), 1.);
  const Vector forces      = model.system->elastic_bodies().forces(space.by_nodes(u));
  const std::size_t corner = model.node_at({{40., 0.}});
  ASSERT_NEAR(space.position(corner)[0], 40., 1e-9);
  ASSERT_NEAR(space.position(corner)[1], 0., 1e-9);
  expect_answer({"V9 Raous block", "nearly rigid joint, n = 64: ΣN [N/mm]", 2000., "equilibrium"},
                -run.resultant("N", 1.) + forces[corner * 2 + 1],
                2e-6);
}
