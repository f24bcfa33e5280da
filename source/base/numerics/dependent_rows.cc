// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/blas.h>
#include <fuga/base/numerics/dependent_rows.h>

#include <algorithm>
#include <lapacke.h>

namespace fuga
{
  // With A = U Σ Vᵀ a combination vanishes if it is orthogonal to the columns of U that belong to
  // singular values; the unit vector of a row that has no share in any lies among these columns.
  std::vector<bool>
  dependent_rows(DenseMatrix A)
  {
    constexpr double zero = 1e-10, none = 1e-8;
    const std::size_t m = A.n_rows(), n = A.n_columns(), rank = std::min(m, n);
    if (rank == 0)
      return std::vector<bool>(m, true);
    Vector singular(rank), superdiagonal(rank);
    DenseMatrix U(m, rank);
    if (LAPACKE_dgesvd(LAPACK_COL_MAJOR,
                       'S',
                       'N',
                       blas::to_int(m),
                       blas::to_int(n),
                       A.data(),
                       blas::to_int(m),
                       singular.data(),
                       U.data(),
                       blas::to_int(m),
                       nullptr,
                       1,
                       superdiagonal.data()) != 0)
      throw NumericalFailure("The singular value decomposition of a matrix did not converge.");
    Vector shares(m, 1.);
    for (std::size_t j = 0; j < rank && singular[j] > zero * singular[0]; ++j)
      for (std::size_t i = 0; i < m; ++i)
        shares[i] -= U(i, j) * U(i, j);
    std::vector<bool> result;
    for (const double share : shares)
      result.push_back(share > none);
    return result;
  }
} // namespace fuga
