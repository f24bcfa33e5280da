// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/condensed/condensed_operator.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>
#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/processes.h>
#include <fuga/bodies/solvers/interior_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

// What rounding does to the stiffness of the jumps.
namespace fuga
{
  // Diagonal of K in the interface coordinates: the stiffness of one lip if nothing else moves.
  template <int dim>
  Vector
  CondensedOperator<dim>::lip_stiffness(const SymmetricTriplets &matrix) const
  {
    const auto &coordinates  = model.interface_coordinates();
    const unsigned int first = coordinates.first_interface_coordinate();
    Vector result(coordinates.n_interface(), 0.);
    for (std::size_t k = 0; k < matrix.values.size(); ++k)
      if (matrix.rows[k] == matrix.columns[k] && matrix.rows[k] > static_cast<int>(first))
        result[static_cast<std::size_t>(matrix.rows[k] - 1) - first] += matrix.values[k];
    processes::sum(result);
    return result;
  }


  // Elimination rounds by a share of the stiffness of cells, times the square of their
  // displacements. Where bodies turn by far more than they deform under a unit jump, or are far
  // softer than others, this is more than what resists the jumps. The displacements U of the unit
  // jumps are known well enough: what is out of balance under them is condensed as well, which
  // gives Uᵀ K U, and errors of U count in it by their squares only.
  template <int dim>
  DenseMatrix
  CondensedOperator<dim>::stiffness_of_unit_jumps() const
  {
    const auto &coordinates = model.interface_coordinates();
    const Vector no_forces(model.discretization().n_dofs(), 0.);
    std::vector<LoadPattern> unit_jumps(coordinates.n_interface());
    for (std::size_t j = 0; j < unit_jumps.size(); ++j)
      {
        Vector y(coordinates.size(), 0.);
        y[coordinates.first_interface_coordinate() + j] = 1.;
        unit_jumps[j].prescribed                        = coordinates.distribute(y.data(), {});
        unit_jumps[j].forces                            = no_forces;
      }
    DenseMatrix out_of_balance = loads_out_of_balance(unit_jumps);
    const DenseMatrix forces   = solver->condense(out_of_balance);
    DenseMatrix stiffness(forces.n_rows(), forces.n_columns());
    for (std::size_t j = 0; j < forces.n_columns(); ++j)
      for (std::size_t i = 0; i < forces.n_rows(); ++i)
        stiffness(i, j) = -0.5 * (forces(i, j) + forces(j, i));
    return stiffness;
  }


  // A jump that the bodies follow without deformation meets no resistance; what elimination leaves
  // of the stiffness of its lip is rounding, and no later step could tell it from a soft body.
  template <int dim>
  void
  CondensedOperator<dim>::remove_rounding(const Vector &lips)
  {
    constexpr double without_consequence = 1e-12; // a thousandth of what a certificate may have
    if (is_direct(used_solver) && projection->rounding(S) > without_consequence)
      S = stiffness_of_unit_jumps();
    projection->project_stiffness(S);
    const double rounding = 64. * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < lips.size(); ++i)
      if (std::abs(S(i, i)) <= rounding * lips[i])
        for (std::size_t j = 0; j < lips.size(); ++j)
          S(i, j) = S(j, i) = 0.;
  }


  template <int dim>
  void
  CondensedOperator<dim>::find_rigid_motions()
  {
    const auto &coordinates = model.interface_coordinates();
    motions =
      DenseMatrix(model.contact_bars().bars().size(), model.rigid_pieces().n_free_motions());
    for (std::size_t k = 0; k < motions.n_columns(); ++k)
      {
        const Vector jump = model.contact_bars().jumps(model.rigid_pieces().free_motion(k));
        std::copy(jump.begin(), jump.end(), motions.column(k));
      }
    motion_coordinates = motions;
    if (const DenseMatrix &B = coordinates.jump_operator(); !B.empty() && motions.n_columns() > 0)
      {
        // Jumps of a motion of the bodies are compatible: B x = jumps has a solution.
        DenseMatrix gram   = multiply_transposed(B, B);
        motion_coordinates = multiply_transposed(B, motions);
        if (!solve_positive_definite(gram, motion_coordinates))
          throw NumericalFailure(
            "The jumps of the joints do not determine the motion of the bodies.");
      }
    projection = std::make_unique<RigidProjection>(motion_coordinates);
  }


  template Vector
  CondensedOperator<2>::lip_stiffness(const SymmetricTriplets &) const;
  template Vector
  CondensedOperator<3>::lip_stiffness(const SymmetricTriplets &) const;
  template void
  CondensedOperator<2>::remove_rounding(const Vector &);
  template void
  CondensedOperator<3>::remove_rounding(const Vector &);
  template void
  CondensedOperator<2>::find_rigid_motions();
  template void
  CondensedOperator<3>::find_rigid_motions();
} // namespace fuga
