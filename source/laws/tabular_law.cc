// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/laws/tabular_law.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Smallest slope at an end of the spline, relative to that of its interval. */
    constexpr double smallest_end_slope = 0.1;
    /** Share of the shorter neighbouring interval that is rounded on each side of a corner. */
    constexpr double rounded_share = 0.05;

    using Values = std::vector<double>;

    /** Return the slope at an end by the one-sided formula for a parabola through three points,
     * limited so that it preserves the shape. */
    double
    end_slope(const double h0, const double h1, const double slope0, const double slope1)
    {
      const double slope = ((2. * h0 + h1) * slope0 - h0 * slope1) / (h0 + h1);
      return std::clamp(slope, smallest_end_slope * slope0, 3. * slope0);
    }

    /** Return the slopes at the points, i.e. the weighted harmonic mean of those of the
     * intervals. */
    Values
    spline_slopes(const Values &h, const Values &slopes)
    {
      const std::size_t n = h.size();
      if (n == 1)
        return {slopes[0], slopes[0]};
      Values d(n + 1);
      d[0] = end_slope(h[0], h[1], slopes[0], slopes[1]);
      d[n] = end_slope(h[n - 1], h[n - 2], slopes[n - 1], slopes[n - 2]);
      for (std::size_t i = 1; i < n; ++i)
        {
          const double left  = 2. * h[i] + h[i - 1];
          const double right = h[i] + 2. * h[i - 1];
          d[i]               = (left + right) / (left / slopes[i - 1] + right / slopes[i]);
        }
      return d;
    }

    /** Return lengths and slopes of the intervals. */
    std::pair<Values, Values>
    intervals_of(const std::vector<TabularLaw::Point> &table)
    {
      std::pair<Values, Values> result;
      for (std::size_t i = 0; i + 1 < table.size(); ++i)
        {
          const double h = table[i + 1].deformation - table[i].deformation;
          result.first.push_back(h);
          result.second.push_back((table[i + 1].stress - table[i].stress) / h);
        }
      return result;
    }
  } // namespace

  TabularLaw::TabularLaw(const std::vector<Point> &table, const TableInterpolation kind_of_curve)
    : interpolation(kind_of_curve), n_points(table.size()), last(table.back())
  {
    if (interpolation == TableInterpolation::monotone_spline)
      join_by_spline(table);
    else
      join_by_lines(table);
  }

  void
  TabularLaw::append(
    const double begin, const double y, const double d, const double c, const double b)
  {
    pieces.push_back({begin, y, d, c, b, 0.});
    if (pieces.size() > 1)
      {
        const Piece &before = pieces[pieces.size() - 2];
        const double x      = begin - before.begin;
        pieces.back().stored =
          before.stored +
          x * (before.y + x * (before.d / 2. + x * (before.c / 3. + x * before.b / 4.)));
      }
  }

  void
  TabularLaw::join_by_spline(const std::vector<Point> &table)
  {
    const auto [h, slopes] = intervals_of(table);
    const Values d         = spline_slopes(h, slopes);
    for (std::size_t i = 0; i < h.size(); ++i)
      append(table[i].deformation,
             table[i].stress,
             d[i],
             (3. * slopes[i] - 2. * d[i] - d[i + 1]) / h[i],
             (d[i] + d[i + 1] - 2. * slopes[i]) / (h[i] * h[i]));
    append(last.deformation, last.stress, d.back(), 0., 0.);
  }

  void
  TabularLaw::join_by_lines(const std::vector<Point> &table)
  {
    const auto [h, slopes] = intervals_of(table);
    append(0., 0., slopes[0], 0., 0.);
    for (std::size_t i = 1; i < h.size(); ++i)
      {
        const double half    = rounded_share * std::min(h[i - 1], h[i]);
        const double corner  = table[i].deformation;
        const double bending = (slopes[i] - slopes[i - 1]) / (4. * half);
        append(corner - half, table[i].stress - half * slopes[i - 1], slopes[i - 1], bending, 0.);
        append(corner + half, table[i].stress + half * slopes[i], slopes[i], 0., 0.);
      }
  }

  const TabularLaw::Piece &
  TabularLaw::piece_at(const double w) const
  {
    const auto next = std::upper_bound(
      pieces.begin() + 1, pieces.end(), w, [](const double value, const Piece &piece) {
        return value < piece.begin;
      });
    return *(next - 1);
  }

  double
  TabularLaw::reference_compliance() const
  {
    return compliance_towards(last.deformation / last.stress);
  }

  double
  TabularLaw::stress(const double w) const
  {
    const Piece &piece = piece_at(w);
    const double x     = w - piece.begin;
    return piece.y + x * (piece.d + x * (piece.c + x * piece.b));
  }

  double
  TabularLaw::tangent(const double w) const
  {
    const Piece &piece = piece_at(w);
    const double x     = w - piece.begin;
    return piece.d + x * (2. * piece.c + x * 3. * piece.b);
  }

  double
  TabularLaw::energy(const double w) const
  {
    const Piece &piece = piece_at(w);
    const double x     = w - piece.begin;
    return piece.stored +
           x * (piece.y + x * (piece.d / 2. + x * (piece.c / 3. + x * piece.b / 4.)));
  }

  double
  TabularLaw::deformation(const double sigma) const
  {
    if (sigma <= 0.)
      return 0.;
    const auto next = std::upper_bound(
      pieces.begin() + 1, pieces.end(), sigma, [](const double value, const Piece &piece) {
        return value < piece.y;
      });
    const Piece &piece = *(next - 1);
    if (piece.c == 0. && piece.b == 0.)
      return piece.begin + (sigma - piece.y) / piece.d;
    return deformation_between(sigma, piece.begin, next->begin);
  }

  double
  TabularLaw::deformation_scale() const
  {
    return last.deformation;
  }

  double
  TabularLaw::data_limit() const
  {
    return last.deformation;
  }

  std::vector<double>
  TabularLaw::knots() const
  {
    Values result;
    for (std::size_t i = 1; i < pieces.size(); ++i)
      result.push_back(pieces[i].begin);
    return result;
  }

  std::string
  TabularLaw::description() const
  {
    return fmt::format("table of {} points up to {:g} at {:g}, {}",
                       n_points,
                       last.stress,
                       last.deformation,
                       interpolation == TableInterpolation::monotone_spline ? "monotone spline"
                                                                            : "piecewise linear");
  }
} // namespace fuga
