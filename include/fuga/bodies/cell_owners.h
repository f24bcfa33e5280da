// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_cell_owners_h
#define fuga_bodies_cell_owners_h

#include <fuga/bodies/discretization.h>

namespace fuga
{
  /**
   * Divides the cells among processes: by METIS through deal.II, in parts of equal size that touch
   * along few faces. The same on all processes, which have to call alike.
   */
  template <int dim>
  std::vector<unsigned int>
  cell_owners(const Discretization<dim> &discretization, const unsigned int n_processes);
} // namespace fuga

#endif
