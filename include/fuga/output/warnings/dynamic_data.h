// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_dynamic_data_h
#define fuga_output_warnings_dynamic_data_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /** Warnings about data of dynamic stages that are allowed but hardly meant, each with the number
   * and what is usual. */
  std::vector<std::string>
  implausible_dynamics(const Parameters &parameters);

  /** A table of the records: their lengths, what they reach, and where the ground ends. Empty
   * without records. */
  std::vector<std::string>
  ground_motion_echo(const Parameters &parameters);
} // namespace fuga

#endif
