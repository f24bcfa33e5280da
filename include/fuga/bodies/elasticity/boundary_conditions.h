// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_elasticity_boundary_conditions_h
#define fuga_bodies_elasticity_boundary_conditions_h

#include <fuga/bodies/model_names.h>

namespace fuga
{
  template <int dim>
  class Discretization;

  /**
   * Check the outer boundary. @throws InputError with coordinates if faces of it belong to no
   * group.
   */
  template <int dim>
  void
  check_outer_faces(const Discretization<dim> &discretization);

  /**
   * Check the absorbing boundaries. @throws InputError if bodies without mass end there, the
   * compliant base is not horizontal, or the sides of a free field are not vertical.
   */
  template <int dim>
  void
  check_absorbing_faces(const Discretization<dim> &discretization,
                        const JointedMesh &mesh,
                        const ModelDefinition &model);

  /**
   * Return which degrees of freedom are held by the axis of revolution and by the supports, except
   * for those of the boundaries @p released: entry node * dim + direction.
   */
  template <int dim>
  std::vector<bool>
  find_fixed_dofs(const Discretization<dim> &discretization,
                  const JointedMesh &mesh,
                  const ModelDefinition &model,
                  const std::vector<std::string> &released = {});

  /**
   * Return all nodes of the boundary or of the points that are called @p name, in increasing order.
   */
  template <int dim>
  std::vector<unsigned int>
  nodes_of_target(const Discretization<dim> &discretization,
                  const JointedMesh &mesh,
                  const std::string &name);
} // namespace fuga

#endif
