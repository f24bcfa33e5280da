// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <Epetra_Vector.h>
#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/solvers/iterative_system.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    constexpr unsigned int max_bar_iterations = 3000, basis_size = 200;
    /** Share of the stiffness of a lip that moves alone which the rest of the bodies leaves, at the
     * wavelengths of the mesh; it affects only the number of iterations. */
    constexpr double share_of_lip = 0.5;
    /** Tolerance of a product with S, by which equilibrium is judged and which nothing refines. */
    constexpr double tolerance_of_products = 1e-12;

    /** The rows of K_ii that this process owns, followed on the first process by the kept
     * unknowns. */
    using Work = dealii::LinearAlgebra::distributed::Vector<double>;

    Work
    work_vector(const NodalBlocks &blocks, const unsigned int n_kept, const MPI_Comm comm)
    {
      const auto place = [&](const unsigned int process) {
        return static_cast<unsigned int>(blocks.first_rows[process]) + (process > 0 ? n_kept : 0);
      };
      dealii::IndexSet own(static_cast<unsigned int>(blocks.n_rows()) + n_kept);
      own.add_range(place(processes::rank()), place(processes::rank() + 1));
      return Work(own, comm);
    }

    Epetra_Vector
    interior_part(const Epetra_Map &map, const Work &x)
    {
      return {View, map, const_cast<double *>(x.begin())};
    }

    /** Return the kept unknowns of x, on all processes. */
    Vector
    kept_part(const Work &x, const std::size_t n_interior, const std::size_t n_kept)
    {
      Vector result(n_kept);
      if (processes::is_first())
        std::copy(x.begin() + n_interior, x.end(), result.begin());
      processes::broadcast(result.data(), n_kept);
      return result;
    }

    /** Compute y_c += C x_c. */
    void
    add_blocks(const std::vector<BlockOfCoordinates> &C, const double *x, double *y)
    {
      for (const BlockOfCoordinates &block : C)
        for (std::size_t j = 0; j < block.coordinates.size(); ++j)
          for (std::size_t i = 0; i < block.coordinates.size(); ++i)
            y[block.coordinates[i]] += block.stiffness(i, j) * x[block.coordinates[j]];
    }

    /** The matrix [K_ii K_ic; K_ci K_cc + C]. */
    struct BodiesWithBars
    {
      const Epetra_CrsMatrix &K;
      const Compressed &coupling, &kept;
      const std::vector<BlockOfCoordinates> &bars;

      void
      vmult(Work &y, const Work &x) const
      {
        const auto n          = static_cast<std::size_t>(K.NumMyRows());
        const Epetra_Vector u = interior_part(K.RowMap(), x);
        Epetra_Vector f       = interior_part(K.RowMap(), y);
        K.Apply(u, f);
        const Vector jumps = kept_part(x, n, kept.start.size() - 1);
        add_to_interior(coupling, 1., jumps.data(), y.begin());
        Vector forces(jumps.size(), 0.);
        add_to_kept(coupling, 1., x.begin(), forces.data());
        add_kept_block(kept, jumps.data(), forces.data());
        processes::sum(forces);
        add_blocks(bars, jumps.data(), forces.data());
        if (processes::is_first())
          std::copy(forces.begin(), forces.end(), y.begin() + n);
      }
    };

    /** Applies first one cycle of multigrid to K_ii, then the inverse of every block of
     * coordinates. */
    struct BlockPreconditioner
    {
      const Epetra_Map &map;
      /** A nullptr if there is nothing to eliminate. */
      const ML_Epetra::MultiLevelPreconditioner *multigrid;
      const Compressed &coupling;
      const std::vector<BlockOfCoordinates> inverses;

      void
      vmult(Work &y, const Work &x) const
      {
        const auto n          = static_cast<std::size_t>(map.NumMyElements());
        const Epetra_Vector f = interior_part(map, x);
        Epetra_Vector u       = interior_part(map, y);
        if (multigrid != nullptr)
          multigrid->ApplyInverse(f, u);
        Vector rest(coupling.start.size() - 1, 0.);
        if (processes::is_first())
          std::copy(x.begin() + n, x.end(), rest.begin());
        add_to_kept(coupling, -1., y.begin(), rest.data());
        processes::sum(rest);
        if (!processes::is_first())
          return;
        std::fill(y.begin() + n, y.end(), 0.);
        add_blocks(inverses, rest.data(), y.begin() + n);
      }
    };

    /** Return the inverses of the blocks of the bars, including the share of the stiffness of their
     * lips that the rest of the bodies leaves. */
    std::vector<BlockOfCoordinates>
    inverses_of_blocks(std::vector<BlockOfCoordinates> blocks, const Compressed &kept)
    {
      const std::size_t n = kept.start.size() - 1;
      std::vector<std::pair<std::size_t, std::size_t>> place(n);
      for (std::size_t k = 0; k < blocks.size(); ++k)
        for (std::size_t i = 0; i < blocks[k].coordinates.size(); ++i)
          place[static_cast<std::size_t>(blocks[k].coordinates[i])] = {k, i};
      // Entry (i, j) of a block is stored under its coordinate i, at place j.
      std::vector<std::size_t> start = {0};
      for (std::size_t i = 0; i < n; ++i)
        start.push_back(start.back() + blocks[place[i].first].coordinates.size());
      Vector lips(start.back(), 0.);
      for_each_kept_entry(kept, [&](const std::size_t i, const std::size_t j, const double value) {
        if (place[i].first == place[j].first)
          lips[start[i] + place[j].second] += share_of_lip * value;
      });
      processes::sum(lips);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < start[i + 1] - start[i]; ++j)
          blocks[place[i].first].stiffness(place[i].second, j) += lips[start[i] + j];
      for (BlockOfCoordinates &block : blocks)
        block.stiffness = LuFactors(std::move(block.stiffness)).release_inverse();
      return blocks;
    }
  } // namespace


  Vector
  IterativeSolver::resistance(const Vector &x, Vector &interior)
  {
    DenseMatrix y(n_own_rows(), 1);
    std::copy(interior.begin(), interior.end(), y.data());
    Vector result(n_kept, 0.);
    add_kept_block(system->kept, x.data(), result.data());
    if (!nothing_to_eliminate() && max_abs(x) > 0.)
      {
        DenseMatrix load(n_own_rows(), 1);
        add_to_interior(system->coupling, -1., x.data(), load.data());
        solve_columns(load, y, tolerance_of_products);
        ++its_work.n_solutions;
        add_to_kept(system->coupling, 1., y.data(), result.data());
      }
    processes::sum(result);
    interior.assign(y.data(), y.data() + n_own_rows());
    return result;
  }


  TangentSolver::Solution
  IterativeSolver::solve_with_bars(const std::vector<BlockOfCoordinates> &bars,
                                   const Vector &r,
                                   const TangentSolver::Solution &so_far,
                                   const double tolerance)
  {
    const std::size_t n = n_own_rows();
    Work load           = work_vector(blocks, n_kept, system->comm.Comm()), y(load);
    if (processes::is_first())
      std::copy(r.begin(), r.end(), load.begin() + n);
    const double goal = tolerance * load.l2_norm();
    if (!so_far.interior.empty())
      {
        const Epetra_Vector u(View, system->map, const_cast<double *>(so_far.interior.data()));
        Epetra_Vector left = interior_part(system->map, load);
        system->K->Apply(u, left);
        add_to_interior(system->coupling, 1., so_far.x.data(), load.begin());
        std::transform(load.begin(), load.begin() + n, load.begin(), std::negate<>());
      }

    dealii::SolverControl control(max_bar_iterations, goal);
    dealii::SolverGMRES<Work> gmres(
      control,
      dealii::SolverGMRES<Work>::AdditionalData(basis_size, /*right_preconditioning=*/true));
    try
      {
        gmres.solve(BodiesWithBars{*system->K, system->coupling, system->kept, bars},
                    y,
                    load,
                    BlockPreconditioner{system->K->RowMap(),
                                        system->multigrid.get(),
                                        system->coupling,
                                        inverses_of_blocks(bars, system->kept)});
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        throw NumericalFailure(fmt::format(
          "The bodies with their bars were not solved in {} iterations of GMRES: nothing "
          "may hold them any more, or a layer is much stiffer than the bodies.",
          max_bar_iterations));
      }
    its_work.n_iterations += control.last_step();
    ++its_work.n_solutions;

    TangentSolver::Solution solution;
    solution.x = kept_part(y, n, n_kept);
    solution.resistance.assign(n_kept, 0.);
    add_kept_block(system->kept, solution.x.data(), solution.resistance.data());
    add_to_kept(system->coupling, 1., y.begin(), solution.resistance.data());
    processes::sum(solution.resistance);
    solution.interior.assign(y.begin(), y.begin() + n);
    return solution;
  }
} // namespace fuga
