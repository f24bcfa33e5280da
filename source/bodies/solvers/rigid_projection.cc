// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/solvers/rigid_projection.h>

namespace fuga
{
  RigidProjection::RigidProjection(const DenseMatrix &motions) : R(motions)
  {
    if (R.size() == 0)
      return;
    DenseMatrix gram = multiply_transposed(R, R), transposed = R.transpose();
    if (solve_positive_definite(gram, transposed))
      Q = transposed.transpose();
  }


  void
  RigidProjection::project_stiffness(DenseMatrix &S) const
  {
    if (Q.size() == 0)
      return;
    // (I - Q Rᵀ) S (I - R Qᵀ) = S - E Qᵀ - Q Eᵀ + Q (Rᵀ E) Qᵀ with the error E = S R.
    //                         = S - E' Qᵀ - Q E'ᵀ,  E' = E - Q (Rᵀ E) / 2
    DenseMatrix error = multiply(S, R);
    error -= 0.5 * multiply(Q, multiply_transposed(R, error));
    const DenseMatrix half = error * Q.transpose();
    S -= half + half.transpose();
  }


  namespace
  {
    /** Compute x -= A Bᵀ x. */
    void
    take_out(const DenseMatrix &A, const DenseMatrix &B, Vector &x)
    {
      view(x) -= view(multiply(A, multiply_transposed(B, x)));
    }
  } // namespace


  void
  RigidProjection::take_out_motion(Vector &jumps) const
  {
    if (Q.size() > 0)
      take_out(R, Q, jumps);
  }


  void
  RigidProjection::take_out_work(Vector &forces) const
  {
    if (Q.size() > 0)
      take_out(Q, R, forces);
  }


  DenseMatrix
  RigidProjection::held(const DenseMatrix &S, const double stiffness) const
  {
    return Q.size() == 0 ? S : DenseMatrix(S + stiffness * Q * R.transpose());
  }


  void
  RigidProjection::project_loads(DenseMatrix &F, const DenseMatrix &work) const
  {
    if (Q.size() > 0 && F.size() > 0)
      F += multiply(Q, work - multiply_transposed(R, F));
  }
} // namespace fuga
