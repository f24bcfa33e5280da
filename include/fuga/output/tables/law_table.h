// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_law_table_h
#define fuga_output_tables_law_table_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /**
   * Write the laws of every joint, and nothing else, into the output directory: law_JOINT.csv
   * contains stress, tangent, secant stiffness and energy as functions of the deformation in both
   * directions, and the limit of the deformation; a rigid law has no rows. The columns are
   * described in doc/results.md. A shear law whose stiffness grows with closure or pressure is that
   * of the unloaded layer.
   * @returns the names of the files.
   */
  std::vector<std::string>
  write_law_tables(const Parameters &parameters);
} // namespace fuga

#endif
