// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/units.h>

#include <map>

namespace fuga
{
  namespace
  {
    std::optional<double>
    find(const std::map<std::string, double> &sizes, const std::string &name)
    {
      const auto known = sizes.find(name);
      return known == sizes.end() ? std::nullopt : std::optional<double>(known->second);
    }
  } // namespace

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
  Units::acceleration() const
  {
    return length + "/s2";
  }

  std::string
  Units::energy() const
  {
    return force + length;
  }

  std::string
  Units::area() const
  {
    return length + "2";
  }

  std::string
  Units::volume() const
  {
    return length + "3";
  }

  std::optional<double>
  Units::newtons() const
  {
    constexpr double g = 9.80665, pound = 4.4482216152605;
    return find({{"N", 1.},
                 {"daN", 1e1},
                 {"kN", 1e3},
                 {"MN", 1e6},
                 {"GN", 1e9},
                 {"kgf", g},
                 {"kp", g},
                 {"tf", 1e3 * g},
                 {"lbf", pound},
                 {"kip", 1e3 * pound},
                 {"Н", 1.},
                 {"кН", 1e3},
                 {"МН", 1e6},
                 {"кгс", g},
                 {"тс", 1e3 * g}},
                force);
  }

  std::optional<double>
  Units::metres() const
  {
    return find({{"m", 1.},
                 {"dm", 1e-1},
                 {"cm", 1e-2},
                 {"mm", 1e-3},
                 {"km", 1e3},
                 {"ft", 0.3048},
                 {"in", 0.0254},
                 {"м", 1.},
                 {"см", 1e-2},
                 {"мм", 1e-3}},
                length);
  }
} // namespace fuga
