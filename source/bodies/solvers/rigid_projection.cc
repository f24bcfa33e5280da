// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/solvers/rigid_projection.h>

namespace fuga
{
  RigidProjection::RigidProjection(const DenseMatrix &motions) : R(motions)
  {
    if (R.empty())
      return;
    DenseMatrix gram = multiply_transposed(R, R);
    DenseMatrix transposed(R.n_columns(), R.n_rows());
    for (std::size_t i = 0; i < R.n_rows(); ++i)
      for (std::size_t k = 0; k < R.n_columns(); ++k)
        transposed(k, i) = R(i, k);
    if (!solve_positive_definite(gram, transposed))
      return;
    Q = DenseMatrix(R.n_rows(), R.n_columns());
    for (std::size_t i = 0; i < R.n_rows(); ++i)
      for (std::size_t k = 0; k < R.n_columns(); ++k)
        Q(i, k) = transposed(k, i);
  }


  void
  RigidProjection::project_stiffness(DenseMatrix &S) const
  {
    if (Q.empty())
      return;
    // (I - Q Rᵀ) S (I - R Qᵀ) = S - E Qᵀ - Q Eᵀ + Q (Rᵀ E) Qᵀ with the error E = S R.
    //                         = S - E' Qᵀ - Q E'ᵀ,  E' = E - Q (Rᵀ E) / 2
    DenseMatrix error      = multiply(S, R);
    const DenseMatrix half = multiply(Q, multiply_transposed(R, error));
    for (std::size_t k = 0; k < R.n_columns(); ++k)
      for (std::size_t i = 0; i < R.n_rows(); ++i)
        error(i, k) -= half(i, k) / 2.;
    for (std::size_t j = 0; j < S.n_columns(); ++j)
      for (std::size_t i = j; i < S.n_rows(); ++i)
        {
          for (std::size_t k = 0; k < R.n_columns(); ++k)
            S(i, j) -= error(i, k) * Q(j, k) + Q(i, k) * error(j, k);
          S(j, i) = S(i, j);
        }
  }


  namespace
  {
    /** Compute x -= A Bᵀ x. */
    void
    take_out(const DenseMatrix &A, const DenseMatrix &B, Vector &x)
    {
      const Vector part = multiply(A, multiply_transposed(B, x));
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] -= part[i];
    }
  } // namespace


  void
  RigidProjection::take_out_motion(Vector &jumps) const
  {
    if (!Q.empty())
      take_out(R, Q, jumps);
  }


  void
  RigidProjection::take_out_work(Vector &forces) const
  {
    if (!Q.empty())
      take_out(Q, R, forces);
  }


  DenseMatrix
  RigidProjection::held(const DenseMatrix &S, const double stiffness) const
  {
    DenseMatrix result = S;
    for (std::size_t k = 0; k < Q.n_columns(); ++k)
      for (std::size_t j = 0; j < result.n_columns(); ++j)
        for (std::size_t i = 0; i < result.n_rows(); ++i)
          result(i, j) += stiffness * Q(i, k) * R(j, k);
    return result;
  }


  void
  RigidProjection::project_loads(DenseMatrix &F, const DenseMatrix &work) const
  {
    if (Q.empty() || F.empty())
      return;
    const DenseMatrix condensed = multiply_transposed(R, F);
    for (std::size_t j = 0; j < F.n_columns(); ++j)
      for (std::size_t k = 0; k < R.n_columns(); ++k)
        for (std::size_t i = 0; i < F.n_rows(); ++i)
          F(i, j) += Q(i, k) * (work(k, j) - condensed(k, j));
  }
} // namespace fuga
