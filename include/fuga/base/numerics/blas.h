// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_blas_h
#define fuga_base_numerics_blas_h

#include <fuga/base/work_counter.h>

#include <cstddef>

// We use the Fortran names of BLAS instead of cblas_*: deal.II links to the GNU Scientific Library,
// whose slow reference versions of the latter are found first by the dynamic linker.
extern "C"
{
  void
  daxpy_(
    const int *n, const double *a, const double *x, const int *incx, double *y, const int *incy);
  double
  ddot_(const int *n, const double *x, const int *incx, const double *y, const int *incy);
  void
  dgemv_(const char *transpose,
         const int *m,
         const int *n,
         const double *alpha,
         const double *A,
         const int *lda,
         const double *x,
         const int *incx,
         const double *beta,
         double *y,
         const int *incy);
  void
  dsymv_(const char *triangle,
         const int *n,
         const double *alpha,
         const double *A,
         const int *lda,
         const double *x,
         const int *incx,
         const double *beta,
         double *y,
         const int *incy);
  void
  dger_(const int *m,
        const int *n,
        const double *alpha,
        const double *x,
        const int *incx,
        const double *y,
        const int *incy,
        double *A,
        const int *lda);
  void
  dgemm_(const char *transpose_A,
         const char *transpose_B,
         const int *m,
         const int *n,
         const int *k,
         const double *alpha,
         const double *A,
         const int *lda,
         const double *B,
         const int *ldb,
         const double *beta,
         double *C,
         const int *ldc);
}

namespace fuga
{
  /**
   * Thin wrappers of BLAS. Matrices are stored by columns with leading dimension lda, vectors
   * contiguously.
   */
  namespace blas
  {
    inline int
    to_int(const std::size_t n)
    {
      return static_cast<int>(n);
    }

    /** Compute y += a x. */
    inline void
    axpy(const std::size_t n, const double a, const double *x, double *y)
    {
      work::now().dense_operations += n;
      const int size = to_int(n), one = 1;
      daxpy_(&size, &a, x, &one, y, &one);
    }

    inline double
    dot(const std::size_t n, const double *x, const double *y)
    {
      work::now().dense_operations += n;
      const int size = to_int(n), one = 1;
      return ddot_(&size, x, &one, y, &one);
    }

    /** Compute y = op(A) x with op = 'N' or 'T', where A is m x n. */
    inline void
    gemv(const char op,
         const std::size_t m,
         const std::size_t n,
         const double *A,
         const std::size_t lda,
         const double *x,
         double *y)
    {
      work::now().dense_operations += m * n;
      const int rows = to_int(m), columns = to_int(n), stride = to_int(lda), unit = 1;
      const double one = 1., zero = 0.;
      dgemv_(&op, &rows, &columns, &one, A, &stride, x, &unit, &zero, y, &unit);
    }

    /**
     * Compute y = A x for a symmetric A of order n, of which the upper triangle is read: with the
     * lower one, OpenBLAS's kernels for old processors read 16 bytes past the end of y, also in
     * LAPACK's eigenvalue solvers (version 0.3.21).
     */
    inline void
    symv(const std::size_t n, const double *A, const std::size_t lda, const double *x, double *y)
    {
      work::now().dense_operations += n * n;
      const int order = to_int(n), stride = to_int(lda), unit = 1;
      const char upper = 'U';
      const double one = 1., zero = 0.;
      dsymv_(&upper, &order, &one, A, &stride, x, &unit, &zero, y, &unit);
    }

    /** Compute A += alpha x yᵀ. */
    inline void
    ger(const std::size_t m,
        const std::size_t n,
        const double alpha,
        const double *x,
        const double *y,
        double *A,
        const std::size_t lda)
    {
      work::now().dense_operations += m * n;
      const int rows = to_int(m), columns = to_int(n), stride = to_int(lda), unit = 1;
      dger_(&rows, &columns, &alpha, x, &unit, y, &unit, A, &stride);
    }

    /** Compute C = op(A) B, where C is m x n and the inner dimension is k. */
    inline void
    gemm(const char op,
         const std::size_t m,
         const std::size_t n,
         const std::size_t k,
         const double *A,
         const std::size_t lda,
         const double *B,
         const std::size_t ldb,
         double *C,
         const std::size_t ldc)
    {
      work::now().dense_operations += m * n * k;
      const int rows = to_int(m), columns = to_int(n), inner = to_int(k);
      const int stride_A = to_int(lda), stride_B = to_int(ldb), stride_C = to_int(ldc);
      const char plain = 'N';
      const double one = 1., zero = 0.;
      dgemm_(&op,
             &plain,
             &rows,
             &columns,
             &inner,
             &one,
             A,
             &stride_A,
             B,
             &stride_B,
             &zero,
             C,
             &stride_C);
    }
  } // namespace blas
} // namespace fuga

#endif
