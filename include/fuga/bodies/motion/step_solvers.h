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


  /**
   * The stiffness of steps of all lengths, factorised when first needed, or the modes of the
   * bodies. Motions of the same bodies with the same masses and step lengths share this object.
   */
  struct StepSolvers
  {
    Vector mass;
    /** Length of the longest steps [s]. */
    double step = 0.;
    /** Order of elimination, see elimination_order(); the same for all solvers. */
    std::vector<int> order;
    /** The factors and Ŝ, by rung. */
    std::vector<std::unique_ptr<SchurSolver>> solvers;
    std::vector<DenseMatrix> stiffness;
    std::shared_ptr<const ModalBasis> modes;

    BodiesWork
    work() const;
  };

  /**
   * Add one triangle of CᵀAC to the matrix of a step, with C of the coordinates and a matrix A by
   * nodes.
   */
  template <int dim>
  void
  add_by_nodes(const dealii::SparseMatrix<double> &by_nodes,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix);

  /** Add one triangle of CᵀAC, where A is a factor times a diagonal matrix. */
  template <int dim>
  void
  add_diagonal(const double factor,
               const Vector &diagonal,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix);

  /** Add one triangle of CᵀAC, where A is a factor times the matrix of dashpots. */
  template <int dim>
  void
  add_dashpots(const double factor,
               const Dashpots<dim> &dashpots,
               const InterfaceCoordinates<dim> &coordinates,
               SymmetricTriplets &matrix);
} // namespace fuga

#endif
