// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_lemke_h
#define fuga_tests_judges_lemke_h

#include <fuga/base/numerics/dense_matrix.h>

#include <string>

namespace fuga::judges
{
  /** How Lemke's method ended. */
  enum class LemkeStatus
  {
    solution,
    ray,
    /** Only rounding can cause it. */
    pivot_limit
  };

  /** The end of Lemke's method for  w = M z + q,  w, z ≥ 0,  wᵀz = 0. */
  struct LemkeResult
  {
    LemkeStatus status = LemkeStatus::pivot_limit;
    /** The solution, or the end point of the ray (there w = M z + d z0 + q). */
    Vector w, z;
    double z0 = 0.;
    /**
     * Direction of the secondary ray, empty unless status is ray: ray_w = M ray_z + d ray_z0, all
     * nonnegative, ray_wᵀ ray_z = 0; not zero.
     */
    Vector ray_w, ray_z;
    double ray_z0        = 0.;
    std::size_t n_pivots = 0;
  };

  /**
   * Lexicographic Lemke: complementary pivoting from the ray z = 0, z0 large, with the covering
   * vector @p d > 0 (empty: ones). Ties of the ratio test are broken by the rows of the basis
   * inverse, so no basis can come back: it ends finitely, with a solution or a ray. A ray proves
   * that there is no solution only for certain classes of M (copositive-plus, P, ...). The final
   * basis is solved again from M and q, so the rounding of the pivots does not stay in the answer.
   *
   * Siconos 4.4 cannot judge here: its lexicographic Lemke reports success at the end of a ray, and
   * it ends there where many ratio tests tie and a solution exists (Lemke.SymmetricBoundarySets).
   */
  LemkeResult
  lemke(const DenseMatrix &M, const Vector &q, const Vector &d = Vector());

  /** The largest violation of w = Mz + q, w ≥ 0, z ≥ 0, wᵢzᵢ = 0 (absolute). */
  double
  lcp_residual(const DenseMatrix &M, const Vector &q, const Vector &w, const Vector &z);
} // namespace fuga::judges

#endif
