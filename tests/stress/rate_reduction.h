// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_rate_reduction_h
#define fuga_tests_stress_rate_reduction_h

#include "judges/dislocation_form.h"
#include "judges/rate_enumeration.h"

namespace fuga::stress
{
  /** One element that stands on a boundary; n and t are its rows in the reduced problem. */
  struct Candidate
  {
    judges::RateStatus status;
    double sign, friction;
    std::size_t n = 0, t = 0;
    bool has_shear = false, cohesive = false;
    /** Of the problem. */
    std::size_t normal_bar = 0, tangential_bar = 0;
  };

  /** forces = q - M rates of dislocation, rows and columns scaled to unit stiffness. */
  struct ReducedProblem
  {
    bool regular = false;
    /** What drives the bars that carry no more force, scaled. */
    double size = 0.;
    DenseMatrix M;
    Vector q;
    std::vector<Candidate> candidates;
    /** Ratio of the scales of the normal and the tangential row, by row of the latter. */
    Vector normal_per_shear;
    /** Dislocation rates of the bars that carry no more force: last column minus the others times
     * the rates of dislocation above, scaled likewise. */
    DenseMatrix follow;
    /** The unscaled form, and which of its bars carry no more force whatever the candidates do.
     */
    judges::DislocationForm form;
    std::vector<std::size_t> free_bars;
    /** Rates so many times larger than what drives them are those of a mechanism. On joints much
     * softer than the bodies fewer digits are left in W to tell. */
    double unbounded_rate = 1e7;
  };

  /** Condenses the elements inside their cones, and those that are open, out of the rates under @p
   * load_rate; see search_continuation(). */
  ReducedProblem
  reduce(const judges::JudgeProblem &problem,
         const std::vector<judges::RateElement> &elements,
         const Vector &load_rate,
         const double stiffness_error);

  /** f N in the units of the scaled shear row. */
  double
  friction(const ReducedProblem &problem, const Candidate &candidate);

  /**
   * The largest rate of the whole problem with these states, like is_consistent(), but without
   * condensation, which may cancel: infinite for a mechanism, be it driven or not.
   */
  double
  exact_rate(const ReducedProblem &problem, const std::vector<ContactState> &states);
} // namespace fuga::stress

#endif
