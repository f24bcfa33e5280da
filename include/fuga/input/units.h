// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_units_h
#define fuga_input_units_h

#include <optional>
#include <string>

namespace fuga
{
  /** Names of the units of a run, for the headers of the files; the program computes in any
   * consistent ones. */
  struct Units
  {
    std::string force  = "MN";
    std::string length = "m";
    /** Whether the user named at least one of them, so that sizes of data can be judged. */
    bool named = false;

    /** "MPa", "kPa" or "Pa" where that is the name, else force/length². */
    std::string
    stress() const;
    std::string
    acceleration() const;
    std::string
    energy() const;
    std::string
    area() const;
    std::string
    volume() const;

    /** Newtons in the unit of force, metres in that of length; nothing for units that are not
     * known. */
    std::optional<double>
    newtons() const;
    std::optional<double>
    metres() const;
  };
} // namespace fuga

#endif
