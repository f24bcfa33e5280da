// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_scenes_blocks_mesh_h
#define fuga_tests_scenes_blocks_mesh_h

#include "scenes/grid_mesh.h"

#include <string>
#include <vector>

namespace fuga::tests
{
  /** A line between blocks along a border. */
  struct InnerLine
  {
    std::string name;
    bool horizontal = true;
    /** Number of the border: line ys[border] if horizontal, else xs[border]. */
    std::size_t border = 0;
    /** Blocks along it: from begin to end. */
    std::size_t begin = 0, end = 1;
  };

  /**
   * A rectangle of blocks with borders @p xs and @p ys, each of n x n cells; bodies by rows from
   * below (equal names make one body). Boundaries `bottom`, `top`, `left`, `right`; only the lines
   * that are named can be joints.
   */
  GmshMesh
  blocks_mesh(const Axis &xs,
              const Axis &ys,
              const std::size_t n,
              const std::vector<std::vector<std::string>> &bodies,
              const std::vector<InnerLine> &lines);
} // namespace fuga::tests

#endif
