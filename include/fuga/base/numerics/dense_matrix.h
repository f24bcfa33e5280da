// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_dense_matrix_h
#define fuga_base_numerics_dense_matrix_h

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fuga
{
  using Vector = std::vector<double>;

  /** A dense matrix, stored by columns; its entries are zero at first. */
  using DenseMatrix = Eigen::MatrixXd;

  /** A column, and a matrix or a block of one, as arguments. */
  using ConstVectorView = Eigen::Ref<const Eigen::VectorXd>;
  using ConstMatrixView = Eigen::Ref<const Eigen::MatrixXd>;

  /** See the numbers of a vector as Eigen does. */
  inline Eigen::Map<const Eigen::VectorXd>
  view(const Vector &x)
  {
    return {x.data(), static_cast<Eigen::Index>(x.size())};
  }

  inline Eigen::Map<Eigen::VectorXd>
  view(Vector &x)
  {
    return {x.data(), static_cast<Eigen::Index>(x.size())};
  }

  /** Return the numbers of a column, or of another expression of Eigen. */
  template <typename Derived>
  Vector
  to_vector(const Eigen::MatrixBase<Derived> &x)
  {
    Vector result(static_cast<std::size_t>(x.size()));
    view(result) = x;
    return result;
  }

  /** Return A x. */
  Vector
  multiply(const ConstMatrixView &A, const Vector &x);

  /** Return A x for a symmetric A, of which the upper triangle is read. */
  Vector
  multiply_symmetric(const DenseMatrix &A, const Vector &x);

  /** Return Aᵀ x. */
  Vector
  multiply_transposed(const ConstMatrixView &A, const Vector &x);

  /** Return A B. */
  DenseMatrix
  multiply(const ConstMatrixView &A, const DenseMatrix &B);

  /** Return Aᵀ B. */
  DenseMatrix
  multiply_transposed(const ConstMatrixView &A, const DenseMatrix &B);

  inline double
  dot(const Vector &x, const Vector &y)
  {
    return view(x).dot(view(y));
  }

  /** Add factor x to y, for as many entries as x has. */
  void
  add_multiple(const double factor, const Vector &x, Vector &y);

  /** Return origin + τ rates; entries of @p origin beyond the end of @p rates remain unchanged. */
  Vector
  along(Vector origin, const double tau, const Vector &rates);

  /** Return the largest absolute value, 0 for an empty vector. */
  double
  max_abs(const Vector &x);

  /** Return the largest absolute value of an entry that is a number, 0 if there is none. */
  template <typename Derived>
  double
  max_abs(const Eigen::MatrixBase<Derived> &A)
  {
    return A.size() == 0 ? 0.
                         : std::max(0., A.cwiseAbs().template maxCoeff<Eigen::PropagateNumbers>());
  }

  /** Return the largest diagonal entry, 0 if none is positive. */
  inline double
  largest_diagonal(const DenseMatrix &A)
  {
    return A.size() == 0 ? 0. : std::max(0., A.diagonal().maxCoeff<Eigen::PropagateNumbers>());
  }

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
