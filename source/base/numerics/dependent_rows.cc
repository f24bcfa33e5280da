// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/cone_projection.h>
#include <fuga/base/numerics/dependent_rows.h>

namespace fuga
{
  // With A = U Σ Vᵀ, a combination vanishes if it is orthogonal to the columns u = A v / σ of U
  // with σ > 0; the unit vector of a row that has no share in any such combination lies in the span
  // of these columns.
  std::vector<bool>
  dependent_rows(const DenseMatrix &A)
  {
    constexpr double zero = 1e-10, none = 1e-8;
    const RightSingularVectors svd(A);
    const DenseMatrix U_sigma = multiply(A, svd.V);
    Vector shares(A.rows(), 1.);
    for (std::size_t j = 0; j < svd.values.size() && svd.values[j] > zero * svd.values[0]; ++j)
      for (Eigen::Index i = 0; i < A.rows(); ++i)
        {
          const double u = U_sigma(i, j) / svd.values[j];
          shares[i] -= u * u;
        }
    std::vector<bool> result;
    for (const double share : shares)
      result.push_back(share > none);
    return result;
  }
} // namespace fuga
