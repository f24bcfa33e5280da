// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_mesh_refinement_h
#define fuga_bodies_space_mesh_refinement_h

#include <fuga/bodies/model_definition.h>
#include <fuga/mesh/joint_splitter.h>

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace fuga
{
  /**
   * Refine the marked active cells of a mesh whose boundary ids are the labels of @p jointed, and
   * all cells that have to be refined with them: neighbours, until levels differ by one at most,
   * and the partners across joints, so that both lips keep the same division; in space also cells
   * beside a joint, so that a vertex of one lip hangs only together with the one that it faces. The
   * result does not depend on the order of the marks.
   */
  template <int dim>
  void
  refine_marked_cells(dealii::Triangulation<dim, dim> &mesh,
                      const JointedMesh &jointed,
                      const std::vector<CellKey> &marked);
} // namespace fuga

#endif
