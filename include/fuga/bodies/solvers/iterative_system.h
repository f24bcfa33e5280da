// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_iterative_system_h
#define fuga_bodies_solvers_iterative_system_h

#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/iterative_solver.h>
#include <fuga/bodies/solvers/nodal_matrix.h>
#include <ml_MultiLevelPreconditioner.h>

#include <mpi.h>

namespace fuga
{
  /**
   * Relative residuals of the solutions from which S is computed, of other solutions, and of the
   * solutions for the remainders of these, which together give all digits.
   */
  constexpr double tolerance_of_columns = 1e-11, tolerance_of_solutions = 1e-9,
                   tolerance_of_remainders = 1e-6;

  /** Compressed rows (or columns) of a sparse matrix. */
  struct Compressed
  {
    std::vector<std::size_t> start;
    std::vector<int> indices;
    std::vector<double> values;

    explicit Compressed(const std::size_t n_rows) : start(n_rows + 1, 0)
    {
    }

    void
    count(const std::size_t row)
    {
      ++start[row + 1];
    }

    void
    finish_counting()
    {
      for (std::size_t row = 1; row < start.size(); ++row)
        start[row] += start[row - 1];
      indices.resize(start.back());
      values.resize(start.back());
      next.assign(start.begin(), start.end() - 1);
    }

    void
    add(const std::size_t row, const int index, const double value)
    {
      indices[next[row]]  = index;
      values[next[row]++] = value;
    }

  private:
    std::vector<std::size_t> next;
  };

  /** Add @p factor times column @p i of K_ic, given by @p coupling, to y_i. */
  void
  add_column(const Compressed &coupling, const double factor, const std::size_t i, double *y);

  /** Compute y_i += factor K_ic x_c. */
  void
  add_to_interior(const Compressed &coupling, const double factor, const double *x, double *y);

  /** Compute y_c += factor K_ci x_i. */
  void
  add_to_kept(const Compressed &coupling, const double factor, const double *x, double *y);

  /** Call @p action(i, j, value) for the entries of both triangles of K_cc. */
  template <typename Action>
  void
  for_each_kept_entry(const Compressed &kept, const Action &action)
  {
    for (std::size_t i = 0; i + 1 < kept.start.size(); ++i)
      for (std::size_t k = kept.start[i]; k < kept.start[i + 1]; ++k)
        {
          const auto j = static_cast<std::size_t>(kept.indices[k]);
          action(i, j, kept.values[k]);
          if (i != j)
            action(j, i, kept.values[k]);
        }
  }

  /** Compute y_c += K_cc x_c. */
  void
  add_kept_block(const Compressed &kept, const double *x, double *y);

  /** The matrices of an IterativeSolver, separated to keep Trilinos out of its header. */
  struct IterativeSolver::System
  {
    System(const NodalBlocks &blocks, const std::size_t n_kept)
      : comm(MPI_Comm_f2c(static_cast<MPI_Fint>(processes::fortran_communicator())))
      , map(blocks.n_rows(), blocks.n_own_rows(), 0, comm)
      , coupling(n_kept)
      , kept(n_kept)
    {
    }

    Epetra_MpiComm comm;
    Epetra_Map map;
    std::unique_ptr<NodalMatrix> K;
    /**
     * Own rows of K_ic by columns; contributions of the own cells to K_cc, by rows of one triangle.
     */
    Compressed coupling, kept;
    std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> multigrid;
  };
} // namespace fuga

#endif
