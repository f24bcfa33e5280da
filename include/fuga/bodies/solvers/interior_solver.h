// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_interior_solver_h
#define fuga_bodies_solvers_interior_solver_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /** One triangle of a sparse symmetric matrix by coordinates, numbered from 1; duplicates add up.
   */
  struct SymmetricTriplets
  {
    int size = 0;
    std::vector<int> rows, columns;
    std::vector<double> values;
  };

  /** What a solver has done so far; loads and solutions count by columns. */
  struct SolverWork
  {
    std::size_t n_factorisations  = 0;
    std::size_t n_condensed_loads = 0;
    std::size_t n_solutions       = 0;
    /** Of conjugate gradients, one vector each. */
    std::size_t n_iterations = 0;
  };

  /**
   * Eliminates all unknowns i of a symmetric matrix but the last ones, c (kept unknowns). K_ii must
   * be positive definite. All members count the eliminated unknowns first.
   */
  class InteriorSolver
  {
  public:
    virtual ~InteriorSolver() = default;

    /**
     * Returns S = K_cc - K_ci K_ii⁻¹ K_ic (n_kept x n_kept, both triangles) and keeps what the
     * other members need. @p matrix is given up.
     * @throws NumericalFailure
     */
    virtual DenseMatrix
    eliminate(SymmetricTriplets &matrix, const unsigned int n_kept) = 0;

    /** Which digits a solution is to bring: those of a load, or those of what a solution has left
     * of it. */
    enum class Digits
    {
      first,
      last
    };

    /** f = F_c - K_ci K_ii⁻¹ F_i for every column of @p loads, which is overwritten. F_i is what a
     * solution has left. */
    virtual DenseMatrix
    condense(DenseMatrix &loads) = 0;

    /** Overwrites every column of @p loads by K_ii⁻¹ load_i, followed by zeros for the kept unknowns. */
    virtual void
    solve(DenseMatrix &loads, const Digits digits) = 0;

    virtual const SolverWork &
    work() const = 0;
  };
} // namespace fuga

#endif
