// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/work_counter.h>
#include <fuga/contact/system/updated_inverse.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuga
{
  void
  UpdatedInverse::reserve(const std::size_t new_size)
  {
    if (new_size > capacity())
      {
        const auto doubled = static_cast<Eigen::Index>(std::max(new_size, 2 * capacity()));
        values.conservativeResize(doubled, doubled);
      }
  }

  bool
  UpdatedInverse::rebuild(DenseMatrix &&matrix)
  {
    const Eigen::Index size = matrix.rows();
    LuFactors factors(std::move(matrix));
    if (!(factors.reciprocal_condition() > std::numeric_limits<double>::epsilon()))
      return false;
    sign = factors.determinant_sign();
    reserve(static_cast<std::size_t>(size));
    n         = size;
    inverse() = factors.release_inverse();
    return true;
  }

  double
  UpdatedInverse::append(const Vector &new_column,
                         const Vector &new_row,
                         const double diagonal,
                         const double smallest_pivot)
  {
    const Vector u = solve(new_column), v = solve_transposed(new_row);
    const double pivot = diagonal - dot(new_row, u);
    if (!(std::abs(pivot) > smallest_pivot))
      return pivot;

    reserve(size() + 1);
    work::now().dense_operations += size() * size();
    inverse().noalias() += view(u) / pivot * view(v).transpose();
    values.col(n).head(n) = -view(u) / pivot;
    values.row(n).head(n) = -view(v).transpose() / pivot;
    values(n, n)          = 1. / pivot;
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

  void
  UpdatedInverse::exchange(const Eigen::Index k, const Eigen::Index l)
  {
    inverse().col(k).swap(inverse().col(l));
    inverse().row(k).swap(inverse().row(l));
  }

  bool
  UpdatedInverse::remove(const std::size_t number)
  {
    const auto k            = static_cast<Eigen::Index>(number);
    const Eigen::Index last = n - 1;
    exchange(k, last);
    const auto removed_column = values.col(last).head(last);
    const auto removed_row    = values.row(last).head(last);
    const double diagonal     = values(last, last);

    // The diagonal entry of the inverse is (determinant without k) / (determinant with k).
    const double noise = std::numeric_limits<double>::epsilon() *
                         std::max(max_abs(removed_column), max_abs(removed_row));
    if (!(std::abs(diagonal) > noise))
      {
        exchange(k, last);
        return false;
      }
    n = last;
    work::now().dense_operations += size() * size();
    inverse().noalias() -= removed_column / diagonal * removed_row;
    sign = diagonal > 0. ? sign : -sign;
    return true;
  }

  Vector
  UpdatedInverse::solve(const Vector &b) const
  {
    return multiply(inverse(), b);
  }

  DenseMatrix
  UpdatedInverse::solve(const DenseMatrix &B) const
  {
    return multiply(inverse(), B);
  }

  Vector
  UpdatedInverse::solve_transposed(const Vector &b) const
  {
    return multiply_transposed(inverse(), b);
  }
} // namespace fuga
