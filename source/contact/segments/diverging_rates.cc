// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/segments/diverging_rates.h>

#include <array>
#include <cmath>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Whether 1/g^n lies on a line that falls to zero @p within the last τ. */
    bool
    diverges(const std::vector<CurvePoint> &curve,
             const Vector &g,
             const int exponent,
             const double within)
    {
      constexpr double bend = 0.1, smaller = 1. / 1.2;
      std::array<double, 3> place, value;
      std::size_t n = 0;
      double limit  = std::numeric_limits<double>::infinity();
      for (std::size_t i = g.size(); i-- > 0 && n < 3;)
        if (g[i] > 0. && g[i] <= limit)
          {
            place[n]   = curve[i].tau;
            value[n++] = std::pow(g[i], -exponent);
            limit      = smaller * g[i];
          }
      if (n < 3)
        return false;
      const double last   = (value[0] - value[1]) / (place[0] - place[1]);
      const double before = (value[1] - value[2]) / (place[1] - place[2]);
      return last < 0. && std::abs(before - last) <= bend * std::abs(last) &&
             -value[0] / last <= within;
    }
  } // namespace

  // Of the bar whose rate g has grown most, whatever else moves steadily; g as a whole or what it
  // has grown by, for steady motion may be a part of it. Two slopes of 1/g^n are compared, between
  // the last point and those at which g was smaller by a sixth each time: others that come to rest
  // near τ* cut the path into short pieces.
  bool
  rates_diverge(const std::vector<CurvePoint> &curve, const int exponent, const double within)
  {
    const Vector &first = curve.front().point->rates.dislocations,
                 &last  = curve.back().point->rates.dislocations;
    std::size_t fastest = 0;
    double growth       = 0.;
    for (std::size_t bar = 0; bar < first.size(); ++bar)
      if (const double grown = std::abs(last[bar]) - std::abs(first[bar]); grown > growth)
        {
          fastest = bar;
          growth  = grown;
        }
    if (growth == 0.)
      return false;
    for (const double steady : {0., first[fastest]})
      {
        Vector speeds;
        for (const CurvePoint &at : curve)
          speeds.push_back(std::abs(at.point->rates.dislocations[fastest] - steady));
        if (diverges(curve, speeds, exponent, within))
          return true;
      }
    return false;
  }
} // namespace fuga
