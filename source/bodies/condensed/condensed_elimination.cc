// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fuga/base/work_counter.h>
#include <fuga/bodies/condensed/condensed_operator.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/elimination_order.h>
#include <fuga/bodies/solvers/iterative_solver.h>
#include <fuga/bodies/solvers/schur_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

// The elimination of the inner unknowns of the bodies.
namespace fuga
{
  namespace
  {
    /** Return the diagonal of K, i.e. the stiffness of each coordinate if nothing else moves
     * [MN/m]. */
    Vector
    diagonal_of(const SymmetricTriplets &matrix)
    {
      Vector result(static_cast<std::size_t>(matrix.size), 0.);
      for (std::size_t k = 0; k < matrix.values.size(); ++k)
        if (matrix.rows[k] == matrix.columns[k])
          result[static_cast<std::size_t>(matrix.rows[k] - 1)] += matrix.values[k];
      processes::sum(result);
      return result;
    }

    /** Return whether S may lack digits. The ratio of entries of the diagonal is a lower bound of
     * the condition number of K. Among random scenes with a smaller ratio than this, none lacks
     * 1e-11 of S. */
    bool
    may_lack_digits(const Vector &diagonal)
    {
      constexpr double harmless   = 1e5;
      const auto [least, largest] = std::minmax_element(diagonal.begin(), diagonal.end());
      return !diagonal.empty() && *largest > harmless * *least;
    }
  } // namespace


  template <int dim>
  void
  CondensedOperator<dim>::factorise()
  {
    eliminate();
    find_rigid_motions();
    if (!matrix_free_solver)
      remove_rounding();
    model.phases().finish("rigid motions");
  }


  template <int dim>
  void
  CondensedOperator<dim>::eliminate()
  {
    const auto &coordinates  = model.interface_coordinates();
    SymmetricTriplets matrix = model.elastic_bodies().assemble(coordinates);
    report_sizes(matrix);
    model.phases().finish("assembly");
    const Vector diagonal = diagonal_of(matrix);
    lips.assign(diagonal.end() - coordinates.n_interface(), diagonal.end());
    choose_solver(matrix);
    if (matrix_free_solver)
      matrix_free_solver->prepare(matrix, coordinates.n_interface());
    else
      S = solver->eliminate(matrix, coordinates.n_interface());
    model.phases().finish("factorisation");
    if (is_direct(used_solver) && may_lack_digits(diagonal))
      check_stiffness();
  }


  template <int dim>
  void
  CondensedOperator<dim>::report_sizes(const SymmetricTriplets &matrix)
  {
    const auto &coordinates = model.interface_coordinates();
    model.add_to_report(
      fmt::format("{} unknowns, {} of them interface coordinates; {} matrix entries",
                  coordinates.size(),
                  coordinates.n_interface(),
                  fmt::join(processes::from_all(matrix.values.size()), " + ")));
    if (processes::number() > 1)
      model.add_to_report(
        fmt::format("{} processes: {} cells, divided by {}",
                    processes::number(),
                    fmt::join(processes::from_all(model.discretization().n_own_cells()), " + "),
                    model.discretization().is_divided_by_p4est()
                      ? "p4est"
                      : "METIS; every process keeps the whole mesh"));
  }


  // The analysis for the direct solver is cheap and tells how much a factorisation would cost.
  template <int dim>
  void
  CondensedOperator<dim>::choose_solver(SymmetricTriplets &matrix)
  {
    const auto &coordinates = model.interface_coordinates();
    const work::Scope phase(work::Phase::elimination);
    BodySolver choice = model.definition().body_solver;
    if (choice == BodySolver::automatic || is_direct(choice))
      {
        std::vector<int> order;
        if (processes::is_first())
          order = elimination_order(model.discretization(), coordinates);
        model.phases().finish("ordering");
        auto direct = std::make_unique<SchurSolver>(std::move(order));
        model.phases().finish("start of MPI and MUMPS");
        const DirectEstimate effort = direct->analyse(matrix, coordinates.n_interface());
        model.phases().finish("analysis");
        if (choice == BodySolver::automatic)
          {
            double n_entries = static_cast<double>(matrix.values.size());
            processes::sum(&n_entries, 1);
            estimate = estimate_solvers({dim,
                                         static_cast<std::size_t>(n_entries),
                                         coordinates.size(),
                                         coordinates.n_interface(),
                                         effort.megabytes,
                                         effort.megabytes_on_disk,
                                         effort.operations,
                                         model.definition().may_be_matrix_free});
            // Another process may run on another machine.
            double of_first = static_cast<double>(estimate->choice);
            processes::broadcast(&of_first, 1);
            choice = estimate->choice     = static_cast<BodySolver>(of_first);
            constexpr double worth_a_line = 1.; // seconds
            if (choice != BodySolver::direct || estimate->direct_seconds > worth_a_line)
              model.add_to_report(estimate->text());
          }
        if (choice == BodySolver::direct_on_disk)
          direct->keep_factor_on_disk();
        solver = std::move(direct);
      }
    used_solver = choice;
    if (is_direct(choice))
      return;
    auto iterative =
      std::make_unique<IterativeSolver>(nodal_blocks(model.discretization(), coordinates));
    matrix_free_solver = choice == BodySolver::matrix_free ? iterative.get() : nullptr;
    solver             = std::move(iterative);
    model.phases().finish("nodal blocks");
  }


  // The order of elimination minimises fill and does not consider pivots: where stiff bodies meet
  // soft ones, or cells are long and almost incompressible, S may lose half of its digits.
  // Displacements are refined, and one randomly drawn set of jumps shows the loss. The
  // displacements have rounding errors of their own where cells are small compared with the bodies;
  // these errors appear as the part of the resulting forces that is not symmetric.
  template <int dim>
  void
  CondensedOperator<dim>::check_stiffness()
  {
    constexpr double wanted = 1e-10, least_pivot = 1e-8, is_better = 0.1;
    if (lips.empty())
      return;
    Vector units;
    DenseMatrix x(lips.size(), 1);
    std::minstd_rand draws;
    for (std::size_t i = 0; i < lips.size(); ++i)
      {
        units.push_back(std::sqrt(std::max(S(i, i), least_pivot * lips[i])));
        x(i, 0) = (draws() % 2 == 0 ? 1. : -1.) / units.back();
      }
    const DenseMatrix right = resistance_of_bodies(x);
    const Vector taken      = multiply(S, to_vector(x.col(0)));
    double error            = 0.;
    for (std::size_t i = 0; i < lips.size(); ++i)
      error = std::max(error, std::abs(taken[i] - right(i, 0)) / units[i]);
    error /= std::sqrt(static_cast<double>(lips.size()));
    model.phases().finish("check of the stiffness");
    if (error <= wanted)
      return;
    DenseMatrix by_displacements = stiffness_by_displacements();
    double asymmetry             = 0.;
    for (std::size_t j = 0; j < lips.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        {
          double &upper = by_displacements(i, j), &lower = by_displacements(j, i);
          asymmetry = std::max(asymmetry, std::abs(upper - lower) / (units[i] * units[j]));
          upper = lower = 0.5 * (upper + lower);
        }
    model.phases().finish("stiffness by displacements");
    if (asymmetry > is_better * error)
      return;
    model.add_to_report(
      fmt::format("elimination lacks {:.1e} of the stiffness of the lips, which is taken from the "
                  "displacements of {} unit jumps instead",
                  error,
                  lips.size()));
    S = std::move(by_displacements);
  }


  template <int dim>
  DenseMatrix
  CondensedOperator<dim>::stiffness_by_displacements() const
  {
    const std::size_t n = lips.size();
    DenseMatrix result(n, n);
    for (std::size_t first = 0; first < n; first += at_once)
      {
        DenseMatrix x(n, std::min(at_once, n - first));
        for (Eigen::Index j = 0; j < x.cols(); ++j)
          x(first + j, j) = 1.;
        const DenseMatrix forces = resistance_of_bodies(x);
        std::copy_n(forces.data(), n * x.cols(), result.col(first).data());
      }
    return result;
  }


  // A jump that the bodies follow without deformation meets no resistance. What elimination leaves
  // of the stiffness of its lip is rounding, which no later step could distinguish from a soft
  // body.
  template <int dim>
  void
  CondensedOperator<dim>::remove_rounding()
  {
    const double rounding = 64. * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < lips.size(); ++i)
      if (std::abs(S(i, i)) <= rounding * lips[i])
        for (std::size_t j = 0; j < lips.size(); ++j)
          S(i, j) = S(j, i) = 0.;
  }


  template void
  CondensedOperator<2>::factorise();
  template void
  CondensedOperator<3>::factorise();
} // namespace fuga
