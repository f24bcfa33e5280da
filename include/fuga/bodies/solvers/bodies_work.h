// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_bodies_work_h
#define fuga_bodies_solvers_bodies_work_h

#include <fuga/bodies/solver_choice.h>

#include <optional>

namespace fuga
{
  /** Counts of the work done with the full model so far. */
  struct BodiesWork
  {
    std::size_t n_factorisations  = 0;
    std::size_t n_condensed_loads = 0;
    /** Solutions with the factors, one right-hand side each: one per load pattern, two per
     * recovered field (the second refines), two per LinearResponse. */
    std::size_t n_solutions        = 0;
    std::size_t n_recovered_fields = 0;
    unsigned int n_processes       = 0;
    /** Iterations of conjugate gradients, one vector each; 0 for the direct solver. */
    std::size_t n_iterations = 0;
    BodySolver solver        = BodySolver::direct;
    /** The estimate from which the solver was chosen; only if the program had to choose. */
    std::optional<SolverEstimate> estimate = {};

    /** Add the counts of other work. */
    void
    add(const BodiesWork &other)
    {
      n_factorisations += other.n_factorisations;
      n_condensed_loads += other.n_condensed_loads;
      n_solutions += other.n_solutions;
      n_recovered_fields += other.n_recovered_fields;
      n_iterations += other.n_iterations;
    }
  };
} // namespace fuga

#endif
