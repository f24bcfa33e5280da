// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_stiffness_need_h
#define fuga_input_stiffness_need_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /**
   * Return what requires the stiffness of the interface of a problem as a matrix ("... is", "...
   * are"); empty if nothing does, so that the bodies may be eliminated matrix-free.
   */
  std::string
  what_needs_stiffness(const Parameters &parameters);
} // namespace fuga

#endif
