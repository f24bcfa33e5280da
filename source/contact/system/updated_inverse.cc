// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/blas.h>
#include <fuga/contact/system/updated_inverse.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  void
  UpdatedInverse::reserve(const std::size_t new_size)
  {
    if (new_size <= stride)
      return;
    const std::size_t new_stride = std::max(new_size, 2 * stride);
    Vector new_values(new_stride * new_stride, 0.);
    for (std::size_t j = 0; j < n; ++j)
      std::copy_n(column(j), n, new_values.data() + j * new_stride);
    values = std::move(new_values);
    stride = new_stride;
  }

  bool
  UpdatedInverse::rebuild(DenseMatrix &&matrix)
  {
    const std::size_t size = matrix.n_rows();
    LuFactors factors(std::move(matrix));
    if (!(factors.reciprocal_condition() > std::numeric_limits<double>::epsilon()))
      return false;
    sign                      = factors.determinant_sign();
    const DenseMatrix inverse = factors.release_inverse();
    reserve(size);
    n = size;
    for (std::size_t j = 0; j < n; ++j)
      std::copy_n(inverse.column(j), n, column(j));
    return true;
  }

  double
  UpdatedInverse::append(const Vector &new_column,
                         const Vector &new_row,
                         const double diagonal,
                         const double smallest_pivot)
  {
    Vector u(n, 0.), v(n, 0.);
    double pivot = diagonal;
    if (n > 0)
      {
        u = solve(new_column);
        blas::gemv('T', n, n, values.data(), stride, new_row.data(), v.data());
        pivot -= dot(new_row, u);
      }
    if (!(std::abs(pivot) > smallest_pivot))
      return pivot;

    reserve(n + 1);
    if (n > 0)
      blas::ger(n, n, 1. / pivot, u.data(), v.data(), values.data(), stride);
    for (std::size_t i = 0; i < n; ++i)
      {
        column(n)[i] = -u[i] / pivot;
        column(i)[n] = -v[i] / pivot;
      }
    column(n)[n] = 1. / pivot;
    ++n;
    sign = pivot > 0. ? sign : -sign;
    return pivot;
  }

  double
  UpdatedInverse::pivot_of(const Vector &new_column,
                           const Vector &new_row,
                           const double diagonal_entry) const
  {
    return diagonal_entry - dot(new_row, solve(new_column));
  }

  bool
  UpdatedInverse::remove(const std::size_t k)
  {
    const std::size_t last = n - 1;
    std::swap_ranges(column(k), column(k) + n, column(last));
    for (std::size_t j = 0; j < n; ++j)
      std::swap(column(j)[k], column(j)[last]);

    Vector removed_column(column(last), column(last) + last), removed_row(last);
    const double diagonal = column(last)[last];
    for (std::size_t j = 0; j < last; ++j)
      removed_row[j] = column(j)[last];

    // The diagonal entry of the inverse is (determinant without k) / (determinant with k).
    const double noise = std::numeric_limits<double>::epsilon() *
                         std::max(max_abs(removed_column), max_abs(removed_row));
    if (!(std::abs(diagonal) > noise))
      {
        std::swap_ranges(column(k), column(k) + n, column(last));
        for (std::size_t j = 0; j < n; ++j)
          std::swap(column(j)[k], column(j)[last]);
        return false;
      }
    if (last > 0)
      blas::ger(last,
                last,
                -1. / diagonal,
                removed_column.data(),
                removed_row.data(),
                values.data(),
                stride);
    n    = last;
    sign = diagonal > 0. ? sign : -sign;
    return true;
  }

  Vector
  UpdatedInverse::solve(const Vector &b) const
  {
    Vector x(n, 0.);
    if (n > 0)
      blas::gemv('N', n, n, values.data(), stride, b.data(), x.data());
    return x;
  }

  DenseMatrix
  UpdatedInverse::solve(const DenseMatrix &B) const
  {
    DenseMatrix X(n, B.n_columns());
    if (n > 0 && B.n_columns() > 0)
      blas::gemm('N', n, B.n_columns(), n, values.data(), stride, B.data(), n, X.data(), n);
    return X;
  }

  Vector
  UpdatedInverse::solve_transposed(const Vector &b) const
  {
    Vector x(n, 0.);
    if (n > 0)
      blas::gemv('T', n, n, values.data(), stride, b.data(), x.data());
    return x;
  }
} // namespace fuga
