// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_base_numerics_lcp_search_h
#define fuga_base_numerics_lcp_search_h

#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /** What counts as a solution of a linear complementarity problem, and is not to be ruled out. */
  struct LcpNoise
  {
    /** By which an entry of q + M z may be off zero or below it. */
    Vector reserves;
    /** The same for an entry of z, and what an entry of q + M z is allowed besides: their parts of
     * a number that grows with all z from what it is at z = 0, by `growth` per unit of each. */
    Vector unknowns, shares;
    double at_rest = 0.;
    Vector growth;
    /** No entry of z is larger. */
    double largest_unknown = 0.;
  };

  /** How a search through the complementary parts of an LCP ended. */
  enum class SearchEnd
  {
    /** Solved, but for rounding errors of the search: to be checked. */
    found,
    /** There is no solution within the noise: every part was ruled out by a proof. */
    none,
    /** The budget was used up, or rounding left a part without proof. */
    undecided
  };

  struct LcpSearch
  {
    SearchEnd end = SearchEnd::undecided;
    /** If found. */
    Vector z;
    /** Exchanges of a basic variable, O(n²) each. */
    std::size_t n_pivots = 0;
  };

  /**
   * Depth-first search for a solution of  z ≥ 0,  w = q + M z ≥ 0,  z·w = 0. A part of it is given
   * by pairs of which one variable is zero; all others only have to be nonnegative. Where this
   * linear relaxation has a solution, the pair that violates z·w = 0 most is divided; where it has
   * none, a combination y of the equations says so (Farkas' lemma): in yᵀw - yᵀM z = yᵀq no term on
   * the left can be negative, and the right is. It is formed anew from M and q and ends the part
   * only if the right is further below zero than @p noise may take the left. The search is complete
   * if it ends. Work is counted in entries of the tableau that change, at most @p most_work.
   */
  LcpSearch
  search_lcp(const DenseMatrix &M,
             const Vector &q,
             const LcpNoise &noise,
             const double most_work = 3e8);
} // namespace fuga

#endif
