// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_lemke_h
#define fuga_contact_lemke_h

#include <fuga/base/dense_matrix.h>

namespace fuga
{
  /** Result of Lemke's method. */
  struct LcpSolution
  {
    /** False: the method ended on a ray. */
    bool solved = false;
    /** z ≥ 0 with q + M z ≥ 0 complementary to it; on a ray the direction of the ray. */
    Vector z;
  };

  /**
   * Linear complementarity problem  z ≥ 0,  q + M z ≥ 0,  z·(q + M z) = 0  by Lemke's method with
   * the lexicographic ratio test (Cottle, Pang & Stone, The Linear Complementarity Problem, 4.4
   * and 4.9):
   * finite for every M, a solution or a ray. O(n²) per pivot. @p covering: the positive vector that
   * multiplies the artificial variable.
   */
  LcpSolution
  solve_lcp(const DenseMatrix &M, const Vector &q, const Vector &covering);
} // namespace fuga

#endif
