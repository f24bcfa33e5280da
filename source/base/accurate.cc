// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/accurate.h>

#include <numeric>

namespace fuga
{
  void
  add_product(const long double sign, const DenseMatrix &A, const Accurate &x, Accurate &y)
  {
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      add_scaled(A.n_rows(), sign * x[j], A.column(j), y.data());
  }

  void
  add_transposed_product(const long double sign,
                         const DenseMatrix &A,
                         const Accurate &x,
                         Accurate &y)
  {
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      {
        long double sum = 0.L;
        for (std::size_t i = 0; i < A.n_rows(); ++i)
          sum += A(i, j) * x[i];
        y[j] += sign * sum;
      }
  }

  long double
  dot(const Accurate &x, const Accurate &y)
  {
    return std::inner_product(x.begin(), x.end(), y.begin(), 0.L);
  }
} // namespace fuga
