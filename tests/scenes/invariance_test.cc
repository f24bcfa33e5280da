// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/mesh_variants.h"
#include "scenes/scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fuga;
using namespace fuga::tests;

// What the answer may not depend on: numbering, units, levels, place. No outside number: the two
// runs are each other's reference. Tolerances: 1e-9 for linear and rigid layers (direct solvers,
// 1e-14 times the condition of bodies and contact), 1e-8 for the nonlinear one, whose iteration
// ends at 1e-12 per step.

namespace
{
  struct Scene
  {
    const char *file;
    const char *mesh;
    double tolerance;
  };

  std::ostream &
  operator<<(std::ostream &out, const Scene &scene)
  {
    return out << scene.file << ' ' << scene.mesh;
  }

  class Invariance : public testing::TestWithParam<Scene>
  {
  protected:
    static std::string
    mesh_path()
    {
      return std::string(FUGA_SOURCE_DIR) + "/meshes/" + GetParam().mesh;
    }

    static SceneRun
    run(const std::string &mesh, std::vector<std::string> overrides = {})
    {
      overrides.push_back("Mesh/File=" + mesh);
      return run_scene(GetParam().file, overrides);
    }

    static bool
    is_paper()
    {
      return std::string(GetParam().file).rfind("paper", 0) == 0;
    }

    /** Compares end of both stages and the events. */
    static void
    expect_same(const SceneRun &a,
                const SceneRun &b,
                const double force       = 1.,
                const double length      = 1.,
                const double orientation = 1.)
    {
      EXPECT_EQ(a.exit_code, b.exit_code);
      for (const double t : {1., 2.})
        {
          const auto compare = [&](const char *name, const double factor) {
            Vector values = a.values(name, t);
            if (orientation < 0.)
              std::reverse(values.begin(), values.end());
            EXPECT_LE(deviation(values, b.values(name, t), factor), GetParam().tolerance)
              << name << " at " << t;
          };
          compare("N", force);
          compare("T1", orientation * force);
          compare("jump_n", length);
          compare("jump_t1", orientation * length);
          compare("gap", length);
          compare("slip1", orientation * length);
          auto states = a.states(t);
          if (orientation < 0.)
            std::reverse(states.begin(), states.end());
          EXPECT_EQ(states, b.states(t));
        }
      const Vector events_a = a.event_times(-1.), events_b = b.event_times(-1.);
      ASSERT_EQ(events_a.size(), events_b.size());
      for (std::size_t i = 0; i < events_a.size(); ++i)
        EXPECT_NEAR(events_a[i], events_b[i], GetParam().tolerance) << i;
    }
  };
} // namespace

// The number of load levels that results are written at.
// Early levels of the first stage are the hard ones: law (9) has infinite curvature at zero
// closure.
TEST_P(Invariance, LoadLevels)
{
  const char *const stage = is_paper() ? "Stages/push/Levels=" : "Stages/water/Levels=";
  const SceneRun one      = run(mesh_path(), {std::string(stage) + "1", "Stages/weight/Levels=1"}),
                 many = run(mesh_path(), {std::string(stage) + "97", "Stages/weight/Levels=97"});
  EXPECT_EQ(many.history.rows.size(), 97 * one.history.rows.size());
  expect_same(many, one);
}

// The numbering of vertices, cells, faces and corners in the mesh file.
TEST_P(Invariance, Renumbering)
{
  const SceneRun original = run(mesh_path());
  const GmshMesh mesh     = read_gmsh_mesh(mesh_path());
  expect_same(run(write_mesh(mesh)), original);
  for (const unsigned int seed : {1u, 2u})
    expect_same(run(write_mesh(renumbered(mesh, seed))), original);
}

// x → -x: the pressure acts from the other side; the tangent keeps its direction, so that shear and
// slip change sign.
TEST_P(Invariance, Mirroring)
{
  const SceneRun original = run(mesh_path());
  const SceneRun mirror   = run(write_mesh(mirrored(read_gmsh_mesh(mesh_path()))));
  expect_same(mirror, original, 1., 1., -1.);
  EXPECT_NEAR(mirror.resultant("T", 2.) / original.resultant("T", 2.), -1., GetParam().tolerance);
}

// Other units: S0 from MN, m to N, mm (lengths 1e3, forces 1e6, stresses 1); scene G from kN, m to
// MN, m (forces and stresses 1e-3).
TEST_P(Invariance, Units)
{
  const SceneRun original = run(mesh_path());
  if (!is_paper())
    {
      std::vector<std::string> sets = {"Constants/water_weight=9.81e-3",
                                       "Bodies/block/Young modulus=3060",
                                       "Bodies/block/Weight density=0.024",
                                       "Bodies/foundation/Young modulus=1e4"};
      if (std::string(GetParam().file).find("rigid") == std::string::npos)
        sets.insert(sets.end(),
                    {"Joints/base/Normal stiffness=1e3", "Joints/base/Shear stiffness=500"});
      expect_same(run(mesh_path(), sets), original, 1e-3, 1.);
      return;
    }
  std::vector<std::string> sets = {"Mesh/Thickness=1000", "Bodies/structure/Weight density=2.4e-5"};
  if (std::string(GetParam().file).find("rigid") == std::string::npos)
    sets.insert(sets.end(),
                {"Joints/base/Normal compliance=0.125",
                 "Joints/base/Shear compliance=0.125",
                 "Joints/base/Thickness=2"});
  expect_same(run(write_mesh(scaled(read_gmsh_mesh(mesh_path()), 1e3)), sets), original, 1e6, 1e3);
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         Invariance,
                         testing::Values(Scene{"paper_1_rigid.prm", "s0.msh", 1e-9},
                                         Scene{"paper_2_linear.prm", "s0.msh", 1e-9},
                                         Scene{"paper_3_cubic_root.prm", "s0.msh", 1e-8},
                                         Scene{"scene_g_f06.prm", "scene_g_9.msh", 1e-9},
                                         Scene{"scene_g_f02.prm", "scene_g_9.msh", 1e-9},
                                         Scene{"scene_g_rigid_f06.prm", "scene_g_9.msh", 1e-9}));

// An open mesh with two lips is the same problem as the line that the program opens.
TEST(OpenMesh, EqualsTheSplitOne)
{
  const std::string meshes = std::string(FUGA_SOURCE_DIR) + "/meshes/";
  for (const char *file : {"paper_1_rigid.prm", "paper_2_linear.prm"})
    {
      const SceneRun split = run_scene(file),
                     open  = run_scene(file,
                                      {"Mesh/File=" + meshes + "s0_split.msh",
                                        "Joints/base/Line=",
                                        "Joints/base/Plus body=",
                                        "Joints/base/Minus body=",
                                        "Joints/base/Plus lip=structure_base",
                                        "Joints/base/Minus lip=foundation_contact"});
      for (const char *name : {"N", "T1", "jump_n", "jump_t1", "slip1"})
        EXPECT_LE(deviation(open.values(name, 2.), split.values(name, 2.)), 1e-9) << name;
      EXPECT_EQ(open.states(2.), split.states(2.));
    }
}
