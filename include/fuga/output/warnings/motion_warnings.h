// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_motion_warnings_h
#define fuga_output_warnings_motion_warnings_h

#include <fuga/contact/dynamics/moving_bodies.h>

#include <string>
#include <vector>

namespace fuga
{
  /**
   * Return warnings about a motion that must not be trusted as it is: its ledger lacks energy, or
   * the integration in time has removed or added much of it. @p steps are the numbers of steps by
   * rung.
   */
  std::vector<std::string>
  motion_warnings(const MotionLedger &ledger, const std::vector<std::size_t> &steps);
} // namespace fuga

#endif
