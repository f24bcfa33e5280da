// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_lcp_search_h
#define fuga_base_numerics_lcp_search_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /**
   * Tolerances within which a point counts as a solution of a linear complementarity problem and
   * must not be ruled out.
   */
  struct LcpNoise
  {
    /** Amount by which an entry of q + M z may differ from zero or be below it. */
    Vector reserves;
    /**
     * The same amount for an entry of z, and what an entry of q + M z is allowed in addition: both
     * are given as multiples of a number that grows with all z from its value `at_rest` at z = 0 by
     * `growth` per unit of each.
     */
    Vector unknowns, shares;
    double at_rest = 0.;
    Vector growth;
    /** Upper bound of all entries of z. */
    double largest_unknown = 0.;
  };

  /** The outcome of a search through the complementary parts of an LCP. */
  enum class SearchEnd
  {
    /** A solution was found up to the rounding errors of the search; it has to be checked. */
    found,
    /** There is no solution within the noise: every part was ruled out by a proof. */
    none,
    /** The budget was used up, or rounding left a part without proof. */
    undecided
  };

  struct LcpSearch
  {
    SearchEnd end = SearchEnd::undecided;
    /** The solution, if one was found. */
    Vector z;
    /** Exchanges of a basic variable, O(n²) each. */
    std::size_t n_pivots = 0;
  };

  /**
   * Depth-first search for a solution of z ≥ 0, w = q + M z ≥ 0, z·w = 0. A part of the search is
   * given by pairs of which one variable is zero; all others only have to be nonnegative. If this
   * linear relaxation has a solution, the search branches on the pair that violates z·w = 0 most;
   * if it has none, a combination y of the equations proves it (Farkas' lemma): in yᵀw - yᵀM z =
   * yᵀq no term on the left can be negative, and the right-hand side is. The combination is formed
   * again from M and q and ends the part only if the right-hand side is further below zero than
   * @p noise may take the left. The search is complete if it ends. Work is counted in entries of
   * the tableau that change, at most @p most_work.
   */
  LcpSearch
  search_lcp(const DenseMatrix &M,
             const Vector &q,
             const LcpNoise &noise,
             const double most_work = 3e8);
} // namespace fuga

#endif
