// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_cone_examiner_h
#define fuga_tests_stress_cone_examiner_h

#include "judges/cone_newton.h"
#include "stress/step_report.h"

#include <fuga/contact/judge/judge.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>

namespace fuga::stress
{
  /** Whether judges::ConeNewton knows the layers: any closure, linear or rigid shear. */
  bool
  cones_know_layers(const std::vector<ContactElement> &elements);

  /** What it is to know of the elements, with what @p state has left of their strength, and touching
   * where they touch by then. */
  std::vector<judges::ConeElement>
  cones_of(const std::vector<ContactElement> &elements, const JointState &state);

  judges::ConeState
  cone_state(const std::vector<ContactElement> &elements, const JointState &state);

  /** The step from one state under one load to another. */
  StepReport
  examine_cone_step(const judges::ConeNewton &newton,
                    const judges::ConeState &from,
                    const Vector &factors_before,
                    const judges::ConeState &to,
                    const Vector &factors);

  /** Puts states of a path in space before judges::ConeNewton, as Examiner does in the plane. Of
   * the solver only forces, dislocations and jumps of a motion are taken. */
  class ConeExaminer
  {
  public:
    ConeExaminer(const Model<3> &model, const JointModel &joint);

    /** Whether layers and strengths in a state are known. */
    bool
    can_solve(const JointState &state) const;

    StepReport
    examine_step(const JointState &from, const JointState &to) const;

    /** Nothing resists these jumps, they respect the states, and the growing load drives them. */
    bool
    is_mechanism(const JointState &state, const Vector &jumps) const;

    /** ConeNewton finds a step to the load that follows in @p part of a stage, and not far away. */
    bool
    finds_step_beyond(const JointState &state, const double part) const;

  private:
    bool
    respects(const judges::ConeElement &element,
             const judges::ConeState &state,
             const Vector &jumps) const;

    const Model<3> &model;
    const std::vector<ContactElement> &elements;
    const Judge judge;
    const judges::ConeNewton newton;
  };
} // namespace fuga::stress

#endif
