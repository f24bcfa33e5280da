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
   * A dense matrix stored by columns, as BLAS and LAPACK want it. It only owns the numbers; the
   * operations below are calls to those libraries.
   */
  class DenseMatrix
  {
  public:
    DenseMatrix() = default;

    /** A zero matrix. */
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

  /** y = A x. */
  Vector
  multiply(const DenseMatrix &A, const Vector &x);

  /** y = Aᵀ x. */
  Vector
  multiply_transposed(const DenseMatrix &A, const Vector &x);

  /** C = A B. */
  DenseMatrix
  multiply(const DenseMatrix &A, const DenseMatrix &B);

  /** C = Aᵀ B. */
  DenseMatrix
  multiply_transposed(const DenseMatrix &A, const DenseMatrix &B);

  double
  dot(const Vector &x, const Vector &y);

  /** y += factor x, for as many entries as x has. */
  void
  add_multiple(const double factor, const Vector &x, Vector &y);

  /** origin + τ rates, where there are rates. */
  Vector
  along(Vector origin, const double tau, const Vector &rates);

  /** The largest absolute value, 0 for an empty vector. */
  double
  max_abs(const Vector &x);

  /** The largest absolute value of an entry. */
  double
  max_abs(const DenseMatrix &A);

  /** The largest diagonal entry, 0 if none is positive. */
  double
  largest_diagonal(const DenseMatrix &A);

  /**
   * Overwrites B by A⁻¹ B for a symmetric positive definite A (Cholesky). Returns false, with both
   * arguments in an undefined state, if A is not positive definite to working precision.
   */
  bool
  solve_positive_definite(DenseMatrix &A, DenseMatrix &B);

  /** A ← A⁻¹ of a symmetric positive definite matrix; false as above. For as many right-hand sides
   * as A has columns this is half of the work. */
  bool
  invert_positive_definite(DenseMatrix &A);

  /**
   * LU factors of a square matrix with partial pivoting. Unless its scaling is to be kept, its rows
   * and columns are brought to one size before by powers of two: bars of any stiffness stand side
   * by side. The matrix is given away; reciprocal_condition() tells LAPACK's estimate in the 1-norm
   * for the matrix so scaled, 0 when a pivot vanished.
   */
  class LuFactors
  {
  public:
    enum class Scaling
    {
      equilibrated,
      /** Rows and columns have their natural size: one that is small against the others is zero but
       * for rounding. */
      as_given
    };

    explicit LuFactors(DenseMatrix &&matrix, const Scaling scaling = Scaling::equilibrated);

    double
    reciprocal_condition() const
    {
      return rcond;
    }

    /** Sign of det A; 0 if a pivot vanished. */
    int
    determinant_sign() const;

    /** Overwrites b by A⁻¹ b. */
    void
    solve(Vector &b) const;

    /** Overwrites B by A⁻¹ B. */
    void
    solve(DenseMatrix &B) const;

    /** Gives the inverse; the factors cannot be used afterwards. */
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

  /** The null vector, largest entry one, of a singular matrix to which rounding was added: inverse
   * iteration, three steps, enough for a motion that is to be shown. */
  Vector
  null_vector(DenseMatrix &&shifted);
} // namespace fuga

#endif
