// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_dense_matrix_h
#define fuga_base_numerics_dense_matrix_h

#include <cstddef>
#include <vector>

namespace fuga
{
  using Vector = std::vector<double>;

  /**
   * A dense matrix stored by columns, as BLAS and LAPACK need it. It only owns the numbers; the
   * operations below are calls to those libraries.
   */
  class DenseMatrix
  {
  public:
    DenseMatrix() = default;

    /** Create a zero matrix. */
    DenseMatrix(const std::size_t n_rows, const std::size_t n_columns)
      : rows(n_rows), columns(n_columns), values(n_rows * n_columns, 0.)
    {
    }

    double &
    operator()(const std::size_t i, const std::size_t j)
    {
      return values[i + j * rows];
    }

    double
    operator()(const std::size_t i, const std::size_t j) const
    {
      return values[i + j * rows];
    }

    std::size_t
    n_rows() const
    {
      return rows;
    }

    std::size_t
    n_columns() const
    {
      return columns;
    }

    bool
    empty() const
    {
      return values.empty();
    }

    double *
    column(const std::size_t j)
    {
      return values.data() + j * rows;
    }

    const double *
    column(const std::size_t j) const
    {
      return values.data() + j * rows;
    }

    double *
    data()
    {
      return values.data();
    }

    const double *
    data() const
    {
      return values.data();
    }

  private:
    std::size_t rows    = 0;
    std::size_t columns = 0;
    std::vector<double> values;
  };

  /** Return A x. */
  Vector
  multiply(const DenseMatrix &A, const Vector &x);

  /** Return Aᵀ x. */
  Vector
  multiply_transposed(const DenseMatrix &A, const Vector &x);

  /** Return A B. */
  DenseMatrix
  multiply(const DenseMatrix &A, const DenseMatrix &B);

  /** Return Aᵀ B. */
  DenseMatrix
  multiply_transposed(const DenseMatrix &A, const DenseMatrix &B);

  double
  dot(const Vector &x, const Vector &y);

  /** Add factor x to y, for as many entries as x has. */
  void
  add_multiple(const double factor, const Vector &x, Vector &y);

  /** Return origin + τ rates; entries of @p origin beyond the end of @p rates remain unchanged. */
  Vector
  along(Vector origin, const double tau, const Vector &rates);

  /** Return the largest absolute value, 0 for an empty vector. */
  double
  max_abs(const Vector &x);

  /** Return the largest absolute value of an entry. */
  double
  max_abs(const DenseMatrix &A);

  /** Return the largest diagonal entry, 0 if none is positive. */
  double
  largest_diagonal(const DenseMatrix &A);

  /**
   * Overwrite B by A⁻¹ B for a symmetric positive definite A (Cholesky). Return false, with both
   * arguments in an undefined state, if A is not positive definite to working precision.
   */
  bool
  solve_positive_definite(DenseMatrix &A, DenseMatrix &B);

  /**
   * Replace a symmetric positive definite matrix A by A⁻¹; return false as above. For as many
   * right-hand sides as A has columns this is half of the work.
   */
  bool
  invert_positive_definite(DenseMatrix &A);

  /**
   * LU factors of a square matrix with partial pivoting. Unless its scaling is to be kept, its rows
   * and columns are first scaled to equal size by powers of two, since bars of any stiffness stand
   * side by side. The matrix is consumed; reciprocal_condition() returns LAPACK's estimate in the
   * 1-norm for the scaled matrix, 0 if a pivot vanished.
   */
  class LuFactors
  {
  public:
    enum class Scaling
    {
      equilibrated,
      /**
       * Rows and columns have their natural size: one that is small compared with the others is
       * zero up to rounding.
       */
      as_given
    };

    explicit LuFactors(DenseMatrix &&matrix, const Scaling scaling = Scaling::equilibrated);

    double
    reciprocal_condition() const
    {
      return rcond;
    }

    /** Return the sign of det A; 0 if a pivot vanished. */
    int
    determinant_sign() const;

    /** Overwrite b by A⁻¹ b. */
    void
    solve(Vector &b) const;

    /** Overwrite B by A⁻¹ B. */
    void
    solve(DenseMatrix &B) const;

    /** Return the inverse; the factors cannot be used afterwards. */
    DenseMatrix
    release_inverse();

  private:
    void
    equilibrate();

    DenseMatrix factors;
    /** Powers of two by which rows and columns were multiplied. */
    Vector row_scale, column_scale;
    std::vector<int> pivots;
    double rcond = 0.;
  };

  /**
   * Return the null vector, with largest entry one, of a matrix that is singular up to rounding, by
   * three steps of inverse iteration: enough for a motion that is only to be shown.
   */
  Vector
  null_vector(DenseMatrix &&shifted);
} // namespace fuga

#endif
