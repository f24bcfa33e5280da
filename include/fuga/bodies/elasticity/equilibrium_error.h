// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_equilibrium_error_h
#define fuga_bodies_elasticity_equilibrium_error_h

#include <fuga/base/numerics/dense_matrix.h>

#include <string>

namespace fuga
{
  template <int dim>
  class RigidPieces;

  /**
   * The error of a solution in the equations of the full model; forces are relative to the largest
   * one.
   */
  struct EquilibriumError
  {
    /**
     * Largest entry of K u + Gᵀ p - P a over all free degrees of freedom, minus the part explained
     * by the rounding of u.
     */
    double residual = 0.;
    /** Largest resultant (force or moment) on a body without support, and the name of this body. */
    double resultant = 0.;
    std::string body;
  };

  /**
   * Compute the error from the nodal forces K u with its @p terms Σ|Kᵢⱼuⱼ|, Gᵀ p and P a (entry
   * node * dim + component). @p acting are forces that others balance within P a or Gᵀ p, e.g.
   * weight by inertia if a body falls; errors are relative to them as well. Empty if there are
   * none.
   */
  template <int dim>
  EquilibriumError
  equilibrium_error(const Vector &elastic,
                    const Vector &terms,
                    const Vector &contact,
                    const Vector &loads,
                    const Vector &acting,
                    const std::vector<bool> &fixed,
                    const RigidPieces<dim> &pieces);
} // namespace fuga

#endif
