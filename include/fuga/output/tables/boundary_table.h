// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_boundary_table_h
#define fuga_output_tables_boundary_table_h

#include <fuga/input/units.h>
#include <fuga/mesh/joint_splitter.h>

#include <string>

namespace fuga
{
  /**
   * Write boundaries.csv in @p directory: one row per face of the mesh of the file, before any
   * refinement, that is on a named boundary or on a side of a joint. A row contains the name of the
   * boundary, the name of the joint if it is a side of one, the body, and the corners,
   * counter-clockwise seen from outside (in the plane the body is to the left). A triangle repeats
   * its last corner.
   */
  void
  write_boundary_table(const std::string &directory, const JointedMesh &mesh, const Units &units);
} // namespace fuga

#endif
