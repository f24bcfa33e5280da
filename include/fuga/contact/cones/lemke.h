// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_cones_lemke_h
#define fuga_contact_cones_lemke_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /** The way in which Lemke's method ended. */
  enum class LcpStatus
  {
    solved,
    /** A ray: no solution is reached from this covering vector. */
    ray,
    /** Too many pivots; the method is finite, but its number of pivots may grow as 2ⁿ. */
    undecided
  };

  struct LcpSolution
  {
    LcpStatus status = LcpStatus::undecided;
    /** z ≥ 0 with q + M z ≥ 0 complementary to it; on a ray, the direction of the ray. */
    Vector z;
    /** The point where the ray begins. If the artificial variable is zero there up to rounding,
     * this is the solution. */
    Vector vertex;

    bool
    solved() const
    {
      return status == LcpStatus::solved;
    }
  };

  /**
   * Solve the linear complementarity problem  z ≥ 0,  q + M z ≥ 0,  z·(q + M z) = 0  by Lemke's
   * method with the lexicographic ratio test (Cottle, Pang & Stone, The Linear Complementarity
   * Problem, 4.4 and 4.9). All rows of (q, basis inverse) are lexicographically positive from the
   * first pivot on, so that no basis comes back: the method is finite for every M and ends with a
   * solution or a ray. Each pivot costs O(n²). The diagonal of @p M should be of order one: ties
   * are recognised by rounding errors relative to that. @p covering is the positive vector that
   * multiplies the artificial variable.
   */
  LcpSolution
  solve_lcp(const DenseMatrix &M, const Vector &q, const Vector &covering);
} // namespace fuga

#endif
