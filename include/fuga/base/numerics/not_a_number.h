// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_not_a_number_h
#define fuga_base_numerics_not_a_number_h

#include <algorithm>
#include <cmath>

namespace fuga
{
  /** Return the larger of two errors. One that is not a number counts as larger than any number,
   * whereas std::max() may drop it. */
  inline double
  larger_error(const double a, const double b)
  {
    return std::isnan(a) || a >= b ? a : b;
  }

  /** Return whether all entries of a container are finite numbers. */
  template <typename Numbers>
  bool
  are_finite(const Numbers &numbers)
  {
    return std::all_of(
      numbers.begin(), numbers.end(), [](const double x) { return std::isfinite(x); });
  }
} // namespace fuga

#endif
