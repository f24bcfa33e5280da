// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/judges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace fuga;
using namespace fuga::judges;

namespace
{
  /** Uniform numbers that are the same with every standard library. */
  class Random
  {
  public:
    explicit Random(const unsigned int seed) : generator(seed)
    {
    }

    double
    operator()(const double from, const double to)
    {
      return from + (to - from) * static_cast<double>(generator()) / 4294967296.;
    }

  private:
    std::mt19937 generator;
  };

  enum class Layers
  {
    compliant,
    rigid,
    mixed,
    floating
  };

  /** Positive definite S = GᵀG/m + 1, bars in a shuffled order, areas and gaps at random.
   * Floating: S = GᵀG/m with two rows of G zero. */
  JudgeProblem
  random_problem(Random &random, const std::size_t n, const Layers layers)
  {
    const std::size_t m = 2 * n;
    JudgeProblem problem;
    DenseMatrix G(m, m);
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t i = 0; i < m; ++i)
        G(i, j) = layers == Layers::floating && i < 2 ? 0. : random(-1., 1.);
    problem.S = DenseMatrix(m, m);
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < m; ++j)
        {
          problem.S(i, j) = i == j && layers != Layers::floating ? 1. : 0.;
          for (std::size_t k = 0; k < m; ++k)
            problem.S(i, j) += G(k, i) * G(k, j) / static_cast<double>(m);
        }
    std::vector<unsigned int> bars(m);
    for (unsigned int i = 0; i < m; ++i)
      bars[i] = i;
    for (std::size_t i = m - 1; i > 0; --i)
      std::swap(bars[i], bars[static_cast<std::size_t>(random(0., static_cast<double>(i)))]);
    for (std::size_t k = 0; k < n; ++k)
      {
        const auto compliance = [&] {
          if (layers == Layers::rigid || (layers == Layers::mixed && random(0., 1.) < .5))
            return 0.;
          return std::pow(10., random(-2., 1.));
        };
        JudgeElement element;
        element.normal_bar        = bars[2 * k];
        element.tangential_bar    = bars[2 * k + 1];
        element.area              = random(.5, 2.);
        element.initial_gap       = random(0., 1.) < .5 ? 0. : random(0., .3);
        element.normal_compliance = compliance();
        element.shear_compliance  = compliance();
        element.friction          = random(0., .4);
        problem.elements.push_back(element);
      }
    return problem;
  }

  /** Mostly pressing, some pulling, shear of any sign. */
  Vector
  random_load(Random &random, const JudgeProblem &problem)
  {
    Vector load(problem.n_coordinates(), 0.);
    for (const JudgeElement &element : problem.elements)
      {
        load[element.normal_bar]     = random(-2., .7);
        load[element.tangential_bar] = random(-1., 1.);
      }
    return load;
  }

  /** Distance to the nearest of the enumerated solutions. */
  double
  nearest(const StepEnumeration &all, const StepSolution &solution)
  {
    double result = std::numeric_limits<double>::infinity();
    for (const StepSolution &candidate : all.solutions)
      result = std::min(result, distance(candidate, solution));
    return result;
  }

  void
  compare_on_random_problems(const Layers layers, const unsigned int seed)
  {
    Random random(seed);
    std::size_t n_unique = 0, n_all = 0, n_retries = 0;
    for (std::size_t n = 1; n <= 5; ++n)
      for (unsigned int run = 0; run < (n == 5 ? 10u : 60u); ++run)
        {
          const JudgeProblem problem = random_problem(random, n, layers);
          Vector slip                = no_slip(problem);
          const Vector load          = random_load(random, problem);
          // Monotone loading from zero in two steps.
          for (const double part : {.5, 1.})
            {
              Vector f = load;
              for (double &entry : f)
                entry *= part;
              const StepEnumeration all  = enumerate_step(problem, slip, f);
              const LemkeStep by_lemke   = lemke_step(problem, slip, f);
              const NewtonStep by_newton = semismooth_newton_step(problem, slip, f);
              ASSERT_GE(all.solutions.size(), 1u) << n << ' ' << run;
              ASSERT_TRUE(by_lemke.solved) << n << ' ' << run;
              ASSERT_TRUE(by_newton.converged)
                << n << ' ' << run << ' ' << by_newton.solution.residual;
              ++n_all;
              n_retries += by_lemke.n_attempts > 1 ? 1 : 0;
              EXPECT_LE(nearest(all, by_lemke.solution), 1e-10) << n << ' ' << run;
              EXPECT_LE(nearest(all, by_newton.solution), 1e-10) << n << ' ' << run;
              if (all.solutions.size() == 1)
                ++n_unique;
              slip = by_lemke.solution.slip;
            }
        }
    EXPECT_EQ(n_unique, n_all);
    ::testing::Test::RecordProperty("steps", static_cast<int>(n_all));
    ::testing::Test::RecordProperty("lemke_retries", static_cast<int>(n_retries));
  }
} // namespace


TEST(JudgesAgree, RandomCompliant)
{
  // Enumeration, Lemke and Newton against each other, f ≤ 0.4: no outside number.
  compare_on_random_problems(Layers::compliant, 1);
}

TEST(JudgesAgree, RandomRigid)
{
  // The same with every bar rigid.
  compare_on_random_problems(Layers::rigid, 2);
}

TEST(JudgesAgree, RandomMixed)
{
  // The same with normal and shear bars rigid or compliant at random.
  compare_on_random_problems(Layers::mixed, 3);
}

TEST(JudgesAgree, CohesionAndFrictionless)
{
  // The three judges against each other with cohesion in some elements and f = 0 in others.
  Random random(4);
  for (unsigned int run = 0; run < 100; ++run)
    {
      JudgeProblem problem = random_problem(random, 1 + run % 4, Layers::mixed);
      for (JudgeElement &element : problem.elements)
        (random(0., 1.) < .5 ? element.cohesion : element.friction) = random(0., 1.) < .5 ? 0. : .1;
      const Vector slip          = no_slip(problem);
      const Vector load          = random_load(random, problem);
      const StepEnumeration all  = enumerate_step(problem, slip, load);
      const LemkeStep by_lemke   = lemke_step(problem, slip, load);
      const NewtonStep by_newton = semismooth_newton_step(problem, slip, load);
      ASSERT_TRUE(by_lemke.solved) << run;
      ASSERT_TRUE(by_newton.converged) << run;
      EXPECT_LE(nearest(all, by_lemke.solution), 1e-10) << run;
      EXPECT_LE(nearest(all, by_newton.solution), 1e-10) << run;
    }
}

TEST(JudgesAgree, RatesContinueTheStep)
{
  // Finite differences: from a solution at load F the unique rates times h must give the solution
  // at F + h F' (linear layers, no event within h). Random problems, rates included at slip limits.
  Random random(5);
  std::size_t n_compared = 0;
  for (unsigned int run = 0; run < 60; ++run)
    {
      const JudgeProblem problem = random_problem(random, 1 + run % 4, Layers::mixed);
      const Vector load          = random_load(random, problem);
      const LemkeStep first      = lemke_step(problem, no_slip(problem), load);
      ASSERT_TRUE(first.solved);
      const Vector rate = random_load(random, problem);
      const auto all    = enumerate_rates(problem, rate_elements(problem, first.solution), rate);
      ASSERT_EQ(all.count(), 1u) << run;
      const double h = 1e-7;
      Vector next    = load;
      for (std::size_t i = 0; i < next.size(); ++i)
        next[i] += h * rate[i];
      const LemkeStep second = lemke_step(problem, first.solution.slip, next);
      // Elements on their limits are ties that the rounding of the BLAS breaks: on some processors
      // Lemke's path ends there.
      if (!second.solved)
        continue;
      for (std::size_t bar = 0; bar < next.size(); ++bar)
        EXPECT_NEAR((second.solution.forces[bar] - first.solution.forces[bar]) / h,
                    all.solutions[0].forces[bar],
                    2e-6)
          << run;
      ++n_compared;
    }
  EXPECT_GE(n_compared, 59u);
}

TEST(JudgesAgree, FloatingBodies)
{
  // S of rank 2n - 2, compliant bars: where enumeration finds no equilibrium, nobody may find one.
  // A floating body may wedge: there are a few problems with several solutions among them.
  Random random(6);
  std::size_t n_without = 0, n_several = 0, n_lemke = 0, n_newton = 0;
  for (unsigned int run = 0; run < 120; ++run)
    {
      const JudgeProblem problem = random_problem(random, 2 + run % 3, Layers::floating);
      const Vector slip          = no_slip(problem);
      const Vector load          = random_load(random, problem);
      const StepEnumeration all  = enumerate_step(problem, slip, load);
      const LemkeStep by_lemke   = lemke_step(problem, slip, load);
      const NewtonStep by_newton = semismooth_newton_step(problem, slip, load);
      n_without += all.solutions.empty() ? 1 : 0;
      n_several += all.solutions.size() > 1 ? 1 : 0;
      n_lemke += by_lemke.solved ? 1 : 0;
      n_newton += by_newton.converged ? 1 : 0;
      if (by_lemke.solved)
        {
          EXPECT_LE(nearest(all, by_lemke.solution), 1e-10) << run;
        }
      if (by_newton.converged)
        {
          EXPECT_LE(nearest(all, by_newton.solution), 1e-10) << run;
        }
    }
  EXPECT_GT(n_without, 10u);
  EXPECT_LT(n_without, 110u);
  EXPECT_EQ(n_lemke, 120u - n_without);
  EXPECT_EQ(n_newton, 120u - n_without);
  EXPECT_LE(n_several, 3u);
}

TEST(JudgesAgree, EveryNewtonStrategyAlone)
{
  // The fall-backs are hardly ever needed; each must do the job alone. Enumeration is the judge.
  for (const char *const strategy : {"undamped", "damped", "load homotopy", "friction homotopy"})
    {
      Random random(8);
      for (unsigned int run = 0; run < 60; ++run)
        {
          const JudgeProblem problem = random_problem(random, 1 + run % 4, Layers::mixed);
          const Vector load          = random_load(random, problem);
          NewtonOptions options;
          options.strategies    = {strategy};
          const NewtonStep step = semismooth_newton_step(problem, no_slip(problem), load, options);
          const StepEnumeration all = enumerate_step(problem, no_slip(problem), load);
          ASSERT_EQ(all.solutions.size(), 1u) << run;
          ASSERT_TRUE(step.converged) << strategy << ' ' << run;
          EXPECT_LE(distance(all.solutions[0], step.solution), 1e-10) << strategy << ' ' << run;
        }
    }
}

TEST(JudgesAgree, TheResidualRejectsWrongAnswers)
{
  // A relative change of 1e-6 of one force, coordinate or slip must be seen as at least 1e-8, and a
  // solution of other states must fail. No outside number.
  Random random(9);
  for (unsigned int run = 0; run < 60; ++run)
    {
      const JudgeProblem problem = random_problem(random, 1 + run % 4, Layers::mixed);
      const Vector slip          = no_slip(problem);
      const Vector load          = random_load(random, problem);
      const StepSolution right   = enumerate_step(problem, slip, load).solutions.at(0);
      const auto residual        = [&](const StepSolution &s) {
        return step_residual(problem, slip, load, s.x, s.forces, s.slip);
      };
      EXPECT_LE(residual(right), 1e-13);
      for (std::size_t i = 0; i < problem.n_bars(); ++i)
        for (const double change : {-1e-6, 1e-6})
          {
            StepSolution wrong = right;
            wrong.forces[i] += change * right.force_scale;
            EXPECT_GT(residual(wrong), 1e-8) << run;
            wrong = right;
            wrong.x[i] += change * right.length_scale;
            EXPECT_GT(residual(wrong), 1e-8) << run;
            wrong = right;
            wrong.slip[i / 2] += change * right.length_scale;
            EXPECT_GT(residual(wrong), 1e-8) << run;
          }
    }
}
