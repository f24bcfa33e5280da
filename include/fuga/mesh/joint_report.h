// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_joint_report_h
#define fuga_mesh_joint_report_h

#include <fuga/mesh/joint_splitter.h>

#include <map>
#include <string>

namespace fuga
{
  /** What became of the vertices on opened joints. */
  struct SplitVertices
  {
    /** By vertex of the closed mesh: into how many it was split; 1 is a tip. */
    std::map<unsigned int, unsigned int> n_copies;
    /** By new vertex: the vertex of the closed mesh. */
    std::map<unsigned int, unsigned int> originals;
  };

  /** One line for the log: what was opened, or which lips were found, and where the normal points.
   */
  std::string
  describe_joint(const JointedMesh &mesh,
                 const JointDefinition &definition,
                 const unsigned int joint,
                 const SplitVertices &split_vertices);
} // namespace fuga

#endif
