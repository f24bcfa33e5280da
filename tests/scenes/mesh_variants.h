// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_mesh_variants_h
#define fuga_tests_scenes_mesh_variants_h

#include <fuga/mesh/gmsh_mesh.h>

#include <string>

namespace fuga::tests
{
  /** Vertices, cells and faces in a random order; the corners of cells begin elsewhere, faces turn
   * round. */
  GmshMesh
  renumbered(GmshMesh mesh, const unsigned int seed);

  /** x → -x; cells remain counter-clockwise. */
  GmshMesh
  mirrored(GmshMesh mesh);

  /** All coordinates times @p factor. */
  GmshMesh
  scaled(GmshMesh mesh, const double factor);

  /** Writes a .msh of version 2.2 into a directory of its own and returns its name. */
  std::string
  write_mesh(const GmshMesh &mesh);
} // namespace fuga::tests

#endif
