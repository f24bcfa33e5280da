// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/blas.h>
#include <fuga/base/numerics/dense_matrix.h>

#include <algorithm>
#include <cmath>
#include <lapacke.h>
#include <string>

namespace fuga
{
  namespace
  {
    using blas::to_int;

    // BLAS requires a leading dimension of at least one, also for empty matrices.
    int
    leading(const DenseMatrix &A)
    {
      return std::max(1, to_int(A.n_rows()));
    }

    /** n³ */
    std::size_t
    cube(const DenseMatrix &A)
    {
      return A.n_rows() * A.n_rows() * A.n_rows();
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
      work::now().dense_operations += A.n_rows() * A.n_rows() * n_columns;
    }

    void
    expect_success(const lapack_int info, const char *routine)
    {
      if (info < 0)
        throw NumericalFailure(std::string(routine) + " refused argument " + std::to_string(-info) +
                               " (not a number in a matrix of the small system?)");
    }
  } // namespace

  Vector
  multiply(const DenseMatrix &A, const Vector &x)
  {
    Vector y(A.n_rows(), 0.);
    if (!A.empty())
      blas::gemv('N', A.n_rows(), A.n_columns(), A.data(), A.n_rows(), x.data(), y.data());
    return y;
  }

  Vector
  multiply_transposed(const DenseMatrix &A, const Vector &x)
  {
    Vector y(A.n_columns(), 0.);
    if (!A.empty())
      blas::gemv('T', A.n_rows(), A.n_columns(), A.data(), A.n_rows(), x.data(), y.data());
    return y;
  }

  namespace
  {
    DenseMatrix
    product(const char op, const DenseMatrix &A, const DenseMatrix &B)
    {
      const std::size_t rows  = op == 'N' ? A.n_rows() : A.n_columns();
      const std::size_t inner = op == 'N' ? A.n_columns() : A.n_rows();
      DenseMatrix C(rows, B.n_columns());
      if (!C.empty() && inner > 0)
        blas::gemm(op,
                   rows,
                   B.n_columns(),
                   inner,
                   A.data(),
                   A.n_rows(),
                   B.data(),
                   B.n_rows(),
                   C.data(),
                   rows);
      return C;
    }
  } // namespace

  DenseMatrix
  multiply(const DenseMatrix &A, const DenseMatrix &B)
  {
    return product('N', A, B);
  }

  DenseMatrix
  multiply_transposed(const DenseMatrix &A, const DenseMatrix &B)
  {
    return product('T', A, B);
  }

  double
  dot(const Vector &x, const Vector &y)
  {
    return blas::dot(x.size(), x.data(), y.data());
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

  namespace
  {
    double
    largest_of(const double *begin, const std::size_t n)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < n; ++i)
        largest = std::max(largest, std::abs(begin[i]));
      return largest;
    }
  } // namespace

  double
  max_abs(const Vector &x)
  {
    return largest_of(x.data(), x.size());
  }

  double
  max_abs(const DenseMatrix &A)
  {
    return largest_of(A.data(), A.n_rows() * A.n_columns());
  }

  double
  largest_diagonal(const DenseMatrix &A)
  {
    double largest = 0.;
    for (std::size_t i = 0; i < A.n_rows(); ++i)
      largest = std::max(largest, A(i, i));
    return largest;
  }

  bool
  solve_positive_definite(DenseMatrix &A, DenseMatrix &B)
  {
    if (A.empty())
      return true;
    count_factorisation(cube(A) / 6);
    count_solution(A, B.n_columns());
    const lapack_int info = LAPACKE_dposv(LAPACK_COL_MAJOR,
                                          'L',
                                          to_int(A.n_rows()),
                                          to_int(B.n_columns()),
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
    if (A.empty())
      return true;
    count_factorisation(cube(A) / 2); // a sixth for the factors
    const int n     = to_int(A.n_rows());
    lapack_int info = LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'L', n, A.data(), n);
    expect_success(info, "dpotrf");
    if (info == 0)
      info = LAPACKE_dpotri(LAPACK_COL_MAJOR, 'L', n, A.data(), n);
    expect_success(info, "dpotri");
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        A(i, j) = A(j, i);
    return info == 0;
  }

  LuFactors::LuFactors(DenseMatrix &&matrix, const Scaling scaling)
    : factors(std::move(matrix))
    , row_scale(factors.n_rows(), 1.)
    , column_scale(factors.n_rows(), 1.)
    , pivots(factors.n_rows())
  {
    if (factors.empty())
      {
        rcond = 1.;
        return;
      }
    if (scaling == Scaling::equilibrated)
      equilibrate();
    count_factorisation(cube(factors) / 3);
    const int n = to_int(factors.n_rows());
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
    const int n      = to_int(factors.n_rows());
    double row_ratio = 0., column_ratio = 0., largest = 0.;
    Vector rows(factors.n_rows()), columns(factors.n_rows());
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
    for (std::size_t j = 0; j < factors.n_columns(); ++j)
      for (std::size_t i = 0; i < factors.n_rows(); ++i)
        factors(i, j) *= row_scale[i] * column_scale[j];
  }

  int
  LuFactors::determinant_sign() const
  {
    int sign = 1;
    for (std::size_t i = 0; i < factors.n_rows(); ++i)
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
    std::copy(b.begin(), b.end(), columns.column(0));
    solve(columns);
    std::copy_n(columns.column(0), b.size(), b.begin());
  }

  void
  LuFactors::solve(DenseMatrix &B) const
  {
    if (factors.empty() || B.empty())
      return;
    for (std::size_t j = 0; j < B.n_columns(); ++j)
      for (std::size_t i = 0; i < B.n_rows(); ++i)
        B(i, j) *= row_scale[i];
    count_solution(factors, B.n_columns());
    // The variant that first looks through all factors for NaN is avoided, because it would cost
    // half a solution.
    expect_success(LAPACKE_dgetrs_work(LAPACK_COL_MAJOR,
                                       'N',
                                       to_int(factors.n_rows()),
                                       to_int(B.n_columns()),
                                       factors.data(),
                                       leading(factors),
                                       pivots.data(),
                                       B.data(),
                                       leading(B)),
                   "dgetrs");
    for (std::size_t j = 0; j < B.n_columns(); ++j)
      for (std::size_t i = 0; i < B.n_rows(); ++i)
        B(i, j) *= column_scale[i];
  }

  DenseMatrix
  LuFactors::release_inverse()
  {
    count_solution(factors, factors.n_rows());
    if (!factors.empty())
      expect_success(LAPACKE_dgetri(LAPACK_COL_MAJOR,
                                    to_int(factors.n_rows()),
                                    factors.data(),
                                    leading(factors),
                                    pivots.data()),
                     "dgetri");
    for (std::size_t j = 0; j < factors.n_columns(); ++j)
      for (std::size_t i = 0; i < factors.n_rows(); ++i)
        factors(i, j) *= column_scale[i] * row_scale[j];
    return std::move(factors);
  }

  Vector
  null_vector(DenseMatrix &&shifted)
  {
    Vector x(shifted.n_rows(), 1.);
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
