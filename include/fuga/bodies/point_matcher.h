// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_point_matcher_h
#define fuga_bodies_point_matcher_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace fuga
{
  /** Copies of one node lie within this fraction of the extent of the model. */
  constexpr double one_node = 1e-9;
  /** The two sides of a joint coincide within this fraction of the size of a face. */
  constexpr double matching_tolerance = 1e-5;

  /**
   * Finds points by their coordinates. The points are sorted along a direction in which lines of a
   * mesh hardly ever coincide, so that a search checks only a few candidates.
   */
  template <int dim>
  class PointMatcher
  {
  public:
    static constexpr unsigned int not_found = static_cast<unsigned int>(-1);

    explicit PointMatcher(std::vector<dealii::Point<dim>> all_points)
      : points(std::move(all_points))
    {
      for (unsigned int i = 0; i < points.size(); ++i)
        keys.emplace_back(key(points[i]), i);
      std::sort(keys.begin(), keys.end());
    }

    /** Return the first of the points that are not further away than @p tolerance. */
    unsigned int
    find(const dealii::Point<dim> &point, const double tolerance) const
    {
      unsigned int first = not_found;
      auto at = std::lower_bound(keys.begin(), keys.end(), key(point) - 2. * tolerance, before);
      for (; at != keys.end() && at->first <= key(point) + 2. * tolerance; ++at)
        if (at->second < first && points[at->second].distance(point) <= tolerance)
          first = at->second;
      return first;
    }

  private:
    using Key = std::pair<double, unsigned int>;

    static bool
    before(const Key &a, const double b)
    {
      return a.first < b;
    }

    static double
    key(const dealii::Point<dim> &point)
    {
      double sum = 0., factor = 1.;
      for (int c = 0; c < dim; ++c, factor *= 0.7548776662466927)
        sum += factor * point[c];
      return sum;
    }

    std::vector<dealii::Point<dim>> points;
    std::vector<Key> keys;
  };
} // namespace fuga

#endif
