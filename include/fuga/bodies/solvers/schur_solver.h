// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_schur_solver_h
#define fuga_bodies_solvers_schur_solver_h

#include <fuga/bodies/solvers/interior_solver.h>

#include <memory>

namespace fuga
{
  /** What a factorisation will take on all processes together, as the analysis says. */
  struct DirectEstimate
  {
    double megabytes = 0.;
    /** The same, if the factor goes to files. */
    double megabytes_on_disk = 0.;
    double operations        = 0.;
  };

  /**
   * An InteriorSolver by MUMPS' partial factorisation, which returns S. All processes of the run
   * share the factors and have to call alike, each with its part of the matrix; loads and solutions
   * of the first one count for all, and S is the same on all. MPI, which MUMPS wants even of a
   * single one, is initialised at the first use and finalised when the program ends, unless
   * somebody else does it.
   */
  class SchurSolver : public InteriorSolver
  {
  public:
    /** @p ordering, if not empty, is the place of every unknown in the elimination, numbered from 1. */
    explicit SchurSolver(std::vector<int> ordering = {});

    ~SchurSolver() override;

    /** The symbolic part of eliminate(), which is not done again there. */
    DirectEstimate
    analyse(SymmetricTriplets &matrix, const unsigned int n_kept);

    /** To be said before eliminate(): the factor goes to files of the folder for temporary files
     * (TMPDIR), and is read again for every solution. */
    void
    keep_factor_on_disk();

    DenseMatrix
    eliminate(SymmetricTriplets &matrix, const unsigned int n_kept) override;

    DenseMatrix
    condense(DenseMatrix &loads) override;

    void
    solve(DenseMatrix &loads, const Digits digits) override;

    /** All unknowns under the load that condense() had last, one column, if the kept ones are @p
     * kept: the second half of a solution. */
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

    /** MUMPS' solution for all columns of @p loads; @p part: its ICNTL(26). */
    void
    run_solution(const int part, DenseMatrix &loads, const char *what);

    std::unique_ptr<Instance> mumps;
    unsigned int n_kept = 0;
    /** All unknowns are kept: small bodies whose every node is in a joint. */
    bool nothing_to_eliminate = false;
    /** The load that condense() had last, where nothing is kept. */
    DenseMatrix of_all;
    bool is_analysed = false;
    SolverWork its_work;
  };
} // namespace fuga

#endif
