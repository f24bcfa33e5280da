// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_semismooth_newton_h
#define fuga_tests_judges_semismooth_newton_h

#include "judges/judge_problem.h"

#include <string>
#include <vector>

namespace fuga::judges
{
  /** Settings of semismooth_newton_step(). */
  struct NewtonOptions
  {
    /** Load at the start of the step, where the load homotopy begins; empty = zero. */
    Vector load_before;
    /** Bound of step_residual(). */
    double tolerance            = 1e-11;
    unsigned int max_iterations = 80;
    /** Smallest part of the load (or of the friction) that the homotopies try. */
    double smallest_increment    = 1e-4;
    unsigned int n_random_starts = 30;
    /** Tried in this order. */
    std::vector<std::string> strategies = {
      "undamped", "damped", "load homotopy", "friction homotopy", "random starts"};
  };

  /** What semismooth_newton_step() found. */
  struct NewtonStep
  {
    bool converged = false;
    StepSolution solution;
    unsigned int n_iterations = 0;
    /** The strategy that converged, "none", or "indeterminate" (rigid bars do not hold the bodies).
     */
    std::string strategy = "none";
  };

  /**
   * One implicit load increment by a semismooth Newton method in the dislocation form p = R - W d
   * (see DislocationForm): per element the unknowns a (opening) and s (slip), or with law (9) the
   * gap g and s, and the complementarity functions
   *
   *     N - min(0, N + c_n a) = 0              or, with law (9),   N + A σ(max(0, -g)) = 0,
   *     T - proj_{[-r,r]}(T + c_t (s - s_before)) = 0,   r = f P + cA, P the pressing force,
   *
   * c_n, c_t from the diagonal of W. Rigid, linear and mixed bars and law (9) in the normal bars,
   * up to some hundred elements.
   *
   * Globalisation: undamped; then non-monotone line search on the merit function ½|F|²; then
   * the same along the load (from load_before, slip_before fixed, so that the end is the same
   * one-step problem) and along the friction (from zero), with adaptive increments; then random
   * starts, which a problem with several solutions may need. All with c, 0.1 c, 10 c.
   *
   * converged means that step_residual() of the final (x, p, s) is below the tolerance, nothing
   * else.
   */
  NewtonStep
  semismooth_newton_step(const JudgeProblem &problem,
                         const Vector &slip_before,
                         const Vector &load,
                         const NewtonOptions &options = NewtonOptions());
} // namespace fuga::judges

#endif
