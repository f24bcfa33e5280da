// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_system_updated_inverse_h
#define fuga_contact_system_updated_inverse_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /**
   * The explicit inverse of a small matrix that changes by one row and column at a time. An
   * insertion or removal costs O(n²); rebuild() starts again from LU factors.
   */
  class UpdatedInverse
  {
  public:
    std::size_t
    size() const
    {
      return static_cast<std::size_t>(n);
    }

    /** Return the size up to which the matrix can grow without reallocation. */
    std::size_t
    capacity() const
    {
      return static_cast<std::size_t>(values.rows());
    }

    /** Reserve space for a matrix of this size. */
    void
    reserve(const std::size_t new_size);

    /** Return the sign of the determinant of the matrix, which is kept through all changes. */
    int
    determinant_sign() const
    {
      return sign;
    }

    /** Return an entry of the inverse. On the diagonal it is the determinant without row and column
     * k divided by the determinant with them. */
    double
    entry(const std::size_t i, const std::size_t j) const
    {
      return values(i, j);
    }

    /** Return the pivot that append() would return. */
    double
    pivot_of(const Vector &column, const Vector &row, const double diagonal) const;

    /** Compute the inverse of @p matrix. Return false if it is singular to working precision. */
    bool
    rebuild(DenseMatrix &&matrix);

    /**
     * Append a last row @p row, column @p column and diagonal entry @p diagonal. Return the pivot
     * (Schur complement of the new entry); if its size is not above @p smallest_pivot nothing is
     * changed.
     */
    double
    append(const Vector &column,
           const Vector &row,
           const double diagonal,
           const double smallest_pivot);

    /**
     * Remove row and column @p k; the last ones take their place. Return false, having changed
     * nothing, if the remaining matrix is singular to working precision.
     */
    bool
    remove(const std::size_t k);

    /** Return x = M⁻¹ b. */
    Vector
    solve(const Vector &b) const;

    /** Return M⁻¹ B, i.e. the solution for all columns of B. */
    DenseMatrix
    solve(const DenseMatrix &B) const;

    /** Return x = M⁻ᵀ b. */
    Vector
    solve_transposed(const Vector &b) const;

  private:
    Eigen::Block<DenseMatrix>
    inverse()
    {
      return values.topLeftCorner(n, n);
    }

    Eigen::Block<const DenseMatrix>
    inverse() const
    {
      return values.topLeftCorner(n, n);
    }

    /** Exchange two rows and columns. */
    void
    exchange(const Eigen::Index k, const Eigen::Index l);

    Eigen::Index n = 0;
    int sign       = 1;
    DenseMatrix values;
  };
} // namespace fuga

#endif
