// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_dynamics_geometric_stiffness_h
#define fuga_bodies_dynamics_geometric_stiffness_h

#include <deal.II/lac/sparse_matrix.h>

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/loads/temperature_field.h>

namespace fuga
{
  /**
   * Add the second-order effect of the stresses σ with which a motion begins [MN/m]:
   *
   *     uᵀ K_g u = ∫ σ : (∇u)ᵀ∇u dV.                    (doc/theory.md, section 19, eq. 39)
   *
   * For a rocking rigid block it is the reduction of the lever arm of the weight, -W h/2 θ².
   * @p displacement (Discretization::dof()) and @p temperature are those at the beginning of the
   * motion; without a displacement there are no stresses. The result is added to a @p matrix by
   * nodes, for the own cells.
   */
  template <int dim>
  void
  add_geometric_stiffness(const CondensedSystem<dim> &bodies,
                          const Vector &displacement,
                          const TemperatureField<dim> &temperature,
                          dealii::SparseMatrix<double> &matrix);
} // namespace fuga

#endif
