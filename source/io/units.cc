// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/units.h>

namespace fuga
{
  std::string
  Units::stress() const
  {
    if (length == "m" && force == "MN")
      return "MPa";
    if (length == "m" && force == "kN")
      return "kPa";
    if (length == "m" && force == "N")
      return "Pa";
    if (length == "mm" && force == "N")
      return "MPa";
    return force + "/" + length + "2";
  }

  std::string
  Units::energy() const
  {
    return force + length;
  }
} // namespace fuga
