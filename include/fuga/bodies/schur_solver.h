// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_schur_solver_h
#define fuga_bodies_schur_solver_h

#include <fuga/base/dense_matrix.h>

#include <memory>

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
  };

  /**
   * Eliminates all unknowns of a symmetric matrix but the last ones by MUMPS' partial
   * factorisation:
   *
   *     S = K_cc - K_ci K_ii⁻¹ K_ic.
   *
   * K_ii must be positive definite. All processes of the run share the factors and have to call
   * alike; MPI, which MUMPS wants even of a single one, is initialised at the first use and
   * finalised when the program ends, unless somebody else does it.
   */
  class SchurSolver
  {
  public:
    SchurSolver();

    ~SchurSolver();

    /**
     * Factorises and returns S (n_kept x n_kept, both triangles), the same on all processes, of the
     * sum of what every process gives as @p matrix, which is not needed afterwards. @p ordering, if
     * not empty, is the place of every unknown in the elimination, numbered from 1; that of the
     * first process counts.
     * @throws NumericalFailure
     */
    DenseMatrix
    factorise(SymmetricTriplets &matrix, const unsigned int n_kept, std::vector<int> ordering = {});

    /** f = F_c - K_ci K_ii⁻¹ F_i for every column of the @p loads of the first process, which are
     *  overwritten. */
    DenseMatrix
    condense(DenseMatrix &loads);

    /**
     * Overwrites @p load by the solution K_ii⁻¹ (load_i - K_ic x) of the eliminated unknowns,
     * followed by the kept ones, @p x; load and x of the first process count for all.
     */
    void
    solve(Vector &load, const Vector &x);

    /** Seconds spent in the analysis and in the factorisation. */
    double
    analysis_seconds() const
    {
      return analysis_time;
    }

    double
    factorisation_seconds() const
    {
      return factorisation_time;
    }

    const SolverWork &
    work() const
    {
      return its_work;
    }

    /** Peak memory of the factorisation in megabytes, as MUMPS reports it. */
    int
    memory() const;

  private:
    struct Instance;

    void
    call(const int job, const char *what);

    void
    run_condensation(double *loads, const std::size_t n_columns, DenseMatrix &reduced);

    std::unique_ptr<Instance> mumps;
    unsigned int n_kept = 0;
    /** All unknowns are kept: small bodies whose every node is in a joint. */
    bool nothing_to_eliminate = false;
    double analysis_time      = 0.;
    double factorisation_time = 0.;
    SolverWork its_work;
  };
} // namespace fuga

#endif
