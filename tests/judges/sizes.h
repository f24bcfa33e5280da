// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_sizes_h
#define fuga_tests_judges_sizes_h

#include <fuga/base/numerics/dense_matrix.h>

#include <algorithm>
#include <cmath>

namespace fuga::judges
{
  /** The largest absolute value. */
  inline double
  largest(const Vector &v)
  {
    double result = 0.;
    for (const double entry : v)
      result = std::max(result, std::abs(entry));
    return result;
  }

  /** Euclid's. */
  inline double
  norm(const Vector &v)
  {
    double sum = 0.;
    for (const double entry : v)
      sum += entry * entry;
    return std::sqrt(sum);
  }
} // namespace fuga::judges

#endif
