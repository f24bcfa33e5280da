// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_enumeration_h
#define fuga_tests_judges_enumeration_h

#include "judges/judge_problem.h"

namespace fuga::judges
{
  /** All solutions of one implicit step. */
  struct StepEnumeration
  {
    /** Distinct in forces or jumps; of equal ones only the first scheme is kept. */
    std::vector<StepSolution> solutions;
    std::size_t n_schemes = 0;
    /** Singular schemes, with or without solution. */
    std::size_t n_singular = 0;
  };

  /**
   * One implicit load increment from the slips @p slip_before to the load @p load, by trying all
   * (open, stick, slip forward, slip backward)^n schemes; n ≤ 9 or std::invalid_argument (n = 7
   * takes a second). Linear and rigid layers. A scheme is accepted if step_residual() ≤ @p tolerance.
   *
   * An open element takes its slip along (s = δ_t); an element that closes within the step keeps
   * the s_before of its start: end a step at the closing event if the exact path is wanted.
   */
  StepEnumeration
  enumerate_step(const JudgeProblem &problem,
                 const Vector &slip_before,
                 const Vector &load,
                 const double tolerance = 1e-10);
} // namespace fuga::judges

#endif
