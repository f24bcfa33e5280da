// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_sparse_operator_h
#define fuga_base_numerics_sparse_operator_h

#include <fuga/base/numerics/accurate.h>

#include <utility>

namespace fuga
{
  /** A matrix with a few entries in every row, or the identity of any size. */
  class SparseOperator
  {
  public:
    struct Entry
    {
      unsigned int row, column;
      double factor;
    };

    /** The identity. */
    SparseOperator() = default;

    /** Factors of the same place are added. */
    SparseOperator(const std::size_t n_rows,
                   const std::size_t n_columns,
                   const std::vector<Entry> &entries);

    bool
    is_identity() const
    {
      return begin.empty();
    }

    /** 0 of the identity, whose size is that of what it is applied to. */
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

    /** Calls @p action(column, factor) for the entries of a row, by increasing columns. */
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
    /** Column and factor, row by row. */
    std::vector<std::pair<std::size_t, double>> entries;
    /** Where in `entries` each row begins, and the last one ends. */
    std::vector<std::size_t> begin;
  };

  /** y = B x. */
  Vector
  multiply(const SparseOperator &B, const Vector &x);

  /** y = Bᵀ x. */
  Vector
  multiply_transposed(const SparseOperator &B, const Vector &x);

  /** y += sign B x. */
  void
  add_product(const long double sign, const SparseOperator &B, const Accurate &x, Accurate &y);

  /** y += sign Bᵀ x. */
  void
  add_transposed_product(const long double sign,
                         const SparseOperator &B,
                         const Accurate &x,
                         Accurate &y);

  /** K += Bᵀ C B with a diagonal matrix C. */
  void
  add_congruent(const SparseOperator &B, const Vector &C, DenseMatrix &K);

  /** Some rows and columns of B, which is not the identity. */
  DenseMatrix
  submatrix(const SparseOperator &B,
            const std::vector<std::size_t> &rows,
            const std::vector<std::size_t> &columns);

  /** Rows that hang together by common columns, and these columns. */
  struct SparseBlock
  {
    std::vector<std::size_t> rows, columns;
  };

  /** The blocks of B, which is not the identity, by their first rows; only those rows count that
   * are @p chosen (empty: all). */
  std::vector<SparseBlock>
  blocks_of(const SparseOperator &B, const std::vector<bool> &chosen = {});

  /**
   * D with Dᵀ B = 1: Dᵀ δ is the solution x of B x = δ by least squares, with the @p weights of its
   * rows (empty: one each), and D q forces p with Bᵀ p = q. D has entries only in the blocks of B.
   * @throws NumericalFailure if B x = 0 does not need x = 0.
   */
  SparseOperator
  dual_of(const SparseOperator &B, const Vector &weights = {});
} // namespace fuga

#endif
