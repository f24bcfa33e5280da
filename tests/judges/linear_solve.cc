// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/linear_solve.h"

#include <lapacke.h>

#include <algorithm>
#include <cmath>

namespace fuga::judges
{
  namespace
  {
    constexpr double singular_below = 1e-14;

    /** Divides rows, then columns, by their largest entry; B like the rows. Returns the column
     * factors. */
    Vector
    equilibrate(DenseMatrix &A, DenseMatrix &B)
    {
      const std::size_t n = A.rows();
      for (std::size_t i = 0; i < n; ++i)
        {
          double size = 0.;
          for (std::size_t j = 0; j < n; ++j)
            size = std::max(size, std::abs(A(i, j)));
          if (size == 0.)
            continue;
          for (std::size_t j = 0; j < n; ++j)
            A(i, j) /= size;
          for (Eigen::Index j = 0; j < B.cols(); ++j)
            B(i, j) /= size;
        }
      Vector factors(n, 1.);
      for (std::size_t j = 0; j < n; ++j)
        {
          double size = 0.;
          for (std::size_t i = 0; i < n; ++i)
            size = std::max(size, std::abs(A(i, j)));
          if (size == 0.)
            continue;
          factors[j] = 1. / size;
          for (std::size_t i = 0; i < n; ++i)
            A(i, j) /= size;
        }
      return factors;
    }

    bool
    solves(const DenseMatrix &A, const DenseMatrix &X, const DenseMatrix &B)
    {
      for (Eigen::Index column = 0; column < B.cols(); ++column)
        {
          double scale = 0., error = 0.;
          for (Eigen::Index i = 0; i < A.rows(); ++i)
            {
              double sum = -B(i, column);
              scale      = std::max(scale, std::abs(sum));
              for (Eigen::Index j = 0; j < A.cols(); ++j)
                {
                  sum += A(i, j) * X(j, column);
                  scale = std::max(scale, std::abs(A(i, j) * X(j, column)));
                }
              error = std::max(error, std::abs(sum));
            }
          if (error > 1e-11 * scale)
            return false;
        }
      return true;
    }
  } // namespace


  LinearSolution
  solve_linear(DenseMatrix A, DenseMatrix B, const bool allow_singular)
  {
    LinearSolution result;
    const Vector factors       = equilibrate(A, B);
    const lapack_int n         = static_cast<lapack_int>(A.rows());
    const lapack_int n_columns = static_cast<lapack_int>(B.cols());
    result.X                   = DenseMatrix(A.rows(), B.cols());

    DenseMatrix A_copy = A, B_copy = B, factorised(A.rows(), A.rows());
    std::vector<lapack_int> pivots(A.rows());
    Vector row_scales(A.rows(), 1.), column_scales(A.rows(), 1.);
    Vector forward_error(B.cols()), backward_error(B.cols());
    char equilibration    = 'N';
    double pivot_growth   = 0.;
    const lapack_int info = LAPACKE_dgesvx(LAPACK_COL_MAJOR,
                                           'N',
                                           'N',
                                           n,
                                           n_columns,
                                           A_copy.data(),
                                           n,
                                           factorised.data(),
                                           n,
                                           pivots.data(),
                                           &equilibration,
                                           row_scales.data(),
                                           column_scales.data(),
                                           B_copy.data(),
                                           n,
                                           result.X.data(),
                                           n,
                                           &result.reciprocal_condition,
                                           forward_error.data(),
                                           backward_error.data(),
                                           &pivot_growth);
    result.regular        = info == 0 && result.reciprocal_condition > singular_below;

    if (!result.regular && allow_singular)
      {
        A_copy          = A;
        result.X        = B;
        lapack_int rank = 0;
        Vector singular_values(A.rows());
        result.consistent = LAPACKE_dgelsd(LAPACK_COL_MAJOR,
                                           n,
                                           n,
                                           n_columns,
                                           A_copy.data(),
                                           n,
                                           result.X.data(),
                                           n,
                                           singular_values.data(),
                                           1e-13,
                                           &rank) == 0 &&
                            solves(A, result.X, B);
      }
    for (Eigen::Index column = 0; column < B.cols(); ++column)
      for (std::size_t i = 0; i < factors.size(); ++i)
        result.X(i, column) *= factors[i];
    return result;
  }

  LinearSolution
  solve_linear(DenseMatrix A, const Vector &b, const bool allow_singular)
  {
    DenseMatrix B(b.size(), 1);
    B.col(0) = view(b);
    return solve_linear(std::move(A), std::move(B), allow_singular);
  }
} // namespace fuga::judges
