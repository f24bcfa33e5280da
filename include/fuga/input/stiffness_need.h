// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_stiffness_need_h
#define fuga_input_stiffness_need_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /** What of a problem needs the stiffness of the interface as a matrix ("... is", "... are");
   * empty if nothing, so that the bodies may be eliminated matrix-free. */
  std::string
  what_needs_stiffness(const Parameters &parameters);
} // namespace fuga

#endif
