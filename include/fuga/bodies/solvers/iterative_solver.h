// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_iterative_solver_h
#define fuga_bodies_solvers_iterative_solver_h

#include <fuga/bodies/solvers/interior_solver.h>
#include <fuga/bodies/solvers/nodal_blocks.h>
#include <fuga/contact/system/tangent_solver.h>

#include <memory>

namespace fuga
{
  /** Interface coordinates, and the stiffness of the bars that they have in common; need not be
   * symmetric. */
  struct BlockOfCoordinates
  {
    std::vector<int> coordinates;
    DenseMatrix stiffness;
  };

  /**
   * An InteriorSolver by conjugate gradients with algebraic multigrid (Trilinos ML), which knows
   * the rigid motions: for models whose factor does not fit. Its memory grows as the matrix does.
   * S costs one solution per kept unknown, several at a time (doc/theory.md, section 1). The
   * processes of the run share rows and have to call alike, each with its part of the matrix and
   * all of the loads; results are the same on all, bit by bit.
   */
  class IterativeSolver : public InteriorSolver
  {
  public:
    explicit IterativeSolver(NodalBlocks blocks);

    ~IterativeSolver() override;

    DenseMatrix
    eliminate(SymmetricTriplets &matrix, const unsigned int n_kept) override;

    DenseMatrix
    condense(DenseMatrix &loads) override;

    void
    solve(DenseMatrix &loads, const Digits digits) override;

    /** Of values of all eliminated coordinates the own rows. */
    Vector
    own_rows(const Vector &eliminated) const;

    /** Instead of eliminate(): S is not computed. */
    void
    prepare(SymmetricTriplets &matrix, const unsigned int n_kept);

    /** S x. @p interior, the own rows of what x causes inside, is refined; empty if it is not
     * known. */
    Vector
    resistance(const Vector &x, Vector &interior);

    /**
     * Solves (S + C) x = r, C of @p bars, for all unknowns at once: GMRES, for slipping elements are
     * not symmetric, preconditioned by the multigrid of K_ii followed by the single blocks.
     */
    TangentSolver::Solution
    solve_with_bars(const std::vector<BlockOfCoordinates> &bars,
                    const Vector &r,
                    const TangentSolver::Solution &so_far,
                    const double tolerance);

    const SolverWork &
    work() const override
    {
      return its_work;
    }

  private:
    struct System;

    bool
    nothing_to_eliminate() const
    {
      return blocks.n_rows() == 0;
    }
    std::size_t
    n_own_rows() const
    {
      return static_cast<std::size_t>(blocks.n_own_rows());
    }
    void
    split(SymmetricTriplets &matrix);
    void
    make_multigrid();
    /** What the own cells give. */
    DenseMatrix
    kept_block() const;
    /** Of a load of all eliminated coordinates the own rows. */
    void
    take_own(const double *load, double *own) const;
    /** The opposite; zero for all others. */
    void
    give_own(const double *own, double *solution) const;
    /** Own rows of the solutions for @p n columns of @p loads from @p first on. */
    DenseMatrix
    own_solutions(const DenseMatrix &loads,
                  const std::size_t first,
                  const std::size_t n,
                  const double tolerance);
    /** Adds to the columns of @p solutions (own rows x any number) what they lack under those of
     * @p loads, which it overwrites. */
    void
    solve_columns(DenseMatrix &loads, DenseMatrix &solutions, const double tolerance);

    NodalBlocks blocks;
    std::unique_ptr<System> system;
    unsigned int n_kept = 0;
    SolverWork its_work;
  };
} // namespace fuga

#endif
