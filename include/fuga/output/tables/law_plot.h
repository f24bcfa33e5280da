// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_law_plot_h
#define fuga_output_tables_law_plot_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /**
   * Writes the laws of every joint into the output directory, nothing else: law_JOINT.csv with
   * stress, tangent, secant stiffness and energy over the deformation in both directions, and
   * law_JOINT.svg, a picture of the two curves with the tangent at zero, the limit, and the points
   * of a table.
   * @returns the names of the files.
   */
  std::vector<std::string>
  write_law_plots(const Parameters &parameters);
} // namespace fuga

#endif
