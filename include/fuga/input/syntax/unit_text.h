// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_unit_text_h
#define fuga_input_syntax_unit_text_h

#include <fuga/input/units.h>

namespace fuga
{
  /**
   * Replace the units in brackets in @p text, which are given in terms of MN and m, as in "[MPa]",
   * by the units of the user.
   */
  std::string
  in_units(const std::string &text, const Units &units);
} // namespace fuga

#endif
