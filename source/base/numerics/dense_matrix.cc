// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/dense_matrix.h>
#include <fuga/base/work_counter.h>

#include <algorithm>
#include <cmath>
#include <lapacke.h>
#include <string>

namespace fuga
{
  namespace
  {
    int
    to_int(const Eigen::Index n)
    {
      return static_cast<int>(n);
    }

    // LAPACK requires a leading dimension of at least one, also for empty matrices.
    int
    leading(const DenseMatrix &A)
    {
      return std::max(1, to_int(A.rows()));
    }

    /** n³ */
    std::size_t
    cube(const DenseMatrix &A)
    {
      return static_cast<std::size_t>(A.rows() * A.rows() * A.rows());
    }

    void
    count_product(const Eigen::Index n_operations)
    {
      work::now().dense_operations += static_cast<std::size_t>(n_operations);
    }

    void
    count_factorisation(const std::size_t n_operations)
    {
      ++work::now().dense_factorisations;
      work::now().dense_operations += n_operations;
    }

    void
    count_solution(const DenseMatrix &A, const std::size_t n_columns)
    {
      work::now().dense_solutions += n_columns;
      work::now().dense_operations += A.rows() * A.rows() * n_columns;
    }

    void
    expect_success(const lapack_int info, const char *routine)
    {
      if (info < 0)
        throw NumericalFailure(std::string(routine) + " refused argument " + std::to_string(-info) +
                               " (not a number in a matrix of the small system?)");
    }
  } // namespace

  // BLAS is called for products, as EIGEN_USE_BLAS tells Eigen to do; it refuses matrices without
  // rows.
  Vector
  multiply(const ConstMatrixView &A, const Vector &x)
  {
    count_product(A.size());
    return A.size() == 0 ? Vector(A.rows(), 0.) : to_vector(A * view(x));
  }

  // With the lower triangle OpenBLAS's kernels for old processors read 16 bytes past the end of y,
  // also in LAPACK's eigenvalue solvers (version 0.3.21).
  Vector
  multiply_symmetric(const DenseMatrix &A, const Vector &x)
  {
    count_product(A.size());
    return A.size() == 0 ? Vector() : to_vector(A.selfadjointView<Eigen::Upper>() * view(x));
  }

  Vector
  multiply_transposed(const ConstMatrixView &A, const Vector &x)
  {
    count_product(A.size());
    return A.size() == 0 ? Vector(A.cols(), 0.) : to_vector(A.transpose() * view(x));
  }

  DenseMatrix
  multiply(const ConstMatrixView &A, const DenseMatrix &B)
  {
    count_product(A.size() * B.cols());
    return A * B;
  }

  DenseMatrix
  multiply_transposed(const ConstMatrixView &A, const DenseMatrix &B)
  {
    count_product(A.size() * B.cols());
    return A.transpose() * B;
  }

  void
  add_multiple(const double factor, const Vector &x, Vector &y)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      y[i] += factor * x[i];
  }

  Vector
  along(Vector origin, const double tau, const Vector &rates)
  {
    add_multiple(tau, rates, origin);
    return origin;
  }

  double
  max_abs(const Vector &x)
  {
    return max_abs(view(x));
  }

  bool
  solve_positive_definite(DenseMatrix &A, DenseMatrix &B)
  {
    if (A.size() == 0)
      return true;
    count_factorisation(cube(A) / 6);
    count_solution(A, B.cols());
    const lapack_int info = LAPACKE_dposv(LAPACK_COL_MAJOR,
                                          'L',
                                          to_int(A.rows()),
                                          to_int(B.cols()),
                                          A.data(),
                                          leading(A),
                                          B.data(),
                                          leading(B));
    expect_success(info, "dposv");
    return info == 0;
  }

  bool
  invert_positive_definite(DenseMatrix &A)
  {
    if (A.size() == 0)
      return true;
    count_factorisation(cube(A) / 2); // a sixth for the factors
    const int n     = to_int(A.rows());
    lapack_int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', n, A.data(), n);
    expect_success(info, "dpotrf");
    if (info == 0)
      info = LAPACKE_dpotri(LAPACK_COL_MAJOR, 'L', n, A.data(), n);
    expect_success(info, "dpotri");
    for (Eigen::Index j = 0; j < A.cols(); ++j)
      for (Eigen::Index i = 0; i < j; ++i)
        A(i, j) = A(j, i);
    return info == 0;
  }

  LuFactors::LuFactors(DenseMatrix &&matrix, const Scaling scaling)
    : factors(std::move(matrix))
    , row_scale(factors.rows(), 1.)
    , column_scale(factors.rows(), 1.)
    , pivots(factors.rows())
  {
    if (factors.size() == 0)
      {
        rcond = 1.;
        return;
      }
    if (scaling == Scaling::equilibrated)
      equilibrate();
    count_factorisation(cube(factors) / 3);
    const int n = to_int(factors.rows());
    const double norm =
      LAPACKE_dlange(LAPACK_COL_MAJOR, '1', n, n, factors.data(), leading(factors));
    const lapack_int info =
      LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, factors.data(), leading(factors), pivots.data());
    expect_success(info, "dgetrf");
    if (info == 0)
      LAPACKE_dgecon(LAPACK_COL_MAJOR, '1', n, factors.data(), leading(factors), norm, &rcond);
  }

  // A matrix with a row or column of zeros stays unchanged: no scale makes it regular.
  void
  LuFactors::equilibrate()
  {
    const int n      = to_int(factors.rows());
    double row_ratio = 0., column_ratio = 0., largest = 0.;
    Vector rows(factors.rows()), columns(factors.rows());
    const lapack_int info = LAPACKE_dgeequb(LAPACK_COL_MAJOR,
                                            n,
                                            n,
                                            factors.data(),
                                            leading(factors),
                                            rows.data(),
                                            columns.data(),
                                            &row_ratio,
                                            &column_ratio,
                                            &largest);
    expect_success(info, "dgeequb");
    if (info > 0)
      return;
    row_scale    = std::move(rows);
    column_scale = std::move(columns);
    for (Eigen::Index j = 0; j < factors.cols(); ++j)
      for (Eigen::Index i = 0; i < factors.rows(); ++i)
        factors(i, j) *= row_scale[i] * column_scale[j];
  }

  int
  LuFactors::determinant_sign() const
  {
    int sign = 1;
    for (Eigen::Index i = 0; i < factors.rows(); ++i)
      {
        if (factors(i, i) == 0.)
          return 0;
        // dgetrf counts from one; every true exchange of rows changes the sign.
        if ((factors(i, i) < 0.) != (pivots[i] != to_int(i) + 1))
          sign = -sign;
      }
    return sign;
  }

  void
  LuFactors::solve(Vector &b) const
  {
    DenseMatrix columns(b.size(), 1);
    columns.col(0) = view(b);
    solve(columns);
    std::copy_n(columns.col(0).data(), b.size(), b.begin());
  }

  void
  LuFactors::solve(DenseMatrix &B) const
  {
    if (factors.size() == 0 || B.size() == 0)
      return;
    for (Eigen::Index j = 0; j < B.cols(); ++j)
      for (Eigen::Index i = 0; i < B.rows(); ++i)
        B(i, j) *= row_scale[i];
    count_solution(factors, B.cols());
    // The variant that first looks through all factors for NaN is avoided, because it would cost
    // half a solution.
    expect_success(LAPACKE_dgetrs_work(LAPACK_COL_MAJOR,
                                       'N',
                                       to_int(factors.rows()),
                                       to_int(B.cols()),
                                       factors.data(),
                                       leading(factors),
                                       pivots.data(),
                                       B.data(),
                                       leading(B)),
                   "dgetrs");
    for (Eigen::Index j = 0; j < B.cols(); ++j)
      for (Eigen::Index i = 0; i < B.rows(); ++i)
        B(i, j) *= column_scale[i];
  }

  DenseMatrix
  LuFactors::release_inverse()
  {
    count_solution(factors, factors.rows());
    if (factors.size() > 0)
      expect_success(LAPACKE_dgetri(LAPACK_COL_MAJOR,
                                    to_int(factors.rows()),
                                    factors.data(),
                                    leading(factors),
                                    pivots.data()),
                     "dgetri");
    for (Eigen::Index j = 0; j < factors.cols(); ++j)
      for (Eigen::Index i = 0; i < factors.rows(); ++i)
        factors(i, j) *= column_scale[i] * row_scale[j];
    return std::move(factors);
  }

  Vector
  null_vector(DenseMatrix &&shifted)
  {
    Vector x(shifted.rows(), 1.);
    const LuFactors factors(std::move(shifted));
    for (int step = 0; step < 3 && factors.reciprocal_condition() > 0.; ++step)
      {
        factors.solve(x);
        const double largest = max_abs(x);
        for (double &value : x)
          value /= largest;
      }
    return x;
  }
} // namespace fuga
