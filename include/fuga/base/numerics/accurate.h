// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_accurate_h
#define fuga_base_numerics_accurate_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /** A vector in extended precision for residuals, with three digits more than double. */
  using Accurate = std::vector<long double>;

  inline Accurate
  accurate(const Vector &x)
  {
    return {x.begin(), x.end()};
  }

  /** Add a x to y, for n numbers; does nothing for a = 0. */
  template <typename Number>
  void
  add_scaled(const std::size_t n, const long double a, const Number *x, long double *y)
  {
    if (a != 0.L)
      for (std::size_t i = 0; i < n; ++i)
        y[i] += a * x[i];
  }

  /** Add a x to y. */
  inline void
  add_scaled(const long double a, const Accurate &x, Accurate &y)
  {
    add_scaled(x.size(), a, x.data(), y.data());
  }

  /** Add sign A x to y. */
  void
  add_product(const long double sign, const DenseMatrix &A, const Accurate &x, Accurate &y);

  long double
  dot(const Accurate &x, const Accurate &y);
} // namespace fuga

#endif
