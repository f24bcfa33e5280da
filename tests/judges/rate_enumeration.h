// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_rate_enumeration_h
#define fuga_tests_judges_rate_enumeration_h

#include "judges/judge_problem.h"

namespace fuga::judges
{
  /** Where an element stands when the rates are asked for. */
  enum class RateStatus
  {
    /** g > 0. */
    open,
    /** Closed and strictly inside the cone. */
    stick,
    /** Closed, |T| = f|N| + cA > 0. */
    slip_limit,
    /** g = 0 and N = 0. */
    grazing,
    /** Closed, f = c = 0. */
    frictionless
  };

  /** One element's part of the question. */
  struct RateElement
  {
    RateStatus status = RateStatus::stick;
    /** Sign of T; slip_limit only. */
    double sign = 0.;
    /** Closure w, for the tangent of law (9) in a closed element. */
    double closure = 0.;
  };

  /** One solution of the rate problem. */
  struct RateSolution
  {
    /** dx/dt; dδ/dt and dp/dt by bar; ds/dt by element. */
    Vector x;
    Vector jumps;
    Vector forces;
    Vector slip;
    std::vector<ContactState> states;
    /** The scheme is singular: one member of a family. */
    bool family = false;
  };

  /** All solutions of the rate problem. */
  struct RateEnumeration
  {
    /** Distinct rates; of schemes with equal rates only the first is kept. */
    std::vector<RateSolution> solutions;
    std::size_t n_schemes  = 0;
    std::size_t n_singular = 0;

    std::size_t
    count() const
    {
      return solutions.size();
    }

    bool
    unique() const
    {
      return solutions.size() == 1 && !solutions.front().family;
    }
  };

  /**
   * Tries every choice of every boundary element against the load rate @p load_rate:
   *  - slip_limit: stick with σṪ ≤ -fṄ, or slip with σṡ ≥ 0;
   *  - grazing: open with ġ ≥ 0, stick with Ṅ ≤ 0 and |Ṫ| ≤ -fṄ, slip with Ṅ ≤ 0 and ±ṡ ≥ 0; with
   *    cohesion only open and stick, since T = 0 is then inside the cone;
   *  - the others keep their state.
   * At most 9 boundary elements of four choices each (or as many schemes), else
   * std::invalid_argument.
   */
  RateEnumeration
  enumerate_rates(const JudgeProblem &problem,
                  const std::vector<RateElement> &elements,
                  const Vector &load_rate,
                  const double tolerance = 1e-9);

  /**
   * The question that belongs to a solution: what is within @p tolerance (relative to the largest
   * force and length) of a boundary is on it.
   */
  std::vector<RateElement>
  rate_elements(const JudgeProblem &problem,
                const StepSolution &solution,
                const double tolerance = 1e-9);
} // namespace fuga::judges

#endif
