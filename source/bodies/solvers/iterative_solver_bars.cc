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
    /** What the rest of the bodies leaves of the stiffness of a lip that moves alone, at the
     * wavelengths of the mesh; only the number of iterations depends on it. */
    constexpr double share_of_lip = 0.5;
    /** Of a product with S, which equilibrium is judged by and nothing refines. */
    constexpr double tolerance_of_products = 1e-12;

    /** The own rows of K_ii; behind them, on the first process, the kept unknowns. */
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

    /** The kept unknowns of x, on all processes. */
    Vector
    kept_part(const Work &x, const std::size_t n_interior, const std::size_t n_kept)
    {
      Vector result(n_kept);
      if (processes::is_first())
        std::copy(x.begin() + n_interior, x.end(), result.begin());
      processes::broadcast(result.data(), n_kept);
      return result;
    }

    /** [K_ii K_ic; K_ci K_cc + C]. */
    struct BodiesWithBars
    {
      const Epetra_CrsMatrix &K;
      const Compressed &coupling, &kept;
      const std::vector<BlockOfBars> &bars;

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
        for (const BlockOfBars &block : bars)
          for (std::size_t i = 0; i < block.bars.size(); ++i)
            for (std::size_t j = 0; j < block.bars.size(); ++j)
              forces[static_cast<std::size_t>(block.bars[i])] +=
                block.stiffness[i][j] * jumps[static_cast<std::size_t>(block.bars[j])];
        if (processes::is_first())
          std::copy(forces.begin(), forces.end(), y.begin() + n);
      }
    };

    /** First K_ii by one cycle of multigrid, then the bars of every element for themselves. */
    struct BlockPreconditioner
    {
      const Epetra_Map &map;
      /** None if there is nothing to eliminate. */
      const ML_Epetra::MultiLevelPreconditioner *multigrid;
      const Compressed &coupling;
      const std::vector<BlockOfBars> &bars;
      std::vector<ElementStiffness> inverses;

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
        for (std::size_t k = 0; k < bars.size() && processes::is_first(); ++k)
          for (std::size_t i = 0; i < bars[k].bars.size(); ++i)
            {
              double sum = 0.;
              for (std::size_t j = 0; j < bars[k].bars.size(); ++j)
                sum += inverses[k][i][j] * rest[static_cast<std::size_t>(bars[k].bars[j])];
              y.begin()[n + static_cast<std::size_t>(bars[k].bars[i])] = sum;
            }
      }
    };

    /** Inverse of the leading n x n block by Gauss and Jordan; its symmetric part is positive
     * definite but for slip, whose coupling is one-sided: no pivots are needed. */
    ElementStiffness
    inverse(ElementStiffness a, const std::size_t n)
    {
      for (std::size_t k = 0; k < n; ++k)
        {
          const double pivot = 1. / a[k][k];
          a[k][k]            = 1.;
          for (std::size_t j = 0; j < n; ++j)
            a[k][j] *= pivot;
          for (std::size_t i = 0; i < n; ++i)
            if (i != k)
              {
                const double factor = a[i][k];
                a[i][k]             = 0.;
                for (std::size_t j = 0; j < n; ++j)
                  a[i][j] -= factor * a[k][j];
              }
        }
      return a;
    }

    std::vector<ElementStiffness>
    inverses_of_elements(const std::vector<BlockOfBars> &bars, const Compressed &kept)
    {
      constexpr std::size_t n_entries = sizeof(ElementStiffness) / sizeof(double);
      std::vector<std::pair<std::size_t, std::size_t>> place(kept.start.size() - 1);
      std::vector<ElementStiffness> blocks;
      for (std::size_t k = 0; k < bars.size(); ++k)
        {
          blocks.push_back(processes::is_first() ? bars[k].stiffness : ElementStiffness{});
          for (std::size_t i = 0; i < bars[k].bars.size(); ++i)
            place[static_cast<std::size_t>(bars[k].bars[i])] = {k, i};
        }
      for_each_kept_entry(kept, [&](const std::size_t i, const std::size_t j, const double value) {
        if (place[i].first == place[j].first)
          blocks[place[i].first][place[i].second][place[j].second] += share_of_lip * value;
      });
      if (!blocks.empty())
        processes::sum(blocks[0][0].data(), blocks.size() * n_entries);
      for (std::size_t k = 0; k < bars.size(); ++k)
        blocks[k] = inverse(blocks[k], bars[k].bars.size());
      return blocks;
    }
  } // namespace


  Vector
  IterativeSolver::resistance(const Vector &x)
  {
    Vector result(n_kept, 0.);
    add_kept_block(system->kept, x.data(), result.data());
    if (!nothing_to_eliminate() && max_abs(x) > 0.)
      {
        DenseMatrix y(n_own_rows(), 1);
        add_to_interior(system->coupling, -1., x.data(), y.data());
        solve_columns(y, tolerance_of_products);
        ++its_work.n_solutions;
        add_to_kept(system->coupling, 1., y.data(), result.data());
      }
    processes::sum(result);
    return result;
  }


  TangentSolver::Solution
  IterativeSolver::solve_with_bars(const std::vector<BlockOfBars> &bars,
                                   const Vector &r,
                                   const double tolerance)
  {
    const std::size_t n = n_own_rows();
    Work load           = work_vector(blocks, n_kept, system->comm.Comm()), y(load);
    if (processes::is_first())
      std::copy(r.begin(), r.end(), load.begin() + n);

    dealii::SolverControl control(max_bar_iterations, tolerance * load.l2_norm());
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
                                        bars,
                                        inverses_of_elements(bars, system->kept)});
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
    solution.jumps = kept_part(y, n, n_kept);
    solution.resistance.assign(n_kept, 0.);
    add_kept_block(system->kept, solution.jumps.data(), solution.resistance.data());
    add_to_kept(system->coupling, 1., y.begin(), solution.resistance.data());
    processes::sum(solution.resistance);
    return solution;
  }
} // namespace fuga
