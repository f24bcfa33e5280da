// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_free_motions_h
#define fuga_bodies_elasticity_free_motions_h

#include <fuga/base/numerics/accurate.h>

#include <vector>

namespace fuga
{
  template <int dim>
  class RigidPieces;

  /**
   * The rigid motions that the supports leave to the bodies. A body that flies moves by far more
   * than it deforms: K u has resultants that are all rounding then, and inertia would follow them,
   * unless the motion, which K does not feel, is taken out of u before.
   */
  class FreeMotions
  {
  public:
    /** @p mass: the diagonal of M. */
    template <int dim>
    FreeMotions(const RigidPieces<dim> &pieces, const Vector &mass);

    /** @p u (entry node * dim + component) without its rigid part. */
    Vector
    deformation(Vector u) const;

    /** The same to the last digit of u, for the displacement that has added up since the motion
     * began: K makes forces of that digit, and both who moves the bodies and who judges them must
     * mean the same ones. */
    Vector
    deformation_of_far(const Vector &u) const;

    /** What deformation() takes off. */
    Vector
    rigid_part(const Vector &u) const;

    /** M R (Rᵀ M R)⁻¹ Rᵀ f, R these motions of bodies with mass: the resultants of forces f as
     * inertia forces. */
    Vector
    inertia_of_resultants(const Vector &forces) const;

  private:
    /** φ, and W φ with the weights of the scalar product, of the nodes that move. */
    struct Motion
    {
      std::vector<std::size_t> entries;
      Vector values, dual;
    };

    /** φᵀ W φ' is 0 or 1; motions without weight are not among them. */
    template <int dim>
    static std::vector<Motion>
    orthonormal(const RigidPieces<dim> &pieces, const Vector &weights);

    /** Σ shape (factors · given) over @p motions. */
    static Vector
    project(const std::vector<Motion> &motions,
            const Vector Motion::*const factors,
            const Vector Motion::*const shape,
            const Vector &given);

    template <typename Number>
    static void
    remove(const Motion &motion, std::vector<Number> &u);

    /** By nodes, and by mass. */
    std::vector<Motion> motions, momenta;
  };
} // namespace fuga

#endif
