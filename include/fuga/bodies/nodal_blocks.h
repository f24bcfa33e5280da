// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_nodal_blocks_h
#define fuga_bodies_nodal_blocks_h

#include <fuga/bodies/interface_coordinates.h>

namespace fuga
{
  /**
   * The eliminated coordinates in blocks of one node each, as algebraic multigrid for elasticity
   * wants them, with the rigid motions of the bonded structure. Blocks that a support has made
   * incomplete are filled up with rows that are no coordinate.
   */
  struct NodalBlocks
  {
    /** Rows of a block: components of a displacement. */
    unsigned int block_size = 1;
    unsigned int n_rows     = 0;
    /** Of every eliminated coordinate. */
    std::vector<int> rows;
    /** n_rows x (3 in the plane, 6 in space). */
    DenseMatrix rigid_motions;
  };

  template <int dim>
  NodalBlocks
  nodal_blocks(const Discretization<dim> &discretization,
               const InterfaceCoordinates<dim> &coordinates);
} // namespace fuga

#endif
