// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_lemke_step_h
#define fuga_tests_judges_lemke_step_h

#include "judges/judge_problem.h"
#include "judges/lemke.h"

namespace fuga::judges
{
  /** What lemke_step() found. */
  struct LemkeStep
  {
    /** The LCP was solved and the solution fulfils step_residual() ≤ tolerance. */
    bool solved = false;
    StepSolution solution;
    /** Bars held rigidly do not hold the bodies (or are not independent): no LCP was made. */
    bool indeterminate = false;
    /** The last run of Lemke, in scaled unknowns (a, λ⁺, λ⁻ of each element in turn). */
    LemkeResult lcp;
    std::size_t n_pivots = 0;
    /** Covering vectors tried. */
    std::size_t n_attempts = 0;
  };

  /**
   * One implicit load increment as a linear complementarity problem in the dislocation form
   * p = R - W d (see DislocationForm), d_n = a - g0, d_t = s_before + λ⁺ - λ⁻:
   *
   *     0 ≤ a  ⟂ -N ≥ 0,
   *     0 ≤ λ⁺ ⟂ f(-N) + cA - T ≥ 0,
   *     0 ≤ λ⁻ ⟂ f(-N) + cA + T ≥ 0.
   *
   * Compliant, rigid and mixed bars are the same to it, also with S singular. Linear layers only.
   * With friction the matrix is not copositive, so a ray of one covering vector is no proof: up to
   * @p max_attempts vectors are tried (the first is all ones). Cohesion is lost by open elements:
   * the LCP is repeated without the cohesion of the elements that it opened.
   */
  LemkeStep
  lemke_step(const JudgeProblem &problem,
             const Vector &slip_before,
             const Vector &load,
             const double tolerance         = 1e-11,
             const std::size_t max_attempts = 9);
} // namespace fuga::judges

#endif
