// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_straightness_h
#define fuga_bodies_straightness_h

#include <algorithm>
#include <cmath>

namespace fuga
{
  /**
   * Deviation from a straight line that is due to rounding, relative to the size of the function.
   */
  constexpr double linear_tolerance = 1e-12;

  /**
   * Return whether a function is linear between two arguments, as far as samples can tell. They are
   * taken at irregular positions, so that no common periodic or piecewise function looks straight
   * at all of them.
   */
  template <typename Function>
  bool
  is_straight(Function &&function, const double begin, const double end)
  {
    const double first = function(begin), last = function(end);
    for (const double s : {0.0719, 0.1931, 0.3137, 0.4391, 0.5, 0.5813, 0.6877, 0.8123, 0.9377})
      if (std::abs(function(begin + s * (end - begin)) - (1. - s) * first - s * last) >
          linear_tolerance * std::max(std::abs(first), std::abs(last)))
        return false;
    return true;
  }
} // namespace fuga

#endif
