// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_dependent_rows_h
#define fuga_base_numerics_dependent_rows_h

#include <fuga/base/numerics/dense_matrix.h>

#include <vector>

namespace fuga
{
  /**
   * Return, for every row of A, whether it is part of a linear combination of rows that vanishes.
   * @throws NumericalFailure
   */
  std::vector<bool>
  dependent_rows(const DenseMatrix &A);
} // namespace fuga

#endif
