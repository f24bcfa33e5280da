// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/judges.h"
#include "scenes/scene_model.h"
#include "scenes/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  /** A scene, and how near the judge must come. */
  struct Case
  {
    const char *file;
    std::vector<std::string> overrides;
    double tolerance;
  };

  std::ostream &
  operator<<(std::ostream &out, const Case &c)
  {
    return out << c.file << ' ' << (c.overrides.empty() ? "" : c.overrides.front());
  }

  class IndependentSolution : public testing::TestWithParam<Case>
  {
  protected:
    /** Follows the load times by implicit steps of the semismooth Newton method and compares. */
    static void
    follow(const SceneModel &model,
           const SceneRun &run,
           const std::vector<double> &times,
           const double tolerance)
    {
      const judges::JudgeProblem problem = model.judge_problem();
      Vector slip                        = judges::no_slip(problem);
      Vector load_before                 = model.judge_load(0.);
      for (const double t : times)
        {
          SCOPED_TRACE(fmt::format("t = {:.17g}", t));
          judges::NewtonOptions options;
          options.load_before = load_before;
          const Vector load   = model.judge_load(t);
          const auto step     = judges::semismooth_newton_step(problem, slip, load, options);
          ASSERT_TRUE(step.converged);
          ASSERT_LE(step.solution.residual, 1e-11);
          slip        = step.solution.slip;
          load_before = load;
          if (t != 1. && t != 2.)
            continue;
          EXPECT_LE(deviation(model.bars(run, t, true), step.solution.forces), tolerance);
          EXPECT_LE(deviation(model.bars(run, t, false), step.solution.jumps), tolerance);
        }
    }
  };
} // namespace

// The paper compares variants 1 and 2 with an iterative solution of the same discrete problem; so
// here, and the nonlinear variant and scene G as well. Between two events slip does not turn, so an
// implicit step from event to event is exact for rigid and linear layers and for law (9). The judge
// shares nothing with the solver but S, F and the data. Its residual is below 1e-11; times the
// condition of the contact problem (some 10) that gives 1e-9 (law (9) 1e-8).
TEST_P(IndependentSolution, StepsFromEventToEvent)
{
  const Case &c = GetParam();
  const SceneModel model(c.file, c.overrides);
  const SceneRun run        = run_scene(c.file, c.overrides);
  std::vector<double> times = {1., 2.};
  for (const double t : run.event_times(0.))
    times.push_back(t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  follow(model, run, times, c.tolerance);
}

// On a monotone path one implicit step per stage has the same end.
// Only forces and jumps are compared, and only for scenes whose slip does not turn within a stage.
TEST_P(IndependentSolution, OneStepPerStage)
{
  const Case &c = GetParam();
  const SceneModel model(c.file, c.overrides);
  follow(model, run_scene(c.file, c.overrides), {1., 2.}, c.tolerance);
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         IndependentSolution,
                         testing::Values(Case{"paper_1_rigid.prm", {}, 1e-9},
                                         Case{"paper_2_as_printed.prm", {}, 1e-9},
                                         Case{"paper_2_linear.prm", {}, 1e-9},
                                         Case{"paper_2_linear.prm",
                                              {"Joints/base/Normal compliance=1.25e-3",
                                               "Joints/base/Shear compliance=1.25e-3"},
                                              1e-9},
                                         Case{"paper_3_cubic_root.prm", {}, 1e-8},
                                         Case{"scene_g_f06.prm", {}, 1e-9},
                                         Case{"scene_g_rigid_f06.prm", {}, 1e-9}));
