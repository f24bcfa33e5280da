// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_examiner_h
#define fuga_tests_stress_examiner_h

#include "judges/judge_problem.h"
#include "stress/rate_question.h"
#include "stress/step_report.h"

#include <fuga/contact/judge/judge.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>

#include <optional>

namespace fuga::stress
{
  /** Whether the independent solvers know the laws of the layers. */
  bool
  judges_know_layers(const std::vector<ContactElement> &elements);

  /** Whether they know the strengths in a state. */
  bool
  judges_know_strengths(const std::vector<ContactElement> &elements, const JointState &state);

  /** The elements with what @p state has left of their strength, and touching where they touch by
   * then. */
  judges::JudgeProblem
  problem_in(const judges::JudgeProblem &virgin, const JointState &state);

  /** The step by another solver; nothing if none finds one. */
  std::optional<judges::StepSolution>
  solve_anew(const judges::JudgeProblem &problem,
             const Vector &slip_before,
             const Vector &load_before,
             const Vector &load);

  /**
   * Puts states of a path before the independent judges. Of the solver only the numbers of the
   * states are taken: forces, dislocations, slips, names of states, broken bonds.
   */
  class Examiner
  {
  public:
    Examiner(const Model<2> &model, const JointModel &joint);

    /** Whether the independent solvers know the laws and strengths in a state well enough to solve
     * steps from it, */
    bool
    can_solve(const JointState &state) const;

    /** or to say whether the joints go on from it, by the tangents of their layers. */
    bool
    can_continue(const JointState &state) const;

    StepReport
    examine_step(const JointState &from, const JointState &to) const;

    /** Do the joints go on from here under the loads that follow? */
    RateSearch
    search(const JointState &state) const;

    /** Nothing resists these jumps, and they respect the states. */
    bool
    is_mechanism(const JointState &state, const Vector &jumps) const;

    /** Another solver finds a step to the load that follows in @p part of a stage, and not far away. */
    bool
    finds_step_beyond(const JointState &state, const double part) const;

    /** Return whether strengths are curved and no such step goes on. */
    bool
    is_turning_point(const JointState &state) const;

  private:
    Vector
    load(const double t) const;
    judges::StepSolution
    solution(const judges::JudgeProblem &at,
             const JointState &state,
             const Vector &slip_before) const;
    std::vector<judges::RateElement>
    positions(const judges::JudgeProblem &at,
              const JointState &state,
              const double tolerance) const;
    double
    stiffness_error() const;

    const Model<2> &model;
    const std::vector<ContactElement> &elements;
    const LayeredSystem layered;
    const Judge judge;
    const judges::JudgeProblem problem;
  };
} // namespace fuga::stress

#endif
