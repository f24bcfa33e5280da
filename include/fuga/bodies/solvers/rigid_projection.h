// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_rigid_projection_h
#define fuga_bodies_solvers_rigid_projection_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /**
   * Removes rounding errors from the condensed system. The jumps R of rigid motions of floating
   * bodies require no force, S R = 0, and the condensed loads do the same work on them as the
   * applied ones, Rᵀ F = W. Both are known exactly, so S and F are projected to satisfy them;
   * equilibrium of the bodies then does not suffer from the condition of the eliminated part.
   */
  class RigidProjection
  {
  public:
    /** @p motions is R; its columns are independent if the bars hold the bodies. */
    explicit RigidProjection(const DenseMatrix &motions);

    void
    project_stiffness(DenseMatrix &S) const;

    void
    project_loads(DenseMatrix &F, const DenseMatrix &work) const;

    /** Compute (I - R Qᵀ) x: jumps without the motion closest to them. */
    void
    take_out_motion(Vector &jumps) const;

    /** Compute (I - Q Rᵀ) p: forces without the part that does work on the motions. */
    void
    take_out_work(Vector &forces) const;

    /** Return S + c R (RᵀR)⁻¹ Rᵀ, which also holds the bodies. */
    DenseMatrix
    held(const DenseMatrix &S, const double stiffness) const;

    /** Return the amounts of the motions closest to given jumps. */
    Vector
    motion_of(const Vector &jumps) const
    {
      return Q.size() == 0 ? Vector() : multiply_transposed(Q, jumps);
    }

  private:
    DenseMatrix R;
    /** Q = R (RᵀR)⁻¹; empty if there is nothing to do. */
    DenseMatrix Q;
  };
} // namespace fuga

#endif
