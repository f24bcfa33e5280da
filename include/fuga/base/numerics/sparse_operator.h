// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_sparse_operator_h
#define fuga_base_numerics_sparse_operator_h

#include <fuga/base/numerics/accurate.h>

#include <utility>

namespace fuga
{
  /** A matrix with a few entries in every row, or the identity, of any size. */
  class SparseOperator
  {
  public:
    struct Entry
    {
      unsigned int row, column;
      double factor;
    };

    /** Create the identity. */
    SparseOperator() = default;

    /** Create a matrix from its entries; factors of entries at the same place are added. */
    SparseOperator(const std::size_t n_rows,
                   const std::size_t n_columns,
                   const std::vector<Entry> &entries);

    bool
    is_identity() const
    {
      return begin.empty();
    }

    /** Return the number of rows; 0 for the identity, whose size is that of its operand. */
    std::size_t
    n_rows() const
    {
      return is_identity() ? 0 : begin.size() - 1;
    }

    std::size_t
    n_columns() const
    {
      return columns;
    }

    /**
     * Call @p action(column, factor) for the entries of a row, in the order of increasing columns.
     */
    template <typename Action>
    void
    for_each_in_row(const std::size_t row, const Action &action) const
    {
      if (is_identity())
        action(row, 1.);
      else
        for (std::size_t k = begin[row]; k < begin[row + 1]; ++k)
          action(entries[k].first, entries[k].second);
    }

  private:
    std::size_t columns = 0;
    /** Column and factor of all entries, row by row. */
    std::vector<std::pair<std::size_t, double>> entries;
    /** Positions in `entries` where each row begins, and where the last one ends. */
    std::vector<std::size_t> begin;
  };

  /** Return B x. */
  Vector
  multiply(const SparseOperator &B, const Vector &x);

  /** Return Bᵀ x. */
  Vector
  multiply_transposed(const SparseOperator &B, const Vector &x);

  /** Add sign B x to y. */
  void
  add_product(const long double sign, const SparseOperator &B, const Accurate &x, Accurate &y);

  /** Add sign Bᵀ x to y. */
  void
  add_transposed_product(const long double sign,
                         const SparseOperator &B,
                         const Accurate &x,
                         Accurate &y);

  /** Add Bᵀ C B to K, with a diagonal matrix C. */
  void
  add_congruent(const SparseOperator &B, const Vector &C, DenseMatrix &K);

  /** Return the submatrix of B, which is not the identity, with the given rows and columns. */
  DenseMatrix
  submatrix(const SparseOperator &B,
            const std::vector<std::size_t> &rows,
            const std::vector<std::size_t> &columns);

  /** Rows that are connected by common columns, together with these columns. */
  struct SparseBlock
  {
    std::vector<std::size_t> rows, columns;
  };

  /**
   * Return the blocks of B, which is not the identity, ordered by their first rows; only the rows
   * in @p chosen count (empty: all).
   */
  std::vector<SparseBlock>
  blocks_of(const SparseOperator &B, const std::vector<bool> &chosen = {});

  /**
   * Return D with Dᵀ B = 1: Dᵀ δ is the least-squares solution x of B x = δ with the @p weights of
   * its rows (empty: all one), and D q are forces p with Bᵀ p = q. D has entries only in the blocks
   * of B.
   * @throws NumericalFailure if B x = 0 does not imply x = 0.
   */
  SparseOperator
  dual_of(const SparseOperator &B, const Vector &weights = {});
} // namespace fuga

#endif
