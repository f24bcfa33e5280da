// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/disjoint_sets.h>
#include <fuga/base/errors.h>
#include <fuga/base/numerics/sparse_operator.h>
#include <fuga/base/work_counter.h>

#include <Eigen/QR>

#include <algorithm>

namespace fuga
{
  SparseOperator::SparseOperator(const std::size_t n_rows,
                                 const std::size_t n_columns,
                                 const std::vector<Entry> &all)
    : columns(n_columns)
  {
    std::vector<Entry> sorted = all;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Entry &a, const Entry &b) {
      return std::pair(a.row, a.column) < std::pair(b.row, b.column);
    });
    begin.assign(n_rows + 1, 0);
    for (std::size_t k = 0; k < sorted.size(); ++k)
      if (k > 0 && sorted[k].row == sorted[k - 1].row && sorted[k].column == sorted[k - 1].column)
        entries.back().second += sorted[k].factor;
      else
        {
          entries.emplace_back(sorted[k].column, sorted[k].factor);
          ++begin[sorted[k].row + 1];
        }
    for (std::size_t row = 0; row < n_rows; ++row)
      begin[row + 1] += begin[row];
  }

  Vector
  multiply(const SparseOperator &B, const Vector &x)
  {
    if (B.is_identity())
      return x;
    Vector y(B.n_rows(), 0.);
    for (std::size_t row = 0; row < y.size(); ++row)
      B.for_each_in_row(
        row, [&](const std::size_t column, const double factor) { y[row] += factor * x[column]; });
    return y;
  }

  Vector
  multiply_transposed(const SparseOperator &B, const Vector &x)
  {
    if (B.is_identity())
      return x;
    Vector y(B.n_columns(), 0.);
    for (std::size_t row = 0; row < x.size(); ++row)
      B.for_each_in_row(
        row, [&](const std::size_t column, const double factor) { y[column] += factor * x[row]; });
    return y;
  }

  void
  add_product(const long double sign, const SparseOperator &B, const Accurate &x, Accurate &y)
  {
    std::size_t n_operations = 0;
    for (std::size_t row = 0; row < y.size(); ++row)
      {
        long double sum = 0.L;
        B.for_each_in_row(row, [&](const std::size_t column, const double factor) {
          sum += factor * x[column];
          ++n_operations;
        });
        y[row] += sign * sum;
      }
    work::now().accurate_operations += n_operations;
  }

  void
  add_transposed_product(const long double sign,
                         const SparseOperator &B,
                         const Accurate &x,
                         Accurate &y)
  {
    std::size_t n_operations = 0;
    for (std::size_t row = 0; row < x.size(); ++row)
      B.for_each_in_row(row, [&](const std::size_t column, const double factor) {
        y[column] += sign * factor * x[row];
        ++n_operations;
      });
    work::now().accurate_operations += n_operations;
  }

  void
  add_congruent(const SparseOperator &B, const Vector &C, DenseMatrix &K)
  {
    for (std::size_t row = 0; row < C.size(); ++row)
      B.for_each_in_row(row, [&](const std::size_t i, const double left) {
        B.for_each_in_row(
          row, [&](const std::size_t j, const double right) { K(i, j) += left * C[row] * right; });
      });
  }

  DenseMatrix
  submatrix(const SparseOperator &B,
            const std::vector<std::size_t> &rows,
            const std::vector<std::size_t> &columns)
  {
    std::vector<std::size_t> place(B.n_columns(), columns.size());
    for (std::size_t j = 0; j < columns.size(); ++j)
      place[columns[j]] = j;
    DenseMatrix result(rows.size(), columns.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      B.for_each_in_row(rows[i], [&](const std::size_t column, const double factor) {
        if (place[column] < columns.size())
          result(i, place[column]) = factor;
      });
    return result;
  }

  std::vector<SparseBlock>
  blocks_of(const SparseOperator &B, const std::vector<bool> &chosen)
  {
    const auto counts = [&](const std::size_t row) { return chosen.empty() || chosen[row]; };
    DisjointSets sets(B.n_rows() + B.n_columns());
    for (std::size_t row = 0; row < B.n_rows(); ++row)
      if (counts(row))
        B.for_each_in_row(row, [&](const std::size_t column, double) {
          sets.unite(static_cast<unsigned int>(row),
                     static_cast<unsigned int>(B.n_rows() + column));
        });
    std::vector<unsigned int> numbers;
    std::vector<SparseBlock> all(sets.number(numbers)), result;
    for (std::size_t row = 0; row < B.n_rows(); ++row)
      if (counts(row))
        all[numbers[row]].rows.push_back(row);
    for (std::size_t column = 0; column < B.n_columns(); ++column)
      all[numbers[B.n_rows() + column]].columns.push_back(column);
    std::copy_if(all.begin(), all.end(), std::back_inserter(result), [](const SparseBlock &block) {
      return !block.rows.empty();
    });
    return result;
  }

  namespace
  {
    /** Return (w A)⁺ w of a dense block. */
    DenseMatrix
    weighted_inverse(const DenseMatrix &A, const Vector &weights)
    {
      const auto w = view(weights).asDiagonal();
      const Eigen::ColPivHouseholderQR<DenseMatrix> factors(w * A);
      if (factors.rank() < A.cols())
        throw NumericalFailure(
          "The jumps of the joints do not determine the motion of the bodies.");
      return factors.solve(DenseMatrix(w));
    }
  } // namespace

  SparseOperator
  dual_of(const SparseOperator &B, const Vector &weights)
  {
    if (B.is_identity())
      return {};
    std::vector<SparseOperator::Entry> entries;
    for (const SparseBlock &block : blocks_of(B))
      {
        Vector of_block;
        for (const std::size_t row : block.rows)
          of_block.push_back(weights.empty() ? 1. : weights[row]);
        const DenseMatrix inverse =
          weighted_inverse(submatrix(B, block.rows, block.columns), of_block);
        for (std::size_t i = 0; i < block.rows.size(); ++i)
          for (std::size_t j = 0; j < block.columns.size(); ++j)
            entries.push_back({static_cast<unsigned int>(block.rows[i]),
                               static_cast<unsigned int>(block.columns[j]),
                               inverse(j, i)});
      }
    return {B.n_rows(), B.n_columns(), entries};
  }
} // namespace fuga
