// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_units_h
#define fuga_input_units_h

#include <optional>
#include <string>

namespace fuga
{
  /**
   * Names of the units of a run, for the headers of the files; the program computes in any
   * consistent units.
   */
  struct Units
  {
    std::string force  = "MN";
    std::string length = "m";
    /** Whether the user named at least one of them, so that sizes of data can be judged. */
    bool named = false;

    /** Return "MPa", "kPa" or "Pa" if this is the name of the unit, otherwise force/length². */
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

    /**
     * Return the number of newtons in the unit of force, or of metres in that of length; nothing
     * for unknown units.
     */
    std::optional<double>
    newtons() const;
    std::optional<double>
    metres() const;
  };
} // namespace fuga

#endif
