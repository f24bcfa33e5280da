// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_condensed_blocks_of_bars_h
#define fuga_bodies_condensed_blocks_of_bars_h

#include <fuga/base/numerics/sparse_operator.h>
#include <fuga/bodies/solvers/iterative_solver.h>
#include <fuga/contact/contact_element.h>
#include <fuga/contact/system/tangent_solver.h>

#include <vector>

namespace fuga
{
  /** Return the contribution of the bars of single elements to S, Bᵀ C B, by blocks of coordinates
   * that elements have in common. */
  std::vector<BlockOfCoordinates>
  blocks_of_bars(const std::vector<ContactElement> &elements,
                 const std::vector<ElementStiffness> &stiffness,
                 const SparseOperator &B,
                 const std::size_t n_coordinates);
} // namespace fuga

#endif
