// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_model_names_h
#define fuga_bodies_model_names_h

#include <fuga/bodies/model_definition.h>
#include <fuga/mesh/joint_splitter.h>

namespace fuga
{
  /**
   * Check that bodies, boundaries and points of the model and of the mesh match: every body has one
   * material; every name of a condition or load exists; every labelled boundary is a support, named
   * free, loaded, or the lip of a joint; a settlement moves supports only.
   * @throws InputError with the name, what exists, and the remedy.
   */
  void
  check_names(const JointedMesh &mesh, const ModelDefinition &model);

  /** Return the index of @p name in @p names, or the size of @p names if it is not there. */
  unsigned int
  index_of(const std::vector<std::string> &names, const std::string &name);

  /** Return for each of @p names whether it is among @p targets. */
  std::vector<bool>
  selection(const std::vector<std::string> &names, const std::vector<std::string> &targets);

  /** Return the mass per volume of the bodies of the mesh [MN s²/m⁴]. */
  Vector
  mass_densities(const JointedMesh &mesh, const ModelDefinition &model);

  /** Return the vertices of the points that are called @p name. */
  std::vector<unsigned int>
  vertices_of_point(const JointedMesh &mesh, const std::string &name);
} // namespace fuga

#endif
