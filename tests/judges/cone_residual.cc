// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "judges/cone_newton.h"
#include "judges/sizes.h"

#include <algorithm>
#include <cmath>

namespace fuga::judges
{
  namespace
  {
    /** The part of @p v in the bars of one element, and its length. */
    double
    length_in(const Vector &v, const std::vector<unsigned int> &bars)
    {
      double sum = 0.;
      for (const unsigned int bar : bars)
        sum += v[bar] * v[bar];
      return std::sqrt(sum);
    }
  } // namespace

  double
  ConeNewton::largest_length(const std::vector<Vector> &lengths) const
  {
    double result = 1e-300;
    for (const Vector &v : lengths)
      result = std::max(result, largest(v));
    for (const ConeElement &element : elements)
      result = std::max(result, std::abs(element.initial_gap));
    return result;
  }

  double
  ConeNewton::residual(const Vector &before, const Vector &factors, const ConeState &state) const
  {
    constexpr double closed = 1e-12; // of the largest length
    const Vector R          = reactions(factors);
    const Vector p          = forces(R, state.dislocations);
    const double force      = size(R, state.forces, state.dislocations);
    const double length     = largest_length({state.dislocations});
    double worst            = 0.;
    for (std::size_t i = 0; i < p.size(); ++i)
      worst = std::max(worst, std::abs(p[i] - state.forces[i]) / force);
    for (const ConeElement &element : elements)
      {
        const auto &bars = element.tangential_bars;
        const double N   = state.forces[element.normal_bar];
        const double a   = state.dislocations[element.normal_bar];
        const double room =
          element.strength(std::max(0., -N), a <= closed * length) - length_in(state.forces, bars);
        if (element.is_curved())
          worst = std::max(worst,
                           std::abs(N + element.area * (a < 0. ? element.stress(-a) : 0.)) / force);
        else
          worst = std::max({worst, N / force, -a / length, std::min(-N / force, a / length)});
        if (bars.empty())
          continue;
        Vector slip(state.dislocations.size(), 0.);
        double work = 0.;
        for (const unsigned int bar : bars)
          {
            slip[bar] = state.dislocations[bar] - before[bar];
            work += state.forces[bar] * slip[bar];
          }
        worst = std::max({worst,
                          -room / force,
                          std::min(room / force, length_in(slip, bars) / length),
                          -work / force / length});
      }
    return worst;
  }

  double
  ConeNewton::distance(const ConeState &a, const ConeState &b, const Vector &factors) const
  {
    const double force  = size(reactions(factors), a.forces, a.dislocations);
    const double length = largest_length({a.dislocations, b.dislocations});
    double worst        = 0.;
    for (std::size_t i = 0; i < a.forces.size(); ++i)
      worst = std::max({worst,
                        std::abs(a.forces[i] - b.forces[i]) / force,
                        std::abs(a.dislocations[i] - b.dislocations[i]) / length});
    return worst;
  }
} // namespace fuga::judges
