// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/base/work_counter.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/schur_solver.h>

#include <algorithm>
#include <cmath>
#include <dmumps_c.h>
#include <filesystem>
#include <numeric>

namespace fuga
{
  namespace
  {
    void
    mirror_lower_triangle(DenseMatrix &S)
    {
      for (Eigen::Index j = 0; j < S.cols(); ++j)
        for (Eigen::Index i = j + 1; i < S.rows(); ++i)
          S(j, i) = S(i, j);
    }
  } // namespace


  struct SchurSolver::Instance
  {
    DMUMPS_STRUC_C data{};
    std::vector<int> kept, ordering;

    /** Return an entry of MUMPS' ICNTL, counted from 1 as in its manual. */
    int &
    control(const int i)
    {
      return data.icntl[i - 1];
    }

    int
    info(const int i) const
    {
      return data.infog[i - 1];
    }

    /** Return the size of the factor; a negative number stands for millions of entries. */
    double
    factor_megabytes() const
    {
      const double entries = info(20) < 0 ? -1e6 * info(20) : info(20);
      return std::ceil(8e-6 * entries);
    }
  };


  SchurSolver::SchurSolver(std::vector<int> ordering) : mumps(std::make_unique<Instance>())
  {
    mumps->ordering          = std::move(ordering);
    mumps->data.comm_fortran = static_cast<MUMPS_INT>(processes::fortran_communicator());
    mumps->data.par          = 1;
    mumps->data.sym          = 1;
    call(-1, "start");
    for (const int stream : {1, 2, 3})
      mumps->control(stream) = -1;
    mumps->control(4)  = 0;
    mumps->control(7)  = 5;
    mumps->control(14) = 30;
    mumps->control(18) = processes::number() > 1 ? 3 : 0;
    mumps->control(27) = 32;
  }


  SchurSolver::~SchurSolver()
  {
    if (processes::have_ended())
      return;
    try
      {
        call(-2, "end");
      }
    catch (const std::exception &)
      {
        // A process that is alone cannot end what it shares with the others.
      }
  }


  void
  SchurSolver::call(const int job, const char *what)
  {
    processes::meet(processes::Place::solver, static_cast<std::size_t>(job + 2));
    mumps->data.job = job;
    dmumps_c(&mumps->data);
    const int error = mumps->info(1);
    if (error == -90)
      throw WriteFailure(fmt::format(
        "The factor of the bodies cannot be written to or read from '{}' ({} MB). Set TMPDIR to a "
        "folder with room, or choose another Solver/Bodies.",
        mumps->data.ooc_tmpdir,
        mumps->factor_megabytes()));
    if (error < 0)
      throw NumericalFailure(
        fmt::format("MUMPS failed in its {} (INFOG(1) = {}, INFOG(2) = {}){}.",
                    what,
                    error,
                    mumps->info(2),
                    error == -13 || error == -7 || error == -19 ? ": out of memory" : ""));
  }


  DirectEstimate
  SchurSolver::analyse(SymmetricTriplets &matrix, const unsigned int kept)
  {
    const work::Scope phase(work::Phase::elimination);
    auto &data           = mumps->data;
    n_kept               = kept;
    nothing_to_eliminate = static_cast<int>(n_kept) == matrix.size;
    if (nothing_to_eliminate) // which MUMPS refuses
      return {};
    data.n   = matrix.size;
    data.nnz = data.nnz_loc = static_cast<MUMPS_INT8>(matrix.values.size());
    data.irn = data.irn_loc = matrix.rows.data();
    data.jcn = data.jcn_loc = matrix.columns.data();
    data.a = data.a_loc = matrix.values.data();
    mumps->kept.resize(n_kept);
    std::iota(mumps->kept.begin(), mumps->kept.end(), matrix.size - static_cast<int>(n_kept) + 1);
    mumps->control(19) = n_kept > 0 ? 3 : 0;
    data.size_schur    = static_cast<int>(n_kept);
    data.listvar_schur = mumps->kept.data();
    data.nprow = data.npcol = 1;
    data.mblock = data.nblock = 100;
    data.schur_lld            = static_cast<int>(n_kept);
    mumps->control(7)         = mumps->ordering.empty() ? 5 : 1;
    data.perm_in              = mumps->ordering.empty() ? nullptr : mumps->ordering.data();

    call(1, "analysis");
    is_analysed = true;
    return {
      static_cast<double>(mumps->info(17)), static_cast<double>(mumps->info(27)), data.rinfog[0]};
  }


  void
  SchurSolver::keep_factor_on_disk()
  {
    std::error_code none;
    const std::string folder = std::filesystem::temp_directory_path(none).string();
    auto &place              = mumps->data.ooc_tmpdir;
    if (none || folder.size() >= sizeof(place))
      throw InputError(fmt::format(
        "Solver/Bodies = direct on disk: the environment variable TMPDIR has to name a folder for "
        "temporary files, in at most {} characters.",
        sizeof(place) - 1));
    std::copy(folder.c_str(), folder.c_str() + folder.size() + 1, place);
    mumps->control(22) = 1;
  }


  DenseMatrix
  SchurSolver::eliminate(SymmetricTriplets &matrix, const unsigned int kept)
  {
    const work::Scope phase(work::Phase::elimination);
    if (!is_analysed)
      analyse(matrix, kept);
    DenseMatrix S(n_kept, n_kept);
    if (nothing_to_eliminate)
      {
        for (std::size_t k = 0; k < matrix.values.size(); ++k)
          {
            const auto [column, row] = std::minmax(matrix.rows[k], matrix.columns[k]);
            S(static_cast<std::size_t>(row - 1), static_cast<std::size_t>(column - 1)) +=
              matrix.values[k];
          }
        processes::sum(S.data(), n_kept * n_kept);
        mirror_lower_triangle(S);
        return S;
      }
    auto &data = mumps->data;
    data.schur = S.data();
    for (unsigned int attempt = 0;; ++attempt)
      try
        {
          call(2, "factorisation");
          break;
        }
      catch (const NumericalFailure &)
        {
          const int error = mumps->info(1);
          const bool too_little =
            error == -8 || error == -9 || error == -14 || error == -15 || error == -20;
          if (!too_little || attempt == 4)
            throw;
          mumps->control(14) = 2 * mumps->control(14) + 50; // estimates were too low: more room
        }
    ++its_work.n_factorisations;
    work::now().sparse_operations += static_cast<std::uint64_t>(data.rinfog[2]);

    data.irn = data.jcn = data.irn_loc = data.jcn_loc = nullptr;
    data.a = data.a_loc = nullptr;
    processes::broadcast(S.data(), n_kept * n_kept);
    for (std::size_t i = 0; i < n_kept; ++i)
      if (!std::isfinite(S(i, i)))
        throw NumericalFailure(
          "The factorisation of the bodies gave no finite stiffness. Check that "
          "no cell is degenerate and that the moduli are of similar size.");
    mirror_lower_triangle(S);
    return S;
  }


  void
  SchurSolver::run_solution(const int part, DenseMatrix &loads, const char *what)
  {
    auto &data         = mumps->data;
    data.nrhs          = static_cast<int>(loads.cols());
    data.lrhs          = data.n;
    data.rhs           = loads.data();
    mumps->control(26) = part;
    call(3, what);
  }


  DenseMatrix
  SchurSolver::condense(DenseMatrix &loads)
  {
    const work::Scope phase(work::Phase::loads);
    const std::size_t n_columns = loads.cols();
    if (nothing_to_eliminate)
      return loads;
    if (n_kept == 0)
      of_all = loads;
    DenseMatrix reduced(n_kept, n_columns);
    if (reduced.size() == 0)
      return reduced;
    mumps->data.lredrhs = static_cast<int>(n_kept);
    mumps->data.redrhs  = reduced.data();
    run_solution(1, loads, "condensation of the loads");
    processes::broadcast(reduced.data(), n_kept * n_columns);
    its_work.n_condensed_loads += n_columns;
    work::now().sparse_columns += n_columns;
    return reduced;
  }


  Vector
  SchurSolver::expand(const Vector &kept)
  {
    if (nothing_to_eliminate)
      return kept;
    const work::Scope phase(work::Phase::loads);
    DenseMatrix solution(static_cast<std::size_t>(mumps->data.n), 1);
    if (n_kept == 0)
      {
        solution = of_all;
        solve(solution, Digits::first);
      }
    else
      {
        Vector reduced      = kept;
        mumps->data.lredrhs = static_cast<int>(n_kept);
        mumps->data.redrhs  = reduced.data();
        run_solution(2, solution, "expansion of the solution");
        processes::broadcast(solution.data(), solution.rows());
        ++its_work.n_solutions;
      }
    return {solution.data(), solution.data() + solution.rows()};
  }


  void
  SchurSolver::solve(DenseMatrix &loads, const Digits)
  {
    if (nothing_to_eliminate)
      {
        loads = DenseMatrix(loads.rows(), loads.cols());
        return;
      }
    run_solution(0, loads, "solution");
    processes::broadcast(loads.data(), loads.rows() * loads.cols());
    its_work.n_solutions += loads.cols();
    work::now().sparse_columns += loads.cols();
  }
} // namespace fuga
