// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_motion_step_solvers_h
#define fuga_bodies_motion_step_solvers_h

#include <deal.II/lac/sparse_matrix.h>

#include <fuga/bodies/dynamics/dashpots.h>
#include <fuga/bodies/joints/interface_coordinates.h>
#include <fuga/bodies/solvers/bodies_work.h>
#include <fuga/bodies/solvers/schur_solver.h>

#include <memory>

namespace fuga
{
  struct ModalBasis;


  /** The stiffness of steps of all lengths, factorised when first needed, or the modes of the
   * bodies. Motions of the same bodies with the same masses and lengths share it. */
  struct StepSolvers
  {
    Vector mass;
    /** Of the longest steps [s]. */
    double step = 0.;
    /** See elimination_order(); the same for all of them. */
    std::vector<int> order;
    /** By rung: the factors and Ŝ. */
    std::vector<std::unique_ptr<SchurSolver>> solvers;
    std::vector<DenseMatrix> stiffness;
    std::shared_ptr<const ModalBasis> modes;

    BodiesWork
    work() const;
  };

  /** Adds one triangle of CᵀAC to the matrix of a step, with C of the coordinates and A a matrix by
   * nodes, */
  template <int dim>
  void
  add_by_nodes(const dealii::SparseMatrix<double> &by_nodes,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix);

  /** or a factor times a diagonal one, */
  template <int dim>
  void
  add_diagonal(const double factor,
               const Vector &diagonal,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix);

  /** or a factor times that of dashpots. */
  template <int dim>
  void
  add_dashpots(const double factor,
               const Dashpots<dim> &dashpots,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix);
} // namespace fuga

#endif
