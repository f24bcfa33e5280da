// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_cone_projection_h
#define fuga_base_numerics_cone_projection_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /** Singular values, decreasing, and right singular vectors (columns of V) of a matrix with any
   * number of rows; values that are missing for want of rows are zero.
   * @throws NumericalFailure if LAPACK's iteration does not converge. */
  struct RightSingularVectors
  {
    explicit RightSingularVectors(const DenseMatrix &A);

    Vector values;
    DenseMatrix V;
  };

  /**
   * The point of the polyhedral cone {x : E x = 0, C x ≥ 0} next to @p q: zero if and only if no
   * point of the cone has a positive product with q. Rows of E and C are to be of size one or less;
   * what is below 1e-7 in E x is zero.
   */
  Vector
  nearest_in_cone(const DenseMatrix &E, const DenseMatrix &C, const Vector &q);
} // namespace fuga

#endif
