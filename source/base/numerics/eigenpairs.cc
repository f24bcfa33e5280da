// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/numerics/eigenpairs.h>
#include <fuga/base/work_counter.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <lapacke.h>

extern "C"
{
  void
  dsaupd_(int *ido,
          const char *bmat,
          const int *n,
          const char *which,
          const int *nev,
          double *tolerance,
          double *residual,
          const int *ncv,
          double *basis,
          const int *ldv,
          int *iparam,
          int *ipntr,
          double *workd,
          double *workl,
          const int *lworkl,
          int *info);
  void
  dseupd_(const int *wants_vectors,
          const char *how_many,
          int *select,
          double *values,
          double *vectors,
          const int *ldz,
          const double *sigma,
          const char *bmat,
          const int *n,
          const char *which,
          const int *nev,
          double *tolerance,
          double *residual,
          const int *ncv,
          double *basis,
          const int *ldv,
          int *iparam,
          int *ipntr,
          double *workd,
          double *workl,
          const int *lworkl,
          int *info);
}

namespace fuga
{
  namespace
  {
    /** LAPACK and ARPACK order by increasing values. */
    void
    put_largest_first(Eigenpairs &pairs)
    {
      std::reverse(pairs.values.begin(), pairs.values.end());
      pairs.vectors = pairs.vectors.rowwise().reverse().eval();
    }

    /** Return a vector that is orthogonal to no eigenvector: the fractional parts of multiples of
     * the golden ratio. */
    Vector
    without_symmetry(const std::size_t n)
    {
      Vector result(n);
      for (std::size_t i = 0; i < n; ++i)
        result[i] = std::fmod(0.6180339887498949 * static_cast<double>(i + 1), 1.);
      return result;
    }
  } // namespace


  Eigenpairs
  eigenpairs(DenseMatrix A)
  {
    Eigenpairs result;
    const auto n = static_cast<lapack_int>(A.rows());
    result.values.resize(A.rows());
    if (n > 0 &&
        LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'U', n, A.data(), n, result.values.data()) != 0)
      throw NumericalFailure("The eigenvalues of a symmetric matrix were not found (LAPACK).");
    result.vectors = std::move(A);
    put_largest_first(result);
    return result;
  }


  Eigenpairs
  largest_eigenpairs(const std::size_t n,
                     const std::size_t count,
                     const std::function<Vector(const Vector &)> &product)
  {
    constexpr int most_restarts = 1000;
    const int order = static_cast<int>(n), nev = static_cast<int>(count);
    const int ncv = std::min(order, 2 * nev + 20), lworkl = ncv * (ncv + 8);
    DenseMatrix basis(n, static_cast<std::size_t>(ncv));
    Vector residual = without_symmetry(n), workd(3 * n), workl(static_cast<std::size_t>(lworkl));
    int ido = 0, info = 1, ipntr[11] = {}; // the iteration begins with the residual as it is
    int iparam[11]   = {1, 0, most_restarts, 1, 0, 0, 1, 0, 0, 0, 0};
    double tolerance = 0.; // rounding
    for (;;)
      {
        dsaupd_(&ido,
                "I",
                &order,
                "LA",
                &nev,
                &tolerance,
                residual.data(),
                &ncv,
                basis.data(),
                &order,
                iparam,
                ipntr,
                workd.data(),
                workl.data(),
                &lworkl,
                &info);
        if (ido != 1 && ido != -1)
          break;
        const double *const x = workd.data() + ipntr[0] - 1;
        const Vector y        = product({x, x + n});
        std::copy(y.begin(), y.end(), workd.begin() + ipntr[1] - 1);
        work::now().dense_operations += 2 * n * static_cast<std::size_t>(ncv);
      }
    Eigenpairs result;
    result.values.resize(count);
    result.vectors          = DenseMatrix(n, count);
    const int wants_vectors = 1;
    const double sigma      = 0.;
    std::vector<int> select(static_cast<std::size_t>(ncv));
    if (info == 0)
      dseupd_(&wants_vectors,
              "A",
              select.data(),
              result.values.data(),
              result.vectors.data(),
              &order,
              &sigma,
              "I",
              &order,
              "LA",
              &nev,
              &tolerance,
              residual.data(),
              &ncv,
              basis.data(),
              &order,
              iparam,
              ipntr,
              workd.data(),
              workl.data(),
              &lworkl,
              &info);
    if (info != 0 || iparam[4] < nev)
      throw NumericalFailure(fmt::format(
        "ARPACK found {} of {} eigenvalues (INFO = {}).", std::max(iparam[4], 0), nev, info));
    put_largest_first(result);
    return result;
  }
} // namespace fuga
