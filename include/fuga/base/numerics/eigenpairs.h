// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_eigenpairs_h
#define fuga_base_numerics_eigenpairs_h

#include <fuga/base/numerics/dense_matrix.h>

#include <functional>

namespace fuga
{
  /** Eigenvalues and orthonormal eigenvectors, stored by columns. */
  struct Eigenpairs
  {
    Vector values;
    DenseMatrix vectors;
  };

  /**
   * Return all eigenpairs of a symmetric matrix, of which the lower triangle is read; the largest
   * eigenvalue comes first.
   * @throws NumericalFailure if LAPACK's iteration does not converge.
   */
  Eigenpairs
  eigenpairs(DenseMatrix A);

  /**
   * Return the @p count < n largest eigenpairs of a symmetric matrix of order n that is given by
   * its products with vectors (ARPACK's Lanczos iteration with implicit restarts), the largest one
   * first. Results are reproducible: every call does the same.
   * @throws NumericalFailure if the iteration does not converge.
   */
  Eigenpairs
  largest_eigenpairs(const std::size_t n,
                     const std::size_t count,
                     const std::function<Vector(const Vector &)> &product);
} // namespace fuga

#endif
