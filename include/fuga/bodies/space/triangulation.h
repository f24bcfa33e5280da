// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_triangulation_h
#define fuga_bodies_space_triangulation_h

#include <fuga/bodies/model_definition.h>
#include <fuga/mesh/joint_splitter.h>

#include <memory>

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace fuga
{
  /**
   * Return the open mesh, refined as specified by the model, as deal.II's triangulation: boundary
   * id = label, material id = body. With one process it is a serial triangulation. Several
   * processes divide it: quadrilaterals and hexahedra that are refined, through p4est
   * (parallel::distributed: each process has its own cells, their neighbours, and the coarse mesh);
   * triangles and tetrahedra, which p4est does not support, and meshes that are as in the file,
   * which it could not divide, as parallel::shared (each process has all cells). The cells are the
   * same as with one process.
   * @throws InputError for cells without area or volume and for points beyond the axis of an
   * axisymmetric model.
   */
  template <int dim>
  std::unique_ptr<dealii::Triangulation<dim, dim>>
  make_triangulation(const JointedMesh &mesh, const ModelDefinition &model);
} // namespace fuga

#endif
