// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_test_problems_h
#define fuga_tests_judges_test_problems_h

#include "judges/judge_problem.h"

namespace fuga::judges
{
  /** S x + Bᵀ p = f for one element; coordinates (normal, tangential), diagonal or coupled S. */
  inline JudgeProblem
  one_element(const double S_nn, const double S_nt, const double S_tt)
  {
    JudgeProblem problem;
    problem.S       = DenseMatrix(2, 2);
    problem.S(0, 0) = S_nn;
    problem.S(0, 1) = problem.S(1, 0) = S_nt;
    problem.S(1, 1)                   = S_tt;
    problem.elements.resize(1);
    problem.elements[0].normal_bar     = 0;
    problem.elements[0].tangential_bar = 1;
    return problem;
  }

  /**
   * A rigid block (u, v, θ) on n + 1 bars at the nodes of n equal elements of a base b = 1 about x
   * = 0, unit depth: normal jump v + xθ, tangential jump u. Tributary areas h, h/2 at the ends.
   */
  inline JudgeProblem
  rigid_block(const std::size_t n, const double k_n, const double k_t, const double f)
  {
    JudgeProblem problem;
    problem.S = DenseMatrix(3, 3);
    problem.B = DenseMatrix(2 * (n + 1), 3);
    for (std::size_t k = 0; k <= n; ++k)
      {
        JudgeElement element;
        element.normal_bar        = static_cast<unsigned int>(2 * k);
        element.tangential_bar    = static_cast<unsigned int>(2 * k + 1);
        element.area              = (k == 0 || k == n ? .5 : 1.) / static_cast<double>(n);
        element.normal_compliance = 1. / k_n;
        element.shear_compliance  = 1. / k_t;
        element.friction          = f;
        problem.B(2 * k, 1)       = 1.;
        problem.B(2 * k, 2)       = static_cast<double>(k) / static_cast<double>(n) - .5;
        problem.B(2 * k + 1, 0)   = 1.;
        problem.elements.push_back(element);
      }
    return problem;
  }
} // namespace fuga::judges

#endif
