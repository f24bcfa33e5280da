// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_solvers_nodal_blocks_h
#define fuga_bodies_solvers_nodal_blocks_h

#include <fuga/bodies/joints/interface_coordinates.h>

namespace fuga
{
  /**
   * The eliminated coordinates in blocks of one node each, as required by algebraic multigrid for
   * elasticity, with the rigid motions of the bonded structure. Blocks that are incomplete because
   * of a support are filled up with rows that are not coordinates. The rows of one process are
   * contiguous; a node belongs to the first of the processes that have a cell at it.
   */
  struct NodalBlocks
  {
    /** Number of rows of a block: components of a displacement. */
    unsigned int block_size = 1;
    /** The first row of every process, followed by the number of all rows. */
    std::vector<int> first_rows;
    /** Row of every eliminated coordinate. */
    std::vector<int> rows;
    /** Rigid motions: own rows x (3 in the plane, 6 in space). */
    DenseMatrix rigid_motions;

    int
    n_rows() const
    {
      return first_rows.back();
    }

    int
    n_own_rows() const;

    /**
     * Return the position of a row among the own ones; for other rows the result is negative or too
     * large.
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
