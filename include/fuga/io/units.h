// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_units_h
#define fuga_io_units_h

#include <string>

namespace fuga
{
  /** Names of the units of a run, for the headers of the files; the program computes in any
   * consistent ones. */
  struct Units
  {
    std::string force  = "MN";
    std::string length = "m";

    /** "MPa", "kPa" or "Pa" where that is the name, else force/length². */
    std::string
    stress() const;
    std::string
    energy() const;
  };
} // namespace fuga

#endif
