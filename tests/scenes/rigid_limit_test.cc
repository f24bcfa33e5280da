// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** S0 or the Raous block with linear laws of one compliance; 0 = rigid. */
  SceneRun
  with_compliance(const bool raous, const std::string &rho)
  {
    std::vector<std::string> sets = {"Joints/base/Normal compliance=" + rho,
                                     "Joints/base/Shear compliance=" + rho};
    if (!raous)
      return run_scene("paper_2_linear.prm", sets);
    sets.insert(sets.end(),
                {"Joints/base/Normal stiffness=",
                 "Joints/base/Shear stiffness=",
                 "Mesh/File=" + std::string(FUGA_SOURCE_DIR) + "/meshes/raous_32.msh"});
    return run_scene("raous_near_rigid.prm", sets);
  }

  SceneRun
  rigid(const bool raous)
  {
    if (!raous)
      return run_scene("paper_1_rigid.prm");
    return run_scene("raous_rigid.prm",
                     {"Mesh/File=" + std::string(FUGA_SOURCE_DIR) + "/meshes/raous_32.msh"});
  }
} // namespace

// A rigid joint is the limit of a stiff one; the difference is of the order of the layer's share of
// the flexibility, ρE/B = 1e-12·3060/4 = 8e-10 (S0; Raous ρE/L = 3e-9), times the condition of the
// contact problem: 1e-6. Also: a compliance of 0 is the rigid law, to rounding.
TEST(RigidLimit, StiffJointBecomesRigid)
{
  for (const bool raous : {false, true})
    for (const auto &[rho, relative] : {std::pair("1e-12", 1e-6), std::pair("0", 1e-12)})
      {
        const SceneRun a = with_compliance(raous, rho), b = rigid(raous);
        for (const char *name : {"N", "T1", "jump_n", "jump_t1", "gap", "slip1"})
          EXPECT_LE(deviation(a.values(name, a.last_t()), b.values(name, b.last_t())), relative)
            << raous << ' ' << rho << ' ' << name;
        EXPECT_EQ(a.states(a.last_t()), b.states(b.last_t())) << raous << ' ' << rho;
        EXPECT_EQ(a.event_times(-1.).size(), b.event_times(-1.).size()) << raous << ' ' << rho;
      }
}

// No compliance between 0 and far softer than the bodies may fail. The end must be reached unless
// the load is above the limit: S0 slides at q H = f·1.152, i.e. at q = 0.0192 > 0.0144, whatever
// the compliance; and overturning about the toe needs q H²/2 = 1.152·2, q = 0.032. The Raous block
// is held by its supports. Certificate: the bound the program states.
TEST(RigidLimit, SweepOfCompliances)
{
  for (const bool raous : {false, true})
    for (const char *rho :
         {"0", "1e-14", "1e-12", "1e-10", "1e-8", "1e-6", "1e-4", "1e-2", "1e-1", "1"})
      {
        SCOPED_TRACE(fmt::format("{} rho = {}", raous ? "Raous" : "S0", rho));
        const SceneRun run = with_compliance(raous, rho);
        EXPECT_EQ(run.exit_code, 0);
        EXPECT_EQ(run.summary.at("verdict"), "done");
        EXPECT_LE(run.certificate(), 1e-9) << run.summary.at("certificate").dump(1);
        if (!raous)
          {
            EXPECT_NEAR(run.resultant("N", 2.), -1.152, 1e-10);
          }
      }
}
