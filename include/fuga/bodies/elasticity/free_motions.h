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
   * The rigid motions of the bodies that the supports allow. A flying body moves by far more than
   * it deforms: the resultants of K u are then nothing but rounding, and inertia would follow them,
   * unless the motion, which K does not feel, is removed from u before.
   */
  class FreeMotions
  {
  public:
    /** @p mass is the diagonal of M. */
    template <int dim>
    FreeMotions(const RigidPieces<dim> &pieces, const Vector &mass);

    /** Return @p u (entry node * dim + component) without its rigid part. */
    Vector
    deformation(Vector u) const;

    /**
     * Return the deformation to the last digit of u, for the displacement accumulated since the
     * motion began: K converts this digit to forces, and both the integration of the motion and the
     * judge must use the same ones.
     */
    Vector
    deformation_of_far(const Vector &u) const;

    /** Return the part that deformation() removes. */
    Vector
    rigid_part(const Vector &u) const;

    /**
     * Return M R (Rᵀ M R)⁻¹ Rᵀ f, where R are these motions of bodies with mass: the resultants of
     * forces f as inertia forces.
     */
    Vector
    inertia_of_resultants(const Vector &forces) const;

  private:
    /** φ, and W φ with the weights of the scalar product, at the nodes that move. */
    struct Motion
    {
      std::vector<std::size_t> entries;
      Vector values, dual;
    };

    /** Return motions for which φᵀ W φ' is 0 or 1; motions without weight are left out. */
    template <int dim>
    static std::vector<Motion>
    orthonormal(const RigidPieces<dim> &pieces, const Vector &weights);

    /** Return the sum of shape (factors · given) over @p motions. */
    static Vector
    project(const std::vector<Motion> &motions,
            const Vector Motion::*const factors,
            const Vector Motion::*const shape,
            const Vector &given);

    template <typename Number>
    static void
    remove(const Motion &motion, std::vector<Number> &u);

    /** The motions, orthonormal with equal weights of the nodes and with the mass, respectively. */
    std::vector<Motion> motions, momenta;
  };
} // namespace fuga

#endif
