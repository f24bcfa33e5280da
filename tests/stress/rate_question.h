// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_rate_question_h
#define fuga_tests_stress_rate_question_h

#include "judges/rate_enumeration.h"

namespace fuga::stress
{
  /** What an independent search for a continuation found. */
  enum class RateAnswer
  {
    /** Bounded rates that satisfy every rate inequality: the path goes on. */
    continuation,
    /** Every combination of states was tried: none. */
    none,
    /** Too many combinations; Lemke's method ended on rays for every covering vector. */
    ray,
    /** The open elements leave a mechanism already, or nothing could be decided. */
    undecided
  };

  struct RateSearch
  {
    RateAnswer answer      = RateAnswer::undecided;
    std::size_t n_schemes  = 0;
    std::size_t n_boundary = 0;
    /** Largest rate of a scheme without violation that was taken for unbounded; 0 if there was
     * none. */
    double unbounded = 0.;
  };

  /**
   * Asks whether the joints can go on from a state under @p load_rate. The judges' own data and
   * linear algebra are used, nothing of the solver: the elements inside their cones or open are
   * eliminated, and what is left, scaled to unit stiffness, is enumerated if it has at most
   * @p max_schemes combinations and given to judges::lemke() with several covering vectors if not.
   *
   * @p problem has linear layers only; nonlinear ones are to be replaced by their tangents.
   * @p stiffness_error is what its stiffness is known to be wrong by.
   */
  RateSearch
  search_continuation(const judges::JudgeProblem &problem,
                      const std::vector<judges::RateElement> &elements,
                      const Vector &load_rate,
                      const double stiffness_error,
                      const std::size_t max_schemes = 20000);
} // namespace fuga::stress

#endif
