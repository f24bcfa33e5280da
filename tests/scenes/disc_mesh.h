// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_disc_mesh_h
#define fuga_tests_scenes_disc_mesh_h

#include <fuga/mesh/gmsh_mesh.h>

#include <string>

namespace fuga::tests
{
  /**
   * A disc of the body `stamp` around the origin, with the rim `side`: a core of 2n x 2n
   * quadrilaterals, and around it n rings of 8n. All nodes of the rim are at @p radius.
   */
  GmshMesh
  disc_mesh(const double radius, const unsigned int n);

  /** Faces of the group @p name whose corners all have y >= 0 become the group @p part. */
  void
  part_above(GmshMesh &mesh, const std::string &name, const std::string &part);
} // namespace fuga::tests

#endif
