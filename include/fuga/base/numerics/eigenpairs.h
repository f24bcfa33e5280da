// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_eigenpairs_h
#define fuga_base_numerics_eigenpairs_h

#include <fuga/base/numerics/dense_matrix.h>

#include <functional>

namespace fuga
{
  /** Eigenvalues, and orthonormal eigenvectors by columns. */
  struct Eigenpairs
  {
    Vector values;
    DenseMatrix vectors;
  };

  /** All of a symmetric matrix, of which the lower triangle is read; the largest eigenvalue first.
   * @throws NumericalFailure if LAPACK's iteration does not converge. */
  Eigenpairs
  eigenpairs(DenseMatrix A);

  /** The largest eigenvalues, @p count < n of them, of a symmetric matrix of order n that is known by
   * its products (ARPACK's Lanczos iteration with implicit restarts), the largest one first. Every
   * call does the same.
   * @throws NumericalFailure if the iteration does not converge. */
  Eigenpairs
  largest_eigenpairs(const std::size_t n,
                     const std::size_t count,
                     const std::function<Vector(const Vector &)> &product);
} // namespace fuga

#endif
