// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_joint_report_h
#define fuga_mesh_joint_report_h

#include <fuga/mesh/joint_splitter.h>

#include <map>
#include <string>

namespace fuga
{
  /** The result of splitting the vertices on opened joints. */
  struct SplitVertices
  {
    /** Number of copies into which each vertex of the closed mesh was split; 1 is a tip. */
    std::map<unsigned int, unsigned int> n_copies;
    /** The vertex of the closed mesh from which each new vertex originates. */
    std::map<unsigned int, unsigned int> originals;
  };

  /**
   * Return one line for the log: what was opened, or which lips were found, and the direction of
   * the normal.
   */
  std::string
  describe_joint(const JointedMesh &mesh,
                 const JointDefinition &definition,
                 const unsigned int joint,
                 const SplitVertices &split_vertices);
} // namespace fuga

#endif
