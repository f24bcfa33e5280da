// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/numerics/accurate.h>
#include <fuga/base/work_counter.h>

#include <cmath>
#include <numeric>

// Error-free products take one more instruction where the processor multiplies and adds with a
// single rounding (on x86-64 all but the oldest); the functions below are then compiled for it,
// whatever the rest of the program is compiled for.
#if defined(__x86_64__) && defined(__GNUC__)
#  define FUGA_FUSED __attribute__((target("avx2,fma")))
#else
#  define FUGA_FUSED
#endif

namespace fuga
{
  namespace
  {
    bool
    is_fused()
    {
#if defined(__x86_64__) && defined(__GNUC__)
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#elif defined(FP_FAST_FMA)
      return true;
#else
      return false;
#endif
    }

    /** Compute high + low += (a + a_low) x for n numbers, with every operation except for those on
     * low free of errors (Dekker's and Knuth's transformations). This gives twice the digits of
     * double, and, unlike long double, several numbers at a time. */
    FUGA_FUSED void
    add_scaled_in_pairs(const std::size_t n,
                        const double a,
                        const double a_low,
                        const double *__restrict x,
                        double *__restrict high,
                        double *__restrict low)
    {
      for (std::size_t i = 0; i < n; ++i)
        {
          const double product = a * x[i];
          const double rest    = __builtin_fma(a, x[i], -product);
          const double sum     = high[i] + product;
          const double part    = sum - high[i];
          const double lost    = (high[i] - (sum - part)) + (product - part);
          high[i]              = sum;
          low[i] += lost + __builtin_fma(a_low, x[i], rest);
        }
    }
  } // namespace

  void
  add_product(const long double sign, const DenseMatrix &A, const Accurate &x, Accurate &y)
  {
    work::now().accurate_operations += A.rows() * A.cols();
    static const bool fused = is_fused();
    if (!fused)
      {
        for (Eigen::Index j = 0; j < A.cols(); ++j)
          add_scaled(A.rows(), sign * x[j], A.col(j).data(), y.data());
        return;
      }
    Vector high(A.rows(), 0.), low(A.rows(), 0.);
    for (Eigen::Index j = 0; j < A.cols(); ++j)
      {
        const long double a     = sign * x[j];
        const double a_high     = static_cast<double>(a);
        const long double a_low = a - a_high;
        if (a != 0.L)
          add_scaled_in_pairs(
            A.rows(), a_high, static_cast<double>(a_low), A.col(j).data(), high.data(), low.data());
      }
    for (std::size_t i = 0; i < high.size(); ++i)
      y[i] += static_cast<long double>(high[i]) + low[i];
  }

  long double
  dot(const Accurate &x, const Accurate &y)
  {
    return std::inner_product(x.begin(), x.end(), y.begin(), 0.L);
  }
} // namespace fuga
