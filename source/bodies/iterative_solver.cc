// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/iterative_system.h>
#include <fuga/bodies/processes.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr int max_iterations          = 2000;
    constexpr std::size_t columns_at_once = 8;
  } // namespace


  IterativeSolver::IterativeSolver(NodalBlocks nodal_blocks) : blocks(std::move(nodal_blocks))
  {
    processes::fortran_communicator(); // starts MPI, which Trilinos wants
  }


  IterativeSolver::~IterativeSolver() = default;


  namespace
  {
    /** A matrix of Trilinos from rows in which indices may repeat; rows without entries get @p
     * diagonal. */
    std::unique_ptr<Epetra_CrsMatrix>
    epetra_matrix(const Epetra_Map &map, const Compressed &rows, const double diagonal)
    {
      const int n_rows = map.NumMyElements();
      std::vector<int> counts(static_cast<std::size_t>(n_rows), 1);
      std::vector<std::pair<int, double>> entries;
      const auto read_row = [&](const std::size_t row) {
        entries.clear();
        for (std::size_t k = rows.start[row]; k < rows.start[row + 1]; ++k)
          entries.emplace_back(rows.indices[k], rows.values[k]);
        std::sort(entries.begin(), entries.end(), [](const auto &a, const auto &b) {
          return a.first < b.first;
        });
        std::size_t last = 0;
        for (std::size_t k = 1; k < entries.size(); ++k)
          if (entries[k].first == entries[last].first)
            entries[last].second += entries[k].second;
          else
            entries[++last] = entries[k];
        if (entries.empty())
          entries.emplace_back(static_cast<int>(row), diagonal);
        else
          entries.resize(last + 1);
      };
      for (std::size_t row = 0; row < counts.size(); ++row)
        {
          read_row(row);
          counts[row] = static_cast<int>(entries.size());
        }
      auto matrix = std::make_unique<Epetra_CrsMatrix>(Copy, map, map, counts.data(), true);
      std::vector<int> indices;
      std::vector<double> values;
      for (std::size_t row = 0; row < counts.size(); ++row)
        {
          read_row(row);
          indices.clear();
          values.clear();
          for (const auto &[index, value] : entries)
            {
              indices.push_back(index);
              values.push_back(value);
            }
          matrix->InsertMyValues(static_cast<int>(row), counts[row], values.data(), indices.data());
        }
      matrix->FillComplete(map, map);
      matrix->OptimizeStorage();
      return matrix;
    }
  } // namespace


  // The triplets are given up before the matrix of Trilinos is made: at no time are there three
  // copies.
  void
  IterativeSolver::split(SymmetricTriplets &matrix)
  {
    const auto n_eliminated = static_cast<int>(blocks.rows.size());
    Compressed interior(blocks.n_rows);
    double sum_of_diagonal = 0.;
    for (const bool counting : {true, false})
      {
        if (!counting)
          {
            interior.finish_counting();
            system->coupling.finish_counting();
            system->kept.finish_counting();
          }
        const auto put =
          [counting](Compressed &to, const int row, const int index, const double value) {
            if (counting)
              to.count(static_cast<std::size_t>(row));
            else
              to.add(static_cast<std::size_t>(row), index, value);
          };
        for (std::size_t k = 0; k < matrix.values.size(); ++k)
          {
            const double value = matrix.values[k];
            const auto [a, b]  = std::minmax({matrix.rows[k] - 1, matrix.columns[k] - 1});
            if (b < n_eliminated)
              {
                const int row    = blocks.rows[static_cast<std::size_t>(a)],
                          column = blocks.rows[static_cast<std::size_t>(b)];
                put(interior, row, column, value);
                if (a != b)
                  put(interior, column, row, value);
                else if (counting)
                  sum_of_diagonal += value;
              }
            else if (a < n_eliminated)
              put(system->coupling,
                  b - n_eliminated,
                  blocks.rows[static_cast<std::size_t>(a)],
                  value);
            else
              put(system->kept, b - n_eliminated, a - n_eliminated, value);
          }
      }
    matrix = {};
    system->K =
      epetra_matrix(system->map, interior, sum_of_diagonal / std::max<double>(1., blocks.n_rows));
  }


  void
  IterativeSolver::make_multigrid()
  {
    Teuchos::ParameterList settings;
    ML_Epetra::SetDefaults("SA", settings);
    settings.set("ML output", 0);
    settings.set("PDE equations", static_cast<int>(blocks.block_size));
    settings.set("null space: type", "pre-computed");
    settings.set("null space: dimension", static_cast<int>(blocks.rigid_motions.n_columns()));
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
    system = std::make_unique<System>(static_cast<int>(blocks.n_rows), static_cast<int>(n_kept));
    split(matrix);
    if (blocks.n_rows > 0)
      make_multigrid();
    ++its_work.n_factorisations;
  }


  DenseMatrix
  IterativeSolver::eliminate(SymmetricTriplets &matrix, const unsigned int kept)
  {
    prepare(matrix, kept);
    DenseMatrix S = kept_block();
    if (blocks.n_rows == 0)
      return S;
    for (std::size_t first = 0; first < n_kept; first += columns_at_once)
      {
        const std::size_t n = std::min(columns_at_once, n_kept - first);
        DenseMatrix X(blocks.n_rows, n);
        for (std::size_t j = 0; j < n; ++j)
          add_column(system->coupling, -1., first + j, X.column(j));
        solve_columns(X, tolerance_of_columns);
        for (std::size_t j = 0; j < n; ++j)
          add_to_kept(system->coupling, 1., X.column(j), S.column(first + j));
      }
    for (std::size_t j = 0; j < n_kept; ++j)
      for (std::size_t i = 0; i < j; ++i)
        S(i, j) = S(j, i) = 0.5 * (S(i, j) + S(j, i));
    return S;
  }


  // Conjugate gradients for some columns side by side: one pass over the matrix serves all of them.
  // (Belos::PseudoBlockCGSolMgr does the same, but took 7 per cent more time.)
  void
  IterativeSolver::solve_columns(DenseMatrix &loads, const double tolerance)
  {
    const auto n_rows = static_cast<int>(blocks.n_rows), n = static_cast<int>(loads.n_columns());
    Epetra_MultiVector R(View, system->map, loads.data(), n_rows, n);
    Epetra_MultiVector X(system->map, n), Z(system->map, n), P(system->map, n), Q(system->map, n);
    Vector goal(loads.n_columns()), norm(goal), rz(goal), product(goal), previous(goal.size(), 0.);
    R.Norm2(goal.data());
    for (double &value : goal)
      value *= tolerance;
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
        previous      = rz;
        largest_count = std::max(largest_count, static_cast<std::size_t>(count) + 1);
      }
    for (int j = 0; j < n; ++j)
      std::copy_n(X[j], n_rows, loads.column(static_cast<std::size_t>(j)));
  }


  DenseMatrix
  IterativeSolver::condense(DenseMatrix &loads)
  {
    const std::size_t n_eliminated = blocks.rows.size(), n = loads.n_columns();
    if (n_kept == 0 || n == 0)
      return {};
    DenseMatrix result(n_kept, n), X(blocks.n_rows, n);
    for (std::size_t j = 0; j < n; ++j)
      {
        for (std::size_t i = 0; i < n_eliminated; ++i)
          X(static_cast<std::size_t>(blocks.rows[i]), j) = loads(i, j);
        for (std::size_t i = 0; i < n_kept; ++i)
          result(i, j) = loads(n_eliminated + i, j);
      }
    if (blocks.n_rows > 0)
      solve_columns(X, tolerance_of_solutions);
    its_work.n_condensed_loads += n;
    for (std::size_t j = 0; j < n; ++j)
      add_to_kept(system->coupling, -1., X.column(j), result.column(j));
    return result;
  }


  void
  IterativeSolver::solve(DenseMatrix &loads)
  {
    for (std::size_t first = 0; first < loads.n_columns(); first += columns_at_once)
      {
        const std::size_t n = std::min(columns_at_once, loads.n_columns() - first);
        DenseMatrix X(blocks.n_rows, n);
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t i = 0; i < blocks.rows.size(); ++i)
            X(static_cast<std::size_t>(blocks.rows[i]), j) = loads(i, first + j);
        if (blocks.n_rows > 0)
          solve_columns(X, tolerance_of_solutions);
        for (std::size_t j = 0; j < n; ++j)
          {
            double *const solution = loads.column(first + j);
            for (std::size_t i = 0; i < blocks.rows.size(); ++i)
              solution[i] = X(static_cast<std::size_t>(blocks.rows[i]), j);
            std::fill_n(solution + blocks.rows.size(), n_kept, 0.);
          }
      }
    its_work.n_solutions += loads.n_columns();
  }
} // namespace fuga
