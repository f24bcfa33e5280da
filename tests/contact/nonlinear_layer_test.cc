// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/toy_system.h"

#include <fuga/base/errors.h>
#include <fuga/laws/cubic_root_law.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  struct BlockRun
  {
    PathResult result;
    Certificate certificate;
    std::vector<JointState> levels;
    std::vector<Vector> jumps;
    std::vector<ContactEvent> events;
    IterationCount iterations;
  };

  /** Weight N in stage one, then a moment and a horizontal force, on law (9) with ρ0 = 1, ζ0 =
   * thickness. */
  BlockRun
  run_block(const double thickness,
            const double weight,
            const double eccentricity,
            const double push,
            const PathOptions &options,
            const bool nonlinear_shear = false)
  {
    const std::size_t n  = 8;
    const ToyJoint joint = rigid_block_joint(
      n,
      1.,
      std::make_unique<CubicRootLaw>(1., thickness),
      nonlinear_shear ? std::make_unique<CubicRootLaw>(1., thickness) : make_linear_law(1.),
      {0.3, 0.});
    const ToySystem system = rigid_block(n, 1.);
    const LayeredSystem layered(system, joint.elements);
    const LoadHistory history({0., 1., 2., 3.},
                              {{0., 0., 0.},
                               {0., -weight, 0.},
                               {push * weight, -weight, -eccentricity * weight},
                               {-push * weight, -weight, 0.}});
    EventPath path(joint.elements, layered, history, options);
    Record record(system, joint.elements, history);
    BlockRun run;
    run.result      = path.run({1., 1.5, 2., 3.}, record);
    run.certificate = record.worst;
    run.levels      = record.levels;
    run.events      = record.events;
    for (const JointState &level : record.levels)
      run.jumps.push_back(layered.jumps(level.dislocations, level.forces));
    run.iterations = path.iterations();
    return run;
  }
} // namespace

// Uniform pressure: closure by the closed form of law (9), V11: σρ/ζ = q³/(1-q) at q = 0.5 is 0.25.
TEST(NonlinearLayer, UniformPressure)
{
  const BlockRun run = run_block(2., 0.25 * 2., 0., 0., {});
  ASSERT_EQ(run.levels.size(), 4u);
  for (std::size_t k = 0; k <= 8; ++k)
    EXPECT_NEAR(run.jumps[0][2 * k], -2. * 0.125, 1e-13);
  EXPECT_LE(run.certificate.worst(), 1e-9);
}

// Opening, sliding and reversal on the hardening layer: the judge finds nothing wrong, energy
// included.
TEST(NonlinearLayer, OpeningSlidingReversal)
{
  for (const bool nonlinear_shear : {false, true})
    {
      const BlockRun run = run_block(1., 0.3, 0.3, 0.27, {}, nonlinear_shear);
      EXPECT_EQ(run.result.verdict, Verdict::done);
      EXPECT_GT(run.events.size(), 5u);
      for (const auto &entry : run.certificate.entries())
        EXPECT_LE(entry.second, 1e-9) << entry.first;
    }
}

// The paper's iteration finds the same path, and diverges beyond w = 0.0604 ζ0 under force control
// (doc/theory.md, section 6: C_tan = 2 A/ρ0 at q = 0.3924).
TEST(NonlinearLayer, ConstantStiffnessIteration)
{
  PathOptions constant;
  constant.iteration = PathOptions::Iteration::constant_stiffness;
  // σρ/ζ = q³/(1-q): w = 0.04 ζ0 converges, w = 0.08 ζ0 does not.
  const auto weight     = [](const double w) { return w / (1. - std::cbrt(w)); };
  const BlockRun newton = run_block(1., weight(0.04), 0.05, 0.1, {});
  const BlockRun paper  = run_block(1., weight(0.04), 0.05, 0.1, constant);
  ASSERT_EQ(newton.levels.size(), paper.levels.size());
  for (std::size_t i = 0; i < newton.levels.size(); ++i)
    for (std::size_t b = 0; b < 18; ++b)
      EXPECT_NEAR(newton.levels[i].forces[b], paper.levels[i].forces[b], 1e-11);
  EXPECT_GT(paper.iterations.n_iterations, newton.iterations.n_iterations);
  EXPECT_NO_THROW(run_block(1., weight(0.08), 0., 0., {}));
  EXPECT_THROW(run_block(1., weight(0.08), 0., 0., constant), NumericalFailure);
}
