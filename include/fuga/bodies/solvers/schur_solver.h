// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_schur_solver_h
#define fuga_bodies_solvers_schur_solver_h

#include <fuga/bodies/solvers/interior_solver.h>

#include <memory>

namespace fuga
{
  /** The cost of a factorisation on all processes together, estimated by the analysis. */
  struct DirectEstimate
  {
    double megabytes = 0.;
    /** Memory if the factor is stored in files. */
    double megabytes_on_disk = 0.;
    double operations        = 0.;
  };

  /**
   * An InteriorSolver by MUMPS' partial factorisation, which returns S. All processes of the run
   * share the factors and have to call the functions alike, each with its part of the matrix; loads
   * and solutions of the first one count for all, and S is the same on all. MPI, which MUMPS
   * requires even for a single process, is initialised at the first use and finalised when the
   * program ends, unless this is done elsewhere.
   */
  class SchurSolver : public InteriorSolver
  {
  public:
    /**
     * @p ordering, if not empty, is the position of every unknown in the elimination, numbered from
     * 1.
     */
    explicit SchurSolver(std::vector<int> ordering = {});

    ~SchurSolver() override;

    /** Do the symbolic part of eliminate(), which is not repeated there. */
    DirectEstimate
    analyse(SymmetricTriplets &matrix, const unsigned int n_kept);

    /**
     * Store the factor in files in the folder for temporary files (TMPDIR), from which it is read
     * for every solution. To be called before eliminate().
     */
    void
    keep_factor_on_disk();

    DenseMatrix
    eliminate(SymmetricTriplets &matrix, const unsigned int n_kept) override;

    DenseMatrix
    condense(DenseMatrix &loads) override;

    void
    solve(DenseMatrix &loads, const Digits digits) override;

    /**
     * Return all unknowns under the last load of condense(), one column, if the kept ones are
     * @p kept: the second half of a solution.
     */
    Vector
    expand(const Vector &kept);

    const SolverWork &
    work() const override
    {
      return its_work;
    }

  private:
    struct Instance;

    void
    call(const int job, const char *what);

    /** Run MUMPS' solution phase for all columns of @p loads; @p part is its ICNTL(26). */
    void
    run_solution(const int part, DenseMatrix &loads, const char *what);

    std::unique_ptr<Instance> mumps;
    unsigned int n_kept = 0;
    /** Whether all unknowns are kept: small bodies with every node in a joint. */
    bool nothing_to_eliminate = false;
    /** The last load of condense(), if no unknown is kept. */
    DenseMatrix of_all;
    bool is_analysed = false;
    SolverWork its_work;
  };
} // namespace fuga

#endif
