// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_scheme_h
#define fuga_tests_judges_scheme_h

#include "judges/judge_problem.h"

namespace fuga::judges
{
  /**
   * The matrix of the linear equations of a working scheme in the unknowns (x, p):
   *     S x + Bᵀ p = f,
   *     open   N = 0, T = 0;
   *     closed (B x)_n - (ρn/A) N = -g0;
   *     stick  (B x)_t - (ρt/A) T = s_before;
   *     slip   T + σ f N = σ c A.
   * Rigid bars (ρ = 0) are the same rows. @p normal_compliances by element, so that a rate problem
   * can put tangents there.
   */
  DenseMatrix
  scheme_matrix(const JudgeProblem &problem,
                const std::vector<ContactState> &states,
                const Vector &normal_compliances);

  /** ρn of all elements, as they are in the data. */
  Vector
  normal_compliances(const JudgeProblem &problem);

  /** One scheme, solved. The inequalities are not looked at, except through the residual. */
  struct SchemeSolution
  {
    /** False: singular and without solution; then @p solution is empty. */
    bool solved   = false;
    bool singular = false;
    StepSolution solution;
  };

  /** Solves the equations above. Linear or rigid layers only. */
  SchemeSolution
  solve_scheme(const JudgeProblem &problem,
               const Vector &slip_before,
               const Vector &load,
               const std::vector<ContactState> &states,
               const bool allow_singular);
} // namespace fuga::judges

#endif
