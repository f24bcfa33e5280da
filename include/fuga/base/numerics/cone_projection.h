// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_cone_projection_h
#define fuga_base_numerics_cone_projection_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /**
   * Singular values in decreasing order and right singular vectors (columns of V) of a matrix with
   * any number of rows; values missing because there are too few rows are zero.
   * @throws NumericalFailure if LAPACK's iteration does not converge.
   */
  struct RightSingularVectors
  {
    explicit RightSingularVectors(const DenseMatrix &A);

    Vector values;
    DenseMatrix V;
  };

  /**
   * Return the point of the polyhedral cone {x : E x = 0, C x ≥ 0} closest to @p q: it is zero if
   * and only if no point of the cone has a positive product with q. The rows of E and C have to
   * have norm one or less; entries of E x below 1e-7 count as zero.
   */
  Vector
  nearest_in_cone(const DenseMatrix &E, const DenseMatrix &C, const Vector &q);
} // namespace fuga

#endif
