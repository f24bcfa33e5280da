// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/bodies/solvers/iterative_system.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr int max_iterations          = 2000;
    constexpr std::size_t columns_at_once = 8;

    int
    multiply_for_multigrid(ML_Operator *level, int, double *x, int, double *y)
    {
      // ML keeps the matrix as an untyped pointer; both types are those of system->K.
      const auto *matrix = static_cast<const Epetra_CrsMatrix *>(ML_Get_MyMatvecData(level));
      const auto &K      = static_cast<const NodalMatrix &>(*matrix);
      const Epetra_Vector X(View, K.DomainMap(), x);
      Epetra_Vector Y(View, K.RangeMap(), y);
      K.multiply_roughly(X, Y);
      return 0;
    }
  } // namespace


  IterativeSolver::IterativeSolver(NodalBlocks nodal_blocks) : blocks(std::move(nodal_blocks))
  {
    processes::fortran_communicator(); // starts MPI, which Trilinos requires
  }


  IterativeSolver::~IterativeSolver() = default;


  void
  IterativeSolver::make_multigrid()
  {
    Teuchos::ParameterList settings;
    ML_Epetra::SetDefaults("SA", settings);
    settings.set("ML output", 0);
    settings.set("PDE equations", static_cast<int>(blocks.block_size));
    settings.set("null space: type", "pre-computed");
    settings.set("null space: dimension", static_cast<int>(blocks.rigid_motions.cols()));
    settings.set("null space: vectors", blocks.rigid_motions.data());
    settings.set("aggregation: type", "Uncoupled");
    settings.set("aggregation: threshold", 0.);
    settings.set("smoother: type", "Chebyshev");
    settings.set("smoother: sweeps", 2);
    settings.set("smoother: Chebyshev alpha", 30.);
    settings.set("coarse: type", "Amesos-KLU");
    settings.set("coarse: max size", 2000);
    system->multigrid =
      std::make_unique<ML_Epetra::MultiLevelPreconditioner>(*system->K, settings, true);
    if (!system->multigrid->IsPreconditionerComputed())
      throw NumericalFailure("Algebraic multigrid failed to set up.");
    const ML *hierarchy = system->multigrid->GetML();
    ML_Operator_Set_ApplyFunc(hierarchy->Amat + hierarchy->ML_finest_level, multiply_for_multigrid);
  }


  DenseMatrix
  IterativeSolver::kept_block() const
  {
    DenseMatrix S(n_kept, n_kept);
    for_each_kept_entry(
      system->kept,
      [&](const std::size_t i, const std::size_t j, const double value) { S(i, j) += value; });
    return S;
  }


  void
  IterativeSolver::prepare(SymmetricTriplets &matrix, const unsigned int kept)
  {
    n_kept = kept;
    system = std::make_unique<System>(blocks, n_kept);
    split(matrix);
    if (!nothing_to_eliminate())
      make_multigrid();
    ++its_work.n_factorisations;
  }


  DenseMatrix
  IterativeSolver::eliminate(SymmetricTriplets &matrix, const unsigned int kept)
  {
    prepare(matrix, kept);
    DenseMatrix S = kept_block();
    for (std::size_t first = 0; first < n_kept && !nothing_to_eliminate(); first += columns_at_once)
      {
        const std::size_t n = std::min(columns_at_once, n_kept - first);
        DenseMatrix X(n_own_rows(), n);
        for (std::size_t j = 0; j < n; ++j)
          add_column(system->coupling, -1., first + j, X.col(j).data());
        DenseMatrix Y(n_own_rows(), n);
        solve_columns(X, Y, tolerance_of_columns);
        for (std::size_t j = 0; j < n; ++j)
          add_to_kept(system->coupling, 1., Y.col(j).data(), S.col(first + j).data());
      }
    processes::sum(S.data(), n_kept * n_kept);
    for (std::size_t j = 0; j < n_kept; ++j)
      for (std::size_t i = 0; i < j; ++i)
        S(i, j) = S(j, i) = 0.5 * (S(i, j) + S(j, i));
    return S;
  }


  // Conjugate gradients are applied to several columns side by side: one pass over the matrix
  // serves all of them. (Belos::PseudoBlockCGSolMgr does the same, but took 4 to 7 per cent more
  // time.) A norm is the same on all processes: MPI_Allreduce adds the parts of two in either
  // order, and the sum of two commutes.
  void
  IterativeSolver::solve_columns(DenseMatrix &loads, DenseMatrix &solutions, const double tolerance)
  {
    interruption::check("while the bodies were solved");
    processes::meet(processes::Place::solver, loads.cols());
    const int n_rows = blocks.n_own_rows(), n = static_cast<int>(loads.cols());
    Epetra_MultiVector R(View, system->map, loads.data(), n_rows, n);
    Epetra_MultiVector X(View, system->map, solutions.data(), n_rows, n);
    Epetra_MultiVector Z(system->map, n), P(system->map, n), Q(system->map, n);
    Vector goal(loads.cols()), norm(goal), rz(goal), product(goal), previous(goal.size(), 0.);
    R.Norm2(goal.data());
    for (double &value : goal)
      value *= tolerance;
    X.NormInf(norm.data());
    if (max_abs(norm) > 0.)
      {
        system->K->Apply(X, Q);
        R.Update(-1., Q, 1.);
      }
    for (int count = 0;; ++count)
      {
        R.Norm2(norm.data());
        std::vector<bool> is_running(norm.size());
        for (std::size_t j = 0; j < norm.size(); ++j)
          is_running[j] = norm[j] > goal[j];
        if (std::find(is_running.begin(), is_running.end(), true) == is_running.end())
          break;
        if (count == max_iterations)
          throw NumericalFailure(
            fmt::format("The iterative solution of the bodies has not converged in {} iterations. "
                        "Check that no cell is degenerate and that Poisson ratios are well below "
                        "0.5, or set Solver/Bodies = direct.",
                        max_iterations));
        system->multigrid->ApplyInverse(R, Z);
        R.Dot(Z, rz.data());
        for (std::size_t j = 0; j < norm.size(); ++j)
          P(static_cast<int>(j))
            ->Update(1., *Z(static_cast<int>(j)), previous[j] > 0. ? rz[j] / previous[j] : 0.);
        system->K->Apply(P, Q);
        P.Dot(Q, product.data());
        for (std::size_t j = 0; j < norm.size(); ++j)
          if (is_running[j])
            {
              const int column   = static_cast<int>(j);
              const double alpha = rz[j] / product[j];
              X(column)->Update(alpha, *P(column), 1.);
              R(column)->Update(-alpha, *Q(column), 1.);
              ++its_work.n_iterations;
            }
        previous = rz;
      }
  }


  void
  IterativeSolver::take_own(const double *load, double *own) const
  {
    for (std::size_t i = 0; i < blocks.rows.size(); ++i)
      if (const auto place = static_cast<std::size_t>(blocks.own_place(blocks.rows[i]));
          place < n_own_rows())
        own[place] = load[i];
  }


  Vector
  IterativeSolver::own_rows(const Vector &eliminated) const
  {
    Vector own(n_own_rows(), 0.);
    take_own(eliminated.data(), own.data());
    return own;
  }


  void
  IterativeSolver::give_own(const double *own, double *solution) const
  {
    std::fill_n(solution, blocks.rows.size() + n_kept, 0.);
    for (std::size_t i = 0; i < blocks.rows.size(); ++i)
      if (const auto place = static_cast<std::size_t>(blocks.own_place(blocks.rows[i]));
          place < n_own_rows())
        solution[i] = own[place];
  }


  DenseMatrix
  IterativeSolver::own_solutions(const DenseMatrix &loads,
                                 const std::size_t first,
                                 const std::size_t n,
                                 const double tolerance)
  {
    DenseMatrix own(n_own_rows(), n), X(n_own_rows(), n);
    for (std::size_t j = 0; j < n; ++j)
      take_own(loads.col(first + j).data(), own.col(j).data());
    if (!nothing_to_eliminate())
      solve_columns(own, X, tolerance);
    return X;
  }


  DenseMatrix
  IterativeSolver::condense(DenseMatrix &loads)
  {
    const std::size_t n_eliminated = blocks.rows.size(), n_columns = loads.cols();
    DenseMatrix result(n_kept, n_columns);
    if (result.size() == 0)
      return result;
    for (std::size_t first = 0; first < n_columns; first += columns_at_once)
      {
        const std::size_t n = std::min(columns_at_once, n_columns - first);
        const DenseMatrix X = own_solutions(loads, first, n, tolerance_of_remainders);
        for (std::size_t j = 0; j < n; ++j)
          {
            if (processes::is_first())
              std::copy_n(
                loads.col(first + j).data() + n_eliminated, n_kept, result.col(first + j).data());
            add_to_kept(system->coupling, -1., X.col(j).data(), result.col(first + j).data());
          }
      }
    its_work.n_condensed_loads += n_columns;
    processes::sum(result.data(), n_kept * n_columns);
    return result;
  }


  void
  IterativeSolver::solve(DenseMatrix &loads, const Digits digits)
  {
    const std::size_t n_columns = loads.cols();
    for (std::size_t first = 0; first < n_columns; first += columns_at_once)
      {
        const std::size_t n = std::min(columns_at_once, n_columns - first);
        const DenseMatrix X =
          own_solutions(loads,
                        first,
                        n,
                        digits == Digits::first ? tolerance_of_solutions : tolerance_of_remainders);
        for (std::size_t j = 0; j < n; ++j)
          give_own(X.col(j).data(), loads.col(first + j).data());
      }
    processes::sum(loads.data(), loads.rows() * loads.cols());
    its_work.n_solutions += loads.cols();
  }
} // namespace fuga
