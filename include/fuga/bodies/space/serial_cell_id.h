// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_serial_cell_id_h
#define fuga_bodies_space_serial_cell_id_h

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

namespace fuga
{
  /**
   * Return the path of a cell from the coarse mesh, as on one process: if p4est divides the mesh,
   * deal.II's own ids count the coarse cells in the order of p4est's trees.
   */
  template <typename Cell>
  dealii::CellId
  serial_cell_id(const Cell &cell)
  {
    const dealii::CellId id = cell->id();
    const auto children     = id.get_child_indices();
    typename dealii::Triangulation<Cell::AccessorType::dimension>::cell_iterator coarse = cell;
    while (coarse->level() > 0)
      coarse = coarse->parent();
    return {static_cast<dealii::types::coarse_cell_id>(coarse->index()),
            static_cast<unsigned int>(children.size()),
            children.data()};
  }
} // namespace fuga

#endif
