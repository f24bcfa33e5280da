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
  /** Interface coordinates, and the stiffness of their common bars, which need not be symmetric. */
  struct BlockOfCoordinates
  {
    std::vector<int> coordinates;
    DenseMatrix stiffness;
  };

  /**
   * An InteriorSolver by conjugate gradients with algebraic multigrid (Trilinos ML), which knows
   * the rigid motions: for models whose factor does not fit into memory. Its memory is proportional
   * to the size of the matrix. S costs one solution per kept unknown, several at a time
   * (doc/theory.md, section 1). The processes of the run share rows and have to call the functions
   * alike, each with its part of the matrix and all of the loads; results are identical on all, bit
   * by bit.
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

    /** Return the rows that this process owns of the values of all eliminated coordinates. */
    Vector
    own_rows(const Vector &eliminated) const;

    /** Prepare the solver, instead of eliminate(), without computing S. */
    void
    prepare(SymmetricTriplets &matrix, const unsigned int n_kept);

    /**
     * Return S x. @p interior contains the own rows of the eliminated unknowns under x and is
     * refined; it is empty if they are not known.
     */
    Vector
    resistance(const Vector &x, Vector &interior);

    /**
     * Solve (S + C) x = r, with C of @p bars, for all unknowns at once: by GMRES, since slipping
     * elements are not symmetric, preconditioned by the multigrid of K_ii followed by the single
     * blocks.
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
    /** Return the contribution of the own cells to K_cc. */
    DenseMatrix
    kept_block() const;
    /** Copy the rows that this process owns of a load of all eliminated coordinates. */
    void
    take_own(const double *load, double *own) const;
    /** Copy own rows to a vector of all eliminated coordinates; all others are zero. */
    void
    give_own(const double *own, double *solution) const;
    /**
     * Return the rows that this process owns of the solutions for columns @p first to @p first +
     * @p n - 1 of @p loads.
     */
    DenseMatrix
    own_solutions(const DenseMatrix &loads,
                  const std::size_t first,
                  const std::size_t n,
                  const double tolerance);
    /**
     * Add the missing part under the columns of @p loads, which are overwritten, to the columns of
     * @p solutions (own rows x any number).
     */
    void
    solve_columns(DenseMatrix &loads, DenseMatrix &solutions, const double tolerance);

    NodalBlocks blocks;
    std::unique_ptr<System> system;
    unsigned int n_kept = 0;
    SolverWork its_work;
  };
} // namespace fuga

#endif
