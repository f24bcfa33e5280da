// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/judges.h"
#include "judges/test_problems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fuga;
using namespace fuga::judges;


TEST(Judges, V10CoupledNodeBeyondCriticalFriction)
{
  // a = d = 1, b = -0.6, f = 2 is unique iff C_n < 3.2, from
  // f_c = a/|b| + (ad - b²)/(C_n|b|); beyond it dF_t + f dF_n < 0 gives two solutions, > 0 none.
  // (a belongs to the tangential coordinate; F_n < 0 presses.)
  for (const double C_n : {.5, 1., 3.19, 3.21, 10., 1e6, -1.})
    {
      JudgeProblem problem      = one_element(1., -.6, 1.);
      JudgeElement &element     = problem.elements[0];
      element.normal_compliance = C_n > 0. ? 1. / C_n : 0.;
      element.friction          = 2.;
      const double critical     = 1. / .6 + (C_n > 0. ? (1. - .36) / (C_n * .6) : 0.);
      EXPECT_EQ(2. < critical, C_n > 0. && C_n < 3.2);
      for (const double shear_compliance : {0., .3, 2.})
        for (unsigned int direction = 0; direction < 48; ++direction)
          {
            element.shear_compliance = shear_compliance;
            const double angle       = (direction + .37) * 3.14159265358979324 / 24.;
            const Vector rate        = {std::cos(angle), std::sin(angle)};
            RateElement at;
            at.status                   = RateStatus::slip_limit;
            at.sign                     = 1.;
            const RateEnumeration rates = enumerate_rates(problem, {at}, rate);
            if (2. < critical)
              EXPECT_TRUE(rates.unique()) << C_n << ' ' << angle;
            else
              EXPECT_NE(rates.count(), 1u) << C_n << ' ' << angle;
            if (C_n < 0. && shear_compliance == 0.)
              {
                EXPECT_EQ(rates.count(), rate[1] + 2. * rate[0] < 0. ? 2u : 0u) << angle;
              }
          }
    }
}

TEST(Judges, V10StepProblemSeesTheSameBound)
{
  // The same numbers in a finite step: f = 2 with N < 0 large, loads swept over the stick cone.
  // Just beyond the bound the window of F_t with stick, slip and open at once is narrow (about
  // 0.015).
  for (const double C_n : {3., 3.4})
    {
      JudgeProblem problem                  = one_element(1., -.6, 1.);
      problem.elements[0].normal_compliance = 1. / C_n;
      problem.elements[0].friction          = 2.;
      std::size_t most = 0, least = 99;
      for (int i = -1500; i <= 1500; ++i)
        {
          const Vector load         = {-1., .002 * i + .00013};
          const StepEnumeration all = enumerate_step(problem, {0.}, load);
          const std::size_t n       = all.solutions.size();
          // Where there are several, the others must end in one of them (or admit defeat).
          if (n > 1)
            {
              const LemkeStep by_lemke   = lemke_step(problem, {0.}, load);
              const NewtonStep by_newton = semismooth_newton_step(problem, {0.}, load);
              EXPECT_TRUE(by_lemke.solved && by_newton.converged);
              double to_lemke = 1., to_newton = 1.;
              for (const StepSolution &solution : all.solutions)
                {
                  to_lemke  = std::min(to_lemke, distance(solution, by_lemke.solution));
                  to_newton = std::min(to_newton, distance(solution, by_newton.solution));
                }
              EXPECT_LE(std::max(to_lemke, to_newton), 1e-10);
            }
          most  = std::max(most, n);
          least = std::min(least, n);
        }
      EXPECT_EQ(most, C_n < 3.2 ? 1u : 3u);
      EXPECT_EQ(least, 1u);
    }
}

TEST(Judges, GrazingAndSingularRates)
{
  // By hand: S = 1, apex g = N = 0, f = 0.5. Pulled: open. Pressed with |F_t| < f|F_n| into a rigid
  // joint: stick; with more: slip by F_t - f|F_n|. A block without any bar's shear (f = 0, S = 0)
  // has none.
  JudgeProblem problem         = one_element(1., 0., 1.);
  problem.elements[0].friction = .5;
  RateElement apex;
  apex.status           = RateStatus::grazing;
  RateEnumeration rates = enumerate_rates(problem, {apex}, {1., .2});
  ASSERT_TRUE(rates.unique());
  EXPECT_EQ(rates.solutions[0].states[0], ContactState::open);
  rates = enumerate_rates(problem, {apex}, {-1., .4});
  ASSERT_TRUE(rates.unique());
  EXPECT_EQ(rates.solutions[0].states[0], ContactState::stick);
  rates = enumerate_rates(problem, {apex}, {-1., -.9});
  ASSERT_TRUE(rates.unique());
  EXPECT_EQ(rates.solutions[0].states[0], ContactState::slip_backward);
  EXPECT_NEAR(rates.solutions[0].slip[0], -.4, 1e-14);

  JudgeProblem block = rigid_block(2, 1., 1., 0.);
  RateElement free;
  free.status = RateStatus::frictionless;
  EXPECT_EQ(enumerate_rates(block, {free, free, free}, {1., 0., 0.}).count(), 0u);
  rates = enumerate_rates(block, {free, free, free}, {0., -1., 0.});
  EXPECT_EQ(rates.count(), 1u);
  EXPECT_FALSE(rates.unique()); // it may slide: a family
}
