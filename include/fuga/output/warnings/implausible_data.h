// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_implausible_data_h
#define fuga_output_warnings_implausible_data_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /** Return the word of the entry Type of a load. */
  std::string
  type_of(const Parameters &parameters, const LoadDefinition &load);

  /**
   * Return warnings about data that are allowed but hardly intended, each with the number and the
   * usual range, in the units of the user. Sizes are judged only if the user named units that are
   * known; comparisons of data with each other hold in any units. @p extent is the largest extent
   * of the mesh [m].
   */
  std::vector<std::string>
  implausible_data(const Parameters &parameters, const double extent);
} // namespace fuga

#endif
