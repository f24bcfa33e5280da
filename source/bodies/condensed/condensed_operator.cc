// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/condensed/blocks_of_bars.h>
#include <fuga/bodies/condensed/condensed_operator.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>
#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/iterative_solver.h>
#include <fuga/bodies/solvers/schur_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  template <int dim>
  CondensedOperator<dim>::CondensedOperator(BodyModel<dim> &body_model) : model(body_model)
  {
  }


  template <int dim>
  CondensedOperator<dim>::~CondensedOperator() = default;


  template <int dim>
  void
  CondensedOperator<dim>::find_rigid_motions()
  {
    const auto &coordinates = model.interface_coordinates();
    motions =
      DenseMatrix(model.contact_bars().bars().size(), model.rigid_pieces().n_free_motions());
    for (Eigen::Index k = 0; k < motions.cols(); ++k)
      {
        const Vector jump = model.contact_bars().jumps(model.rigid_pieces().free_motion(k));
        motions.col(k)    = view(jump);
      }
    dual = dual_of(coordinates.jump_operator());
    // Jumps of a motion of the bodies are compatible: B x = jumps has a solution.
    motion_coordinates = DenseMatrix(coordinates.n_interface(), motions.cols());
    for (Eigen::Index k = 0; k < motions.cols(); ++k)
      {
        const Vector x            = multiply_transposed(dual, to_vector(motions.col(k)));
        motion_coordinates.col(k) = view(x);
      }
    projection = std::make_unique<RigidProjection>(motion_coordinates);
    if (!matrix_free_solver)
      projection->project_stiffness(S);
  }


  template <int dim>
  DenseMatrix
  CondensedOperator<dim>::condense(const std::vector<LoadPattern> &patterns,
                                   const DenseMatrix &motion_loads) const
  {
    DenseMatrix loads = loads_out_of_balance(patterns);
    return condense(loads, motion_loads);
  }


  template <int dim>
  DenseMatrix
  CondensedOperator<dim>::condense(DenseMatrix &loads, const DenseMatrix &motion_loads) const
  {
    DenseMatrix condensed = solver->condense(loads);
    projection->project_loads(condensed, motion_loads);
    return condensed;
  }


  // Condensing the imbalance of the bonded structure instead of the load itself keeps rounding
  // errors that would grow with the model out of F.
  template <int dim>
  DenseMatrix
  CondensedOperator<dim>::loads_out_of_balance(const std::vector<LoadPattern> &patterns) const
  {
    const auto &coordinates = model.interface_coordinates();
    DenseMatrix result(coordinates.size(), patterns.size());
    if (coordinates.n_interface() == 0)
      return result; // recover() does everything that remains to be done
    const Vector no_coordinates(coordinates.size(), 0.);
    for (std::size_t first = 0; first < patterns.size(); first += at_once)
      {
        const std::size_t n = std::min(at_once, patterns.size() - first);
        std::vector<Vector> loads, u;
        for (std::size_t j = 0; j < n; ++j)
          {
            const LoadPattern &pattern = patterns[first + j];
            loads.push_back(pattern.forces);
            u.push_back(coordinates.distribute(no_coordinates.data(), pattern.prescribed));
          }
        solve_bonded(loads, u, InteriorSolver::Digits::first);
        for (std::size_t j = 0; j < n; ++j)
          {
            const Vector residual = model.out_of_balance(loads[j], u[j]);
            result.col(first + j) = view(residual);
          }
      }
    return result;
  }


  template <int dim>
  DenseMatrix
  CondensedOperator<dim>::resistance_of_bodies(const DenseMatrix &x) const
  {
    const auto &coordinates = model.interface_coordinates();
    const std::vector<Vector> no_loads(x.cols(), Vector(model.discretization().n_dofs(), 0.));
    std::vector<Vector> u;
    for (Eigen::Index j = 0; j < x.cols(); ++j)
      {
        Vector y(coordinates.size(), 0.);
        std::copy_n(x.col(j).data(), x.rows(), y.data() + y.size() - x.rows());
        u.push_back(coordinates.distribute(y.data(), {}));
      }
    solve_to_rounding(no_loads, u);
    DenseMatrix result(x.rows(), x.cols());
    for (Eigen::Index j = 0; j < x.cols(); ++j)
      {
        const Vector held = model.out_of_balance(no_loads[j], u[j]);
        std::transform(held.end() - static_cast<std::ptrdiff_t>(x.rows()),
                       held.end(),
                       result.col(j).data(),
                       std::negate<>());
      }
    return result;
  }


  template <int dim>
  void
  CondensedOperator<dim>::add_bonded_response(const Vector &loads, Vector &u) const
  {
    const std::vector<Vector> given = {loads};
    std::vector<Vector> field       = {std::move(u)};
    solve_to_rounding(given, field);
    u = std::move(field.front());
  }


  // The second solution is a refinement. Without it the lips of S0 (129 elements, 81 000 unknowns)
  // lack 1.3e-10 of the largest force, though no unknown inside lacks 1e-12; with it, the error is
  // rounding only.
  template <int dim>
  void
  CondensedOperator<dim>::solve_to_rounding(const std::vector<Vector> &loads,
                                            std::vector<Vector> &u) const
  {
    for (const auto digits : {InteriorSolver::Digits::first, InteriorSolver::Digits::last})
      solve_bonded(loads, u, digits);
  }


  template <int dim>
  void
  CondensedOperator<dim>::solve_bonded(const std::vector<Vector> &loads,
                                       std::vector<Vector> &u,
                                       const InteriorSolver::Digits digits) const
  {
    const auto &coordinates = model.interface_coordinates();
    DenseMatrix y(coordinates.size(), u.size());
    for (std::size_t j = 0; j < u.size(); ++j)
      {
        const Vector load = model.out_of_balance(loads[j], u[j]);
        y.col(j)          = view(load);
      }
    solver->solve(y, digits);
    for (std::size_t j = 0; j < u.size(); ++j)
      u[j] = coordinates.distribute(y.col(j).data(), u[j]);
  }


  template <int dim>
  void
  CondensedOperator<dim>::solve_bonded(DenseMatrix &columns) const
  {
    const auto &coordinates = model.interface_coordinates();
    DenseMatrix y(coordinates.size(), columns.cols());
    for (Eigen::Index j = 0; j < columns.cols(); ++j)
      {
        const Vector load = coordinates.gather(to_vector(columns.col(j)));
        y.col(j)          = view(load);
      }
    solver->solve(y, InteriorSolver::Digits::first);
    for (Eigen::Index j = 0; j < columns.cols(); ++j)
      {
        const Vector u = coordinates.distribute(y.col(j).data(), {});
        columns.col(j) = view(u);
      }
  }


  template <int dim>
  Vector
  CondensedOperator<dim>::resistance(const Vector &x) const
  {
    TangentSolver::Solution solution{x, {}, {}};
    refine(solution);
    return solution.resistance;
  }


  // This is not left to the iterations, whose errors the condition number of the eliminated part
  // magnifies: motions of the bodies meet no resistance.
  template <int dim>
  void
  CondensedOperator<dim>::refine(TangentSolver::Solution &solution) const
  {
    Vector jumps        = solution.x;
    const Vector motion = interior_of_motion(jumps);
    projection->take_out_motion(jumps);
    if (!solution.interior.empty() && !motion.empty())
      add_multiple(-1., motion, solution.interior);
    solution.resistance = matrix_free_solver->resistance(jumps, solution.interior);
    if (!motion.empty())
      add_multiple(1., motion, solution.interior);
    projection->take_out_work(solution.resistance);
  }


  template <int dim>
  Vector
  CondensedOperator<dim>::interior_of_motion(const Vector &jumps) const
  {
    const Vector amounts = motion_of(jumps);
    if (amounts.empty())
      return {};
    Vector field(model.discretization().n_dofs(), 0.);
    for (std::size_t k = 0; k < amounts.size(); ++k)
      add_multiple(amounts[k], model.rigid_pieces().free_motion(k), field);
    const auto &coordinates = model.interface_coordinates();
    Vector eliminated(coordinates.first_interface_coordinate(), 0.);
    for (std::size_t dof = 0; dof < field.size(); ++dof)
      if (const auto c = coordinates.coordinate_of(dof); c && *c < eliminated.size())
        eliminated[*c] = field[dof];
    return matrix_free_solver->own_rows(eliminated);
  }


  // The smallest coordinates that move a bar with the row b of B by one are b/|b|².
  template <int dim>
  Vector
  CondensedOperator<dim>::stiffness_of_lips() const
  {
    Vector result(model.contact_bars().bars().size());
    for (std::size_t bar = 0; bar < result.size(); ++bar)
      {
        double work = 0., square = 0.;
        model.interface_coordinates().jump_operator().for_each_in_row(
          bar, [&](const std::size_t c, const double factor) {
            work += factor * factor * lips[c];
            square += factor * factor;
          });
        result[bar] = work / (square * square);
      }
    return result;
  }


  template <int dim>
  Vector
  CondensedOperator<dim>::coordinates_under(Vector f) const
  {
    if (!has_stiffness() || S.size() == 0)
      return {};
    projection->take_out_work(f);
    const LuFactors factors(projection->held(S, largest_diagonal(S)));
    if (!(factors.reciprocal_condition() > std::numeric_limits<double>::epsilon()))
      return {};
    factors.solve(f);
    projection->take_out_motion(f);
    return f;
  }


  template <int dim>
  TangentSolver::Solution
  CondensedOperator<dim>::solve_with_bars(const std::vector<ElementStiffness> &stiffness,
                                          const Vector &r,
                                          const TangentSolver::Solution &so_far,
                                          const double tolerance) const
  {
    TangentSolver::Solution solution = matrix_free_solver->solve_with_bars(
      blocks_of_bars(
        model.elements(), stiffness, model.interface_coordinates().jump_operator(), r.size()),
      r,
      so_far,
      tolerance);
    projection->take_out_work(solution.resistance);
    return solution;
  }


  template <int dim>
  BodiesWork
  CondensedOperator<dim>::work() const
  {
    if (!solver)
      return {};
    const SolverWork &work = solver->work();
    return {work.n_factorisations,
            work.n_condensed_loads,
            work.n_solutions,
            0,
            processes::number(),
            work.n_iterations,
            used_solver,
            estimate};
  }


  template class CondensedOperator<2>;
  template class CondensedOperator<3>;
} // namespace fuga
