// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/work_counter.h>
#include <fuga/bodies/condensed_system.h>
#include <fuga/bodies/contact_bars.h>
#include <fuga/bodies/elimination_order.h>
#include <fuga/bodies/iterative_solver.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/rigid_projection.h>
#include <fuga/bodies/schur_solver.h>

#include <deal.II/lac/vector.h>

namespace fuga
{
  // The analysis for the direct solver, which costs little, says what a factorisation would take.
  template <int dim>
  void
  CondensedSystem<dim>::choose_solver(SymmetricTriplets &matrix)
  {
    const work::Scope phase(work::Phase::elimination);
    BodySolver choice = model.body_solver;
    if (choice == BodySolver::automatic || is_direct(choice))
      {
        std::vector<int> order;
        if (processes::is_first())
          order = elimination_order(*space, *coordinates);
        timer.finish("ordering");
        auto direct = std::make_unique<SchurSolver>(std::move(order));
        timer.finish("start of MPI and MUMPS");
        const DirectEstimate effort = direct->analyse(matrix, coordinates->n_interface());
        timer.finish("analysis");
        if (choice == BodySolver::automatic)
          {
            double n_entries = static_cast<double>(matrix.values.size());
            processes::sum(&n_entries, 1);
            estimate = estimate_solvers({dim,
                                         static_cast<std::size_t>(n_entries),
                                         coordinates->size(),
                                         coordinates->n_interface(),
                                         effort.megabytes,
                                         effort.megabytes_on_disk,
                                         effort.operations,
                                         model.may_be_matrix_free && jump_operator().empty()});
            // Another process may run on another machine.
            double of_first = static_cast<double>(estimate->choice);
            processes::broadcast(&of_first, 1);
            choice = estimate->choice     = static_cast<BodySolver>(of_first);
            constexpr double worth_a_line = 1.; // seconds
            if (choice != BodySolver::direct || estimate->direct_seconds > worth_a_line)
              lines.push_back(estimate->text());
          }
        if (choice == BodySolver::direct_on_disk)
          direct->keep_factor_on_disk();
        solver = std::move(direct);
      }
    used_solver = choice;
    if (is_direct(choice))
      return;
    auto iterative     = std::make_unique<IterativeSolver>(nodal_blocks(*space, *coordinates));
    matrix_free_solver = choice == BodySolver::matrix_free ? iterative.get() : nullptr;
    solver             = std::move(iterative);
    timer.finish("nodal blocks");
  }

  template <int dim>
  unsigned int
  CondensedSystem<dim>::n_coordinates() const
  {
    return coordinates->n_interface();
  }

  // Not left to the iterations, whose errors the condition of the eliminated part magnifies:
  // motions of the bodies meet no resistance.
  template <int dim>
  Vector
  CondensedSystem<dim>::resistance(const Vector &x) const
  {
    Vector jumps = x;
    projection->take_out_motion(jumps);
    Vector forces = matrix_free_solver->resistance(jumps);
    projection->take_out_work(forces);
    return forces;
  }

  template <int dim>
  TangentSolver::Solution
  CondensedSystem<dim>::solve_with_bars(const std::vector<ElementStiffness> &stiffness,
                                        const Vector &r,
                                        const double tolerance) const
  {
    std::vector<BlockOfBars> blocks;
    for (std::size_t k = 0; k < stiffness.size(); ++k)
      {
        const ContactElement &element = elements()[k];
        BlockOfBars block{{static_cast<int>(element.normal_bar)}, stiffness[k]};
        if (element.has_tangential_bar())
          block.bars.push_back(static_cast<int>(element.tangential_bar));
        if (element.has_second_tangential_bar())
          block.bars.push_back(static_cast<int>(element.second_tangential_bar));
        blocks.push_back(std::move(block));
      }
    Solution solution = matrix_free_solver->solve_with_bars(blocks, r, tolerance);
    projection->take_out_work(solution.resistance);
    return solution;
  }

  template void
  CondensedSystem<2>::choose_solver(SymmetricTriplets &);
  template void
  CondensedSystem<3>::choose_solver(SymmetricTriplets &);
  template unsigned int
  CondensedSystem<2>::n_coordinates() const;
  template unsigned int
  CondensedSystem<3>::n_coordinates() const;
  template Vector
  CondensedSystem<2>::resistance(const Vector &) const;
  template Vector
  CondensedSystem<3>::resistance(const Vector &) const;
  template TangentSolver::Solution
  CondensedSystem<2>::solve_with_bars(const std::vector<ElementStiffness> &,
                                      const Vector &,
                                      const double) const;
  template TangentSolver::Solution
  CondensedSystem<3>::solve_with_bars(const std::vector<ElementStiffness> &,
                                      const Vector &,
                                      const double) const;
} // namespace fuga
