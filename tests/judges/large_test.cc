// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/from_contact.h"
#include "judges/judges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace fuga;
using namespace fuga::judges;

namespace
{
  /**
   * n points on a line, S = inverse of a decaying flexibility with the antisymmetric coupling of
   * normal and tangential displacements that an elastic half-plane has.
   */
  JudgeProblem
  line_contact(const std::size_t n, const double rho, const double f)
  {
    const std::size_t m = 2 * n;
    DenseMatrix flexibility(m, m), S(m, m);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        {
          const double r            = static_cast<double>(i) - static_cast<double>(j);
          const double decay        = std::exp(-std::abs(r) / 6.);
          flexibility(2 * i, 2 * j) = flexibility(2 * i + 1, 2 * j + 1) = decay;
          const double coupling         = r == 0. ? 0. : .05 * std::exp(-std::abs(r) / 3.);
          flexibility(2 * i, 2 * j + 1) = r > 0. ? coupling : -coupling;
          flexibility(2 * j + 1, 2 * i) = r > 0. ? coupling : -coupling;
        }
    // Gauss-Jordan without pivoting: the flexibility is positive definite.
    for (std::size_t i = 0; i < m; ++i)
      S(i, i) = 1.;
    for (std::size_t k = 0; k < m; ++k)
      {
        const double pivot = flexibility(k, k);
        EXPECT_GT(pivot, 0.);
        for (std::size_t j = 0; j < m; ++j)
          {
            flexibility(k, j) /= pivot;
            S(k, j) /= pivot;
          }
        for (std::size_t i = 0; i < m; ++i)
          {
            const double factor = flexibility(i, k);
            if (i == k || factor == 0.)
              continue;
            for (std::size_t j = 0; j < m; ++j)
              {
                flexibility(i, j) -= factor * flexibility(k, j);
                S(i, j) -= factor * S(k, j);
              }
          }
      }
    JudgeProblem problem;
    problem.S = DenseMatrix(m, m);
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < m; ++j)
        problem.S(i, j) = .5 * (S(i, j) + S(j, i));
    for (std::size_t k = 0; k < n; ++k)
      {
        JudgeElement element;
        const double x         = 2. * (static_cast<double>(k) + .5) / static_cast<double>(n) - 1.;
        element.normal_bar     = static_cast<unsigned int>(2 * k);
        element.tangential_bar = static_cast<unsigned int>(2 * k + 1);
        element.initial_gap    = .3 * x * x;
        element.normal_compliance = element.shear_compliance = rho;
        element.friction                                     = f;
        problem.elements.push_back(element);
      }
    return problem;
  }

  /** Bodies pressed together by w_n and sheared by w_t everywhere (imposed far displacement). */
  Vector
  far_displacement(const JudgeProblem &problem, const double w_n, const double w_t)
  {
    Vector load(problem.n_coordinates(), 0.);
    for (std::size_t j = 0; j < load.size(); ++j)
      for (std::size_t i = 0; i < load.size(); ++i)
        load[i] += problem.S(i, j) * (j % 2 == 0 ? w_n : w_t);
    return load;
  }

  std::array<std::size_t, 3>
  open_stick_slip(const StepSolution &solution)
  {
    std::array<std::size_t, 3> counts = {{0, 0, 0}};
    for (const ContactState state : solution.states)
      ++counts[static_cast<std::size_t>(state_code(state))];
    return counts;
  }
} // namespace


TEST(JudgesLarge, LineContactOf40Elements)
{
  // Lemke and Newton against each other, rigid and compliant; open, stick and slip all present.
  for (const double rho : {0., .05})
    {
      const JudgeProblem problem = line_contact(40, rho, .35);
      Vector slip                = no_slip(problem);
      Vector before(problem.n_coordinates(), 0.);
      for (const double shear : {0., .02, .05, -.05})
        {
          const Vector load        = far_displacement(problem, -.2, shear);
          const LemkeStep by_lemke = lemke_step(problem, slip, load);
          NewtonOptions options;
          options.load_before        = before;
          const NewtonStep by_newton = semismooth_newton_step(problem, slip, load, options);
          ASSERT_TRUE(by_lemke.solved) << shear;
          ASSERT_TRUE(by_newton.converged) << shear;
          EXPECT_LE(distance(by_lemke.solution, by_newton.solution), 1e-10);
          if (shear == .05)
            {
              for (const std::size_t some : open_stick_slip(by_lemke.solution))
                EXPECT_GT(some, 0u);
            }
          slip   = by_lemke.solution.slip;
          before = load;
        }
    }
}

TEST(JudgesLarge, NewtonOf300ElementsAndLawNine)
{
  // Nothing to compare with: the own residual of the solution is the judge. ζ0 = 0.002: the
  // largest closure must be beyond 0.0604 ζ0, where the fixed-stiffness iteration of the paper
  // fails.
  for (const double thickness : {0., .002})
    {
      JudgeProblem problem = line_contact(thickness > 0. ? 100 : 300, .05, .35);
      for (JudgeElement &element : problem.elements)
        element.layer_thickness = thickness;
      const NewtonStep step =
        semismooth_newton_step(problem, no_slip(problem), far_displacement(problem, -.2, .03));
      ASSERT_TRUE(step.converged) << step.solution.residual;
      if (thickness > 0.)
        {
          EXPECT_LT(*std::min_element(step.solution.gap.begin(), step.solution.gap.end()),
                    -.0604 * thickness);
        }
      EXPECT_LE(step.solution.residual, 1e-11);
      for (const std::size_t some : open_stick_slip(step.solution))
        EXPECT_GT(some, 0u);
    }
}

TEST(JudgesLarge, ReadsTheContactInterface)
{
  // By hand: one bar, S = 1, C_n = 1, pressed by 1: N = -1/2.
  struct Linear : ComplianceLaw
  {
    ComplianceKind
    kind() const override
    {
      return ComplianceKind::linear;
    }
    double
    initial_compliance() const override
    {
      return 1.;
    }
    double
    stress(const double w) const override
    {
      return w;
    }
    double
    tangent(const double) const override
    {
      return 1.;
    }
    double
    secant(const double) const override
    {
      return 1.;
    }
    double
    energy(const double w) const override
    {
      return .5 * w * w;
    }
    double
    deformation(const double sigma) const override
    {
      return sigma;
    }
    std::string
    description() const override
    {
      return "";
    }
  };
  struct Toy : ContactSystem
  {
    DenseMatrix one = DenseMatrix(1, 1), none;
    const DenseMatrix &
    stiffness() const override
    {
      return one;
    }
    const DenseMatrix &
    load_patterns() const override
    {
      return one;
    }
    SparseOperator identity;
    const SparseOperator &
    jump_operator() const override
    {
      return identity;
    }
    const DenseMatrix &
    rigid_motions() const override
    {
      return none;
    }
    const DenseMatrix &
    rigid_motion_loads() const override
    {
      return none;
    }
  };
  Toy system;
  system.one(0, 0) = 1.;
  const Linear law;
  ContactElement element;
  element.normal_bar         = 0;
  element.normal_law         = &law;
  const JudgeProblem problem = judge_problem(system, {element});
  const auto all             = enumerate_step(problem, {0.}, judge_load(system, {-1.}));
  ASSERT_EQ(all.solutions.size(), 1u);
  EXPECT_NEAR(all.solutions[0].forces[0], -.5, 1e-15);
}
