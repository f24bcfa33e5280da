// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_system_updated_inverse_h
#define fuga_contact_system_updated_inverse_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /**
   * The explicit inverse of a small matrix that changes by one row and column at a time. An
   * insertion or removal costs O(n²); rebuild() starts afresh from LU factors.
   */
  class UpdatedInverse
  {
  public:
    std::size_t
    size() const
    {
      return n;
    }

    /** The size up to which the matrix can grow where it lies. */
    std::size_t
    capacity() const
    {
      return stride;
    }

    /** Makes room for a matrix of this size. */
    void
    reserve(const std::size_t new_size);

    /** Sign of the determinant of the matrix, kept through all changes. */
    int
    determinant_sign() const
    {
      return sign;
    }

    /** Entry of the inverse. On the diagonal: the determinant without row and column k over the
     * determinant with them. */
    double
    entry(const std::size_t i, const std::size_t j) const
    {
      return column(j)[i];
    }

    /** Pivot that append() would return. */
    double
    pivot_of(const Vector &column, const Vector &row, const double diagonal) const;

    /** The inverse of @p matrix. Returns false if it is singular to working precision. */
    bool
    rebuild(DenseMatrix &&matrix);

    /**
     * Appends a last row @p row, column @p column and diagonal entry @p diagonal. The pivot (Schur
     * complement of the new entry) is returned; if its size is not above @p smallest_pivot nothing is
     * changed.
     */
    double
    append(const Vector &column,
           const Vector &row,
           const double diagonal,
           const double smallest_pivot);

    /**
     * Removes row and column @p k; the last ones take its place. Returns false, having changed nothing,
     * if the remaining matrix is singular to working precision.
     */
    bool
    remove(const std::size_t k);

    /** x = M⁻¹ b. */
    Vector
    solve(const Vector &b) const;

    /** The same for all columns of B. */
    DenseMatrix
    solve(const DenseMatrix &B) const;

    /** x = M⁻ᵀ b. */
    Vector
    solve_transposed(const Vector &b) const;

  private:
    double *
    column(const std::size_t j)
    {
      return values.data() + j * stride;
    }

    const double *
    column(const std::size_t j) const
    {
      return values.data() + j * stride;
    }

    std::size_t n      = 0;
    std::size_t stride = 0;
    int sign           = 1;
    Vector values;
  };
} // namespace fuga

#endif
