// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_law_table_h
#define fuga_output_tables_law_table_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /**
   * Writes the laws of every joint into the output directory, nothing else: law_JOINT.csv has
   * stress, tangent, secant stiffness and energy over the deformation in both directions, and the
   * limit of the deformation; a rigid law has no rows. Columns: doc/results.md. A shear law whose
   * stiffness grows with closure or pressure is that of the unloaded layer.
   * @returns the names of the files.
   */
  std::vector<std::string>
  write_law_tables(const Parameters &parameters);
} // namespace fuga

#endif
