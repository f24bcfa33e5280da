// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_navier_with_crack_h
#define fuga_tests_navier_with_crack_h

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace fuga::tests
{
  /**
   * Pressure under a rigid base on a layer without tension, with water: Navier's straight line over
   * the closed part, the full pressure of the reservoir in the crack. With the tributary areas of
   * linear elements, so that sums stand for integrals; from sums of force and moment alone.
   */
  struct NavierWithCrack
  {
    /** Upstream end first. */
    std::vector<double> x, area;
    /** ∫ N u over the elements for a pressure that falls from 1 to 0. */
    std::vector<double> closed;
    /** Whether the pressure falls from the tip of the crack, or else from the upstream end. */
    bool from_tip = false;

    /** n equal elements over @p base, around x = 0; @p share of the linear pressure where closed. */
    NavierWithCrack(const std::size_t n, const double base, const double share = 1.)
      : x(n + 1), area(n + 1, base / static_cast<double>(n)), closed(n + 1, 0.)
    {
      const double h = area[0];
      area.front() = area.back() = h / 2.;
      for (std::size_t k = 0; k <= n; ++k)
        x[k] = h * static_cast<double>(k) - base / 2.;
      for (std::size_t e = 0; e < n; ++e)
        {
          const double u0 = share * (0.5 - x[e] / base), u1 = share * (0.5 - x[e + 1] / base);
          closed[e] += h * (u0 / 3. + u1 / 6.);
          closed[e + 1] += h * (u0 / 6. + u1 / 3.);
        }
    }

    /** ∫ N u over the elements with the first @p m open, for a head of 1. The crack ends where the
     * open elements do, half-way between two of them. */
    std::vector<double>
    water(const std::size_t m) const
    {
      std::vector<double> result(closed);
      for (std::size_t k = 0; !from_tip && k < m; ++k)
        result[k] = area[k];
      if (!from_tip || m == 0)
        return result;
      const double end = x.back(), h = area[1];
      const double tip = m < x.size() ? x[m] - h / 2. : end;
      const auto u     = [&](const double at) { return at <= tip ? 1. : (end - at) / (end - tip); };
      result.assign(x.size(), 0.);
      // Simpson's rule, exact on both sides of the tip.
      const auto add = [&](const std::size_t e, const double a, const double b) {
        for (const auto &[at, weight] :
             {std::pair(a, 1.), std::pair((a + b) / 2., 4.), std::pair(b, 1.)})
          for (const std::size_t k : {e, e + 1})
            result[k] += (b - a) / 6. * weight * u(at) * (1. - std::abs(at - x[k]) / h);
      };
      for (std::size_t e = 0; e + 1 < x.size(); ++e)
        if (tip > x[e] && tip < x[e + 1])
          {
            add(e, x[e], tip);
            add(e, tip, x[e + 1]);
          }
        else
          add(e, x[e], x[e + 1]);
      return result;
    }

    /**
     * Pressures of the lips if the first @p m elements are open. @p V: load downwards; @p M: its
     * moment about x = 0, positive if it presses on the downstream side; @p head: pressure of the
     * reservoir.
     */
    std::vector<double>
    pressures(double V, double M, const double head, const std::size_t m) const
    {
      double a = 0., b = 0., c = 0.;
      const std::vector<double> unit = water(m);
      for (std::size_t k = 0; k < x.size(); ++k)
        {
          const double w = head * unit[k];
          V -= w;
          M -= w * x[k];
          if (k < m)
            continue;
          a += area[k];
          b += area[k] * x[k];
          c += area[k] * x[k] * x[k];
        }
      const double determinant = a * c - b * b;
      const double alpha = (V * c - M * b) / determinant, beta = (a * M - b * V) / determinant;
      std::vector<double> result;
      for (const double position : x)
        result.push_back(alpha + beta * position);
      return result;
    }

    /** The shortest crack whose tip carries pressure and whose last element is pulled apart: the
     * one that a rising level reaches; more than all elements if there is none. */
    std::size_t
    crack(const double V, const double M, const double head) const
    {
      for (std::size_t m = 0; m + 1 < x.size(); ++m)
        if (const auto p = pressures(V, M, head, m); p[m] >= 0. && (m == 0 || p[m - 1] < 0.))
          return m;
      return x.size();
    }
  };
} // namespace fuga::tests

#endif
