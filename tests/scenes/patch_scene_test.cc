// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "known_answer.h"
#include "scenes/scene_model.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr double E = 3000., p = 2., tau = 0.7, rho_n = 1e-3, rho_t = 2e-3;
  constexpr double angle = 20. * M_PI / 180.;

  /** σ = [[0, τ], [τ, -p]] in two blocks with ν = 0 and one E, by tractions on all sides. */
  std::string
  patch_file(const std::string &mesh, const unsigned int degree, const bool rigid)
  {
    const std::string name = temporary_directory() + "/patch.prm";
    const std::string layer =
      rigid
        ? std::string("  set Normal law = rigid\n  set Shear law = rigid\n")
        : fmt::format("  set Normal compliance = {}\n  set Shear compliance = {}\n", rho_n, rho_t);
    std::ofstream(name) << fmt::format(R"(subsection Mesh
  set File = {}/meshes/{}
  set Polynomial degree = {}
end
subsection Bodies
  subsection lower
    set Young modulus = {E}
    set Poisson ratio = 0
  end
  subsection upper
    set Young modulus = {E}
    set Poisson ratio = 0
  end
end
subsection Joints
  subsection base
  set Line = joint
  set Plus body = upper
  set Minus body = lower
  set Friction coefficient = 2
{layer}  end
end
subsection Boundaries
  subsection bottom
    set Fixed = all
  end
end
subsection Loads
  subsection top
    set Type = traction
    set Boundaries = top
    set Value = {tau}; -{p}
  end
  subsection right
    set Type = traction
    set Boundaries = right_lower, right_upper
    set Value = 0; {tau}
  end
  subsection left
    set Type = traction
    set Boundaries = left_lower, left_upper
    set Value = 0; -{tau}
  end
end
subsection Stages
  subsection all
    set Loads = top: t; right: t; left: t
    set Levels = 2
  end
end
)",
                                       FUGA_SOURCE_DIR,
                                       mesh,
                                       degree,
                                       fmt::arg("E", E),
                                       fmt::arg("layer", layer),
                                       fmt::arg("tau", tau),
                                       fmt::arg("p", p));
    return name;
  }

  struct Patch
  {
    const char *mesh;
    unsigned int degree;
    bool rigid;
  };

  std::ostream &
  operator<<(std::ostream &out, const Patch &patch)
  {
    return out << patch.mesh << " degree " << patch.degree << (patch.rigid ? " rigid" : "");
  }

  class PatchScene : public testing::TestWithParam<Patch>
  {
  };
} // namespace

// V2, closed form: with ν = 0 and uniform stress σ every bar carries N = A n·σn, T = A t·σn (n from
// minus to plus, t = n turned clockwise); the lips move apart by ρn N/A and ρt T/A; below the joint
// u = (2τy/E, -py/E), above it the constant jump is added. A: half of the neighbouring faces
// (degree 1). Everything is linear: 1e-10 relative leaves 4 digits for the condition.
TEST_P(PatchScene, UniformPressureAndShear)
{
  const Patch &patch     = GetParam();
  const std::string file = patch_file(patch.mesh, patch.degree, patch.rigid);
  const SceneRun run     = run_scene(file);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_EQ(run.events.rows.size(), 0u);

  const double nx = -std::sin(angle), ny = std::cos(angle), tx = ny, ty = -nx;
  const double sx = tau * ny, sy = tau * nx - p * ny; // σn
  const double sigma_n = nx * sx + ny * sy, sigma_t = tx * sx + ty * sy;
  ASSERT_LT(std::abs(sigma_t), -2. * sigma_n);
  const double jump_n = patch.rigid ? 0. : rho_n * sigma_n,
               jump_t = patch.rigid ? 0. : rho_t * sigma_t;
  const double length = 3. / std::cos(angle);

  const Vector A = run.values("area", 1.), N = run.values("N", 1.), T = run.values("T1", 1.),
               w = run.values("jump_n", 1.), v = run.values("jump_t1", 1.), x = run.values("x", 1.);
  double sum = 0.;
  for (std::size_t k = 0; k < A.size(); ++k)
    {
      sum += A[k];
      EXPECT_NEAR(N[k], A[k] * sigma_n, 1e-10 * p) << k;
      EXPECT_NEAR(T[k], A[k] * sigma_t, 1e-10 * p) << k;
      EXPECT_NEAR(w[k], jump_n, 1e-10 * p * 4. / E) << k;
      EXPECT_NEAR(v[k], jump_t, 1e-10 * p * 4. / E) << k;
      if (patch.degree == 1)
        {
          const double left = x[k == 0 ? 0 : k - 1], right = x[std::min(k + 1, x.size() - 1)];
          EXPECT_NEAR(A[k], (right - left) / 2. / std::cos(angle), 1e-9);
        }
    }
  EXPECT_NEAR(sum, length, 1e-9);
  EXPECT_EQ(run.count("stick", 1.), A.size());

  const SceneModel model(file);
  const auto u      = model.displacement(model.bars(run, 1., false), 1.);
  const auto &space = model.system->discretization();
  double worst      = 0.;
  for (std::size_t node = 0; node < space.n_nodes(); ++node)
    {
      const auto &point   = space.position(node);
      const double height = point[1] - (2. + (point[0] - 1.5) * std::tan(angle));
      if (std::abs(height) < 1e-9) // on the joint: either lip
        continue;
      const double above = height > 0. ? 1. : 0.;
      const double ux    = 2. * tau * point[1] / E + above * (jump_n * nx + jump_t * tx);
      const double uy    = -p * point[1] / E + above * (jump_n * ny + jump_t * ty);
      worst              = std::max(
        {worst, std::abs(u[space.dof(node, 0)] - ux), std::abs(u[space.dof(node, 1)] - uy)});
    }
  std::ostringstream name;
  name << patch << ": largest error of u [p h/E]";
  expect_answer({"V2 patch test", name.str(), 0., "closed form"}, worst * E / (4. * p), 1e-10);
}

namespace
{
  /** Normal and shear stress of the uniform state along the joint. */
  struct JointStress
  {
    double normal, shear;
  };

  JointStress
  joint_stress()
  {
    const double nx = -std::sin(angle), ny = std::cos(angle), tx = ny, ty = -nx;
    const double sx = tau * ny, sy = tau * nx - p * ny;
    return {nx * sx + ny * sy, tx * sx + ty * sy};
  }
} // namespace

// The stresses reversed pull the joint apart: at the load at which the uniform normal stress is the
// tensile strength every bond breaks, and nothing holds the upper block.
TEST(PatchStrength, BondBreaksAtItsTensileStrength)
{
  const SceneRun run = run_scene(patch_file("patch_quad.msh", 1, false),
                                 {"Stages/all/Loads=top: -t; right: -t; left: -t",
                                  "Joints/base/Cohesion=10",
                                  "Joints/base/Tensile strength=1.5"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_LE(run.certificate(), 1e-9);
  EXPECT_NEAR(run.last_t(), 1.5 / -joint_stress().normal, 1e-9);
}

// Shear stiffness growing with pressure, (1 + σ/σr)/ρt: by hand e = ρt τ/(1 + σ/σr) and the closure
// ρn σ less ½ k' e² with k' = 1/(ρt σr).
TEST(PatchStrength, ShearStiffnessGrowsWithPressure)
{
  const double sigma_r = 4.;
  const SceneRun run   = run_scene(
    patch_file("patch_quad.msh", 1, false),
    {"Joints/base/Shear stiffness grows with=pressure", "Joints/base/Shear growth pressure=4"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  const auto [normal, shear] = joint_stress();
  const double e             = rho_t * shear / (1. - normal / sigma_r);
  const double closure       = -rho_n * normal - 0.5 * e * e / (rho_t * sigma_r);
  for (const double jump : run.values("jump_n", 1.))
    EXPECT_NEAR(jump, -closure, 1e-10 * p * 4. / E);
  for (const double jump : run.values("jump_t1", 1.))
    EXPECT_NEAR(jump, e, 1e-10 * p * 4. / E);
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         PatchScene,
                         testing::Values(Patch{"patch_quad.msh", 1, false},
                                         Patch{"patch_quad.msh", 1, true},
                                         Patch{"patch_quad.msh", 2, false},
                                         Patch{"patch_tri.msh", 1, false},
                                         Patch{"patch_tri.msh", 1, true},
                                         Patch{"patch_tri.msh", 2, false}));
