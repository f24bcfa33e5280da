// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_nodal_blocks_h
#define fuga_bodies_solvers_nodal_blocks_h

#include <fuga/bodies/joints/interface_coordinates.h>

namespace fuga
{
  /**
   * The eliminated coordinates in blocks of one node each, as algebraic multigrid for elasticity
   * wants them, with the rigid motions of the bonded structure. Blocks that a support has made
   * incomplete are filled up with rows that are no coordinate. The rows of one process follow each
   * other; a node belongs to the first of the processes that have a cell at it.
   */
  struct NodalBlocks
  {
    /** Rows of a block: components of a displacement. */
    unsigned int block_size = 1;
    /** The first row of every process, and the number of all rows. */
    std::vector<int> first_rows;
    /** Of every eliminated coordinate. */
    std::vector<int> rows;
    /** Own rows x (3 in the plane, 6 in space). */
    DenseMatrix rigid_motions;

    int
    n_rows() const
    {
      return first_rows.back();
    }

    int
    n_own_rows() const;

    /** Place of a row among the own ones; of others the result is no place: negative or too large.
     */
    int
    own_place(const int row) const;
  };

  template <int dim>
  NodalBlocks
  nodal_blocks(const Discretization<dim> &discretization,
               const InterfaceCoordinates<dim> &coordinates);
} // namespace fuga

#endif
