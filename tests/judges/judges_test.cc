// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/judges.h"
#include "judges/test_problems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace fuga;
using namespace fuga::judges;

namespace
{
  /** All judges on one step; they must agree. Returns the enumerated (n ≤ 7) or Lemke's solution.
   */
  StepSolution
  judged(const JudgeProblem &problem, const Vector &slip, const Vector &load)
  {
    const LemkeStep by_lemke   = lemke_step(problem, slip, load);
    const NewtonStep by_newton = semismooth_newton_step(problem, slip, load);
    EXPECT_TRUE(by_lemke.solved);
    EXPECT_TRUE(by_newton.converged);
    EXPECT_LE(distance(by_lemke.solution, by_newton.solution), 1e-10);
    if (problem.elements.size() > 4)
      return by_lemke.solution;
    const StepEnumeration all = enumerate_step(problem, slip, load);
    EXPECT_EQ(all.solutions.size(), 1u);
    if (all.solutions.empty())
      return by_lemke.solution;
    EXPECT_LE(distance(by_lemke.solution, all.solutions[0]), 1e-10);
    return all.solutions[0];
  }

  std::size_t
  count(const StepSolution &solution, const ContactState state)
  {
    std::size_t n = 0;
    for (const ContactState s : solution.states)
      n += s == state ? 1 : 0;
    return n;
  }
} // namespace


TEST(Judges, V1OneBarWithGapSlipAndReversal)
{
  // Code_Aster SSND116A: event times and displacements; steps from event to
  // event.
  JudgeProblem problem      = one_element(1., 0., 1.);
  JudgeElement &element     = problem.elements[0];
  element.initial_gap       = .5;
  element.normal_compliance = 1.;
  element.shear_compliance  = 2.;
  element.friction          = .5;
  const auto load           = [](const double t) {
    return Vector{-std::min(t, 1.), t < 1. ? 0. : t < 1.5 ? 4. * (t - 1.) : 4. * (2. - t)};
  };
  struct Row
  {
    double t, u_n, u_t;
    ContactState state;
  };
  const double u_slip = 1.5 - .125; // F_t(1.375) - fN
  const Row rows[]    = {{.49, -.49, 0., ContactState::open},
                         {.6, -.55, 0., ContactState::stick},
                         {1., -.75, 0., ContactState::stick},
                         {1.05, -.75, 2. / 15., ContactState::stick},
                         {1.09374, -.75, 4. * .09374 / 1.5, ContactState::stick},
                         {1.375, -.75, u_slip, ContactState::slip_forward},
                         {1.5, -.75, 1.875, ContactState::slip_forward},
                         {1.55, -.75, 1.74166666666666667, ContactState::stick},
                         {1.68749, -.75, (4. * .31251 + .8125) / 1.5, ContactState::stick},
                         {1.6876, -.75, 4. * .3124 + .125, ContactState::slip_backward},
                         {2., -.75, .125, ContactState::slip_backward}};
  Vector slip(1, 0.);
  for (const Row &row : rows)
    {
      const StepSolution solution = judged(problem, slip, load(row.t));
      EXPECT_NEAR(solution.x[0], row.u_n, 1e-12) << "t = " << row.t;
      EXPECT_NEAR(solution.x[1], row.u_t, 1e-12) << "t = " << row.t;
      EXPECT_EQ(solution.states[0], row.state) << "t = " << row.t;
      slip = solution.slip;
    }
}

TEST(Judges, V3EccentricBlockOpensBarByBar)
{
  // Closed form: opening events of nine bars at these e/b, overturning at 0.5.
  const double events[] = {
    .171875, .214285714285714, .256944444444444, .3, .34375, .388888888888889, .4375};
  JudgeProblem problem = rigid_block(8, 10., 1., 0.);
  std::size_t n_open   = 0;
  const Vector slip    = no_slip(problem);
  for (const double e : events)
    for (const double side : {-1e-9, 1e-9})
      {
        const StepSolution solution = judged(problem, slip, {0., -1., -(e + side)});
        n_open += side > 0. ? 1 : 0;
        EXPECT_EQ(count(solution, ContactState::open), n_open) << "e = " << e + side;
      }
  EXPECT_EQ(lemke_step(problem, slip, {0., -1., -.501}).lcp.status, LemkeStatus::ray);
  EXPECT_FALSE(semismooth_newton_step(problem, slip, {0., -1., -.501}).converged);
}

TEST(Judges, V4ProgressiveSlipOfTheRigidBlock)
{
  // Closed form: n = 8, e = b/12, N = b = 1, f = 0.2, k_t = 1: bars slip in order at
  // d = 0.103030303 + 0.024242424(k-1), H/(fN) as listed; limit load sliding at 1.
  const double H[]     = {.515151515151515,
                          .628787878787879,
                          .727272727272727,
                          .810606060606061,
                          .878787878787879,
                          .931818181818182,
                          .969696969696970,
                          .992424242424242};
  JudgeProblem problem = rigid_block(8, 7., 1., .2);
  Vector slip          = judged(problem, no_slip(problem), {0., -1., -1. / 12.}).slip;
  for (std::size_t k = 0; k < 8; ++k)
    for (const double side : {-1e-9, 1e-9})
      {
        const StepSolution solution = judged(problem, slip, {.2 * (H[k] + side), -1., -1. / 12.});
        EXPECT_EQ(count(solution, ContactState::slip_forward), k + (side > 0. ? 1 : 0));
        EXPECT_NEAR(solution.x[0], (3.4 + .8 * static_cast<double>(k)) / 33., 1e-7);
        slip = solution.slip;
      }
  // Beyond the limit load there is no equilibrium at all.
  const LemkeStep beyond = lemke_step(problem, slip, {.2002, -1., -1. / 12.});
  EXPECT_FALSE(beyond.solved);
  EXPECT_EQ(beyond.lcp.status, LemkeStatus::ray);
  EXPECT_FALSE(semismooth_newton_step(problem, slip, {.2002, -1., -1. / 12.}).converged);
}

TEST(Judges, V6ShakedownOfTheJenkinsElement)
{
  // Closed form: U = (F0 - fN)/k and W = 4fN(U - fN/k_t) per cycle if F0 > fN(1 + k/k_t).
  // k = 1, k_t = 2, fN = 0.3: the bound is 0.45. N comes from a normal spring of its own.
  JudgeProblem problem                  = one_element(1., 0., 1.);
  problem.elements[0].normal_compliance = 1.;
  problem.elements[0].shear_compliance  = .5;
  problem.elements[0].friction          = .3;
  for (const double F0 : {.44, .46, 1.})
    {
      Vector slip(1, 0.);
      double dissipated = 0.;
      for (unsigned int half = 0; half < 8; ++half)
        {
          const StepSolution solution = judged(problem, slip, {-2., half % 2 == 0 ? F0 : -F0});
          if (F0 > .45)
            {
              EXPECT_NEAR(std::abs(solution.x[1]), F0 - .3, 1e-12);
            }
          if (half >= 6)
            dissipated += solution.forces[1] * (solution.slip[0] - slip[0]);
          slip = solution.slip;
        }
      EXPECT_NEAR(dissipated, F0 > .45 ? 1.2 * (F0 - .3 - .15) : 0., 1e-12);
    }
}

TEST(Judges, V6RatchetOfTheRockingBlock)
{
  // Closed form: Q = 0.9, N0 = 1, β = 0.5, f = 0.6, k_t = 2 advances 2D/k_t = 0.3 per cycle,
  // D = Q - 2fN0(1-β). Two bars of area 1/2 each at x = ±1/2: k_t = 4 makes the bar stiffness 2.
  JudgeProblem problem = rigid_block(1, 4., 4., .6);
  Vector slip          = judged(problem, no_slip(problem), {0., -2., 0.}).slip;
  double before        = 0.;
  for (unsigned int half = 0; half < 12; ++half)
    {
      const StepSolution solution = judged(problem, slip, {.9, -2., half % 2 == 0 ? .5 : -.5});
      slip                        = solution.slip;
      if (half % 2 == 1)
        {
          if (half > 4)
            {
              EXPECT_NEAR(solution.x[0] - before, .3, 1e-12);
            }
          before = solution.x[0];
        }
    }
}

TEST(Judges, V11LawNineAndItsNewtonStep)
{
  // Law (9): q = 0.1, 0.2, 0.5, 0.6 give σρ/ζ = 1/900, 0.01, 0.25, 0.54 and
  // C_tan ρ = 1.1522634, 1.3541667, 8/3, 3.75.
  const double rho = 1.25e-4, zeta = 2e-3;
  const double rows[][3] = {
    {.1, 1. / 900., 1.1522634}, {.2, .01, 1.3541667}, {.5, .25, 8. / 3.}, {.6, .54, 3.75}};
  for (const auto &row : rows)
    {
      const double w     = zeta * row[0] * row[0] * row[0];
      const double sigma = row[1] * zeta / rho;
      EXPECT_NEAR(cubic_root_stress(rho, zeta, w) / sigma, 1., 1e-13);
      EXPECT_NEAR(cubic_root_tangent(rho, zeta, w) * rho, row[2], 5e-8);
      EXPECT_NEAR(cubic_root_closure(rho, zeta, sigma) / w, 1., 1e-13);

      // A node on springs 1000 and 500 pressed by exactly 1000 w + A σ, sheared beyond the cone.
      JudgeProblem problem      = one_element(1000., 0., 500.);
      JudgeElement &element     = problem.elements[0];
      element.area              = .5;
      element.normal_compliance = rho;
      element.layer_thickness   = zeta;
      element.shear_compliance  = rho;
      element.friction          = .3;
      const double N            = .5 * sigma;
      const NewtonStep step     = semismooth_newton_step(problem, {0.}, {-1000. * w - N, N});
      ASSERT_TRUE(step.converged);
      EXPECT_NEAR(step.solution.jumps[0] / -w, 1., 1e-10);
      EXPECT_NEAR(step.solution.forces[0] / -N, 1., 1e-10);
      EXPECT_NEAR(step.solution.forces[1] / (.3 * N), 1., 1e-10);
      EXPECT_NEAR(step.solution.x[1] / (.7 * N / 500.), 1., 1e-10);
      EXPECT_EQ(step.solution.states[0], ContactState::slip_forward);
    }
}
