// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_step_solvers_h
#define fuga_bodies_dynamics_step_solvers_h

#include <fuga/bodies/solvers/bodies_work.h>
#include <fuga/bodies/solvers/schur_solver.h>

#include <memory>

namespace fuga
{
  /** The stiffness of steps of all lengths, factorised when first needed. Motions of the same
   * bodies with the same masses and lengths share it. */
  struct StepSolvers
  {
    Vector mass;
    /** Of the longest steps [s]. */
    double step = 0.;
    /** See elimination_order(); the same for all of them. */
    std::vector<int> order;
    /** By rung: the factors and Ŝ. */
    std::vector<std::unique_ptr<SchurSolver>> solvers;
    std::vector<DenseMatrix> stiffness;

    BodiesWork
    work() const;
  };
} // namespace fuga

#endif
