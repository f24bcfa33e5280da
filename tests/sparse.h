// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_sparse_h
#define fuga_tests_sparse_h

#include <fuga/base/numerics/sparse_operator.h>

namespace fuga::tests
{
  /** A jump operator from all of its numbers; an empty matrix stands for the identity. */
  inline SparseOperator
  sparse(const DenseMatrix &B)
  {
    if (B.size() == 0)
      return {};
    std::vector<SparseOperator::Entry> entries;
    for (unsigned int i = 0; i < B.rows(); ++i)
      for (unsigned int j = 0; j < B.cols(); ++j)
        if (B(i, j) != 0.)
          entries.push_back({i, j, B(i, j)});
    return {static_cast<std::size_t>(B.rows()), static_cast<std::size_t>(B.cols()), entries};
  }

  /** The opposite. */
  inline DenseMatrix
  dense(const SparseOperator &B)
  {
    DenseMatrix result(B.n_rows(), B.n_columns());
    for (std::size_t i = 0; i < B.n_rows(); ++i)
      B.for_each_in_row(i,
                        [&](const std::size_t j, const double factor) { result(i, j) = factor; });
    return result;
  }
} // namespace fuga::tests

#endif
