// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_interior_solver_h
#define fuga_bodies_solvers_interior_solver_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /**
   * One triangle of a sparse symmetric matrix in coordinate format, numbered from 1; duplicates are
   * added.
   */
  struct SymmetricTriplets
  {
    int size = 0;
    std::vector<int> rows, columns;
    std::vector<double> values;
  };

  /** Counts of the work done by a solver so far; loads and solutions are counted by columns. */
  struct SolverWork
  {
    std::size_t n_factorisations  = 0;
    std::size_t n_condensed_loads = 0;
    std::size_t n_solutions       = 0;
    /** Iterations of conjugate gradients, one vector each. */
    std::size_t n_iterations = 0;
  };

  /**
   * Eliminates all unknowns i of a symmetric matrix except for the last ones, c (kept unknowns).
   * K_ii must be positive definite. In all members the eliminated unknowns come first.
   */
  class InteriorSolver
  {
  public:
    virtual ~InteriorSolver() = default;

    /**
     * Return S = K_cc - K_ci K_ii⁻¹ K_ic (n_kept x n_kept, both triangles) and store the data that
     * the other members need. @p matrix is consumed.
     * @throws NumericalFailure
     */
    virtual DenseMatrix
    eliminate(SymmetricTriplets &matrix, const unsigned int n_kept) = 0;

    /**
     * The digits that a solution has to contribute: the first ones, under a load, or the last ones,
     * under the residual that a solution has left.
     */
    enum class Digits
    {
      first,
      last
    };

    /**
     * Return f = F_c - K_ci K_ii⁻¹ F_i for every column of @p loads, which is overwritten. F_i is
     * the residual that a solution has left.
     */
    virtual DenseMatrix
    condense(DenseMatrix &loads) = 0;

    /**
     * Overwrite every column of @p loads by K_ii⁻¹ load_i, followed by zeros for the kept unknowns.
     */
    virtual void
    solve(DenseMatrix &loads, const Digits digits) = 0;

    virtual const SolverWork &
    work() const = 0;
  };
} // namespace fuga

#endif
