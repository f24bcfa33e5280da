// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_dynamic_data_h
#define fuga_output_warnings_dynamic_data_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /**
   * Return warnings about data of dynamic stages that are allowed but hardly intended, each with
   * the number and the usual range.
   */
  std::vector<std::string>
  implausible_dynamics(const Parameters &parameters);

  /**
   * Return a table of the records: their lengths, their peak values, and velocity and displacement
   * of the ground at the end. Empty without records.
   */
  std::vector<std::string>
  ground_motion_echo(const Parameters &parameters);
} // namespace fuga

#endif
