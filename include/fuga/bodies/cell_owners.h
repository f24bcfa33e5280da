// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_cell_owners_h
#define fuga_bodies_cell_owners_h

#include <fuga/bodies/discretization.h>

namespace fuga
{
  /**
   * Divides the cells among processes, in parts of equal size: across the longest side of the box
   * around their first corners, again and again, as elimination_order() does with the nodes.
   */
  template <int dim>
  std::vector<unsigned int>
  cell_owners(const Discretization<dim> &discretization, const unsigned int n_processes);
} // namespace fuga

#endif
