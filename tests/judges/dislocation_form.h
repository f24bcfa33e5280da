// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_dislocation_form_h
#define fuga_tests_judges_dislocation_form_h

#include "judges/judge_problem.h"

namespace fuga::judges
{
  /**
   * Bar forces as a function of imposed dislocations. Let D = diag(ρ/A) and let d be imposed on the
   * bars in series with their layers: δ = B x = D p + d. The saddle system
   *
   *     [ S  Bᵀ ] [x]   [f]
   *     [ B  -D ] [p] = [d]        gives        p = R(f) - W d,   x = x_R(f) + X d,
   *
   * with W = (B S⁻¹ Bᵀ + D)⁻¹ where the inverses exist. W is symmetric positive semidefinite, and
   * the saddle matrix is regular also for S singular (floating bodies) and for D = 0 (rigid bars),
   * as long as S + BᵀB is positive definite and the rigid bars are independent.
   *
   * Contact puts d_n = a - g0 with the opening a ≥ 0 ⟂ -N ≥ 0, and d_t = s. With law (9), D
   * holds ρ0 and d_n = g + ρ0 σ(w) - g0, w = -g.
   */
  struct DislocationForm
  {
    /** False: the saddle matrix is singular and the rest is not to be used. */
    bool regular = false;
    DenseMatrix W;
    DenseMatrix X;
    /** R(f) and x_R(f) of the loads that were given. */
    std::vector<Vector> R;
    std::vector<Vector> x_R;
  };

  DislocationForm
  dislocation_form(const JudgeProblem &problem, const std::vector<Vector> &loads);

  /**
   * Names the states of a solution from forces @p p and dislocations (openings a in the normal bars,
   * slips in the tangential ones): whichever side of each complementarity is larger, lengths times
   * @p stiffness compared with forces.
   */
  std::vector<ContactState>
  name_states(const JudgeProblem &problem,
              const Vector &slip_before,
              const Vector &p,
              const Vector &openings_and_slips,
              const Vector &stiffness);

  /** The diagonal of W, its largest entry in place of zeros (1 if all are zero). */
  Vector
  stiffness_scales(const DenseMatrix &W);
} // namespace fuga::judges

#endif
